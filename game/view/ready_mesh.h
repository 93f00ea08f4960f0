// view/ready_mesh.h - a mesh that a segment's file carries, made fit to be drawn. Pure.
#pragma once

#include "engine/render/bake.h"
#include "game/content/baked_mesh.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

/// Its triangles are turned counter-clockwise as seen from outside the look's boxes (files do not say how theirs are
/// wound, so most of those that lie on a box decide), and those on faces that reflect stand last.
render::BakedMesh readyMesh(const content::BakedMesh& carried, const sim::SegmentLook& look);

/// Adds all of `more` to `mesh`.
void append(const render::BakedMesh& more, render::BakedMesh& mesh);

}  // namespace brittle::view
