// One bank for all tests, mixes in one go, and a count of allocations.
#pragma once

#include <vector>

#include "engine/audio/mixer.h"

namespace brittle::audio {

inline const Bank& bank() {
  static const Bank made;
  return made;
}

/// What a mixer gives next: left and right in turn.
inline std::vector<float> take(Mixer& mixer, double seconds) {
  std::vector<float> stereo(2 * static_cast<std::size_t>(seconds * kSampleRate));
  mixer.render(stereo);
  return stereo;
}

inline std::vector<float> leftOf(const std::vector<float>& stereo) {
  std::vector<float> left;
  for (std::size_t i = 0; i < stereo.size(); i += 2) left.push_back(stereo[i]);
  return left;
}

/// A voice of the bank, in the middle.
inline VoiceDef voiceOf(Sound sound, std::uint32_t variation = 0, float gain = 1.0f) {
  VoiceDef def;
  def.clip = &bank().clip(sound, variation);
  def.left = def.right = gain;
  return def;
}

}  // namespace brittle::audio
