// tests/engine/geometry/shapes.h - convexes for the tests of distance and overlap, built without geometry/make so that
// those tests stand alone: boxes, random hulls by brute force, scaled to slivers; spheres and poses. And the slow,
// certain answers in double.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/geometry/convex.h"
#include "engine/geometry/gjk.h"
#include "engine/math/transform.h"

namespace brittle::geometry::test {

/// Half-edges and planes for faces given as counter-clockwise corner lists.
inline Convex fromFaces(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces) {
  Convex convex;
  for (const Vec3& point : points) convex.vertices.push_back({point});
  std::map<std::pair<int, int>, int> edgeAt;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<int>& loop = faces[f];
    const int first = static_cast<int>(convex.edges.size()), count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i) {
      edgeAt[{loop[i], loop[(i + 1) % count]}] = first + i;
      convex.edges.push_back({static_cast<std::uint16_t>(f), static_cast<std::uint16_t>(loop[i]),
                              static_cast<std::uint16_t>(first + (i + 1) % count), 0});
    }
    const Vec3d a = points[loop[0]].cast<double>(), b = points[loop[1]].cast<double>(),
                c = points[loop[2]].cast<double>();
    const Vec3d normal = (b - a).cross(c - a).normalized();
    Face face;
    face.edge = static_cast<std::uint16_t>(first);
    face.plane = {normal.cast<float>(), static_cast<float>(normal.dot(a))};
    convex.faces.push_back(face);
  }
  for (const auto& [ends, edge] : edgeAt)
    convex.edges[edge].opposite = static_cast<std::uint16_t>(edgeAt.at({ends.second, ends.first}));
  return convex;
}

inline Convex box(const Vec3& half, const Vec3& center = Vec3::Zero()) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(center +
                     Vec3(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z()));
  return fromFaces(points, {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

/// The hull of `count` random points on the unit sphere, scaled per axis: triangles only, every point a vertex.
inline Convex randomHull(Random& random, int count, const Vec3& scale, const Vec3& center = Vec3::Zero()) {
  std::vector<Vec3d> round;
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    Vec3d p;
    do {
      for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(random.nextFloat(-1.0f, 1.0f));
    } while (p.squaredNorm() < 0.1 || p.squaredNorm() > 1.0);
    round.push_back(p.normalized());
    points.push_back(center + Vec3(round.back().cast<float>().cwiseProduct(scale)));
  }
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      for (int k = 0; k < count; ++k) {
        if (i == j || j == k || i == k || i > j || i > k) continue;
        const Vec3d normal = (round[j] - round[i]).cross(round[k] - round[i]);
        bool outer = true;
        for (int m = 0; m < count && outer; ++m)
          outer = m == i || m == j || m == k || normal.dot(round[m] - round[i]) < 0.0;
        if (outer) faces.push_back({i, j, k});
      }
  return fromFaces(points, faces);
}

inline Transform randomPose(Random& random, float reach) {
  Transform pose;
  for (int i = 0; i < 3; ++i) pose.position[i] = random.nextFloat(-reach, reach);
  Vec4 q;
  for (int i = 0; i < 4; ++i) q[i] = random.nextFloat(-1.0f, 1.0f);
  pose.rotation = Quat(q[0], q[1], q[2], q[3]).normalized();
  return pose;
}

inline Proxy proxy(const Convex& convex) {
  return {convex.view(), Vec3::Zero(), 0.0f};
}
inline Proxy sphere(float radius, const Vec3& center = Vec3::Zero()) {
  return {{}, center, radius};
}
inline Transform at(float x, float y, float z) {
  return {Vec3(x, y, z), Quat::Identity()};
}

/// The vertices in the world, in double.
inline std::vector<Vec3d> worldPoints(const Convex& convex, const Transform& pose) {
  std::vector<Vec3d> points;
  const Eigen::Quaterniond q = pose.rotation.cast<double>().normalized();
  for (const Vertex& vertex : convex.vertices)
    points.push_back(q * vertex.point.cast<double>() + pose.position.cast<double>());
  return points;
}

inline double widthAlong(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b, const Vec3d& axis) {
  double high = -1e300, low = 1e300;
  for (const Vec3d& p : a) high = std::max(high, p.dot(axis));
  for (const Vec3d& p : b) low = std::min(low, p.dot(axis));
  return low - high;
}

/// Largest separation over every face normal (from the vertices) and every pair of edges: the depth if the two overlap.
inline double slowSeparation(const Convex& a, const std::vector<Vec3d>& pa, const Convex& b,
                             const std::vector<Vec3d>& pb) {
  double best = -1e300;
  const auto tryAxis = [&](const Vec3d& axis) {
    const double length = axis.norm();
    if (length < 1e-13) return;
    best = std::max({best, widthAlong(pa, pb, axis / length), widthAlong(pa, pb, -axis / length)});
  };
  const auto faces = [&](const Convex& c, const std::vector<Vec3d>& p) {
    for (const Face& face : c.faces) {
      const Edge& e = c.edges[face.edge];
      const Edge& f = c.edges[e.next];
      const Edge& g = c.edges[f.next];
      tryAxis((p[f.vertex] - p[e.vertex]).cross(p[g.vertex] - p[e.vertex]));
    }
  };
  faces(a, pa);
  faces(b, pb);
  for (const Edge& e : a.edges)
    for (const Edge& f : b.edges) {
      const Vec3d u = pa[a.edges[e.next].vertex] - pa[e.vertex], v = pb[b.edges[f.next].vertex] - pb[f.vertex];
      const Vec3d axis = u.cross(v);
      if (axis.norm() > 1e-9 * u.norm() * v.norm()) tryAxis(axis / (u.norm() * v.norm()));
    }
  return best;
}

inline double segmentDistance(const Vec3d& p, const Vec3d& u, const Vec3d& q, const Vec3d& v) {
  const Vec3d w = p - q;
  const double a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(w), e = v.dot(w), det = a * c - b * b;
  double best = 1e300;
  const auto at = [&](double s, double t) { best = std::min(best, (w + s * u - t * v).norm()); };
  const auto clamp01 = [](double x) { return std::min(1.0, std::max(0.0, x)); };
  if (det > 1e-14 * a * c) {
    const double s = clamp01((b * e - c * d) / det);
    const double t = clamp01((b * s + e) / c);
    at(clamp01((b * t - d) / a), t);
  }
  for (const double s : {0.0, 1.0}) at(s, clamp01((b * s + e) / c));
  for (const double t : {0.0, 1.0}) at(clamp01((b * t - d) / a), t);
  return best;
}

/// Distance of two disjoint convexes: all pairs of edges, all vertices against the inner part of all faces.
inline double slowDistance(const Convex& a, const std::vector<Vec3d>& pa, const Convex& b,
                           const std::vector<Vec3d>& pb) {
  double best = 1e300;
  for (const Edge& e : a.edges)
    for (const Edge& f : b.edges)
      best = std::min(best, segmentDistance(pa[e.vertex], pa[a.edges[e.next].vertex] - pa[e.vertex], pb[f.vertex],
                                            pb[b.edges[f.next].vertex] - pb[f.vertex]));
  const auto verticesAgainstFaces = [&](const Convex& c, const std::vector<Vec3d>& p,
                                        const std::vector<Vec3d>& points) {
    for (const Face& face : c.faces) {
      const Edge first = c.edges[face.edge];
      const Edge second = c.edges[first.next];
      const Vec3d origin = p[first.vertex];
      const Vec3d normal = (p[second.vertex] - origin).cross(p[c.edges[second.next].vertex] - origin).normalized();
      for (const Vec3d& point : points) {
        const double height = normal.dot(point - origin);
        if (height < 0.0 || height >= best) continue;
        bool inner = true;
        std::uint32_t e = face.edge;
        do {
          const Vec3d start = p[c.edges[e].vertex], end = p[c.edges[c.edges[e].next].vertex];
          inner = inner && normal.dot((end - start).cross(point - start)) >= 0.0;
          e = c.edges[e].next;
        } while (e != face.edge);
        if (inner) best = height;
      }
    }
  };
  verticesAgainstFaces(a, pa, pb);
  verticesAgainstFaces(b, pb, pa);
  return best;
}

}  // namespace brittle::geometry::test
