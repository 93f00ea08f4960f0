#include "engine/audio/echo.h"

#include <algorithm>

#include "engine/core/assert.h"

namespace brittle::audio {
namespace {

constexpr float kSilent = 1e-6f;  // 120 dB below full scale

}  // namespace

Echo::Echo(const EchoDef& def)
    : def_(def), step_(onePoleStep(cutoffOf(def.lowPass))), left_(samplesIn(def.delay), 0.0f), right_(left_) {
  BR_ASSERT(def.volume >= 0.0f && def.volume <= 1.0f && def.delay >= 0.001f && def.delay <= 2.0f);
  BR_ASSERT(def.feedback >= 0.0f && def.feedback <= 0.95f);
}

void Echo::process(const Block& in, Block& out) {
  const bool fed = in.peak() > 0.0f;
  if (silent_ && !fed) return;
  silent_ = false;
  float most = 0.0f;
  for (int i = 0; i < kBlockFrames; ++i) {
    const float left = lowLeft_.low(left_[at_], step_), right = lowRight_.low(right_[at_], step_);
    out.left[i] += def_.volume * left;
    out.right[i] += def_.volume * right;
    left_[at_] = in.left[i] + def_.feedback * left;
    right_[at_] = in.right[i] + def_.feedback * right;
    most = maxOf(most, maxOf(std::fabs(left_[at_]), std::fabs(right_[at_])));
    at_ = at_ + 1 == left_.size() ? 0 : at_ + 1;
  }
  quiet_ = fed || most > kSilent ? 0 : quiet_ + kBlockFrames;
  if (quiet_ <= left_.size() + kBlockFrames) return;
  std::fill(left_.begin(), left_.end(), 0.0f);
  std::fill(right_.begin(), right_.end(), 0.0f);
  lowLeft_ = lowRight_ = {};
  quiet_ = 0;
  silent_ = true;
}

}  // namespace brittle::audio
