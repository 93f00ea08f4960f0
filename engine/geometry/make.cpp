#include "engine/geometry/make.h"

#include <cmath>
#include <string>

#include "engine/core/assert.h"
#include "engine/geometry/make_impl.h"
#include "engine/math/trig.h"

namespace brittle::geometry {
namespace {

using make_detail::Loops;

Vec3d pointOf(const ConvexView& convex, std::uint32_t edge) {
  return convex.startOf(edge).cast<double>();
}

/// The mean of `normal . corner` over a face: the offset that serves its corners best.
double meanOffset(const ConvexView& convex, std::uint32_t face, const Vec3d& normal) {
  const std::uint32_t first = convex.faces[face].edge;
  double sum = 0.0;
  int count = 0;
  std::uint32_t edge = first;
  do {
    sum += normal.dot(pointOf(convex, edge));
    ++count;
    edge = convex.edges[edge].next;
  } while (edge != first);
  return sum / count;
}

Plane planeWith(const ConvexView& convex, std::uint32_t face, const Vec3d& normal) {
  const Vec3 rounded = normal.cast<float>();
  return {rounded, static_cast<float>(meanOffset(convex, face, rounded.cast<double>()))};
}

/// Two equal polygons, `bottom` and `top` vertices 0..n-1 and n..2n-1, with quads between them. Seen from the top side
/// the polygon runs counter-clockwise.
Convex makeBetween(std::vector<Vertex> vertices) {
  const auto n = static_cast<std::uint32_t>(vertices.size() / 2);
  Convex convex;
  convex.vertices = std::move(vertices);
  Loops loops;
  for (std::uint32_t i = 0; i < n; ++i) loops.corners.push_back(n - 1 - i);
  loops.close();
  for (std::uint32_t i = 0; i < n; ++i) loops.corners.push_back(n + i);
  loops.close();
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = i + 1 == n ? 0 : i + 1;
    loops.corners.insert(loops.corners.end(), {i, next, n + next, n + i});
    loops.close();
  }
  const bool isLinked = make_detail::linkLoops(loops, convex);
  BR_ASSERT(isLinked);
  make_detail::fitPlanes(convex);
  return convex;
}

/// Twice the area of the triangle, in double so that the sign is that of the floats given.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double abX = static_cast<double>(b.x()) - a.x();
  const double abY = static_cast<double>(b.y()) - a.y();
  const double acX = static_cast<double>(c.x()) - a.x();
  const double acY = static_cast<double>(c.y()) - a.y();
  return abX * acY - abY * acX;
}

/// A polygon whose corners all turn left goes round once or several times; its angles add up to one turn exactly if its
/// direction passes from the lower to the upper half plane once.
const char* findPolygonError(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return "a prism needs at least 3 corners";
  if (6 * n > kMaxHalfEdges) return "a prism may have at most 10922 corners";
  int halfTurns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % n];
    const Vec2& c = polygon[(i + 2) % n];
    if (!isFinite(a.x()) || !isFinite(a.y())) return "a prism's corners must be finite";
    if (!(turn(a, b, c) > 0.0)) return "a prism's corners must turn left, no three in a line";
    const bool wasUp = b.y() > a.y() || (b.y() == a.y() && b.x() > a.x());
    const bool isUp = c.y() > b.y() || (c.y() == b.y() && c.x() > b.x());
    halfTurns += wasUp != isUp ? 1 : 0;
  }
  return halfTurns == 2 ? nullptr : "a prism's corners must go round once";
}

}  // namespace

void make_detail::fitPlanes(Convex& convex) {
  const ConvexView view = convex.view();
  for (std::uint32_t i = 0; i < convex.faces.size(); ++i) {
    const std::uint32_t first = convex.faces[i].edge;
    const Vec3d origin = pointOf(view, first);
    Vec3d doubleArea = Vec3d::Zero();
    for (std::uint32_t edge = first;;) {
      const std::uint32_t next = convex.edges[edge].next;
      const Vec3d a = pointOf(view, edge) - origin;
      const Vec3d b = pointOf(view, next) - origin;
      doubleArea += a.cross(b);
      if (next == first) break;
      edge = next;
    }
    convex.faces[i].plane = planeWith(view, i, doubleArea.normalized());
  }
}

Convex makeCylinder(float radius, float halfHeight, int sides, bool smooth) {
  BR_ASSERT(radius > 0.0f && halfHeight > 0.0f && sides >= 3 && sides <= 10000);
  constexpr double kTwoPi = 6.283185307179586;
  const auto n = static_cast<std::size_t>(sides);
  std::vector<Vertex> vertices(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        -kTwoPi * static_cast<double>(i) / sides;  // counter-clockwise seen from above, Z towards the eye
    const auto x = static_cast<float>(cosineOf(angle));
    const auto z = static_cast<float>(sineOf(angle));
    for (const std::size_t at : {i, n + i}) {
      vertices[at].point = Vec3(radius * x, at < n ? -halfHeight : halfHeight, radius * z);
      vertices[at].normal = smooth ? packNormal(Vec3(x, 0.0f, z)) : 0;
    }
  }
  return makeBetween(std::move(vertices));
}

Result<Convex> makePrism(std::span<const Vec2> polygon, float halfDepth) {
  if (!(halfDepth > 0.0f) || !isFinite(halfDepth)) {
    return Error{"a prism's half depth is " + std::to_string(halfDepth) + ", expected above 0"};
  }
  if (const char* error = findPolygonError(polygon)) {
    return Error{std::string(error) + " (" + std::to_string(polygon.size()) + " given)"};
  }
  const std::size_t n = polygon.size();
  std::vector<Vertex> vertices(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const Vec2& corner = polygon[i % n];
    vertices[i].point = Vec3(corner.x(), corner.y(), i < n ? -halfDepth : halfDepth);
  }
  return makeBetween(std::move(vertices));
}

Convex transformed(const ConvexView& convex, const Quat& rotation, const Vec3& translation, const Vec3& scale) {
  BR_ASSERT(scale.x() > 0.0f && scale.y() > 0.0f && scale.z() > 0.0f);
  const Eigen::Quaterniond turned = rotation.cast<double>().normalized();
  const Vec3d factors = scale.cast<double>();
  const auto normalOf = [&](const Vec3& normal) -> Vec3d {
    const Vec3d stretched = normal.cast<double>().cwiseQuotient(factors);
    return turned * stretched.normalized();
  };
  Convex result;
  result.assign(convex);
  for (Vertex& vertex : result.vertices) {
    const Vec3d scaled = vertex.point.cast<double>().cwiseProduct(factors);
    const Vec3d moved = turned * scaled + translation.cast<double>();
    vertex.point = moved.cast<float>();
    if (vertex.normal != 0) vertex.normal = packNormal(normalOf(unpackNormal(vertex.normal)).cast<float>());
  }
  // The old normals are turned rather than fitted anew: a face may have shrunk to less than three different corners.
  for (std::uint32_t i = 0; i < result.faces.size(); ++i) {
    result.faces[i].plane = planeWith(result.view(), i, normalOf(result.faces[i].plane.normal));
  }
  return result;
}

template ConvexT<float> makeBox<float>(const Vec3T<float>&, const Vec3T<float>&);
template ConvexT<double> makeBox<double>(const Vec3T<double>&, const Vec3T<double>&);

}  // namespace brittle::geometry
