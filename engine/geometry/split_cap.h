// geometry/split_cap.h - the numbers of a split: where the plane meets the edges, and whether both sides have a volume.
// Only split_impl.h uses it.
#pragma once

#include <cmath>

#include "engine/geometry/split_sides.h"

namespace brittle::geometry::split_detail {

/// Colours between a (0) and b (256), channel by channel.
std::uint32_t mixColor(std::uint32_t a, std::uint32_t b, std::uint32_t weight);
/// Shading normals between two packed ones; none if either is none.
std::uint32_t mixNormal(std::uint32_t a, std::uint32_t b, float weight);

/// The fraction of an edge, from its nearer end, at which a cut vertex may stand. Below zero where the repair left an
/// end on the wrong side, and moved away from there as well.
template <class S>
S movedAway(const Sides<S>& sides, const S& fraction, const Vec3T<S>& along) {
  if constexpr (!kIsExact<S>) {
    const S least = S(kMoveAway) * sides.extent;
    const S longestSide = maxOf<S>(maxOf<S>(absolute<S>(along[0]), absolute<S>(along[1])), absolute<S>(along[2]));
    if (!(fraction * longestSide < least)) return fraction;
    const S length = std::sqrt((along[0] * along[0] + along[1] * along[1]) + along[2] * along[2]);
    const S smallest = S(4) * least < length ? S(least / length) : S(0.25);
    return maxOf<S>(fraction, smallest);
  }
  return fraction;
}

/// Where the plane meets the edge from `low` to `high`: measured from the nearer end, so that it stays between the
/// two bit for bit (half an edge, rounded, cannot reach past the other end), and not too near to it.
template <class S>
VertexT<S> cutVertex(const Sides<S>& sides, std::uint32_t low, std::uint32_t high) {
  const S drop = sides.scratch.distances[low] - sides.scratch.distances[high];
  S fraction = drop < S(0) || S(0) < drop ? S(sides.scratch.distances[low] / drop) : S(0);
  const bool fromLow = !(S(0.5) < fraction);
  const VertexT<S>& near = sides.parent.vertices[fromLow ? low : high];
  const VertexT<S>& far = sides.parent.vertices[fromLow ? high : low];
  if (!fromLow) fraction = S(-sides.scratch.distances[high]) / drop;
  Vec3T<S> along(far.point.x() - near.point.x(), far.point.y() - near.point.y(), far.point.z() - near.point.z());
  fraction = movedAway<S>(sides, fraction, along);
  VertexT<S> vertex = near;
  for (int i = 0; i < 3; ++i) vertex.point[i] = near.point[i] + fraction * along[i];
  if (near.color != far.color) {
    vertex.color = mixColor(near.color, far.color, static_cast<std::uint32_t>(static_cast<float>(fraction) * 256.0f));
  }
  if (near.normal != far.normal) vertex.normal = mixNormal(near.normal, far.normal, static_cast<float>(fraction));
  return vertex;
}

/// One vertex per cut face, on the half-edge that goes up into it.
template <class S>
void makeCutVertices(const Sides<S>& sides) {
  sides.scratch.caps.resize(sides.cutCount());
  for (std::uint32_t i = 0; i < sides.cutCount(); ++i) {
    const Edge& up = sides.parent.edges[sides.scratch.cut[i].up];
    sides.scratch.caps[i] = cutVertex<S>(sides, up.vertex, sides.parent.edges[up.opposite].vertex);
  }
}

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

/// The part of a cut face on one side: from where `leaving` is cut over where `entering` is cut and on along the
/// loop.
template <class S>
void addPart(const Sides<S>& sides, Volumes& volumes, std::uint8_t side, std::uint32_t exit, std::uint32_t entry,
             std::uint32_t entering, std::uint32_t leaving) {
  volumes.startFan(sides.scratch.caps[exit].point);
  volumes.addCorner(side, sides.scratch.caps[entry].point);
  std::uint32_t edge = entering;
  do {
    edge = sides.parent.edges[edge].next;
    volumes.addCorner(side, sides.parent.startOf(edge));
  } while (edge != leaving);
}

/// Whether both sides have a positive volume, over the triangles massOf sums: fans from each face's first half-edge.
/// Where a piece is thinner than its caps are off their planes, it may have none although it reaches far from the
/// cut.
template <class S>
bool haveVolume(const Sides<S>& sides) {
  if constexpr (kIsExact<S>) return true;
  Volumes volumes(sides.scratch.caps[0].point);  // the caps are fans from this point, and add nothing
  for (std::uint32_t face = 0; face < sides.parent.faces.size(); ++face) {
    if (sides.isCut(face)) continue;
    const std::uint32_t first = sides.parent.faces[face].edge;
    volumes.startFan(sides.parent.startOf(first));
    std::uint32_t edge = sides.parent.edges[first].next;
    for (; edge != first; edge = sides.parent.edges[edge].next) {
      volumes.addCorner(sides.sideOf(edge), sides.parent.startOf(edge));
    }
  }
  for (std::uint32_t i = 0; i < sides.cutCount(); ++i) {
    const std::uint32_t after = i + 1 == sides.cutCount() ? 0 : i + 1;
    const typename SplitScratchT<S>::CutFace& cut = sides.scratch.cut[i];
    addPart<S>(sides, volumes, kAbove, after, i, cut.up, cut.down);
    addPart<S>(sides, volumes, kBelow, i, after, cut.down, cut.up);
  }
  return volumes.six[kBelow] > 0.0 && volumes.six[kAbove] > 0.0;
}

}  // namespace brittle::geometry::split_detail
