// view/air.h - what hangs in a room's air: dust, bubbles, stars, as its script asks by mgParticles. A function of the
// moment and the camera's place alone.
#pragma once

#include "engine/render/frame.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

/// `tick` is the moment seen. Nothing where the room's script asks for nothing; a name that is not known is dust.
void addAir(const sim::FramePacket& packet, double tick, render::Frame& frame);

}  // namespace brittle::view
