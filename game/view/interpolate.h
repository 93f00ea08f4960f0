// view/interpolate.h - what is seen between two ticks: poses blended, everything else as the later tick left it. Pure:
// packets in, a packet out. Used by the scene.
#pragma once

#include "game/sim/frame_packet.h"

namespace brittle::view {

/// Fills `seen` with the picture's packet `alpha` of the way from `before` to `now`, in the frame of `now`. 1 is `now`
/// itself, bit for bit; 0 puts everything that was there before where it was. What is new (another generation of a
/// body, a ball just thrown, a crumb in another's place) stands where `now` has it. Packets that are not one tick apart
/// are not blended.
void interpolate(const sim::FramePacket& before, const sim::FramePacket& now, float alpha, sim::FramePacket& seen);

}  // namespace brittle::view
