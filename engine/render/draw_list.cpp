#include "engine/render/draw_list.h"

#include <algorithm>

#include "engine/math/aabb.h"

namespace brittle::render {

namespace {

// Edges flatter than this are facets of one smooth surface and not drawn: the cosine of about 11 and 45 degrees. Chosen
// by eye.
constexpr float kFlatCut = 0.98f;
constexpr float kFlatSurface = 0.70f;
// Brightness of the edges something was made with, and of those seen through the glass, relative to a fresh cut. Chosen
// by eye.
constexpr float kSurfaceEdge = 0.40f;
constexpr float kHiddenEdge = 0.30f;
// Glass less clear than this shows its far faces, too: they give it a body. Through clearer glass they would not be
// noticed.
constexpr float kShowsBack = 0.7f;

const Material& materialOf(const VisibleMesh& mesh, std::span<const Material> materials) {
  return materials[minOf<std::size_t>(mesh.material, materials.size() - 1)];
}

}  // namespace

void DrawList::clear() {
  opaque.clear();
  glass.clear();
  cuts.clear();
  edges.clear();
  nearestGlass = 0.0f;
}

void DrawListBuilder::collect(const MeshGroup& group, std::span<const Material> materials, const View& view,
                              float farthest) {
  opaque_.clear();
  glass_.clear();
  for (std::size_t i = 0; i < group.meshes.size(); ++i) {
    const VisibleMesh& mesh = group.meshes[i];
    if (!group.pool->isAlive(mesh.slot) || mesh.body >= group.bodies.size()) continue;
    Aabb box;
    for (const geometry::Vertex& vertex : group.pool->view(mesh.slot).vertices) box.include(vertex.point);
    const Vec3 center = group.bodies[mesh.body].toWorld(box.center());
    if (!view.sees(center, 0.5f * box.extent().norm(), farthest)) continue;
    std::vector<Item>& items = materialOf(mesh, materials).look == Look::Glass ? glass_ : opaque_;
    items.push_back({view.depthOf(center), static_cast<std::uint32_t>(i)});
  }
  // Ties keep the frame's order, so a picture never depends on the sort.
  const auto isNearer = [](const Item& a, const Item& b) { return a.depth < b.depth; };
  const auto isFarther = [](const Item& a, const Item& b) { return a.depth > b.depth; };
  std::stable_sort(opaque_.begin(), opaque_.end(), isNearer);
  std::stable_sort(glass_.begin(), glass_.end(), isFarther);
}

void DrawListBuilder::findFacing(const geometry::ConvexView& convex, const Vec3& eyeLocal) {
  facing_.clear();
  for (const geometry::Face& face : convex.faces) facing_.push_back(face.plane.distance(eyeLocal) > 0.0f ? 1 : 0);
}

void DrawListBuilder::addFace(const geometry::ConvexView& convex, std::size_t face, std::uint32_t firstVertex,
                              std::vector<std::uint32_t>& indices) const {
  const std::uint16_t first = convex.faces[face].edge;
  const geometry::Edge* edge = &convex.edges[convex.edges[first].next];
  while (edge->next != first) {
    indices.push_back(firstVertex + convex.edges[first].vertex);
    indices.push_back(firstVertex + edge->vertex);
    indices.push_back(firstVertex + convex.edges[edge->next].vertex);
    edge = &convex.edges[edge->next];
  }
}

void DrawListBuilder::addGlass(const geometry::ConvexView& convex, std::uint32_t firstVertex, bool withBack,
                               DrawList& list) const {
  for (std::size_t f = 0; f < convex.faces.size() && withBack; ++f)
    if (facing_[f] == 0) addFace(convex, f, firstVertex, list.glass);
  for (std::size_t f = 0; f < convex.faces.size(); ++f)
    if (facing_[f] != 0)
      addFace(convex, f, firstVertex, convex.faces[f].kind == geometry::FaceKind::Cut ? list.cuts : list.glass);
}

void DrawListBuilder::addEdges(const geometry::ConvexView& convex, geometry::MeshSlot slot, float brightness,
                               std::vector<EdgeInstance>& edges) const {
  for (std::size_t e = 0; e < convex.edges.size(); ++e) {
    const geometry::Edge& edge = convex.edges[e];
    if (edge.opposite < e) continue;  // its twin was here
    const geometry::Face& a = convex.faces[edge.face];
    const geometry::Face& b = convex.faces[convex.edges[edge.opposite].face];
    const bool isCut = a.kind == geometry::FaceKind::Cut || b.kind == geometry::FaceKind::Cut;
    if (a.plane.normal.dot(b.plane.normal) > (isCut ? kFlatCut : kFlatSurface)) continue;
    const bool isHidden = facing_[edge.face] == 0 && facing_[convex.edges[edge.opposite].face] == 0;
    const float strength = brightness * (isCut ? 1.0f : kSurfaceEdge) * (isHidden ? kHiddenEdge : 1.0f);
    edges.push_back(
        {convex.startOf(static_cast<std::uint32_t>(e)), convex.endOf(static_cast<std::uint32_t>(e)), slot, strength});
  }
}

void DrawListBuilder::build(const MeshGroup& group, std::span<const Material> materials, const View& view,
                            float farthest, DrawList& list) {
  list.clear();
  collect(group, materials, view, farthest);
  const auto add = [&](const Item& item, bool isGlass) {
    const VisibleMesh& mesh = group.meshes[item.index];
    const Material& material = materialOf(mesh, materials);
    const geometry::ConvexView convex = group.pool->view(mesh.slot);
    const std::uint32_t firstVertex = group.pool->info(mesh.slot).vertices.first;
    findFacing(convex, group.bodies[mesh.body].toLocal(view.eye));
    if (isGlass) addGlass(convex, firstVertex, material.clarity < kShowsBack, list);
    for (std::size_t f = 0; f < convex.faces.size() && !isGlass; ++f)
      if (facing_[f] != 0) addFace(convex, f, firstVertex, list.opaque);
    if (material.edge > 0.0f) addEdges(convex, mesh.slot, material.edge, list.edges);
  };
  for (const Item& item : opaque_) add(item, false);
  for (const Item& item : glass_) add(item, true);
  if (!glass_.empty()) list.nearestGlass = glass_.back().depth;
}

}  // namespace brittle::render
