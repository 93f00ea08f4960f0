// geometry/split_sides.h - the signs of a split: which vertices are above, whether any plane could give such a pattern,
// and the repair if none could. Only split_impl.h and split_cap.h use it.
#pragma once

#include <limits>

#include "engine/geometry/split.h"

namespace brittle::geometry::split_detail {

inline constexpr std::uint8_t kBelow = 0;
inline constexpr std::uint8_t kAbove = 1;
inline constexpr std::uint32_t kNotCut = 0xffffffff;

/// Closest a cut vertex comes to a vertex of its edge, as a fraction of the parent's extent [-]; at most a quarter of
/// the edge. It puts caps off their planes by as much. Measured on a cube in 512 pieces: four times larger and the
/// volumes of cuts through vertices add up to 1.3e-6 only; four times smaller and half as many edges again have length
/// zero.
inline constexpr float kMoveAway = 0x1p-20f;

/// Exact scalars need no slack: no thickness, no moving away.
template <class S>
inline constexpr bool kIsExact = std::numeric_limits<S>::is_exact;

/// What a coordinate may be off by rounding: 8 units in the last place of the largest coordinate.
template <class S>
S roundingSlack(const S& reach) {
  if constexpr (kIsExact<S>) {
    return S(0);
  } else {
    return S(8) * std::numeric_limits<S>::epsilon() * reach;
  }
}

template <class S>
S absolute(const S& value) {
  return value < S(0) ? S(-value) : value;
}

/// Which side every vertex is on, and the ring of cut faces between the sides. All arrays live in the caller's scratch.
template <class S>
struct Sides {
  using Index = std::uint32_t;

  Sides(const ConvexViewT<S>& convex, SplitScratchT<S>& memory) : parent(convex), scratch(memory) {}

  std::uint8_t sideOf(Index edge) const { return scratch.sides[parent.edges[edge].vertex]; }
  Index cutCount() const { return static_cast<Index>(scratch.cut.size()); }
  bool isCut(Index face) const { return faceCut[face] != kNotCut; }

  /// Distances and sides of all vertices; the box they fill; whether both sides are thick enough.
  SplitOutcome classify(const PlaneT<S>& plane) {
    const std::size_t count = parent.vertices.size();
    scratch.distances.resize(count);
    scratch.sides.resize(count);
    Vec3T<S> low = parent.vertices[0].point;
    Vec3T<S> high = low;
    S highest = S(0);
    S lowest = S(0);
    std::size_t aboveCount = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3T<S>& point = parent.vertices[i].point;
      const S distance = plane.distance(point);
      const bool isAbove = !(distance < S(0));
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = point[axis] < low[axis] ? point[axis] : low[axis];
        high[axis] = high[axis] < point[axis] ? point[axis] : high[axis];
      }
      highest = highest < distance ? distance : highest;
      lowest = distance < lowest ? distance : lowest;
      scratch.sides[i] = isAbove ? kAbove : kBelow;
      scratch.distances[i] = distance;
      aboveCount += isAbove ? 1 : 0;
    }
    if (aboveCount == 0) return SplitOutcome::AllBelow;
    if (aboveCount == count) return SplitOutcome::AllAbove;
    extent = S(0);
    S reach = S(0);
    for (int axis = 0; axis < 3; ++axis) {
      extent = maxOf<S>(extent, high[axis] - low[axis]);
      reach = maxOf<S>(reach, maxOf<S>(absolute<S>(low[axis]), absolute<S>(high[axis])));
    }
    slack = roundingSlack<S>(reach);
    // The repair keeps the farthest vertex of either side, so this is also the thickness after it.
    const S thinnest = kIsExact<S> ? S(0) : maxOf<S>(S(kMinThickness) * extent, S(kMinThicknessOfReach) * reach);
    if (!(thinnest < highest) || !(thinnest < S(-lowest))) return SplitOutcome::TooThin;
    return SplitOutcome::Split;
  }

  /// Numbers the half-edges of both sides, then walks from cut edge to cut edge through the faces they share. True if
  /// that one walk meets every cut edge and no face twice: then, and only then, both sides are connected.
  bool walkCut() {
    const auto count = static_cast<Index>(parent.edges.size());
    edgeMap = reserveIndices();
    faceCut = edgeMap + count;
    edgeCount[0] = edgeCount[1] = 0;
    Index crossings = 0;
    Index firstUp = kNotCut;
    for (Index i = 0; i < count; ++i) {
      const Edge& edge = parent.edges[i];
      const std::uint8_t side = scratch.sides[edge.vertex];
      edgeMap[i] = edgeCount[side]++;
      const bool isUp = side < sideOf(edge.opposite);
      if (isUp && crossings++ == 0) firstUp = i;
    }
    for (Index face = 0; face < parent.faces.size(); ++face) faceCut[face] = kNotCut;
    scratch.cut.clear();
    Index up = firstUp;
    do {
      const Index face = parent.edges[up].face;
      if (faceCut[face] != kNotCut) return false;
      faceCut[face] = cutCount();
      Index down = parent.edges[up].next;
      while (sideOf(parent.edges[down].next) == kAbove) down = parent.edges[down].next;
      scratch.cut.push_back({up, down});
      up = parent.edges[down].opposite;
    } while (up != firstUp);
    return cutCount() == crossings;
  }

  /// Flips vertices until the walk succeeds; see split.cpp.
  void repair() {
    keepLargestOf(kAbove);
    keepLargestOf(kBelow);
  }

  /// After a repair: a vertex farther on the wrong side than rounding and moving away together explain would make a
  /// dent. Cut vertices lie no farther off than the ends of their edges.
  bool isTooFarOff() const {
    const S most = slack + S(kMoveAway) * extent;
    for (std::size_t i = 0; i < scratch.sides.size(); ++i) {
      const S& distance = scratch.distances[i];
      if (scratch.sides[i] == kAbove ? distance < S(-most) : most < distance) return true;
    }
    return false;
  }

  const ConvexViewT<S>& parent;
  SplitScratchT<S>& scratch;
  S extent = S(0);
  S slack = S(0);
  Index edgeCount[2] = {0, 0};  // half-edges that start on each side
  Index* edgeMap = nullptr;     // parent's half-edge -> index in the child of its start
  Index* faceCut = nullptr;  // parent's face -> which cut face it is, or kNotCut; room for 2 more maps of faces behind
                             // it, then one of vertices

 private:
  Index* reserveIndices() {
    const std::size_t size = parent.edges.size() + 3 * parent.faces.size() + parent.vertices.size();
    if (scratch.indices.size() < size) scratch.indices.resize(size);
    return scratch.indices.data();
  }

  /// Leaves on `side` only the connected part that holds its farthest vertex (ties: lowest index).
  void keepLargestOf(std::uint8_t side) {
    const Index count = static_cast<Index>(parent.vertices.size());
    Index* parents = reserveIndices();
    Index farthest = kNotCut;
    for (Index i = 0; i < count; ++i) {
      parents[i] = i;
      if (scratch.sides[i] != side) continue;
      const bool isFarther =
          farthest == kNotCut || (side == kAbove ? scratch.distances[farthest] < scratch.distances[i]
                                                 : scratch.distances[i] < scratch.distances[farthest]);
      if (isFarther) farthest = i;
    }
    for (const Edge& edge : parent.edges) {
      const Index end = parent.edges[edge.opposite].vertex;
      if (scratch.sides[edge.vertex] != side || scratch.sides[end] != side) continue;
      parents[rootOf(parents, edge.vertex)] = rootOf(parents, end);
    }
    const Index kept = rootOf(parents, farthest);
    for (Index i = 0; i < count; ++i) {
      if (scratch.sides[i] == side && rootOf(parents, i) != kept) scratch.sides[i] = kAbove - side;
    }
  }

  static Index rootOf(Index* parents, Index i) {
    while (parents[i] != i) {
      parents[i] = parents[parents[i]];
      i = parents[i];
    }
    return i;
  }
};

}  // namespace brittle::geometry::split_detail
