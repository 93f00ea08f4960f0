#include "engine/audio/acoustics.h"

#include "engine/effects/built.h"

namespace brittle::audio {
namespace {

constexpr bool kHasReverb = effects::isBuilt(effects::Effect::Reverb);
constexpr bool kHasEcho = effects::isBuilt(effects::Effect::Echo);

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
  if constexpr (kHasReverb)
    if (acoustics.reverb.volume > 0.0f) reverb_.emplace(acoustics.reverb);
  if constexpr (kHasEcho)
    if (acoustics.echo.volume > 0.0f) echo_.emplace(acoustics.echo);
}

void Space::process(const Block& in, Block& out) {
  if constexpr (kHasReverb)
    if (reverb_) reverb_->process(in, out);
  if constexpr (kHasEcho)
    if (echo_) echo_->process(in, out);
}

bool Space::isSilent() const {
  bool isSilent = true;
  if constexpr (kHasReverb) isSilent = isSilent && (!reverb_ || reverb_->isSilent());
  if constexpr (kHasEcho) isSilent = isSilent && (!echo_ || echo_->isSilent());
  return isSilent;
}

std::size_t Space::bytes() const {
  std::size_t bytes = 0;
  if constexpr (kHasReverb) bytes += reverb_ ? reverb_->bytes() : 0;
  if constexpr (kHasEcho) bytes += echo_ ? echo_->bytes() : 0;
  return bytes;
}

}  // namespace brittle::audio
