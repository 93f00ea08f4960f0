// view/lamps.h - the halos of boxes that glow. Pure.
#pragma once

#include <vector>

#include "engine/render/frame.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

/// Appends the halos of the look's glowing boxes; `origin` is where the segment is.
void addHalos(const sim::SegmentLook& look, const Vec3& origin, std::vector<render::Glow>& glows);

/// Whether any segment of the rooms has a lamp: without one nothing shines.
bool hasLamps(const sim::FramePacket& packet);

}  // namespace brittle::view
