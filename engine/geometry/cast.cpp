#include <cmath>

#include "engine/geometry/gjk.h"
#include "engine/geometry/relative_pose.h"

namespace brittle::geometry {

namespace {

/// Each advance aims at this fraction of the target distance, so that the search ends within the target after finitely
/// many.
constexpr float kAim = 0.75f;
/// Every advance takes at least a quarter of the target at the fastest closing speed, so only long, fast, spinning near
/// misses need many. At 1 mm and 30 m/s for 1/60 s that is 2000 at the very worst; usual are 3 to 8 (measured).
constexpr int kMaxAdvances = 256;

/// Largest distance of the proxy's points from `center` (world). [m]
float reachFrom(const Proxy& proxy, const Transform& pose, const Vec3& center) {
  const Vec3 local = pose.toLocal(center);
  if (proxy.isSphere()) return (proxy.center - local).norm() + proxy.radius;
  float squared = 0.0f;
  for (const Vertex& vertex : proxy.convex.vertices) squared = maxOf(squared, (vertex.point - local).squaredNorm());
  return std::sqrt(squared) + proxy.radius;
}

/// A sphere that turns about its own centre does not move.
bool turns(const Proxy& proxy, const Motion& motion) {
  return !(motion.angularVelocity == Vec3::Zero()) &&
         !(proxy.isSphere() && (motion.pose.toWorld(proxy.center) - motion.center).norm() < 1e-5f * proxy.radius);
}

/// An upper bound for how fast the two may close along `normal` at any time from now on, whatever the rotations [m/s]:
/// n . (w x r) = r . (n x w) and |r| stays.
float closingBound(const Motion& a, float reachA, const Motion& b, float reachB, const Vec3& normal) {
  return normal.dot(a.velocity - b.velocity) + normal.cross(a.angularVelocity).norm() * reachA +
         normal.cross(b.angularVelocity).norm() * reachB;
}

/// The same along any normal. [m/s]
float fastestClosing(const Motion& a, float reachA, const Motion& b, float reachB) {
  return (a.velocity - b.velocity).norm() + a.angularVelocity.norm() * reachA + b.angularVelocity.norm() * reachB;
}

Vec3 velocityAt(const Motion& motion, const Vec3& center, const Vec3& point) {
  return motion.velocity + motion.angularVelocity.cross(point - center);
}

Impact hitAt(float time, const Separation& s) {
  Impact impact;
  impact.hit = true;
  impact.time = time;
  impact.normal = s.normal;
  impact.point = 0.5f * (s.pointA + s.pointB);
  return impact;
}

Impact missUntil(float time) {
  Impact impact;
  impact.time = time;
  return impact;
}

}  // namespace

Transform poseAt(const Motion& motion, float time) {
  if (time == 0.0f) return motion.pose;
  Transform pose;
  pose.rotation = integrateRotation(motion.pose.rotation, motion.angularVelocity, time);
  pose.position = motion.center + motion.velocity * time - pose.rotate(motion.pose.toLocal(motion.center));
  return pose;
}

Impact timeOfImpact(const Proxy& a, const Motion& motionA, const Proxy& b, const Motion& motionB, float duration,
                    float target) {
  const float reachA = turns(a, motionA) ? reachFrom(a, motionA.pose, motionA.center) : 0.0f;
  const float reachB = turns(b, motionB) ? reachFrom(b, motionB.pose, motionB.center) : 0.0f;
  const float fastest =
      1.0001f * fastestClosing(motionA, reachA, motionB, reachB);  // what is out of its reach need not be measured
  SimplexCache cache;
  float time = 0.0f;
  for (int advance = 0; advance < kMaxAdvances; ++advance) {
    const float farthest = target + fastest * (duration - time);
    const Separation s = separation(a, poseAt(motionA, time), b, poseAt(motionB, time), cache, farthest);
    if (s.distance > farthest) return missUntil(duration);
    if (s.distance <= target) {
      if (advance > 0) return hitAt(time, s);
      const Vec3 point = 0.5f * (s.pointA + s.pointB);
      const float approach =
          s.normal.dot(velocityAt(motionA, motionA.center, point) - velocityAt(motionB, motionB.center, point));
      // Sliding along is not approaching: what closes less than a hundredth of the target within the duration is
      // rounding.
      return approach * duration > 0.01f * target ? hitAt(0.0f, s) : missUntil(duration);
    }
    const float closing = closingBound(motionA, reachA, motionB, reachB, s.normal);
    if (closing * (duration - time) <= s.distance - target) return missUntil(duration);
    const float step = (s.distance - kAim * target) / closing;
    if (time + step >= duration) {
      const Separation last = separation(a, poseAt(motionA, duration), b, poseAt(motionB, duration), cache);
      return last.distance <= target ? hitAt(duration, last) : missUntil(duration);
    }
    if (!(time + step > time)) return missUntil(time);
    time += step;
  }
  return missUntil(time);
}

RayHit castRay(const Proxy& proxy, const Transform& pose, const Vec3& from, const Vec3& to) {
  const Mat3d inverse = rotationMatrix(pose.rotation).transpose();
  const Vec3d origin = pose.position.cast<double>();
  const Vec3d start = inverse * (from.cast<double>() - origin),
              way = inverse * (to.cast<double>() - from.cast<double>());
  RayHit result;
  if (proxy.isSphere()) {
    // |start + t way - center| = radius, the smaller root; a start inside has a negative c and does not hit.
    const Vec3d apart = start - proxy.center.cast<double>();
    const double radius = static_cast<double>(proxy.radius);
    const double a = way.squaredNorm(), b = apart.dot(way), c = apart.squaredNorm() - radius * radius;
    const double root = b * b - a * c;
    if (c < 0.0 || b >= 0.0 || root < 0.0) return result;
    const double t = c / (-b + std::sqrt(root));
    if (t > 1.0) return result;
    result.hit = true;
    result.fraction = static_cast<float>(t);
    result.normal = pose.rotate((apart + t * way).normalized().cast<float>());
    return result;
  }
  double enter = -1.0, leave = 1.0;
  const Face* entered = nullptr;
  for (const Face& face : proxy.convex.faces) {
    const Vec3d normal = face.plane.normal.cast<double>();
    const double height = normal.dot(start) - static_cast<double>(face.plane.offset), slope = normal.dot(way);
    if (slope == 0.0) {
      if (height > 0.0) return result;
      continue;
    }
    const double t = -height / slope;
    if (slope < 0.0 && t > enter) {
      enter = t;
      entered = &face;
    }
    if (slope > 0.0) leave = minOf(leave, t);
    if (enter > leave) return result;
  }
  if (entered == nullptr || enter < 0.0) return result;
  result.hit = true;
  result.fraction = static_cast<float>(enter);
  result.normal = pose.rotate(entered->plane.normal);
  return result;
}

bool containsPoint(const Proxy& proxy, const Transform& pose, const Vec3& point) {
  const Vec3d apart = point.cast<double>() - pose.position.cast<double>();
  const Vec3d local = rotationMatrix(pose.rotation).transpose() * apart;
  if (proxy.isSphere()) return (local - proxy.center.cast<double>()).norm() <= static_cast<double>(proxy.radius);
  // On the surface counts, and floats cannot put a point there better than to a few units in the last place.
  const double slack = 1.2e-7 * (point.cast<double>().norm() + pose.position.cast<double>().norm() + apart.norm());
  for (const Face& face : proxy.convex.faces)
    if (face.plane.normal.cast<double>().dot(local) > static_cast<double>(face.plane.offset) + slack) return false;
  return true;
}

Aabb boundsOf(const Proxy& proxy, const Transform& pose) {
  Aabb bounds;
  if (proxy.isSphere()) {
    bounds.include(pose.toWorld(proxy.center));
    return bounds.grownBy(proxy.radius);
  }
  const Mat3 rotation = pose.rotation.toRotationMatrix();
  for (const Vertex& vertex : proxy.convex.vertices) bounds.include(Vec3(rotation * vertex.point));
  bounds.low += pose.position;
  bounds.high += pose.position;
  return bounds.grownBy(proxy.radius);
}

}  // namespace brittle::geometry
