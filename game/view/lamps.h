// view/lamps.h - boxes that glow: they shine on the baked vertices about them and have a halo. Pure.
#pragma once

#include <vector>

#include "engine/render/bake.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

/// Brightens the vertices that face a glowing box of the look, and makes the boxes themselves bright. `mesh` is the
/// look's, in quads of four vertices as render::bake gives them. Light passes through what stands between; ambient
/// occlusion hides that it does.
void lightByLamps(const sim::SegmentLook& look, render::BakedMesh& mesh);

/// Appends the halos of the look's glowing boxes; `origin` is where the segment is.
void addHalos(const sim::SegmentLook& look, const Vec3& origin, std::vector<render::Glow>& glows);

}  // namespace brittle::view
