#include <cstdio>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

#include "engine/core/file.h"
#include "game/sim/constants.h"
#include "game/view/memory.h"
#include "platform/headless/headless.h"
#include "tools/brittle/game.h"
#include "tools/brittle/interrupt.h"
#include "tools/brittle/movie.h"
#include "tools/brittle/picture.h"
#include "tools/brittle/progress.h"
#include "tools/brittle/soundtrack.h"

namespace brittle::program {
namespace {

Result<platform::HeadlessBackend> backendOf(const std::string& name) {
  for (const auto backend :
       {platform::HeadlessBackend::Egl, platform::HeadlessBackend::OsMesa, platform::HeadlessBackend::Null})
    if (name == platform::nameOf(backend)) return backend;
  return Error{"--backend " + name + ": expected egl, osmesa or null"};
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

/// What is done with a frame that was drawn.
using TakeFrame = std::function<Status(const render::Image& image, std::uint32_t frame)>;

/// Everything that a rendering starts from.
struct Job {
  const RenderOptions& options;
  const content::AssetSource& assets;
  const replay::Replay& replay;
  FrameRange frames;

  /// At the start of the replay; each output plays one of its own.
  Result<std::unique_ptr<GameSimulation>> simulation() const { return openReplay(assets, replay, options.replay); }
  std::uint32_t pictures() const { return (frames.last - frames.first) / options.every + 1; }
};

/// An off-screen context and the picture drawn in it.
struct Canvas {
  Size size;
  std::unique_ptr<platform::Headless> platform;
  std::unique_ptr<Picture> picture;
};

Result<Canvas> makeCanvas(const RenderOptions& options, const content::AssetSource& assets) {
  const Result<Size> size = parseSize(options.size);
  if (!size) return size.error();
  const Result<platform::HeadlessBackend> backend = backendOf(options.backend);
  if (!backend) return backend.error();
  auto headless = platform::createHeadless(*backend, {size->width, size->height});
  if (!headless) return headless.error();
  auto picture = Picture::create(**headless, options.samples, assets);
  if (!picture) return picture.error();
  return Canvas{*size, std::move(*headless), std::move(*picture)};
}

Status drawFrames(const Job& job, Canvas& canvas, const TakeFrame& take) {
  const auto simulation = job.simulation();
  if (!simulation) return simulation.error();
  sim::Game& game = (*simulation)->game();
  replay::Player player(job.replay, **simulation);
  const FrameRange& frames = job.frames;
  // So much earlier, any range of frames comes out as it does in a rendering of the whole replay.
  const std::uint32_t begin = frames.first > view::kMemoryTicks ? frames.first - view::kMemoryTicks : 0;
  if (begin > 0) {
    const Status found = player.seek(begin);
    if (!found) return found;
  }
  Progress progress("rendering", frames.last - begin);
  while (true) {
    canvas.picture->ticked(game);
    const std::uint32_t frame = player.tick();
    if (frame >= frames.first && (frame - frames.first) % job.options.every == 0) {
      canvas.picture->draw(game, {.size = {canvas.size.width, canvas.size.height}});
      const Status taken = take(canvas.picture->readBack(), frame);
      if (!taken) return taken;
    }
    progress.reached(frame - begin);
    if (isInterrupted()) return interruption();
    if (frame >= frames.last) return Done{};
    player.step();
  }
}

Status writeSound(const Job& job, const std::string& path) {
  const auto simulation = job.simulation();
  if (!simulation) return simulation.error();
  return writeSoundtrack(job.replay, **simulation, job.frames, path);
}

double seconds(const FrameRange& frames) {
  return static_cast<double>(frames.last - frames.first + 1) / sim::rules::kTickRate;
}

Status renderPictures(const Job& job) {
  const std::string& out = job.options.out;
  Result<Canvas> canvas = makeCanvas(job.options, job.assets);
  if (!canvas) return canvas.error();
  const Status folder = prepareFolder(out);
  if (!folder) return folder;
  const Status drawn = drawFrames(job, *canvas, [&](const render::Image& image, std::uint32_t frame) {
    return render::writePng(image, pictureName(out, frame));
  });
  if (!drawn) return drawn;
  std::printf("%s: %u pictures of %dx%d\n", out.c_str(), job.pictures(), canvas->size.width, canvas->size.height);
  return Done{};
}

/// A file for the time of the work.
struct Scratch {
  std::string path;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

Status drawMovie(const Job& job, Canvas& canvas, const std::string& sound) {
  const auto movie = Movie::open({job.options.out, sound, canvas.size, job.options.every});
  if (!movie) return movie.error();
  const Status drawn =
      drawFrames(job, canvas, [&](const render::Image& image, std::uint32_t) { return (*movie)->write(image); });
  return drawn ? (*movie)->close() : drawn;
}

Status renderVideo(const Job& job) {
  const std::string& out = job.options.out;
  Result<Canvas> canvas = makeCanvas(job.options, job.assets);
  if (!canvas) return canvas.error();
  const Status possible = Movie::check(out, canvas->size);
  if (!possible) return possible;
  const Scratch sound{out + ".part.wav"};
  const Status heard = writeSound(job, sound.path);
  if (!heard) return heard;
  const Status drawn = drawMovie(job, *canvas, sound.path);
  if (!drawn) return drawn;
  std::printf("%s: %.2f s, %u pictures of %dx%d\n", out.c_str(), seconds(job.frames), job.pictures(),
              canvas->size.width, canvas->size.height);
  return Done{};
}

Status renderSound(const Job& job) {
  const Status written = writeSound(job, job.options.sound);
  if (!written) return written;
  std::printf("%s: %.2f s of sound\n", job.options.sound.c_str(), seconds(job.frames));
  return Done{};
}

Result<Otherwise> otherwiseOf(const RenderOptions& options) {
  Otherwise otherwise;
  const Result<effects::EffectMask> without = effectsOf(options.without);
  if (!without) return without.error();
  otherwise.without = *without;
  if (options.accuracy.empty()) return otherwise;
  const Result<physics::Accuracy> accuracy = accuracyOf(options.accuracy);
  if (!accuracy) return accuracy.error();
  otherwise.accuracy = *accuracy;
  return otherwise;
}

}  // namespace

int render(const RenderOptions& options) {
  if (options.out.empty() && options.sound.empty())
    return refuse(
        {"--out DIR for pictures, --out FILE.mp4 for a video or --sound FILE is needed (brittle render --help)"});
  Result<replay::Replay> replay = loadReplay(options.replay);
  if (!replay) return refuse(replay.error());
  const Result<Otherwise> otherwise = otherwiseOf(options);
  if (!otherwise) return refuse(otherwise.error());
  if (const Status played = playOtherwise(*otherwise, options.replay, *replay); !played) return refuse(played.error());
  const Result<FrameRange> frames = framesOf(options.frames, replay->ticks());
  if (!frames) return refuse(frames.error());
  const auto assets = openAssets(options.assets);
  if (!assets) return refuse(assets.error());
  const Job job{options, **assets, *replay, *frames};
  catchInterrupts();
  if (!options.out.empty()) {
    const Status seen = Movie::isNamed(options.out) ? renderVideo(job) : renderPictures(job);
    if (!seen) return refuse(seen.error());
  }
  if (!options.sound.empty()) {
    const Status heard = renderSound(job);
    if (!heard) return refuse(heard.error());
  }
  return kDone;
}

}  // namespace brittle::program
