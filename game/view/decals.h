// view/decals.h - pictures on surfaces: those the level has, those that scripts paint on their bodies, and the marks of
// balls that hit the room. Pure.
#pragma once

#include "game/view/memory.h"

namespace brittle::view {

/// `tick` is the moment seen.
void addDecals(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame);

}  // namespace brittle::view
