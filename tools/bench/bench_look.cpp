// What the first level's picture costs on the software driver, and what each part of it adds:
// `bench --benchmark_filter=look`. CPU time of all threads, at 640 x 360.
#include <benchmark/benchmark.h>

#include <ctime>
#include <functional>
#include <map>

#include "engine/render/gl.h"
#include "game/content/asset_source.h"
#include "game/sim/game.h"
#include "game/view/look.h"
#include "game/view/scene.h"
#include "platform/headless/headless.h"

namespace {

using namespace brittle;

constexpr int kWidth = 640, kHeight = 360;
constexpr std::uint64_t kTick = 240;  // a pane has just been broken, crystals and blocks are ahead
constexpr int kPictures = 40;

double cpuMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/// The game at kTick and what draws it.
struct Studio {
  content::FolderSource assets{{BRITTLE_SOURCE_DIR "/assets"}};
  std::unique_ptr<sim::Game> game;
  std::unique_ptr<platform::Headless> device;
  render::Gl gl;
  std::unique_ptr<render::Renderer> renderer;
  std::unique_ptr<view::Scene> scene;
  render::Frame frame;

  Studio() {
    game = std::move(sim::Game::create(assets, {}).value());
    device = std::move(platform::createHeadless(platform::HeadlessBackend::Egl, {kWidth, kHeight}).value());
    gl = render::loadGl(device->glLoader()).value();
    renderer = std::move(render::Renderer::create(gl, {.width = kWidth, .height = kHeight}).value());
    scene = std::make_unique<view::Scene>(*renderer);
    sim::FramePacket packet;
    while (game->tickCount() < kTick) {
      replay::InputFrame input;
      if (game->tickCount() % 60 == 10) input.throws.push_back({});
      game->tick(input);
      game->copyFrame(packet);
      scene->tick(packet);
    }
    frame = scene->build(1.0f, static_cast<float>(kWidth) / kHeight, {game->meshes(0), game->meshes(1)});
  }

  double millisecondsOf(const render::Frame& shown) {
    for (int i = 0; i < 3; ++i) renderer->draw(shown);  // shaders are compiled, buffers grown
    renderer->readBack();
    double least = 1e9;  // others share the machine
    for (int i = 0; i < kPictures; ++i) {
      const double start = cpuMilliseconds();
      renderer->draw(shown);
      renderer->readBack();
      least = minOf(least, cpuMilliseconds() - start);
    }
    return least;
  }
};

void drawParts(benchmark::State& state) {
  const std::map<std::string, std::function<void(render::Frame&)>> parts = {
      {"statics", [](render::Frame& f) { f.statics.clear(); }},
      {"convexes", [](render::Frame& f) { f.groups = {}; }},
      {"spheres", [](render::Frame& f) { f.spheres.clear(); }},
      {"shadows",
       [](render::Frame& f) {
         f.shadows.clear();
         f.sphereShadow = 0.0f;
       }},
      {"glows_beams",
       [](render::Frame& f) {
         f.glows.clear();
         f.beams.clear();
       }},
      {"decals", [](render::Frame& f) { f.decals.clear(); }},
      {"mirror", [](render::Frame& f) { f.mirrorHeight.reset(); }},
      {"bloom", [](render::Frame& f) { f.bloom = 0.0f; }},
      {"hud",
       [](render::Frame& f) {
         f.quads.clear();
         f.arcs.clear();
         f.texts.clear();
       }},
  };
  Studio studio;
  for (auto iteration : state) {
    const double all = studio.millisecondsOf(studio.frame);
    state.counters["all_ms"] = all;
    for (const auto& [name, leaveOut] : parts) {
      render::Frame without = studio.frame;
      leaveOut(without);
      state.counters[name] = all - studio.millisecondsOf(without);
    }
    const double start = cpuMilliseconds();
    for (int i = 0; i < kPictures; ++i)
      studio.scene->build(1.0f, 1.78f, {studio.game->meshes(0), studio.game->meshes(1)});
    state.counters["build_ms"] = (cpuMilliseconds() - start) / kPictures;
  }
}
BENCHMARK(drawParts)->Name("look/parts")->Unit(benchmark::kMillisecond)->Iterations(1);

void bakeSegments(benchmark::State& state) {
  Studio studio;
  sim::FramePacket packet;
  studio.game->copyFrame(packet);
  double most = 0.0, sum = 0.0, vertices = 0.0;
  int count = 0;
  for (auto iteration : state) {
    for (const sim::PlacedSegment& segment : packet.rooms[0].segments) {
      render::Baker baker = view::bakerOf(*segment.look);
      bool isLeft = true;
      while (isLeft) {
        const double start = cpuMilliseconds();
        isLeft = baker.step();
        const double spent = cpuMilliseconds() - start;
        most = maxOf(most, spent);
        sum += spent;
      }
      vertices += static_cast<double>(baker.finish().vertices.size());
      ++count;
    }
  }
  state.counters["segments"] = count;
  state.counters["mean_ms"] = sum / count;
  state.counters["longest_step_ms"] = most;
  state.counters["vertices"] = vertices / count;
}
BENCHMARK(bakeSegments)->Name("look/bake")->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
