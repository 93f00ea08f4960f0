#include "engine/geometry/clip.h"

namespace brittle::geometry {

void facePolygon(const ConvexView& convex, std::uint32_t face, const Transform& pose, std::vector<Vec3>& polygon) {
  polygon.clear();
  const Mat3 rotation = pose.rotation.toRotationMatrix();
  const std::uint32_t first = convex.faces[face].edge;
  std::uint32_t edge = first;
  do {
    polygon.push_back(rotation * convex.startOf(edge) + pose.position);
    edge = convex.edges[edge].next;
  } while (edge != first);
}

void clipPolygon(const Plane& plane, std::vector<Vec3>& scratch, std::vector<Vec3>& polygon) {
  scratch.clear();
  if (polygon.empty()) return;
  const Vec3* previous = &polygon.back();
  float distanceBefore = plane.distance(*previous);
  for (const Vec3& corner : polygon) {
    const float distance = plane.distance(corner);
    if ((distance <= 0.0f) != (distanceBefore <= 0.0f)) {
      // Always from the corner below, so that two polygons that share the edge get the same point.
      const bool entering = distance <= 0.0f;
      const Vec3& below = entering ? corner : *previous;
      const Vec3& above = entering ? *previous : corner;
      const float depth = entering ? distance : distanceBefore, height = entering ? distanceBefore : distance;
      scratch.push_back(below + (above - below) * (depth / (depth - height)));
    }
    if (distance <= 0.0f) scratch.push_back(corner);
    previous = &corner;
    distanceBefore = distance;
  }
  polygon.swap(scratch);
}

void clipToFace(const ConvexView& convex, std::uint32_t face, const Transform& pose, std::vector<Vec3>& scratch,
                std::vector<Vec3>& polygon) {
  const Mat3 rotation = pose.rotation.toRotationMatrix();
  const Vec3 normal = rotation * convex.faces[face].plane.normal;
  const std::uint32_t first = convex.faces[face].edge;
  std::uint32_t edge = first;
  do {
    const Vec3 start = rotation * convex.startOf(edge) + pose.position;
    const Vec3 end = rotation * convex.endOf(edge) + pose.position;
    const Vec3 outward = (end - start).cross(normal);
    const float length = outward.norm();
    if (length > 1e-20f) clipPolygon(planeThrough(start, outward / length), scratch, polygon);
    edge = convex.edges[edge].next;
  } while (edge != first && !polygon.empty());
}

float polygonArea(const std::vector<Vec3>& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  return 0.5f * sum.norm();
}

std::uint32_t supportFace(const ConvexView& convex, const Vec3& directionLocal) {
  std::uint32_t best = 0;
  float bestAlong = -3.0e38f;
  for (std::uint32_t i = 0; i < convex.faces.size(); ++i) {
    const float along = convex.faces[i].plane.normal.dot(directionLocal);
    if (along > bestAlong) {
      bestAlong = along;
      best = i;
    }
  }
  return best;
}

}  // namespace brittle::geometry
