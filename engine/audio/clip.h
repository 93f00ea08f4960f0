// audio/clip.h - a mono sound in memory, and how loud it will still get from any point on: what stealing a voice goes
// by. Made once at load, then only read, by the audio callback too.
#pragma once

#include <cstddef>
#include <vector>

namespace brittle::audio {

inline constexpr int kSampleRate = 48000;  // of everything that sounds [1/s]

using Samples = std::vector<float>;

inline std::size_t samplesIn(float seconds) {
  return seconds > 0.0f ? static_cast<std::size_t>(seconds * static_cast<float>(kSampleRate) + 0.5f) : 0;
}

class Clip {
 public:
  /// Scales `samples` so that the largest is `peak` in magnitude (silence stays silent), fades their last 5 ms out and
  /// keeps them.
  explicit Clip(const Samples& samples, float peak = 1.0f);

  std::size_t size() const { return samples_.size() - kBefore - kAfter; }
  /// Sample `i`; one before the first and three behind the last may be read and are zero. For interpolation.
  const float* at(std::size_t i) const { return samples_.data() + kBefore + i; }
  /// The largest magnitude from sample `i` on; 0 behind the end.
  float loudestFrom(std::size_t i) const { return i / kStep < loudest_.size() ? loudest_[i / kStep] : 0.0f; }
  std::size_t bytes() const { return (samples_.capacity() + loudest_.capacity()) * sizeof(float); }

 private:
  static constexpr std::size_t kBefore = 1, kAfter = 3, kStep = 256;
  Samples samples_;
  std::vector<float> loudest_;  // from the begin of each kStep samples on
};

}  // namespace brittle::audio
