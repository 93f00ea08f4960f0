// effects_probe SCENE [--off] [--ticks N] [--backend egl|osmesa|null]: plays one room for so many ticks, with its
// picture and its sound, and prints what that took. tools/effects_cost runs it, in this build and in builds without an
// effect.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "engine/audio/mixer.h"
#include "engine/core/log.h"
#include "engine/render/gl.h"
#include "engine/render/renderer.h"
#include "game/sim/constants.h"
#include "game/sim/game.h"
#include "game/view/scene.h"
#include "game/view/sound.h"
#include "platform/headless/headless.h"
#include "tests/allocations.h"
#include "tools/bench/cpu_time.h"
#include "tools/brittle/arguments.h"
#include "tools/effects_probe/scenes.h"

namespace brittle::probe {

constexpr int kCrowd = 10;  // rows of crates
constexpr runtime::PictureSize kSize = {320, 180};

struct Stage {
  sim::Game& game;
  view::Scene& scene;
  render::Renderer& renderer;
  view::Sound& sound;
  audio::Mixer& mixer;
};

/// What is counted by callgrind: one tick of everything.
[[gnu::noinline]] void playTick(Stage& stage, sim::FramePacket& packet, std::vector<float>& stereo) {
  replay::InputFrame input;
  stage.game.tick(input);
  stage.game.copyFrame(packet);
  stage.scene.tick(packet);
  stage.renderer.draw(stage.scene.build(1.0f, static_cast<float>(kSize.width) / kSize.height,
                                        {stage.game.meshes(0), stage.game.meshes(1)}));
  stage.sound.tick(packet);
  stage.mixer.render(stereo);
}

/// Milliseconds of each tick.
std::vector<double> playTicks(Stage& stage, int ticks) {
  std::vector<double> times;
  sim::FramePacket packet;
  std::vector<float> stereo(2 * audio::kSampleRate / sim::rules::kTickRate);
  for (int i = 0; i < ticks; ++i) {
    const double start = cpuMilliseconds();
    playTick(stage, packet, stereo);
    times.push_back(cpuMilliseconds() - start);
  }
  return times;
}

std::size_t bodiesIn(const sim::Game& game) {
  std::size_t bodies = 0;
  game.world(0)->forEachBody([&](physics::BodyHandle, const physics::Body&) { ++bodies; });
  return bodies;
}

Status run(const std::string& name, bool off, int ticks, platform::HeadlessBackend backend) {
  const auto effect = effects::effectNamed(name);
  if (!effect && name != "plain" && name != "crowd")
    return Error{"scene " + name + ": expected plain, crowd or the name of an effect"};
  const content::MemorySource source = effect ? roomWith(*effect) : plainRoom(name == "crowd" ? kCrowd : 1);
  sim::GameDef def;
  def.level = "probe";
  if (effect && off) def.without = def.without.with(*effect);
  auto game = sim::Game::create(source, def);
  if (!game) return game.error();
  auto headless = platform::createHeadless(backend, kSize);
  if (!headless) return headless.error();
  const Result<render::Gl> gl = render::loadGl((*headless)->glLoader());
  if (!gl) return gl.error();
  render::Gl table = *gl;
  render::RendererDef picture;
  picture.width = kSize.width;
  picture.height = kSize.height;
  auto renderer = render::Renderer::create(table, picture);
  if (!renderer) return renderer.error();
  const audio::Bank bank;
  audio::Mixer mixer(bank);
  view::Scene scene(**renderer);
  view::Sound sound(mixer);
  Stage stage{**game, scene, **renderer, sound, mixer};
  std::vector<double> times = playTicks(stage, ticks);
  (*renderer)->readBack();  // waits for the last picture
  for (const sim::Problem& problem : (*game)->problems()) logWarning(problem.text);
  std::sort(times.begin(), times.end());
  double sum = 0.0;
  for (const double time : times) sum += time;
  std::printf(
      "{\"ms\": %.6f, \"median_ms\": %.6f, \"heap_bytes\": %zu, \"bodies\": %zu, \"demanded\": %s, \"runs\": %s}\n",
      sum / static_cast<double>(ticks), times[times.size() / 2], allocatedBytes(), bodiesIn(**game),
      effect && (*game)->effects().has(*effect) ? "true" : "false",
      effect && (*game)->effects().runs(*effect) ? "true" : "false");
  return Done{};
}

}  // namespace brittle::probe

int main(int argc, char** argv) {
  using namespace brittle;
  CLI::App app("Plays one small room with what calls for one effect, and prints what a tick of it takes.",
               "effects_probe");
  std::string scene = "plain", backend = "null";
  int ticks = 300;
  bool off = false;
  app.add_option("SCENE", scene,
                 "plain, crowd (more bodies), or the name of an effect (brittle play --help lists them)")
      ->capture_default_str();
  app.add_option("--ticks", ticks, "of 1/60 s")->capture_default_str()->check(CLI::Range(1, 1900));
  app.add_flag("--off", off, "with the scene's effect switched off");
  app.add_option("--backend", backend, "egl, osmesa or null: without drawing")->capture_default_str();
  app.footer(
      "Examples:\n  effects_probe plain\n  effects_probe reverb --ticks 600\n  effects_probe mirror --backend egl");
  if (const auto ended = program::readArguments(app, argc, argv)) return *ended;
  for (const auto kind :
       {platform::HeadlessBackend::Egl, platform::HeadlessBackend::OsMesa, platform::HeadlessBackend::Null}) {
    if (backend != platform::nameOf(kind)) continue;
    const Status played = probe::run(scene, off, ticks, kind);
    return played ? 0 : program::refuse(app.get_name(), played.error());
  }
  return program::refuse(app.get_name(), {"--backend " + backend + ": expected egl, osmesa or null"});
}
