// replay/input_frame.h - everything the player does in one tick. The only way input reaches the simulation, so
// recording it records the game. Aim is quantised in the view's tangent plane: the picture's size and aspect never
// matter.
#pragma once

#include <cstdint>
#include <vector>

namespace brittle::replay {

/// Steps of 1/8192 of the tangent: below a tenth of a pixel at any picture size.
inline constexpr float kAimStep = 1.0f / 8192.0f;

/// A throw towards the point (x, y) of the plane one unit ahead of the camera: x to the right, y up.
struct Throw {
  std::int16_t x = 0;  // [kAimStep]
  std::int16_t y = 0;
  friend bool operator==(const Throw&, const Throw&) = default;
};

/// Use1 and its followers use what the player holds in the first place, the second ...: recordings from before there
/// was any such thing have none of these bits.
enum class Button : std::uint8_t { None = 0, Restart = 1, Pause = 2, Use1 = 4, Use2 = 8, Use3 = 16, Use4 = 32 };

inline constexpr int kUsePlaces = 4;

/// The bit that uses what is held in place `place`, from 0 to kUsePlaces - 1.
constexpr std::uint8_t useBit(int place) {
  return static_cast<std::uint8_t>(static_cast<unsigned>(Button::Use1) << place);
}

struct InputFrame {
  std::vector<Throw> throws;  // in the order they were made; at most kMaxThrows
  std::uint8_t buttons = 0;   // bits of Button
  friend bool operator==(const InputFrame&, const InputFrame&) = default;
};

inline constexpr int kMaxThrows = 8;

/// The nearest quantised aim for a tangent-plane point; clamped to the representable range of about +-4 (76 degrees).
Throw quantizeAim(float tangentX, float tangentY);

}  // namespace brittle::replay
