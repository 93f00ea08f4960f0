// audio/wav.h - a stereo sound file of 16 bits, written as it comes. The file appears under its name only when it is
// complete.
#pragma once

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

#include "engine/core/result.h"

namespace brittle::audio {

class WavWriter {
 public:
  /// Tries the path before the work begins.
  static Result<WavWriter> open(const std::string& path);
  WavWriter(WavWriter&& other) noexcept;
  WavWriter& operator=(WavWriter&&) = delete;
  /// Without close() nothing is left behind.
  ~WavWriter();

  /// Left and right in turn, in [-1, 1]; beyond that they are clipped.
  void write(std::span<const float> samples);
  Status close();

 private:
  WavWriter(std::string path, std::FILE* file) : path_(std::move(path)), file_(file) {}
  void writeHeader();
  std::string partPath() const { return path_ + ".part"; }

  std::string path_;
  std::FILE* file_ = nullptr;
  std::uint64_t dataBytes_ = 0;
  bool failed_ = false;
};

}  // namespace brittle::audio
