// physics/manifold_points.h - choosing and matching contact points. Private to the manifold.
#pragma once

#include <vector>

#include "engine/physics/manifold.h"

namespace brittle::physics {

/// A possible contact point, in A's frame.
struct Candidate {
  Vec3 onA, onB;     // [m]
  float separation;  // [m]
  float normalImpulse = 0.0f;
};

/// Keeps at most four: one of the deepest (within `band` [m] of the very deepest, so that rounding does not choose),
/// then each time the one farthest from those kept. Points that touch (to within the band) go before points that only
/// may.
void reducePoints(const Vec3& normal, float band, std::vector<Candidate>& candidates);

/// Gives the points of `fresh` the impulses of the nearest old ones. A point may slide along one of the two shapes, so
/// the nearer of the two distances counts; beyond `radius` [m] it is another point. Each old point is used once.
void keepImpulses(const ManifoldPoint* old, int oldCount, float radius, Manifold& fresh);

}  // namespace brittle::physics
