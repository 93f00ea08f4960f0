// The stress of the split tests: a unit cube, cut one random piece at a time until there are 512, then again. Planes
// are random, or go on purpose through what is there already, where rounding leaves no sign to be trusted.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "engine/core/random.h"
#include "engine/geometry/convex.h"
#include "engine/geometry/make.h"
#include "engine/geometry/split.h"
#include "engine/math/transform.h"

namespace brittle::geometry {

enum class CutMode {
  AtRandom,
  ThroughVertex,
  ThroughEdge,
  OnFace,        // of any piece, either way round, bit for bit
  BesideEdge,    // through an edge, but for one unit in the last place of the offset or of the cube's size
  OnFaceAfresh,  // of any piece, either way round, computed again from three of its corners
};
/// The four that differ in kind; the other two vary the last two.
inline constexpr CutMode kCutModes[] = {CutMode::AtRandom, CutMode::ThroughVertex, CutMode::ThroughEdge,
                                        CutMode::OnFace};
inline constexpr const char* kCutModeNames[] = {"random", "vertex", "edge", "face"};

/// The engine's own; what compares splitters puts others in its place.
template <class S>
struct EngineSplitter {
  SplitOutcome operator()(const ConvexViewT<S>& parent, const PlaneT<S>& plane, CutMark mark, SplitScratchT<S>& scratch,
                          ConvexT<S>& above, ConvexT<S>& below) const {
    return split<S>(parent, plane, mark, scratch, above, below);
  }
};

/// One piece of a cut cube, or all of it. Edges of float pieces are moved into S exactly.
template <class S, class Splitter = EngineSplitter<S>>
class CutCube {
 public:
  /// Starts again when there are `mostPieces`.
  CutCube(CutMode mode, std::uint64_t seed, std::size_t mostPieces = 512)
      : random(seed), mode_(mode), pieces_(mostPieces) {
    restart();
  }

  /// Chooses a piece and a plane, cuts, and keeps both parts. The pieces are then `above` and `below`, `parent` the one
  /// before.
  SplitOutcome step() {
    if (isFull()) restart();
    chosen = random.nextBelow(static_cast<std::uint32_t>(count_));
    parent.assign(pieces_[chosen].view());
    plane = choosePlane();
    const SplitOutcome outcome = splitter(parent.view(), plane, {++cuts_, FaceKind::Cut}, scratch_, above, below);
    if (outcome != SplitOutcome::Split) return outcome;
    pieces_[chosen].assign(above.view());
    pieces_[count_++].assign(below.view());
    return outcome;
  }

  std::size_t count() const { return count_; }
  bool isFull() const { return count_ == pieces_.size(); }
  const ConvexT<S>& piece(std::size_t i) const { return pieces_[i]; }

  Splitter splitter;
  Random random;
  std::uint32_t chosen = 0;
  PlaneT<S> plane;
  ConvexT<S> parent, above, below;

 private:
  void restart() {
    count_ = 1;
    pieces_[0].assign(makeBox<S>(Vec3T<S>(S(0.5), S(0.5), S(0.5))).view());
  }

  S draw() { return S(random.nextFloat(-1.0f, 1.0f)); }

  Vec3T<S> drawVector() {
    const S x = draw();
    const S y = draw();
    const S z = draw();
    return Vec3T<S>(x, y, z);
  }

  /// Unit, or any length for exact scalars.
  static bool normalize(Vec3T<S>& vector) {
    const S square = vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
    if (!(S(1e-20f) < square)) return false;
    if constexpr (!std::numeric_limits<S>::is_exact) {
      const S length = std::sqrt(square);
      for (int i = 0; i < 3; ++i) vector[i] /= length;
    }
    return true;
  }

  static S dotOf(const Vec3T<S>& a, const Vec3T<S>& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

  static Vec3T<S> crossOf(const Vec3T<S>& a, const Vec3T<S>& b) {
    return Vec3T<S>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  }

  Vec3T<S> drawDirection() {
    for (;;) {
      Vec3T<S> direction = drawVector();
      if (normalize(direction)) return direction;
    }
  }

  PlaneT<S> choosePlane() {
    if (mode_ == CutMode::OnFace || mode_ == CutMode::OnFaceAfresh) {
      const ConvexT<S>& other = pieces_[random.nextBelow(static_cast<std::uint32_t>(count_))];
      const FaceT<S>& face = other.faces[random.nextBelow(static_cast<std::uint32_t>(other.faces.size()))];
      const PlaneT<S> found = mode_ == CutMode::OnFace ? face.plane : throughCorners(other.view(), face);
      // Few planes are shared by chance: every fourth cut is fresh, so that there are pieces to cut.
      const std::uint32_t kind = random.nextBelow(4);
      if (kind != 0) return kind == 1 ? found.flipped() : found;
    }
    const auto edge = random.nextBelow(static_cast<std::uint32_t>(parent.edges.size()));
    const Vec3T<S> start = parent.view().startOf(edge);
    const Vec3T<S> end = parent.view().endOf(edge);
    Vec3T<S> normal = drawDirection();
    if (mode_ == CutMode::ThroughEdge || mode_ == CutMode::BesideEdge) {
      const Vec3T<S> along(end[0] - start[0], end[1] - start[1], end[2] - start[2]);
      Vec3T<S> across = crossOf(along, normal);
      if (normalize(across)) normal = across;
    }
    if (mode_ == CutMode::BesideEdge) return {normal, beside(dotOf(normal, start))};
    if (mode_ == CutMode::ThroughVertex || mode_ == CutMode::ThroughEdge) return {normal, jitter(dotOf(normal, start))};
    float low = static_cast<float>(dotOf(normal, start));
    float high = low;
    for (const VertexT<S>& vertex : parent.vertices) {
      const auto along = static_cast<float>(dotOf(normal, vertex.point));
      low = minOf(low, along);
      high = maxOf(high, along);
    }
    return {normal, S(random.nextFloat(low, high))};
  }

  /// As a splitter that stores no planes would have it; the stored one for a face without area.
  static PlaneT<S> throughCorners(const ConvexViewT<S>& convex, const FaceT<S>& face) {
    const Edge& second = convex.edges[convex.edges[face.edge].next];
    const Vec3T<S>& a = convex.startOf(face.edge);
    const Vec3T<S>& b = convex.vertices[second.vertex].point;
    const Vec3T<S>& c = convex.startOf(second.next);
    Vec3T<S> normal =
        crossOf(Vec3T<S>(b[0] - a[0], b[1] - a[1], b[2] - a[2]), Vec3T<S>(c[0] - a[0], c[1] - a[1], c[2] - a[2]));
    if (!normalize(normal)) return face.plane;
    return {normal, dotOf(normal, a)};
  }

  /// The offset's neighbours among floats, or one unit of the grid of the cube's coordinates, either way.
  S beside(const S& offset) {
    const std::uint32_t kind = random.nextBelow(4);
    if constexpr (!std::numeric_limits<S>::is_exact) {
      if (kind < 2) return std::nextafter(offset, kind == 0 ? S(8) : S(-8));
      return offset + (kind == 2 ? S(0x1p-24) : S(-0x1p-24));
    }
    return offset;
  }

  /// The offset itself, or its neighbour among floats on either side.
  S jitter(const S& offset) {
    const std::uint32_t kind = random.nextBelow(3);
    if constexpr (!std::numeric_limits<S>::is_exact) {
      if (kind != 0) return std::nextafter(offset, kind == 1 ? S(8) : S(-8));
    }
    return offset;
  }

  CutMode mode_;
  std::uint32_t cuts_ = 0;
  std::vector<ConvexT<S>> pieces_;
  std::size_t count_ = 0;
  SplitScratchT<S> scratch_;
};

inline bool isSame(const Vec3& a, const Vec3& b) {
  return std::memcmp(a.data(), b.data(), sizeof(float) * 3) == 0;
}
inline bool isSame(const Plane& a, const Plane& b) {
  return isSame(a.normal, b.normal) && a.offset == b.offset;
}

/// The corners of the last face, in loop order.
inline std::vector<Vec3> capOf(const Convex& piece) {
  std::vector<Vec3> corners;
  const std::uint32_t first = piece.faces.back().edge;
  std::uint32_t edge = first;
  do {
    corners.push_back(piece.view().startOf(edge));
    edge = piece.edges[edge].next;
  } while (edge != first);
  return corners;
}

/// Volume summed in A over tetrahedra from the first vertex. [m3]
template <class A, class S>
A volumeOf(const ConvexT<S>& convex) {
  A sum = A(0);
  const ConvexViewT<S> view = convex.view();
  const Vec3T<S>& origin = convex.vertices[0].point;
  const auto relative = [&](std::uint32_t edge, A(&out)[3]) {
    for (int i = 0; i < 3; ++i) out[i] = A(view.startOf(edge)[i]) - A(origin[i]);
  };
  for (const FaceT<S>& face : convex.faces) {
    A a[3], b[3], c[3];
    relative(face.edge, a);
    std::uint32_t edge = convex.edges[face.edge].next;
    relative(edge, b);
    for (edge = convex.edges[edge].next; edge != face.edge; edge = convex.edges[edge].next) {
      relative(edge, c);
      sum += a[0] * A(b[1] * c[2] - b[2] * c[1]) + a[1] * A(b[2] * c[0] - b[0] * c[2]) +
             a[2] * A(b[0] * c[1] - b[1] * c[0]);
      for (int i = 0; i < 3; ++i) b[i] = c[i];
    }
  }
  return sum / A(6);
}

/// Area of a face. [m2]
template <class S>
double areaOf(const ConvexT<S>& convex, const FaceT<S>& face) {
  const auto at = [&](std::uint32_t edge) {
    const Vec3T<S>& point = convex.view().startOf(edge);
    return Vec3d(static_cast<double>(point[0]), static_cast<double>(point[1]), static_cast<double>(point[2]));
  };
  const Vec3d origin = at(face.edge);
  Vec3d twice = Vec3d::Zero();
  for (std::uint32_t edge = convex.edges[face.edge].next; edge != face.edge; edge = convex.edges[edge].next)
    twice += (at(edge) - origin).cross(at(convex.edges[edge].next) - origin);
  return 0.5 * twice.norm();
}

/// Each coordinate in [-1, 1).
inline Vec3 drawVector(Random& random) {
  const float x = random.nextFloat(-1.0f, 1.0f);
  const float y = random.nextFloat(-1.0f, 1.0f);
  const float z = random.nextFloat(-1.0f, 1.0f);
  return Vec3(x, y, z);
}

inline Quat drawRotation(Random& random) {
  const Vec3 axis = normalizedOr(drawVector(random), Vec3::UnitX());
  return rotationAbout(axis, random.nextFloat(-3.0f, 3.0f));
}

}  // namespace brittle::geometry
