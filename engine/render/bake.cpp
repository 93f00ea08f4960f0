#include "engine/render/bake.h"

#include <cmath>

#include "engine/math/trig.h"
#include "engine/render/tiles.h"

namespace brittle::render {

namespace {

constexpr int kRays = 24;
constexpr float kLift = 0.02f;         // start of a ray above its face [m]: clear of boxes that only share the face's plane
constexpr float kSmallestQuad = 0.1f;  // [m]
constexpr float kTileInset = 1.0f / 256.0f;  // keeps bilinear look-ups inside a tile [of the atlas]

/// Directions over the hemisphere about +Z, denser towards the pole as light counts there (golden-angle spiral).
std::array<Vec3, kRays> hemisphere() {
  std::array<Vec3, kRays> rays;
  for (int i = 0; i < kRays; ++i) {
    const float height = std::sqrt(1.0f - (static_cast<float>(i) + 0.5f) / kRays);
    const float across = std::sqrt(1.0f - height * height);
    const float turn = 2.39996323f * static_cast<float>(i);
    rays[static_cast<std::size_t>(i)] = Vec3(across * cosine(turn), across * sine(turn), height);
  }
  return rays;
}

/// Distance at which a ray enters the box, or `reach` if it does not within that. Inside counts as 0.
float distanceTo(const Aabb& box, const Vec3& from, const Vec3& direction, float reach) {
  float enter = 0.0f, leave = reach;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(direction[axis]) < 1e-6f) {
      if (from[axis] < box.low[axis] || from[axis] > box.high[axis]) return reach;
      continue;
    }
    const float a = (box.low[axis] - from[axis]) / direction[axis], b = (box.high[axis] - from[axis]) / direction[axis];
    enter = maxOf(enter, minOf(a, b));
    leave = minOf(leave, maxOf(a, b));
  }
  return enter < leave ? enter : reach;
}

class Baker {
 public:
  Baker(std::span<const BakeBox> boxes, const BakeDef& def) : boxes_(boxes), def_(def), rays_(hemisphere()) {
    for (const BakeBox& box : boxes) {
      bounds_.push_back({box.center - box.halfExtents, box.center + box.halfExtents});
    }
    bounds_.insert(bounds_.end(), def.beyond.begin(), def.beyond.end());
  }

  BakedMesh run() {
    for (const BakeBox& box : boxes_) {
      for (int axis = 0; axis < 3; ++axis) {
        if (isSeen(box, axis, 1.0f)) addFace(box, axis, 1.0f);
        if (isSeen(box, axis, -1.0f)) addFace(box, axis, -1.0f);
      }
    }
    return std::move(mesh_);
  }

 private:
  /// The camera flies along -Z at x = 0, y = 1: it never sees what looks away from there.
  bool isSeen(const BakeBox& box, int axis, float sign) const {
    if (def_.allFaces) return true;
    if (axis == 2) return sign > 0.0f;
    const float travel = axis == 1 ? 1.0f : 0.0f;
    return (travel - (box.center[axis] + sign * box.halfExtents[axis])) * sign > 0.0f;
  }

  float lightOf(int axis, float sign) const {
    const FaceLight& l = def_.light;
    if (axis == 0) return sign > 0.0f ? l.right : l.left;
    if (axis == 1) return sign > 0.0f ? l.top : l.bottom;
    return sign > 0.0f ? l.front : l.back;
  }

  /// u and v run along the other two axes so that (u, v, normal) is right-handed.
  void addFace(const BakeBox& box, int axis, float sign) {
    const int u = sign > 0.0f ? (axis + 1) % 3 : (axis + 2) % 3;
    const int v = sign > 0.0f ? (axis + 2) % 3 : (axis + 1) % 3;
    const float step = maxOf(box.tileSize[static_cast<std::size_t>(axis)], kSmallestQuad);
    const Vec3 low = box.center - box.halfExtents, size = 2.0f * box.halfExtents;
    findNear(box, axis, sign);
    for (float y = 0.0f; y < size[v] - 1e-4f; y += step) {
      for (float x = 0.0f; x < size[u] - 1e-4f; x += step) {
        Vec3 corner = low;
        if (sign > 0.0f) corner[axis] += size[axis];
        corner[u] += x;
        corner[v] += y;
        addQuad(box, axis, sign, corner, minOf(step, size[u] - x), minOf(step, size[v] - y), step);
      }
    }
  }

  void addQuad(const BakeBox& box, int axis, float sign, const Vec3& corner, float width, float height, float step) {
    const int u = sign > 0.0f ? (axis + 1) % 3 : (axis + 2) % 3;
    const int v = sign > 0.0f ? (axis + 2) % 3 : (axis + 1) % 3;
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto kind = static_cast<std::size_t>(axis);
    const Rgb half = box.color[kind] * (0.5f * lightOf(axis, sign));
    for (int i = 0; i < 4; ++i) {
      const float right = i == 1 || i == 2 ? 1.0f : 0.0f, up = i >= 2 ? 1.0f : 0.0f;
      StaticVertex vertex;
      vertex.point = corner;
      vertex.point[u] += right * width;
      vertex.point[v] += up * height;
      setTile(box.tile[kind], box.tileRotation[kind], right * width / step, up * height / step, vertex);
      vertex.color = packRgba(half, opennessAt(vertex.point, axis, sign));
      mesh_.vertices.push_back(vertex);
    }
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh_.indices.push_back(first + k);
  }

  static void setTile(int tile, int quarterTurns, float x, float y, StaticVertex& vertex) {
    for (int i = 0; i < (quarterTurns & 3); ++i) {
      const float old = x;
      x = 1.0f - y;
      y = old;
    }
    const float side = 1.0f / kTilesAcross;
    const int index = tile & (kTilesAcross * kTilesAcross - 1);
    vertex.u = static_cast<float>(index % kTilesAcross) * side + kTileInset + x * (side - 2.0f * kTileInset);
    vertex.v = static_cast<float>(index / kTilesAcross) * side + kTileInset + y * (side - 2.0f * kTileInset);
  }

  /// Boxes that can reach this face with their shadow.
  void findNear(const BakeBox& box, int axis, float sign) {
    Aabb reach{box.center - box.halfExtents, box.center + box.halfExtents};
    if (sign > 0.0f) reach.low[axis] = reach.high[axis];
    else reach.high[axis] = reach.low[axis];
    reach = reach.grownBy(def_.occlusionReach);
    near_.clear();
    for (const Aabb& other : bounds_) {
      if (other.overlaps(reach)) near_.push_back(other);
    }
  }

  float opennessAt(const Vec3& point, int axis, float sign) const {
    Vec3 from = point;
    from[axis] += sign * kLift;
    float open = 0.0f;
    for (const Vec3& ray : rays_) {
      Vec3 direction;
      direction[axis] = sign * ray.z();
      direction[(axis + 1) % 3] = ray.x();
      direction[(axis + 2) % 3] = ray.y();
      float nearest = def_.occlusionReach;
      for (const Aabb& box : near_) nearest = minOf(nearest, distanceTo(box, from, direction, nearest));
      open += nearest / def_.occlusionReach;
    }
    return open / kRays;
  }

  std::span<const BakeBox> boxes_;
  const BakeDef& def_;
  std::array<Vec3, kRays> rays_;
  std::vector<Aabb> bounds_, near_;
  BakedMesh mesh_;
};

}  // namespace

BakedMesh bake(std::span<const BakeBox> boxes, const BakeDef& def) { return Baker(boxes, def).run(); }

}  // namespace brittle::render
