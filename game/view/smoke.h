// view/smoke.h - the puffs that scripts let out. Each is a function of the moment and of a remembered event alone.
#pragma once

#include "game/view/memory.h"
#include "game/view/omission.h"

namespace brittle::view {

inline constexpr float kPuffSeconds = 2.6f;  // from its beginning until nothing is left of it; within kMemoryTicks

/// Of a puff this long after it was let out [s]: it grows as what spreads does, with the root of its age. [m]
float puffRadius(float age);
/// How far it has drifted with a speed of 1 m/s at first: the air stops it. [m]
float puffDrift(float age);
/// How much it hides. [0, 1]
float puffCover(float age);

/// `tick` is the moment seen. Adds puffs, farthest first.
void addSmoke(const sim::FramePacket& packet, const Memory& memory, double tick, Bounds& bounds, render::Frame& frame);

}  // namespace brittle::view
