#include "engine/audio/reverb.h"

#include <cmath>

#include "engine/core/assert.h"
#include "engine/math/trig.h"

namespace brittle::audio {
namespace {

// At full size, without common factors; the shortest is as long as sound takes for 7 m. [samples]
constexpr std::size_t kLengths[] = {1021, 1187, 1361, 1523, 1709, 1907, 2129, 2333};
constexpr std::size_t kDiffusers[2][2] = {{241, 373}, {263, 347}};
// How the left and the right go into the lines: at right angles, so that each reaches both sides from the start.
constexpr float kLeftIn[] = {1, 1, -1, -1, 1, 1, -1, -1}, kRightIn[] = {1, -1, -1, 1, 1, -1, -1, 1};
constexpr float kRootOfLines = 2.8284271f;
constexpr float kDiffusion = 0.6f;
constexpr float kHighs = 0.5f;    // of the decay time, at the highest frequency
constexpr float kSilent = 1e-6f;  // 120 dB below full scale

/// Short decays are those of small rooms.
std::size_t scaled(std::size_t length, float time) {
  return static_cast<std::size_t>(static_cast<float>(length) * clampTo(0.35f + 0.65f * time, 0.35f, 1.0f)) | 1;
}

/// What is left after `samples` of a decay by 60 dB in `time`.
float leftAfter(std::size_t samples, float time) {
  return exponential(-6.9077553f * static_cast<float>(samples) / (time * static_cast<float>(kSampleRate)));
}

/// Hadamard's matrix times `v`, but for a factor of the root of 8: energy stays, and every line feeds every other.
void mixLines(float (&v)[8]) {
  for (std::size_t half = 1; half < 8; half *= 2) {
    for (std::size_t i = 0; i < 8; ++i) {
      if ((i & half) != 0) continue;
      const float a = v[i], b = v[i + half];
      v[i] = a + b;
      v[i + half] = a - b;
    }
  }
}

}  // namespace

float Reverb::Diffuser::process(float in) {
  const float held = delay.read();
  const float fed = in - kDiffusion * held;
  delay.write(fed);
  return held + kDiffusion * fed;
}

Reverb::Reverb(const ReverbDef& def) : color_(onePoleStep(cutoffOf(def.lowPass))) {
  BR_ASSERT(def.volume >= 0.0f && def.volume <= 1.0f && def.time >= 0.05f && def.time <= 10.0f);
  float lost = 0.0f;
  for (std::size_t i = 0; i < kLines; ++i) {
    Line& line = lines_[i];
    const std::size_t length = scaled(kLengths[i], def.time);
    line.delay.samples.assign(length, 0.0f);
    line.gain = leftAfter(length, def.time);
    // A one-pole of this step passes step / (2 - step) of the highest frequency.
    const float high = leftAfter(length, def.time * kHighs) / line.gain;
    line.step = 2.0f * high / (1.0f + high);
    longest_ = maxOf(longest_, length);
    lost += 1.0f / (line.gain * line.gain) - 1.0f;
  }
  // Energy in a loop that keeps g^2 per pass adds up to g^2 / (1 - g^2), and a quarter of it comes out.
  gain_ = 2.0f * def.volume * std::sqrt(lost / static_cast<float>(kLines));
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t i = 0; i < 2; ++i)
      diffusers_[side][i].delay.samples.assign(scaled(kDiffusers[side][i], def.time), 0.0f);
}

/// One sample through the network; returns the largest number that was written.
float Reverb::step(float left, float right, float& outLeft, float& outRight) {
  for (Diffuser& diffuser : diffusers_[0]) left = diffuser.process(left);
  for (Diffuser& diffuser : diffusers_[1]) right = diffuser.process(right);
  float out[kLines], most = 0.0f;
  for (std::size_t i = 0; i < kLines; ++i)
    out[i] = lines_[i].damping.low(lines_[i].delay.read() * lines_[i].gain, lines_[i].step);
  outLeft = 0.5f * ((out[0] - out[2]) + (out[4] - out[6]));
  outRight = 0.5f * ((out[1] - out[3]) + (out[5] - out[7]));
  mixLines(out);
  for (std::size_t i = 0; i < kLines; ++i) {
    const float fed = (out[i] + kLeftIn[i] * left + kRightIn[i] * right) / kRootOfLines;
    lines_[i].delay.write(fed);
    most = maxOf(most, std::fabs(fed));
  }
  return most;
}

void Reverb::process(const Block& in, Block& out) {
  const bool fed = in.peak() > 0.0f;
  if (silent_ && !fed) return;
  silent_ = false;
  float most = 0.0f;
  for (int i = 0; i < kBlockFrames; ++i) {
    float left = 0.0f, right = 0.0f;
    most = maxOf(most, step(colorLeft_.low(in.left[i], color_), colorRight_.low(in.right[i], color_), left, right));
    out.left[i] += gain_ * left;
    out.right[i] += gain_ * right;
  }
  quiet_ = fed || most > kSilent ? 0 : quiet_ + kBlockFrames;
  if (quiet_ > longest_) rest();
}

void Reverb::rest() {
  for (Line& line : lines_) {
    line.delay.samples.assign(line.delay.samples.size(), 0.0f);
    line.damping = {};
  }
  for (auto& side : diffusers_)
    for (Diffuser& diffuser : side) diffuser.delay.samples.assign(diffuser.delay.samples.size(), 0.0f);
  colorLeft_ = colorRight_ = {};
  quiet_ = 0;
  silent_ = true;
}

std::size_t Reverb::bytes() const {
  std::size_t sum = 0;
  for (const Line& line : lines_) sum += line.delay.samples.size() * sizeof(float);
  for (const auto& side : diffusers_)
    for (const Diffuser& diffuser : side) sum += diffuser.delay.samples.size() * sizeof(float);
  return sum;
}

}  // namespace brittle::audio
