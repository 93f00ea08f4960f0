// geometry/split_impl.h - the body of split.h's template. Include it only to instantiate it for another scalar (tests
// and the accuracy study do, with exact rationals); float and double are instantiated in split.cpp. How it works is
// told there.
#pragma once

#include <cmath>
#include <limits>

#include "engine/core/assert.h"
#include "engine/geometry/convex_impl.h"
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

/// Colours between a (0) and b (256), channel by channel.
std::uint32_t mixColor(std::uint32_t a, std::uint32_t b, std::uint32_t weight);
/// Shading normals between two packed ones; none if either is none.
std::uint32_t mixNormal(std::uint32_t a, std::uint32_t b, float weight);

/// Six times the volume of each side, summed over fans of triangles as seen from `origin`.
struct Volumes {
  template <class S>
  explicit Volumes(const Vec3T<S>& from) : origin(toDouble(from)) {}

  template <class S>
  void startFan(const Vec3T<S>& point) {
    apex = toDouble(point) - origin;
    count = 0;
  }
  template <class S>
  void addCorner(std::uint8_t side, const Vec3T<S>& point) {
    const Vec3d corner = toDouble(point) - origin;
    if (count++ > 0) {
      six[side] += (apex.x() * (previous.y() * corner.z() - previous.z() * corner.y()) +
                    apex.y() * (previous.z() * corner.x() - previous.x() * corner.z())) +
                   apex.z() * (previous.x() * corner.y() - previous.y() * corner.x());
    }
    previous = corner;
  }
  template <class S>
  static Vec3d toDouble(const Vec3T<S>& point) {
    return Vec3d(static_cast<double>(point.x()), static_cast<double>(point.y()), static_cast<double>(point.z()));
  }

  double six[2] = {0.0, 0.0};
  Vec3d origin;
  Vec3d apex;
  Vec3d previous;
  int count = 0;
};

/// One split under way. All arrays live in the caller's scratch.
template <class S>
class Splitter {
 public:
  Splitter(const ConvexViewT<S>& parent, const PlaneT<S>& plane, CutMark mark, SplitScratchT<S>& scratch)
      : parent_(parent), plane_(plane), mark_(mark), scratch_(scratch) {}

  SplitOutcome run(ConvexT<S>& above, ConvexT<S>& below) {
    const SplitOutcome outcome = classify();
    if (outcome != SplitOutcome::Split) return outcome;
    bool repaired = false;
    if (!walkCut()) {
      repairSides();
      repaired = true;
      const bool isOneLoop = walkCut();
      BR_ASSERT(isOneLoop && "split needs a 3-connected parent");
    }
    if (repaired && isTooFarOff()) return SplitOutcome::TooFarOff;
    if (!fitsIndices()) return SplitOutcome::TooManyIndices;
    makeCutVertices();
    if (!haveVolume()) return SplitOutcome::TooThin;
    writeVertices(above, below);
    writeFaces(above, below);
    writeEdges(above, below);
    writeCap(above, nA(), true);
    writeCap(below, nB(), false);
    return SplitOutcome::Split;
  }

 private:
  using Index = std::uint32_t;
  using CutFace = typename SplitScratchT<S>::CutFace;

  std::uint8_t sideOf(Index edge) const { return scratch_.sides[parent_.edges[edge].vertex]; }
  Index cutCount() const { return static_cast<Index>(scratch_.cut.size()); }
  Index nA() const { return edgeCount_[kAbove]; }
  Index nB() const { return edgeCount_[kBelow]; }

  /// Distances and sides of all vertices; the box they fill; whether both sides are thick enough.
  SplitOutcome classify() {
    const std::size_t count = parent_.vertices.size();
    scratch_.distances.resize(count);
    scratch_.sides.resize(count);
    Vec3T<S> low = parent_.vertices[0].point;
    Vec3T<S> high = low;
    S highest = S(0);
    S lowest = S(0);
    std::size_t aboveCount = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3T<S>& point = parent_.vertices[i].point;
      const S distance = plane_.distance(point);
      const bool isAbove = !(distance < S(0));
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = point[axis] < low[axis] ? point[axis] : low[axis];
        high[axis] = high[axis] < point[axis] ? point[axis] : high[axis];
      }
      highest = highest < distance ? distance : highest;
      lowest = distance < lowest ? distance : lowest;
      scratch_.sides[i] = isAbove ? kAbove : kBelow;
      scratch_.distances[i] = distance;
      aboveCount += isAbove ? 1 : 0;
    }
    if (aboveCount == 0) return SplitOutcome::AllBelow;
    if (aboveCount == count) return SplitOutcome::AllAbove;
    extent_ = S(0);
    S reach = S(0);
    for (int axis = 0; axis < 3; ++axis) {
      extent_ = maxOf<S>(extent_, high[axis] - low[axis]);
      reach = maxOf<S>(reach, maxOf<S>(absolute<S>(low[axis]), absolute<S>(high[axis])));
    }
    slack_ = roundingSlack<S>(reach);
    // The repair keeps the farthest vertex of either side, so this is also the thickness after it.
    const S thinnest = kIsExact<S> ? S(0) : maxOf<S>(S(kMinThickness) * extent_, S(kMinThicknessOfReach) * reach);
    if (!(thinnest < highest) || !(thinnest < S(-lowest))) return SplitOutcome::TooThin;
    return SplitOutcome::Split;
  }

  /// Numbers the half-edges of both sides, then walks from cut edge to cut edge through the faces they share. True if
  /// that one walk meets every cut edge and no face twice: then, and only then, both sides are connected.
  bool walkCut() {
    const Index count = static_cast<Index>(parent_.edges.size());
    edgeMap_ = reserveIndices(count);
    faceCut_ = edgeMap_ + count;
    edgeCount_[0] = edgeCount_[1] = 0;
    Index crossings = 0;
    Index firstUp = kNotCut;
    for (Index i = 0; i < count; ++i) {
      const Edge& edge = parent_.edges[i];
      const std::uint8_t side = scratch_.sides[edge.vertex];
      edgeMap_[i] = edgeCount_[side]++;
      const bool isUp = side < sideOf(edge.opposite);
      if (isUp && crossings++ == 0) firstUp = i;
    }
    for (Index face = 0; face < parent_.faces.size(); ++face) faceCut_[face] = kNotCut;
    scratch_.cut.clear();
    Index up = firstUp;
    do {
      const Index face = parent_.edges[up].face;
      if (faceCut_[face] != kNotCut) return false;
      faceCut_[face] = cutCount();
      Index down = parent_.edges[up].next;
      while (sideOf(parent_.edges[down].next) == kAbove) down = parent_.edges[down].next;
      scratch_.cut.push_back({up, down});
      up = parent_.edges[down].opposite;
    } while (up != firstUp);
    return cutCount() == crossings;
  }

  Index* reserveIndices(Index edgeCount) {
    const std::size_t size = edgeCount + 3 * parent_.faces.size() + parent_.vertices.size();
    if (scratch_.indices.size() < size) scratch_.indices.resize(size);
    return scratch_.indices.data();
  }

  void repairSides() {
    keepLargestOf(kAbove);
    keepLargestOf(kBelow);
  }

  /// Leaves on `side` only the connected part that holds its farthest vertex (ties: lowest index).
  void keepLargestOf(std::uint8_t side) {
    const Index count = static_cast<Index>(parent_.vertices.size());
    Index* parents = reserveIndices(static_cast<Index>(parent_.edges.size()));
    Index farthest = kNotCut;
    for (Index i = 0; i < count; ++i) {
      parents[i] = i;
      if (scratch_.sides[i] != side) continue;
      const bool isFarther =
          farthest == kNotCut || (side == kAbove ? scratch_.distances[farthest] < scratch_.distances[i]
                                                 : scratch_.distances[i] < scratch_.distances[farthest]);
      if (isFarther) farthest = i;
    }
    for (const Edge& edge : parent_.edges) {
      const Index end = parent_.edges[edge.opposite].vertex;
      if (scratch_.sides[edge.vertex] != side || scratch_.sides[end] != side) continue;
      parents[rootOf(parents, edge.vertex)] = rootOf(parents, end);
    }
    const Index kept = rootOf(parents, farthest);
    for (Index i = 0; i < count; ++i) {
      if (scratch_.sides[i] == side && rootOf(parents, i) != kept) scratch_.sides[i] = kAbove - side;
    }
  }

  static Index rootOf(Index* parents, Index i) {
    while (parents[i] != i) {
      parents[i] = parents[parents[i]];
      i = parents[i];
    }
    return i;
  }

  bool fitsIndices() const { return maxOf(nA(), nB()) + 3 * cutCount() <= kMaxHalfEdges; }

  void makeCutVertices() {
    scratch_.caps.resize(cutCount());
    for (Index i = 0; i < cutCount(); ++i) {
      const Edge& up = parent_.edges[scratch_.cut[i].up];
      scratch_.caps[i] = cutVertex(up.vertex, parent_.edges[up.opposite].vertex);
    }
  }

  /// Where the plane meets the edge from `low` to `high`: measured from the nearer end, so that it stays between the
  /// two bit for bit (half an edge, rounded, cannot reach past the other end), and not too near to it.
  VertexT<S> cutVertex(Index low, Index high) const {
    const S drop = scratch_.distances[low] - scratch_.distances[high];
    S fraction = drop < S(0) || S(0) < drop ? S(scratch_.distances[low] / drop) : S(0);
    const bool fromLow = !(S(0.5) < fraction);
    const VertexT<S>& near = parent_.vertices[fromLow ? low : high];
    const VertexT<S>& far = parent_.vertices[fromLow ? high : low];
    if (!fromLow) fraction = S(-scratch_.distances[high]) / drop;
    if (fraction < S(0)) fraction = S(0);  // a repaired end may lie on the wrong side
    Vec3T<S> along(far.point.x() - near.point.x(), far.point.y() - near.point.y(), far.point.z() - near.point.z());
    fraction = movedAway(fraction, along);
    VertexT<S> vertex = near;
    for (int i = 0; i < 3; ++i) vertex.point[i] = near.point[i] + fraction * along[i];
    if (near.color != far.color) {
      vertex.color = mixColor(near.color, far.color, static_cast<std::uint32_t>(static_cast<float>(fraction) * 256.0f));
    }
    if (near.normal != far.normal) vertex.normal = mixNormal(near.normal, far.normal, static_cast<float>(fraction));
    return vertex;
  }

  S movedAway(const S& fraction, const Vec3T<S>& along) const {
    if constexpr (!kIsExact<S>) {
      const S least = S(kMoveAway) * extent_;
      const S longestSide = maxOf<S>(maxOf<S>(absolute<S>(along[0]), absolute<S>(along[1])), absolute<S>(along[2]));
      if (!(fraction * longestSide < least)) return fraction;
      const S length = std::sqrt((along[0] * along[0] + along[1] * along[1]) + along[2] * along[2]);
      const S smallest = S(4) * least < length ? S(least / length) : S(0.25);
      return maxOf<S>(fraction, smallest);
    }
    return fraction;
  }

  /// After a repair: a vertex farther on the wrong side than rounding and moving away explain would make a dent. Cut
  /// vertices lie no farther off than the ends of their edges.
  bool isTooFarOff() const {
    const S most = maxOf<S>(slack_, S(kMoveAway) * extent_);
    for (std::size_t i = 0; i < scratch_.sides.size(); ++i) {
      const S& distance = scratch_.distances[i];
      if (scratch_.sides[i] == kAbove ? distance < S(-most) : most < distance) return true;
    }
    return false;
  }

  /// Whether both sides have a positive volume, over the triangles massOf sums: fans from each face's first half-edge.
  /// Where a piece is thinner than its caps are off their planes, it may have none although it reaches far from the
  /// cut.
  bool haveVolume() const {
    if constexpr (kIsExact<S>) return true;
    Volumes volumes(scratch_.caps[0].point);  // the caps are fans from this point, and add nothing
    for (Index face = 0; face < parent_.faces.size(); ++face) {
      if (faceCut_[face] != kNotCut) continue;
      const Index first = parent_.faces[face].edge;
      volumes.startFan(parent_.startOf(first));
      Index edge = parent_.edges[first].next;
      for (; edge != first; edge = parent_.edges[edge].next) volumes.addCorner(sideOf(edge), parent_.startOf(edge));
    }
    for (Index i = 0; i < cutCount(); ++i) {
      const Index after = i + 1 == cutCount() ? 0 : i + 1;
      const CutFace& cut = scratch_.cut[i];
      addPart(volumes, kAbove, after, i, cut.up, cut.down);
      addPart(volumes, kBelow, i, after, cut.down, cut.up);
    }
    return volumes.six[kBelow] > 0.0 && volumes.six[kAbove] > 0.0;
  }

  /// The part of a cut face on one side: from where `leaving` is cut over where `entering` is cut and on along the
  /// loop.
  void addPart(Volumes& volumes, std::uint8_t side, Index exit, Index entry, Index entering, Index leaving) const {
    volumes.startFan(scratch_.caps[exit].point);
    volumes.addCorner(side, scratch_.caps[entry].point);
    Index edge = entering;
    do {
      edge = parent_.edges[edge].next;
      volumes.addCorner(side, parent_.startOf(edge));
    } while (edge != leaving);
  }

  // No coordinates are computed beyond this point: topology only.

  void writeVertices(ConvexT<S>& above, ConvexT<S>& below) {
    const Index count = static_cast<Index>(parent_.vertices.size());
    vertexMap_ = faceCut_ + 3 * parent_.faces.size();
    Index next[2] = {0, 0};
    for (Index i = 0; i < count; ++i) vertexMap_[i] = next[scratch_.sides[i]]++;
    capStart_[kBelow] = next[kBelow];
    capStart_[kAbove] = next[kAbove];
    above.vertices.resize(next[kAbove] + cutCount());
    below.vertices.resize(next[kBelow] + cutCount());
    for (Index i = 0; i < count; ++i) {
      ConvexT<S>& child = scratch_.sides[i] == kAbove ? above : below;
      child.vertices[vertexMap_[i]] = parent_.vertices[i];
    }
    for (Index i = 0; i < cutCount(); ++i) {
      above.vertices[next[kAbove] + i] = scratch_.caps[i];
      below.vertices[next[kBelow] + i] = scratch_.caps[i];
    }
  }

  /// Faces keep their order, plane and mark; a cut face goes to both, entered by its new edge. The caps come last.
  void writeFaces(ConvexT<S>& above, ConvexT<S>& below) {
    const Index count = static_cast<Index>(parent_.faces.size());
    faceMap_[kBelow] = faceCut_ + count;
    faceMap_[kAbove] = faceMap_[kBelow] + count;
    Index next[2] = {0, 0};
    for (Index i = 0; i < count; ++i) {
      const bool isCut = faceCut_[i] != kNotCut;
      const std::uint8_t side = sideOf(parent_.faces[i].edge);
      for (const std::uint8_t s : {kBelow, kAbove}) {
        if (isCut || s == side) faceMap_[s][i] = next[s]++;
      }
    }
    above.faces.resize(next[kAbove] + 1);
    below.faces.resize(next[kBelow] + 1);
    for (Index i = 0; i < count; ++i) {
      const bool isCut = faceCut_[i] != kNotCut;
      const std::uint8_t side = sideOf(parent_.faces[i].edge);
      for (const std::uint8_t s : {kBelow, kAbove}) {
        if (!isCut && s != side) continue;
        FaceT<S>& face = (s == kAbove ? above : below).faces[faceMap_[s][i]];
        face = parent_.faces[i];
        const Index edge = isCut ? edgeCount_[s] + cutCount() + 2 * faceCut_[i] : edgeMap_[face.edge];
        face.edge = static_cast<std::uint16_t>(edge);
      }
    }
  }

  /// Half-edges keep their order. What this writes into `next` and `opposite` of cut ones is mended by writeCap.
  void writeEdges(ConvexT<S>& above, ConvexT<S>& below) {
    above.edges.resize(nA() + 3 * cutCount());
    below.edges.resize(nB() + 3 * cutCount());
    Edge* children[2] = {below.edges.data(), above.edges.data()};
    for (const Edge& edge : parent_.edges) {
      const std::uint8_t side = scratch_.sides[edge.vertex];
      *children[side]++ = {
          static_cast<std::uint16_t>(faceMap_[side][edge.face]), static_cast<std::uint16_t>(vertexMap_[edge.vertex]),
          static_cast<std::uint16_t>(edgeMap_[edge.next]), static_cast<std::uint16_t>(edgeMap_[edge.opposite])};
    }
  }

  /// Closes one child. The i-th cut face is entered by its half-edge `up` and left by `down`; cut vertex i lies on
  /// `up`. After the child's `inherited` half-edges come: the far part of each half-edge that reaches in from the other
  /// side; then for each cut face the new edge that closes it, and that edge's opposite, on the cap.
  void writeCap(ConvexT<S>& child, Index inherited, bool isAbove) {
    const Index count = cutCount();
    const Index capFace = static_cast<Index>(child.faces.size()) - 1;
    const std::uint8_t side = isAbove ? kAbove : kBelow;
    Edge* edges = child.edges.data();
    const auto write = [edges](Index at, Index face, Index vertex, Index next, Index opposite) {
      edges[at] = {static_cast<std::uint16_t>(face), static_cast<std::uint16_t>(vertex),
                   static_cast<std::uint16_t>(next), static_cast<std::uint16_t>(opposite)};
    };
    for (Index i = 0; i < count; ++i) {
      const Index after = i + 1 == count ? 0 : i + 1;
      const Index before = i == 0 ? count - 1 : i - 1;
      // In the face, the child's loop enters by `entering` (its far part) and leaves by `leaving` (its near part).
      const Index entering = isAbove ? scratch_.cut[i].up : scratch_.cut[i].down;
      const Index leaving = isAbove ? scratch_.cut[i].down : scratch_.cut[i].up;
      const Index entryVertex = capStart_[side] + (isAbove ? i : after);
      const Index exitVertex = capStart_[side] + (isAbove ? after : i);
      const Index following = isAbove ? after : before;  // the cut face beyond `leaving`
      const Index face = faceMap_[side][parent_.edges[entering].face];
      const Index farPart = inherited + i;
      const Index closing = inherited + count + 2 * i;
      write(farPart, face, entryVertex, edgeMap_[parent_.edges[entering].next],
            edgeMap_[parent_.edges[entering].opposite]);
      write(closing, face, exitVertex, farPart, closing + 1);
      write(closing + 1, capFace, entryVertex, inherited + count + 2 * following + 1, closing);
      Edge& nearPart = edges[edgeMap_[leaving]];
      nearPart.next = static_cast<std::uint16_t>(closing);
      nearPart.opposite = static_cast<std::uint16_t>(inherited + following);
    }
    // Both caps start at cut vertex 0, see haveVolume.
    const Index first = inherited + count + 1 + (isAbove ? 0 : 2 * (count - 1));
    child.faces[capFace] = {isAbove ? plane_.flipped() : plane_, static_cast<std::uint16_t>(first), mark_.kind,
                            mark_.cut};
  }

  const ConvexViewT<S>& parent_;
  const PlaneT<S>& plane_;
  CutMark mark_;
  SplitScratchT<S>& scratch_;
  S extent_ = S(0);
  S slack_ = S(0);
  Index edgeCount_[2] = {0, 0};  // half-edges that start on each side
  Index capStart_[2] = {0, 0};   // first cut vertex in each child
  Index* edgeMap_ = nullptr;     // parent's half-edge -> index in the child of its start
  Index* faceCut_ = nullptr;     // parent's face -> which cut face it is, or kNotCut
  Index* faceMap_[2] = {nullptr, nullptr};
  Index* vertexMap_ = nullptr;
};

}  // namespace brittle::geometry::split_detail

namespace brittle::geometry {

template <class S>
SplitOutcome split(const ConvexViewT<S>& parent, const PlaneT<S>& plane, CutMark mark, SplitScratchT<S>& scratch,
                   ConvexT<S>& above, ConvexT<S>& below) {
  const SplitOutcome outcome = split_detail::Splitter<S>(parent, plane, mark, scratch).run(above, below);
  if (outcome == SplitOutcome::Split) {
    BR_VALIDATE(findTopologyError<S>(above.view()) == nullptr);
    BR_VALIDATE(findTopologyError<S>(below.view()) == nullptr);
  }
  return outcome;
}

}  // namespace brittle::geometry
