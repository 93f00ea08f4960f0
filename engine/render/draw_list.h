// render/draw_list.h - the front end for convexes: which faces and edges of a pool are drawn, in what order. Faces
// turned away from the camera never reach the GPU. Pure: geometry in, index streams out; no GL.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/material.h"
#include "engine/render/uniforms.h"

namespace brittle::render {

/// A line between two body-local points, as the edge shader reads it.
struct EdgeInstance {
  Vec3 from, to;       // [m]
  std::uint32_t slot;  // mesh slot: body, material and tint are found through it
  float strength;      // brightness [0, 1]
};

/// What one mesh group gives: triangles as indices into the pool's vertices.
struct DrawList {
  std::vector<std::uint32_t> opaque;
  std::vector<std::uint32_t> glass;  // farthest convex first; its cut faces are in `cuts`
  std::vector<std::uint32_t> cuts;
  std::vector<EdgeInstance> edges;
  float nearestGlass = 0.0f;  // depth of the last one [m]; 0 if there is none

  void clear();
};

/// Fills `list` (cleared first) from the group's visible meshes. Convexes outside the view, or beyond `farthest` [m] of
/// depth, are left out; so are dead slots and bodies out of range. Order depends on the arguments only.
class DrawListBuilder {
 public:
  void build(const MeshGroup& group, std::span<const Material> materials, const View& view, float farthest,
             DrawList& list);

 private:
  struct Item {
    float depth;
    std::uint32_t index;  // in MeshGroup::meshes
  };
  void collect(const MeshGroup& group, std::span<const Material> materials, const View& view, float farthest);
  void findFacing(const geometry::ConvexView& convex, const Vec3& eyeLocal);
  void addFace(const geometry::ConvexView& convex, std::size_t face, std::uint32_t firstVertex,
               std::vector<std::uint32_t>& indices) const;
  void addGlass(const geometry::ConvexView& convex, std::uint32_t firstVertex, bool withBack, DrawList& list) const;
  void addEdges(const geometry::ConvexView& convex, geometry::MeshSlot slot, float brightness,
                std::vector<EdgeInstance>& edges) const;

  // Kept to avoid allocating every frame.
  std::vector<Item> opaque_, glass_;
  std::vector<std::uint8_t> facing_;  // by face of the convex at hand
};

}  // namespace brittle::render
