// geometry/gjk.h - distance and overlap of two convex point sets, each with a radius (a sphere is one point with a
// radius). Source: Gilbert, Johnson, Keerthi, A Fast Procedure for Computing the Distance Between Complex Objects,
// 1988; van den Bergen, A Fast and Robust GJK Implementation, 1999.
#pragma once

#include <cstdint>

#include "engine/geometry/convex.h"
#include "engine/geometry/relative_pose.h"
#include "engine/math/aabb.h"
#include "engine/math/transform.h"

namespace brittle::geometry {

/// One of the two things: a convex (points from its vertices) or a sphere about `center`.
struct Proxy {
  ConvexView convex;           // empty for a sphere
  Vec3 center = Vec3::Zero();  // sphere only, local [m]
  float radius = 0.0f;         // [m]; 0 for a convex
  bool isSphere() const { return convex.vertices.empty(); }
};

/// The vertices the last call ended with, and the face that gave the least depth: a warm start for the next one of the
/// same pair. It saves time and changes no answer beyond rounding. Any content is legal. Part of snapshots.
struct SimplexCache {
  std::uint8_t count = 0;
  std::uint16_t a[4] = {};
  std::uint16_t b[4] = {};
  std::uint32_t axis = 0;  // 0: none, else 1 + 2 * face + (0: of A, 1: of B)
};

struct Separation {
  float distance = 0.0f;        // [m]; negative: penetration depth
  Vec3 normal = Vec3::UnitY();  // unit, world, from A towards B
  Vec3 pointA = Vec3::Zero();   // world, on the surface of A
  Vec3 pointB = Vec3::Zero();
};

/// Distance between A at `poseA` and B at `poseB`. Separated or touching: closest points. Overlapping (deeper than the
/// radii): the penetration along the axis of least depth (faces of both and edge pairs). Never returns a non-finite
/// number for finite input; terminates within a fixed number of iterations whatever the input. A pair further apart
/// than `stopAbove` [m] may be given any distance from there to the true one, with some axis along which it is that far
/// apart and no closest points.
Separation separation(const Proxy& a, const Transform& poseA, const Proxy& b, const Transform& poseB,
                      SimplexCache& cache, float stopAbove = 3.0e38f);

/// The same as seen from A: `pose` is B in A's frame, and so are normal and points.
Separation separation(const Proxy& a, const Proxy& b, const RelativePose& pose, SimplexCache& cache,
                      float stopAbove = 3.0e38f);

/// True if the two overlap or come closer than `margin` [m] >= 0: overlap in configuration space, early out as soon as
/// known.
bool overlaps(const Proxy& a, const Transform& poseA, const Proxy& b, const Transform& poseB, float margin);

/// How a proxy moves in one tick: from `pose`, with the velocity of the point `center` [m/s] and angular velocity
/// [rad/s].
struct Motion {
  Transform pose;
  Vec3 center = Vec3::Zero();  // world, the point `velocity` belongs to (the centre of mass)
  Vec3 velocity = Vec3::Zero();
  Vec3 angularVelocity = Vec3::Zero();
};

/// Pose after `time` [s].
Transform poseAt(const Motion& motion, float time);

struct Impact {
  bool hit = false;
  float time = 0.0f;            // [s], from 0 to the duration asked for; without a hit: the path is free up to here
  Vec3 normal = Vec3::UnitY();  // from A towards B at that time
  Vec3 point = Vec3::Zero();    // world
};

/// First time in [0, duration] at which the two come within `target` [m] > 0 while approaching. A pair already within
/// the target at time 0 hits at 0 if it approaches (by more than target/100 within the duration), else never.
/// Conservative advancement: never reports a time after the true one by more than target/speed, and never a hit for a
/// pair whose least distance stays above `target`. A graze that comes between 0.75 target and target may count as a
/// miss. Source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996.
Impact timeOfImpact(const Proxy& a, const Motion& motionA, const Proxy& b, const Motion& motionB, float duration,
                    float target);

struct RayHit {
  bool hit = false;
  float fraction = 1.0f;        // of the ray's length
  Vec3 normal = Vec3::UnitY();  // outward
};

/// The segment from `from` to `to` (world) against a convex or sphere. A start inside does not hit.
RayHit castRay(const Proxy& proxy, const Transform& pose, const Vec3& from, const Vec3& to);

/// True if the world point lies inside or on the surface.
bool containsPoint(const Proxy& proxy, const Transform& pose, const Vec3& point);

Aabb boundsOf(const Proxy& proxy, const Transform& pose);

}  // namespace brittle::geometry
