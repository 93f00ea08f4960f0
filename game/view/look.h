// view/look.h - how the game's things look: a draw material per sim::Look, and segments as baked meshes. No GL, no game
// state.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/bake.h"
#include "engine/render/material.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

/// The material table, indexed by sim::Look.
std::vector<render::Material> materials();

/// Which of a segment's boxes become triangles.
enum class Baked : std::uint8_t {
  All,
  Stones  // what a mesh that the segment's file carries leaves out; the others shade it
};

/// Makes a segment's boxes triangles in the segment's frame, with the light of its faces and lamps and ambient
/// occlusion in the vertices. The same look gives the same mesh.
render::Baker bakerOf(const sim::SegmentLook& look, Baked baked = Baked::All);

}  // namespace brittle::view
