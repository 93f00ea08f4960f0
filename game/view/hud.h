// view/hud.h - numbers and signs over the picture, from a packet's hud and what is remembered. Knows no rules.
#pragma once

#include "game/view/memory.h"

namespace brittle::view {

/// `tick` is the moment seen, which may lie between two ticks.
void addHud(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame);

}  // namespace brittle::view
