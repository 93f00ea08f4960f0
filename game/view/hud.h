// view/hud.h - numbers and signs over the picture, from a packet's hud and what is remembered: balls, streak, distance,
// hints, what flies to and from the counter, the title and how it ended. Knows no rules.
#pragma once

#include "game/view/memory.h"

namespace brittle::view {

/// `tick` is the moment seen, which may lie between two ticks; `aspect` the picture's width over its height.
void addHud(const sim::FramePacket& packet, const Memory& memory, double tick, float aspect, render::Frame& frame,
            bool paused = false);

}  // namespace brittle::view
