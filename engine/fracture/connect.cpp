#include "engine/fracture/connect.h"

#include <algorithm>

#include "engine/geometry/clip.h"
#include "engine/geometry/gjk.h"

namespace brittle::fracture {

namespace {

// Faces that lean by more than a degree do not face each other. Derived: a thin gap between faces hinged at an edge
// would otherwise count as contact over slop / sin(angle). [-]
constexpr float kFacing = -0.99985f;

float mostAlong(const geometry::ConvexView& convex, const Vec3& direction) {
  float most = -3.0e38f;
  for (const geometry::Vertex& vertex : convex.vertices) most = maxOf(most, direction.dot(vertex.point));
  return most;
}

Aabb faceBox(const geometry::ConvexView& convex, const geometry::Face& face) {
  Aabb box;
  std::uint32_t edge = face.edge;
  do {
    box.include(convex.startOf(edge));
    edge = convex.edges[edge].next;
  } while (edge != face.edge);
  return box;
}

/// The faces that come near the other's box.
void facesNear(const geometry::ConvexView& convex, const Aabb& box, std::vector<std::uint32_t>& faces) {
  faces.clear();
  for (std::size_t i = 0; i < convex.faces.size(); ++i) {
    if (faceBox(convex, convex.faces[i]).overlaps(box)) faces.push_back(static_cast<std::uint32_t>(i));
  }
}

/// Area that the two faces share within `slop` of each other.
float sharedArea(const geometry::ConvexView& a, std::uint32_t faceA, const geometry::ConvexView& b, std::uint32_t faceB,
                 float slop, ConnectScratch& scratch) {
  geometry::facePolygon(a, faceA, Transform{}, scratch.polygon);
  Plane limit = b.faces[faceB].plane;
  limit.offset += slop;
  geometry::clipPolygon(limit, scratch.clip, scratch.polygon);
  limit = b.faces[faceB].plane.flipped();
  limit.offset += slop;
  geometry::clipPolygon(limit, scratch.clip, scratch.polygon);
  if (scratch.polygon.size() < 3) return 0.0f;
  geometry::clipToFace(b, faceB, Transform{}, scratch.clip, scratch.polygon);
  return scratch.polygon.size() < 3 ? 0.0f : geometry::polygonArea(scratch.polygon);
}

bool shareAFace(const geometry::ConvexView& a, const geometry::ConvexView& b, float slop, ConnectScratch& scratch) {
  facesNear(a, boxOf(b).grownBy(slop), scratch.facesA);
  facesNear(b, boxOf(a).grownBy(slop), scratch.facesB);
  const float least = 4.0f * slop * slop;
  for (const std::uint32_t faceA : scratch.facesA) {
    for (const std::uint32_t faceB : scratch.facesB) {
      if (a.faces[faceA].plane.normal.dot(b.faces[faceB].plane.normal) > kFacing) continue;
      if (sharedArea(a, faceA, b, faceB, slop, scratch) > least) return true;
    }
  }
  return false;
}

/// Levels are built from boxes that stand in each other: what overlaps deeper than the slop hangs together however it
/// is turned.
bool overlapDeeply(const geometry::ConvexView& a, const geometry::ConvexView& b, float slop) {
  if (!boxOf(a).grownBy(-slop).overlaps(boxOf(b))) return false;
  // A face that holds the other off settles most pairs without the full test.
  for (const geometry::Face& face : a.faces) {
    if (mostAlong(b, -face.plane.normal) < slop - face.plane.offset) return false;
  }
  for (const geometry::Face& face : b.faces) {
    if (mostAlong(a, -face.plane.normal) < slop - face.plane.offset) return false;
  }
  geometry::SimplexCache cache;
  return geometry::separation({a, Vec3::Zero(), 0.0f}, Transform{}, {b, Vec3::Zero(), 0.0f}, Transform{}, cache)
             .distance < -slop;
}

}  // namespace

void DisjointSets::reset(std::size_t count) {
  parent_.resize(count);
  for (std::size_t i = 0; i < count; ++i) parent_[i] = static_cast<std::uint32_t>(i);
}

std::uint32_t DisjointSets::find(std::uint32_t member) {
  while (parent_[member] != member) {
    parent_[member] = parent_[parent_[member]];
    member = parent_[member];
  }
  return member;
}

void DisjointSets::unite(std::uint32_t a, std::uint32_t b) {
  a = find(a);
  b = find(b);
  parent_[maxOf(a, b)] = minOf(a, b);
}

Aabb boxOf(const geometry::ConvexView& convex) {
  Aabb box;
  for (const geometry::Vertex& vertex : convex.vertices) box.include(vertex.point);
  return box;
}

bool areConnected(const geometry::ConvexView& a, const geometry::ConvexView& b, float slop, ConnectScratch& scratch) {
  return shareAFace(a, b, slop, scratch) || overlapDeeply(a, b, slop);
}

bool areConnected(const geometry::ConvexView& a, const geometry::ConvexView& b, float slop) {
  ConnectScratch scratch;
  return areConnected(a, b, slop, scratch);
}

void connectNodes(std::span<const Node> nodes, float slop, ConnectScratch& scratch, DisjointSets& sets) {
  scratch.order.clear();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].isUsed) scratch.order.push_back(static_cast<std::uint32_t>(i));
  }
  std::sort(scratch.order.begin(), scratch.order.end(), [&](std::uint32_t i, std::uint32_t k) {
    const float lowI = nodes[i].box.low.x(), lowK = nodes[k].box.low.x();
    return lowI != lowK ? lowI < lowK : i < k;
  });
  // Sweep along x: only boxes that begin before this one ends can touch it.
  for (std::size_t i = 0; i < scratch.order.size(); ++i) {
    const std::uint32_t a = scratch.order[i];
    const Aabb grown = nodes[a].box.grownBy(slop);
    for (std::size_t k = i + 1; k < scratch.order.size(); ++k) {
      const std::uint32_t b = scratch.order[k];
      if (nodes[b].box.low.x() > grown.high.x()) break;
      if (nodes[a].part == nodes[b].part || !grown.overlaps(nodes[b].box) || sets.find(a) == sets.find(b)) continue;
      // In the order of their numbers, so that the answer does not depend on where they lie.
      if (areConnected(nodes[minOf(a, b)].convex, nodes[maxOf(a, b)].convex, slop, scratch)) sets.unite(a, b);
    }
  }
}

void connectParts(std::span<const Part> parts, float slop, std::vector<std::uint32_t>& groupOfPart) {
  std::vector<Node> nodes;
  nodes.reserve(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    nodes.push_back({parts[i].convex, boxOf(parts[i].convex), static_cast<std::uint32_t>(i), true});
  }
  ConnectScratch scratch;
  DisjointSets sets;
  sets.reset(parts.size());
  connectNodes(nodes, slop, scratch, sets);
  groupOfPart.assign(parts.size(), 0);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const std::uint32_t lowest = sets.find(i);
    groupOfPart[i] = lowest == i ? count++ : groupOfPart[lowest];
  }
}

bool touchesAnchor(const geometry::ConvexView& convex, const Anchor& anchor, float slop, ConnectScratch& scratch) {
  if (anchor.pointCount < 3) {
    for (std::uint32_t i = 0; i < anchor.pointCount; ++i) {
      bool isWithin = true;
      for (const geometry::Face& face : convex.faces)
        isWithin = isWithin && face.plane.distance(anchor.points[i]) <= slop;
      if (isWithin) return true;
    }
    return false;
  }
  scratch.polygon.assign(anchor.points, anchor.points + anchor.pointCount);
  for (const geometry::Face& face : convex.faces) {
    Plane limit = face.plane;
    limit.offset += slop;
    geometry::clipPolygon(limit, scratch.clip, scratch.polygon);
    if (scratch.polygon.size() < 3) return false;
  }
  return geometry::polygonArea(scratch.polygon) > 4.0f * slop * slop;
}

}  // namespace brittle::fracture
