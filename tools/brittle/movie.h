// brittle/movie.h - frames and a sound file to a video (MP4: H.264 and AAC). The frames go to ffmpeg as they come; the
// file appears under its name only when it is complete.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/render/capture.h"
#include "tools/brittle/child.h"
#include "tools/brittle/options.h"

namespace brittle::program {

struct MovieDef {
  std::string path;         // ends in .mp4
  std::string sound;        // a WAV file that is complete
  Size size;                // even sides
  std::uint32_t every = 1;  // ticks from one frame to the next
};

class Movie {
 public:
  /// Whether `path` asks for a video and not for a folder of pictures.
  static bool isNamed(const std::string& path);
  /// What would make open() fail, before the work begins: no ffmpeg, a size it cannot encode, a path that cannot be
  /// written.
  static Status check(const std::string& path, const Size& size);

  static Result<std::unique_ptr<Movie>> open(const MovieDef& def);
  /// Without close() nothing is left behind.
  ~Movie();
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  Status write(const render::Image& frame);
  Status close();

 private:
  Movie(std::string path, std::unique_ptr<Child> encoder) : path_(std::move(path)), encoder_(std::move(encoder)) {}

  std::string path_;
  std::unique_ptr<Child> encoder_;
};

}  // namespace brittle::program
