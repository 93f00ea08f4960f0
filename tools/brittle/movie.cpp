#include "tools/brittle/movie.h"

#include <filesystem>
#include <system_error>

#include "engine/core/file.h"
#include "game/sim/constants.h"

namespace brittle::program {
namespace {

constexpr const char* kPackage = "ffmpeg";

std::string partOf(const std::string& path) {
  return path + ".part";
}

/// As ffmpeg wants a file: without the prefix a dash begins an option and a colon ends a protocol.
std::string fileUrl(const std::string& path) {
  return "file:" + path;
}

std::vector<std::string> commandFor(const MovieDef& def) {
  std::vector<std::string> words = {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y"};
  const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
  add({"-f", "rawvideo", "-pixel_format", "rgba"});
  add({"-video_size", std::to_string(def.size.width) + "x" + std::to_string(def.size.height)});
  add({"-framerate", std::to_string(sim::rules::kTickRate) + "/" + std::to_string(def.every), "-i", "pipe:0"});
  add({"-i", fileUrl(def.sound), "-map", "0:v", "-map", "1:a"});
  // Said in the file as well, or players take the colours of small pictures for those of old television.
  add({"-vf", "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"});
  add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv"});
  add({"-c:v", "libx264", "-crf", "18", "-c:a", "aac", "-b:a", "192k"});
  add({"-movflags", "+faststart", "-f", "mp4", fileUrl(partOf(def.path))});
  return words;
}

}  // namespace

bool Movie::isNamed(const std::string& path) {
  return path.ends_with(".mp4");
}

Status Movie::check(const std::string& path, const Size& size) {
  if (size.width % 2 != 0 || size.height % 2 != 0)
    return Error{"--size " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                 ": a video needs even sides, like 640x360"};
  auto asked = Child::start({"ffmpeg", "-version"}, kPackage);
  if (!asked) return asked.error();
  const Status answered = (*asked)->end();
  return answered ? checkWritable(path) : answered;
}

Result<std::unique_ptr<Movie>> Movie::open(const MovieDef& def) {
  auto encoder = Child::start(commandFor(def), kPackage);
  if (!encoder) return encoder.error();
  return std::unique_ptr<Movie>(new Movie(def.path, std::move(*encoder)));
}

Movie::~Movie() {
  if (encoder_ == nullptr) return;
  encoder_.reset();  // first, or it would go on writing
  std::error_code ignored;
  std::filesystem::remove(partOf(path_), ignored);
}

Status Movie::write(const render::Image& frame) {
  if (encoder_->write(frame.pixels)) return Done{};
  const Status ended = encoder_->end();
  return errorAt(path_, 0, ended ? "ffmpeg ended before the last frame" : ended.error().message);
}

Status Movie::close() {
  const Status ended = encoder_->end();
  if (!ended) return errorAt(path_, 0, ended.error().message);
  std::error_code problem;
  std::filesystem::rename(partOf(path_), path_, problem);
  if (problem) return errorAt(path_, 0, "cannot be replaced: " + problem.message());
  encoder_.reset();
  return Done{};
}

}  // namespace brittle::program
