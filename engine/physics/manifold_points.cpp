#include "engine/physics/manifold_points.h"

namespace brittle::physics {

namespace {

int firstPoint(const Vec3& normal, float band, const std::vector<Candidate>& candidates) {
  float deepest = candidates[0].separation;
  for (const Candidate& candidate : candidates) deepest = minOf(deepest, candidate.separation);
  const Vec3 along = perpendicular(normal);
  int best = -1;
  float bestAlong = 0.0f;
  for (int i = 0; i < static_cast<int>(candidates.size()); ++i) {
    if (candidates[i].separation > deepest + band) continue;
    const float value = along.dot(candidates[i].onA);
    if (best >= 0 && value <= bestAlong) continue;
    best = i;
    bestAlong = value;
  }
  return best;
}

/// The candidate farthest from its nearest kept one, of those up to `limit`; -1 if all are within `band` of a kept one.
int farthestFrom(const Candidate* kept, int keptCount, float limit, float band,
                 const std::vector<Candidate>& candidates) {
  int best = -1;
  float farthest = band * band;
  for (int i = 0; i < static_cast<int>(candidates.size()); ++i) {
    if (candidates[i].separation > limit) continue;
    float nearest = 3.0e38f;
    for (int k = 0; k < keptCount; ++k) nearest = minOf(nearest, (candidates[i].onA - kept[k].onA).squaredNorm());
    if (nearest <= farthest) continue;
    farthest = nearest;
    best = i;
  }
  return best;
}

}  // namespace

void reducePoints(const Vec3& normal, float band, std::vector<Candidate>& candidates) {
  if (candidates.size() <= kMaxPoints) return;
  Candidate kept[kMaxPoints] = {candidates[firstPoint(normal, band, candidates)]};
  int count = 1;
  const float touching = maxOf(kept[0].separation, 0.0f) + band;
  for (; count < kMaxPoints; ++count) {
    int next = farthestFrom(kept, count, touching, band, candidates);
    if (next < 0) next = farthestFrom(kept, count, 3.0e38f, band, candidates);
    if (next < 0) break;
    kept[count] = candidates[next];
  }
  candidates.assign(kept, kept + count);
}

void keepImpulses(const ManifoldPoint* old, int oldCount, float radius, Manifold& fresh) {
  bool used[kMaxPoints] = {};
  for (int i = 0; i < fresh.count; ++i) {
    ManifoldPoint& point = fresh.points[i];
    int nearest = -1;
    float best = radius * radius;
    for (int k = 0; k < oldCount; ++k) {
      if (used[k]) continue;
      const float squared =
          minOf((old[k].localA - point.localA).squaredNorm(), (old[k].localB - point.localB).squaredNorm());
      if (squared >= best) continue;
      best = squared;
      nearest = k;
    }
    if (nearest < 0) continue;
    used[nearest] = true;
    point.normalImpulse = old[nearest].normalImpulse;
  }
}

}  // namespace brittle::physics
