// view/decals.h - pictures on the room's surfaces: those the level has, and the marks of balls that hit it. Pure.
#pragma once

#include "game/view/memory.h"

namespace brittle::view {

/// `tick` is the moment seen.
void addDecals(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame);

}  // namespace brittle::view
