#include "engine/replay/input_frame.h"

namespace brittle::replay {
namespace {

std::int16_t quantize(float tangent) {
  constexpr float limit = 32767.0f;
  const float steps = tangent / kAimStep;
  if (!(steps == steps)) return 0;  // a picture without height gives NaN: aim ahead
  const float clamped = steps < -limit ? -limit : (steps > limit ? limit : steps);
  return static_cast<std::int16_t>(clamped < 0.0f ? clamped - 0.5f : clamped + 0.5f);
}

}  // namespace

Throw quantizeAim(float tangentX, float tangentY) {
  return {quantize(tangentX), quantize(tangentY)};
}

}  // namespace brittle::replay
