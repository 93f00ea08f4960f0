// Where joints go when the shape that holds their anchor is split. Pieces keep the local frame of their body, so an
// anchor needs no new coordinates, only a new owner.
#include "engine/physics/joint_move.h"

#include "engine/physics/state.h"

namespace brittle::physics {

float anchorDistance(const State& state, const Shape& shape, const Vec3& anchorLocal) {
  const geometry::Proxy proxy = proxyOf(shape, state.meshes);
  if (geometry::containsPoint(proxy, Transform{}, anchorLocal)) return 0.0f;
  geometry::Proxy point;
  point.center = anchorLocal;
  geometry::SimplexCache cache;
  return maxOf(geometry::separation(proxy, Transform{}, point, Transform{}, cache).distance, 0.0f);
}

namespace {

/// The first piece that holds the anchor, else the nearest within `reach` (ties: the first), else null.
ShapeHandle findOwner(const State& state, const Vec3& anchorLocal, const ShapeHandle* pieces, std::uint32_t count,
                      float reach) {
  ShapeHandle nearest;
  float distance = 0.0f;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Shape* piece = state.shapes.find(pieces[i]);
    if (!piece) continue;
    const float d = anchorDistance(state, *piece, anchorLocal);
    if (d == 0.0f) return pieces[i];
    if (d <= reach && (!nearest || d < distance)) {
      nearest = pieces[i];
      distance = d;
    }
  }
  return nearest;
}

}  // namespace

std::uint32_t moveJoints(State& state, ShapeHandle source, const ShapeHandle* pieces, std::uint32_t count, float slop) {
  std::uint32_t removed = 0;
  for (std::uint32_t i = 0; i < state.joints.capacity(); ++i) {
    if (!state.joints.isAlive(i)) continue;
    Joint& joint = state.joints.at(i);
    const bool holdsA = joint.a == source;
    const bool holdsB = joint.b == source;
    if (!holdsA && !holdsB) continue;
    if (holdsA) joint.a = findOwner(state, joint.localAnchorA, pieces, count, joint.gapA + slop);
    if (holdsB) joint.b = findOwner(state, joint.localAnchorB, pieces, count, joint.gapB + slop);
    if ((holdsA && !joint.a) || (holdsB && !joint.b)) {
      state.joints.erase(state.joints.handleAt(i));
      ++removed;
    }
  }
  return removed;
}

}  // namespace brittle::physics
