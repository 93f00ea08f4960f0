// sandbox [SCENE] [--replay FILE]: a scene of the accuracy study, or a recorded game, with every setting under a
// slider, the cost of every phase, and the error where the exact result is known.
#include <cstdio>
#include <memory>
#include <string>

#include "engine/render/gl.h"
#include "engine/render/renderer.h"
#include "platform/headless/headless.h"
#include "platform/sdl/window.h"
#include "tools/brittle/arguments.h"
#include "tools/brittle/game.h"
#include "tools/brittle/progress.h"
#include "tools/panels/listening_platform.h"
#include "tools/sandbox/replay_run.h"
#include "tools/sandbox/sandbox.h"
#include "tools/sandbox/scene_run.h"

namespace brittle::sandbox {
namespace {

using program::kDone;

struct Options {
  std::string scene = "panes", replay, assets, preset = "balanced", size = "1280x720", picture;
  int variant = 0;
  std::uint32_t frames = 0, ticks = 0;
};

constexpr const char* kName = "sandbox";

int refuse(const Error& error) {
  return program::refuse(kName, error);
}

constexpr const char* kFooter = R"(keys:
  space       pause, go on          .  ,       a tick forward, back
  r           restart               b, click   throw a ball
  arrows      turn the view         escape     leave

examples:
  sandbox panes --variant 12
  sandbox stack --accuracy phone
  sandbox --replay assets/replays/first-rooms.brt
  sandbox panes --ticks 20 --picture panes.png)";

std::string sceneNames() {
  std::string names;
  for (const accuracy::Scene& scene : accuracy::allScenes())
    names += (names.empty() ? "" : ", ") + std::string(scene.name);
  return names;
}

std::string presetNames() {
  std::string names;
  for (const std::string_view name : physics::presetNames()) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

Result<std::unique_ptr<Run>> openScene(const Options& options) {
  const accuracy::Scene* scene = accuracy::findScene(options.scene);
  if (scene == nullptr) return Error{options.scene + ": no such scene; expected " + sceneNames()};
  if (options.variant < 0 || options.variant >= scene->variants)
    return Error{"--variant " + std::to_string(options.variant) + ": the scene has 0 to " +
                 std::to_string(scene->variants - 1)};
  const Result<physics::Accuracy> accuracy = program::accuracyOf(options.preset);
  if (!accuracy) return accuracy.error();
  return std::unique_ptr<Run>(new SceneRun(*scene, options.variant, *accuracy));
}

/// A recorded game that this build can play.
struct Recorded {
  replay::Replay replay;
  std::unique_ptr<program::GameSimulation> game;
};

Result<Recorded> openReplay(const Options& options, const content::AssetSource& assets) {
  Result<replay::Replay> replay = program::loadReplay(options.replay);
  if (!replay) return replay.error();
  auto game = program::openReplay(assets, *replay, options.replay);
  if (!game) return game.error();
  return Recorded{std::move(*replay), std::move(*game)};
}

Result<std::unique_ptr<runtime::Platform>> openPlatform(const Options& options, runtime::PictureSize size) {
  if (options.picture.empty()) {
    platform::WindowDef window;
    window.title = "Brittle sandbox";
    window.size = size;
    return platform::openWindow(window);
  }
  auto headless = platform::createHeadless(platform::HeadlessBackend::Egl, size);
  if (!headless) return headless.error();
  return std::unique_ptr<runtime::Platform>(std::move(*headless));
}

/// The state after so many ticks, with its panels.
int writePicture(const Options& options, Sandbox& sandbox, Run& run, render::Renderer& renderer,
                 runtime::PictureSize size) {
  program::Progress progress("playing", options.ticks);
  for (std::uint32_t i = 0; i < options.ticks;) {
    sandbox.tick({});
    progress.reached(++i);
  }
  sandbox.setPaused(true);
  for (int i = 0; i < 2; ++i) sandbox.draw({1.0f, size});  // panels know their size from the second picture on
  const Status written = render::writePng(renderer.readBack(), options.picture);
  if (!written) return refuse(written.error());
  std::printf("%s: tick %u\n", options.picture.c_str(), run.tick());
  return kDone;
}

/// What is wrong with the options shows before a window opens; so a scene is open already; else it is `recorded`.
int show(const Options& options, const content::AssetSource& assets, std::unique_ptr<Run> scene, Recorded recorded) {
  const auto size = program::parseSize(options.size);
  if (!size) return refuse(size.error());
  const runtime::PictureSize picture{size->width, size->height};
  const auto platform = openPlatform(options, picture);
  if (!platform) return refuse(platform.error());
  Result<render::Gl> gl = render::loadGl((*platform)->glLoader());
  if (!gl) return refuse(gl.error());
  render::RendererDef def;
  def.width = (*platform)->size().width;
  def.height = (*platform)->size().height;
  def.samples = 4;
  def.offscreen = !(*platform)->hasDefaultFramebuffer();
  const auto renderer = render::Renderer::create(*gl, def);
  if (!renderer) return refuse(renderer.error());
  // A recorded game draws with the renderer to its end, so it ends first.
  const std::unique_ptr<Run> run =
      scene ? std::move(scene)
            : std::make_unique<ReplayRun>(assets, std::move(recorded.replay), std::move(recorded.game), **renderer);

  panels::Gui gui;
  Sandbox sandbox(*run, **renderer, gui, **platform, options.frames);
  if (!options.picture.empty()) return writePicture(options, sandbox, *run, **renderer, picture);
  panels::ListeningPlatform listening(**platform, [&](const runtime::Event& event) { return sandbox.hear(event); });
  runtime::Loop loop(listening, sandbox);
  while (loop.frame()) {
  }
  std::printf("%u ticks\n", run->tick());
  return kDone;
}

int open(const Options& options) {
  const auto assets = program::openAssets(options.assets);
  if (!assets) return refuse(assets.error());
  if (options.replay.empty()) {
    auto run = openScene(options);
    return run ? show(options, **assets, std::move(*run), {}) : refuse(run.error());
  }
  auto recorded = openReplay(options, **assets);
  return recorded ? show(options, **assets, nullptr, std::move(*recorded)) : refuse(recorded.error());
}

}  // namespace
}  // namespace brittle::sandbox

int main(int argc, char** argv) {
  brittle::sandbox::Options options;
  CLI::App app("scenes of breaking glass, or a recorded game, with every setting of accuracy under a slider",
               brittle::sandbox::kName);
  app.footer(brittle::sandbox::kFooter);
  app.add_option("SCENE", options.scene, "one of " + brittle::sandbox::sceneNames())->capture_default_str();
  app.add_option("--variant", options.variant, "which of the scene's phases or seeds, from 0")->capture_default_str();
  app.add_option("--accuracy", options.preset, "settings to begin with: " + brittle::sandbox::presetNames())
      ->capture_default_str();
  app.add_option("--replay", options.replay, "a recorded game instead of a scene");
  app.add_option("--assets", options.assets, "folder of levels for the replay (default: the one that came with it)");
  app.add_option("--size", options.size, "of the window or picture")->capture_default_str();
  app.add_option("--frames", options.frames, "leave after so many pictures (0: when the window is closed)");
  app.add_option("--picture", options.picture, "no window: write the state after --ticks as a PNG");
  app.add_option("--ticks", options.ticks, "of the picture")->check(CLI::Range(0u, brittle::replay::kMaxTicks));
  if (const auto ended = brittle::program::readArguments(app, argc, argv)) return *ended;
  return brittle::sandbox::open(options);
}
