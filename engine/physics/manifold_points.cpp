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

}  // namespace

void reducePoints(const Vec3& normal, float band, std::vector<Candidate>& candidates) {
  if (candidates.size() <= kMaxPoints) return;
  const int count = static_cast<int>(candidates.size());
  int chosen[4] = {firstPoint(normal, band, candidates), -1, -1, -1};
  const Vec3 first = candidates[chosen[0]].onA;
  float farthest = 0.0f;
  for (int i = 0; i < count; ++i) {
    const float squared = (candidates[i].onA - first).squaredNorm();
    if (squared > farthest) {
      farthest = squared;
      chosen[1] = i;
    }
  }
  float left = 0.0f, right = 0.0f;
  if (chosen[1] >= 0) {
    const Vec3 side = normal.cross(candidates[chosen[1]].onA - first);
    for (int i = 0; i < count; ++i) {
      const float value = side.dot(candidates[i].onA - first);
      if (value > left) {
        left = value;
        chosen[2] = i;
      }
      if (value < right) {
        right = value;
        chosen[3] = i;
      }
    }
  }
  Candidate kept[4];
  int keptCount = 0;
  for (const int index : chosen)
    if (index >= 0) kept[keptCount++] = candidates[index];
  candidates.assign(kept, kept + keptCount);
}

void keepImpulses(const ManifoldPoint* old, int oldCount, float radius, Manifold& fresh) {
  bool used[kMaxPoints] = {};
  for (int i = 0; i < fresh.count; ++i) {
    ManifoldPoint& point = fresh.points[i];
    int nearest = -1;
    float best = radius * radius;
    for (int k = 0; k < oldCount; ++k) {
      if (used[k]) continue;
      const float squared = minOf((old[k].localA - point.localA).squaredNorm(), (old[k].localB - point.localB).squaredNorm());
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
