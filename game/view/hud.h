// view/hud.h - numbers and signs over the picture, from a packet's hud and what is remembered: balls, streak, distance,
// hints, what flies to and from the counter, the title and how it ended. Knows no rules.
#pragma once

#include <vector>

#include "game/view/memory.h"

namespace brittle::view {

/// `tick` is the moment seen, which may lie between two ticks; `aspect` the picture's width over its height.
void addHud(const sim::FramePacket& packet, const Memory& memory, double tick, float aspect, render::Frame& frame,
            bool paused = false);

/// Where a touch uses a power-up instead of throwing. [pixels], y down
struct TouchSpot {
  float left = 0.0f, top = 0.0f, right = 0.0f, bottom = 0.0f;
};

/// Of each power-up's sign, in their places, on a picture of this size [pixels].
std::vector<TouchSpot> powerUpSpots(const sim::Hud& hud, float width, float height);

/// What a frame took, as means. [ms]
struct Timings {
  float frame = 0.0f, simulate = 0.0f, draw = 0.0f, swap = 0.0f;
  float longest = 0.0f;                // frame
  std::vector<NamedCount> heard = {};  // what the sound leaves out
};

/// Its parts as a small table in the corner.
void addTimings(const Timings& timings, render::Frame& frame);
/// Below that table: every effect that runs in a room of the packet, a line each.
void addRunning(const sim::FramePacket& packet, render::Frame& frame);
/// Beside that table: what was put off, refused or taken away, a line each.
void addOmissions(const std::vector<NamedCount>& counts, render::Frame& frame);

}  // namespace brittle::view
