// view/lasers.h - lasers as they are seen: the beam, the light at its ends, sparks where it meets something. A function
// of the moment and the packet alone.
#pragma once

#include "engine/render/frame.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

/// `tick` is the moment seen. Adds lasers, glows and beams.
void addLasers(const sim::FramePacket& packet, double tick, render::Frame& frame);

}  // namespace brittle::view
