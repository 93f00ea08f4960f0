// fracture/connect.h - what hangs together: the test of two convexes, and the grouping of many. Chunks of one part know
// their neighbours from the cuts (see neighbours.h); this file finds those of different parts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fracture/fracture.h"
#include "engine/math/aabb.h"

namespace brittle::fracture {

/// Disjoint sets over [0, count); the representative of a set is its lowest member.
class DisjointSets {
 public:
  void reset(std::size_t count);
  std::uint32_t find(std::uint32_t member);
  void unite(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> parent_;
};

struct ConnectScratch {
  std::vector<Vec3> polygon, clip;
  std::vector<std::uint32_t> facesA, facesB;
  std::vector<std::uint32_t> order;
};

/// A convex that takes part in the grouping.
struct Node {
  geometry::ConvexView convex;
  Aabb box;
  std::uint32_t part = 0;  // nodes of one part are not tested against each other
  bool isUsed = true;
};

Aabb boxOf(const geometry::ConvexView& convex);

bool areConnected(const geometry::ConvexView& a, const geometry::ConvexView& b, float slop, ConnectScratch& scratch);

/// Unites the sets of all pairs of nodes of different parts that hang together.
void connectNodes(std::span<const Node> nodes, float slop, ConnectScratch& scratch, DisjointSets& sets);

/// True if `convex` touches the anchor: the anchor's polygon has more than (2 slop)^2 of area within `slop` of the
/// convex; for an anchor of one or two points, if one of them is within `slop` of it.
bool touchesAnchor(const geometry::ConvexView& convex, const Anchor& anchor, float slop, ConnectScratch& scratch);

}  // namespace brittle::fracture
