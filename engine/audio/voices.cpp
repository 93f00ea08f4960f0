#include "engine/audio/voices.h"

#include "engine/core/assert.h"

namespace brittle::audio {
namespace {

constexpr float kOne = 4294967296.0f;  // 2^32: one sample

/// Between s[0] and s[1] by a cubic through s[-1] to s[2] (Catmull-Rom); exactly s[0] at 0.
float between(const float* s, float t) {
  const float c1 = 0.5f * (s[1] - s[-1]);
  const float c2 = s[-1] - 2.5f * s[0] + 2.0f * s[1] - 0.5f * s[2];
  const float c3 = 0.5f * (s[2] - s[-1]) + 1.5f * (s[0] - s[1]);
  return ((c3 * t + c2) * t + c1) * t + s[0];
}

}  // namespace

float Voices::Voice::loudness() const {
  return def.worth * maxOf(def.left, def.right) * def.clip->loudestFrom(static_cast<std::size_t>(position >> 32));
}

bool Voices::play(const VoiceDef& def) {
  BR_ASSERT(def.clip != nullptr && isFinite(def.left) && isFinite(def.right) && isFinite(def.send * def.worth));
  BR_ASSERT(def.pitch >= 0.0625f && def.pitch <= 16.0f && def.cutoff > 0.0f);
  Voice fresh;
  fresh.def = def;
  fresh.step = onePoleStep(def.cutoff);
  Voice* quietest = nullptr;
  float least = fresh.loudness();
  for (Voice& voice : voices_) {
    if (!voice.plays()) {
      voice = fresh;
      return true;
    }
    const float loudness = voice.loudness();
    if (loudness >= least) continue;
    least = loudness;
    quietest = &voice;
  }
  if (quietest == nullptr) {
    ++refused_;
    return false;
  }
  *quietest = fresh;
  ++ended_;
  return true;
}

void Voices::render(float rate, Block& dry, Block* send) {
  for (Voice& voice : voices_)
    if (voice.plays()) voice.render(static_cast<std::uint64_t>(voice.def.pitch * rate * kOne), dry, send);
}

void Voices::Voice::render(std::uint64_t stride, Block& dry, Block* send) {
  int i = static_cast<int>(minOf(def.delay, static_cast<std::uint32_t>(kBlockFrames)));
  def.delay -= static_cast<std::uint32_t>(i);
  for (; i < kBlockFrames; ++i, position += stride) {
    const auto at = static_cast<std::size_t>(position >> 32);
    if (at >= def.clip->size()) {
      def.clip = nullptr;
      return;
    }
    const float part = static_cast<float>(static_cast<std::uint32_t>(position) >> 8) * 0x1p-24f;
    const float out = lowPass.low(between(def.clip->at(at), part), step);
    dry.left[i] += out * def.left;
    dry.right[i] += out * def.right;
    if (send == nullptr) continue;
    send->left[i] += out * def.left * def.send;
    send->right[i] += out * def.right * def.send;
  }
}

void Voices::stop() {
  voices_.fill({});
}

std::uint32_t Voices::active() const {
  std::uint32_t count = 0;
  for (const Voice& voice : voices_) count += voice.plays() ? 1 : 0;
  return count;
}

}  // namespace brittle::audio
