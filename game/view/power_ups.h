// view/power_ups.h - how power-ups look in the room: those that wait, the balls that carry a charge, and blasts. Pure:
// functions of the moment and of what is remembered.
#pragma once

#include "game/view/memory.h"

namespace brittle::view {

/// Of each kind; the HUD's sign, border and everything else has it too.
render::Rgb colorOf(sim::PowerUp kind);

/// Of a ball: white, or what it carries.
std::uint32_t tintOf(const sim::BallView& ball);

/// What waits turns and bobs; `time` in ticks of the game's time. `bodies` are the room's, as MeshGroup holds them.
void turnPickups(const sim::RoomView& room, double time, std::vector<Transform>& bodies);

/// The light of what waits and of charged balls.
void addPowerUps(const sim::FramePacket& packet, double time, render::Frame& frame);

/// A blast `age` ticks ago: flash, fire, sparks, smoke; `key` makes it its own. The module of explosions.
void addExplosion(const sim::Event& event, const Vec3& point, float age, std::uint64_t key, render::Frame& frame);
/// How much a blast lights up the whole picture, 0 to 1, seen from `distance` [m].
float glareOf(const sim::Event& event, float age, float distance);

inline constexpr float kBlastTicks = 110.0f;  // of its smoke

}  // namespace brittle::view
