#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "engine/core/file.h"
#include "game/sim/constants.h"
#include "game/view/memory.h"
#include "platform/headless/headless.h"
#include "tools/brittle/game.h"
#include "tools/brittle/picture.h"
#include "tools/brittle/progress.h"
#include "tools/brittle/soundtrack.h"

namespace brittle::program {
namespace {

Result<platform::HeadlessBackend> backendOf(const std::string& name) {
  for (const auto backend : {platform::HeadlessBackend::Egl, platform::HeadlessBackend::OsMesa})
    if (name == platform::nameOf(backend)) return backend;
  return Error{"--backend " + name + ": expected egl or osmesa"};
}

/// Frame 0 is the start, frame N the state after N ticks.
Result<FrameRange> framesOf(const std::string& text, std::uint32_t ticks) {
  if (text.empty()) return FrameRange{0, ticks};
  Result<FrameRange> range = parseFrames(text);
  if (range && range->last > ticks)
    return Error{"--frames " + text + ": the replay has frames 0.." + std::to_string(ticks)};
  return range;
}

/// Makes the folder and tries it, before the work begins.
Status prepareFolder(const std::string& path) {
  std::error_code problem;
  std::filesystem::create_directories(path, problem);
  if (problem)
    return errorAt(path, 0, "cannot be made: " + problem.message() + "; --out needs a folder that can be written");
  return checkWritable(path + "/frame.png");
}

std::string pictureName(const std::string& folder, std::uint32_t frame) {
  char name[32];
  std::snprintf(name, sizeof name, "/frame_%06u.png", frame);
  return folder + name;
}

struct Job {
  const replay::Replay& replay;
  GameSimulation& simulation;
  Picture& picture;
  runtime::PictureSize size;
  FrameRange frames;
  std::uint32_t every;
  const std::string& folder;
};

Status renderFrame(const Job& job, std::uint32_t frame) {
  job.picture.draw(job.simulation.game(), 1.0f, job.size);
  return render::writePng(job.picture.readBack(), pictureName(job.folder, frame));
}

Status renderFrames(const Job& job) {
  replay::Player player(job.replay, job.simulation);
  // So much earlier, any range of frames comes out as it does in a rendering of the whole replay.
  const std::uint32_t begin = job.frames.first > view::kMemoryTicks ? job.frames.first - view::kMemoryTicks : 0;
  if (begin > 0) {
    const Status found = player.seek(begin);
    if (!found) return found;
  }
  Progress progress("rendering", job.frames.last - begin);
  job.picture.ticked(job.simulation.game());
  while (true) {
    const std::uint32_t frame = player.tick();
    if (frame >= job.frames.first && (frame - job.frames.first) % job.every == 0) {
      const Status drawn = renderFrame(job, frame);
      if (!drawn) return drawn;
    }
    progress.reached(frame - begin);
    if (frame >= job.frames.last) return Done{};
    player.step();
    job.picture.ticked(job.simulation.game());
  }
}

/// The frames as pictures, on a simulation of their own.
Status renderPictures(const RenderOptions& options, const replay::Replay& replay, const FrameRange& frames,
                      GameSimulation& simulation) {
  const Result<Size> size = parseSize(options.size);
  if (!size) return size.error();
  const Result<platform::HeadlessBackend> backend = backendOf(options.backend);
  if (!backend) return backend.error();
  const runtime::PictureSize pictureSize{size->width, size->height};
  const auto headless = platform::createHeadless(*backend, pictureSize);
  if (!headless) return headless.error();
  const auto picture = Picture::create(**headless, options.samples);
  if (!picture) return picture.error();
  const Status folder = prepareFolder(options.out);
  if (!folder) return folder;
  const Status rendered =
      renderFrames({replay, simulation, **picture, pictureSize, frames, options.every, options.out});
  if (!rendered) return rendered;
  std::printf("%s: %u pictures of %dx%d\n", options.out.c_str(), (frames.last - frames.first) / options.every + 1,
              size->width, size->height);
  return Done{};
}

Status renderSound(const RenderOptions& options, const replay::Replay& replay, const FrameRange& frames,
                   GameSimulation& simulation) {
  const Status written = writeSoundtrack(replay, simulation, frames, options.sound);
  if (!written) return written;
  std::printf("%s: %.2f s of sound\n", options.sound.c_str(),
              static_cast<double>(frames.last - frames.first + 1) / sim::rules::kTickRate);
  return Done{};
}

}  // namespace

int render(const RenderOptions& options) {
  if (options.out.empty() && options.sound.empty())
    return refuse({"--out DIR for pictures or --sound FILE is needed (brittle render --help)"});
  const Result<replay::Replay> replay = loadReplay(options.replay);
  if (!replay) return refuse(replay.error());
  const Result<FrameRange> frames = framesOf(options.frames, replay->ticks());
  if (!frames) return refuse(frames.error());
  const auto assets = openAssets(options.assets);
  if (!assets) return refuse(assets.error());
  using Write = Status (*)(const RenderOptions&, const replay::Replay&, const FrameRange&, GameSimulation&);
  const std::pair<const std::string&, Write> outputs[] = {{options.out, renderPictures}, {options.sound, renderSound}};
  for (const auto& [path, write] : outputs) {
    if (path.empty()) continue;
    const auto simulation = openReplay(**assets, *replay, options.replay);
    if (!simulation) return refuse(simulation.error());
    const Status written = write(options, *replay, *frames, **simulation);
    if (!written) return refuse(written.error());
  }
  return kDone;
}

}  // namespace brittle::program
