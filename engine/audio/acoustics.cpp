#include "engine/audio/acoustics.h"

#include "engine/effects/has/echo.h"
#include "engine/effects/has/reverb.h"

namespace brittle::audio {
namespace {

void limit(float& value, float low, float high) {
  value = value == value ? clampTo(value, low, high) : low;
}

}  // namespace

Acoustics withinLimits(Acoustics asked) {
  limit(asked.reverb.volume, 0.0f, 1.0f);
  limit(asked.reverb.time, 0.05f, 10.0f);
  limit(asked.reverb.lowPass, 0.0f, 1.0f);
  limit(asked.echo.volume, 0.0f, 1.0f);
  limit(asked.echo.delay, 0.001f, 2.0f);
  limit(asked.echo.feedback, 0.0f, 0.95f);
  limit(asked.echo.lowPass, 0.0f, 1.0f);
  limit(asked.lowPass, 0.0f, 1.0f);
  return asked;
}

Space::Space(const Acoustics& acoustics) {
  if constexpr (effects::kHasReverb)
    if (acoustics.reverb.volume > 0.0f) reverb_.emplace(acoustics.reverb);
  if constexpr (effects::kHasEcho)
    if (acoustics.echo.volume > 0.0f) echo_.emplace(acoustics.echo);
}

void Space::process(const Block& in, Block& out) {
  if constexpr (effects::kHasReverb)
    if (reverb_) reverb_->process(in, out);
  if constexpr (effects::kHasEcho)
    if (echo_) echo_->process(in, out);
}

bool Space::isSilent() const {
  bool isSilent = true;
  if constexpr (effects::kHasReverb) isSilent = isSilent && (!reverb_ || reverb_->isSilent());
  if constexpr (effects::kHasEcho) isSilent = isSilent && (!echo_ || echo_->isSilent());
  return isSilent;
}

std::size_t Space::bytes() const {
  std::size_t bytes = 0;
  if constexpr (effects::kHasReverb) bytes += reverb_ ? reverb_->bytes() : 0;
  if constexpr (effects::kHasEcho) bytes += echo_ ? echo_->bytes() : 0;
  return bytes;
}

}  // namespace brittle::audio
