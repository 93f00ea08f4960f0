// Bakes test segments the way level editors do: a box's faces in tiles of four vertices and two triangles, colours
// halved, openness counted by rays. For tests of what reads such meshes; the game's own baker is engine/render/bake.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/byte_stream.h"
#include "game/content/baked_mesh.h"
#include "game/content/segment.h"
#include "tests/game/content/content_helpers.h"

namespace brittle::content {

/// What the archive of a mesh's file holds. `count`: the number before the indices, which differs between editors.
inline std::string meshBytes(const BakedMesh& mesh, std::uint32_t count) {
  ByteWriter out;
  out.write(static_cast<std::uint32_t>(mesh.vertices.size()));
  for (const BakedVertex& vertex : mesh.vertices) {
    for (const float number : {vertex.point.x(), vertex.point.y(), vertex.point.z(), vertex.u, vertex.v})
      out.write(number);
    out.write(vertex.color);
  }
  out.write(count);
  for (const std::uint32_t index : mesh.indices) out.write(index);
  return std::string(out.bytes().begin(), out.bytes().end());
}
inline std::string meshFile(const BakedMesh& mesh) {
  return archived(meshBytes(mesh, static_cast<std::uint32_t>(mesh.indices.size() / 3)));
}

/// A segment's visible boxes as triangles.
class MeshBaker {
 public:
  explicit MeshBaker(const Segment& segment) : segment_(segment) {
    for (const Box& box : segment.boxes)
      if (box.visible && !box.hidden)
        for (int side = 0; side < 6; ++side) addFace(box, side / 2, side % 2 == 0 ? -1.0f : 1.0f);
  }
  const BakedMesh& mesh() const { return mesh_; }

 private:
  static constexpr int kRays = 64;
  static constexpr float kReach = 4.0f;  // [m]

  /// As editors do: what the camera, flying along -Z at about (0, 1), never sees is left out.
  static bool isKept(const Box& box, int axis, float sign) {
    if (axis == 2) return sign > 0.0f;
    return (box.position[axis] - (axis == 1 ? 1.0f : 0.0f)) * sign < 0.0f;
  }

  void addFace(const Box& box, int axis, float sign) {
    if (!isKept(box, axis, sign)) return;
    const int u = sign > 0.0f ? (axis + 1) % 3 : (axis + 2) % 3, v = 3 - axis - u;
    const float tile = box.tileSize[static_cast<std::size_t>(axis)];
    Vec3 corner = box.position - box.halfExtents;
    corner[axis] = box.position[axis] + sign * box.halfExtents[axis];
    for (float y = 0.0f; y < 2.0f * box.halfExtents[v] - 1e-4f; y += tile)
      for (float x = 0.0f; x < 2.0f * box.halfExtents[u] - 1e-4f; x += tile) {
        Vec3 low = corner, high = corner;
        low[u] += x;
        low[v] += y;
        high[u] += std::min(x + tile, 2.0f * box.halfExtents[u]);
        high[v] += std::min(y + tile, 2.0f * box.halfExtents[v]);
        addTile(box, low, high, axis, sign, u, v);
      }
  }

  void addTile(const Box& box, const Vec3& low, const Vec3& high, int axis, float sign, int u, int v) {
    const auto kind = static_cast<std::size_t>(axis);
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (int i = 0; i < 4; ++i) {
      const bool isRight = i == 1 || i == 2, isUp = i >= 2;
      BakedVertex vertex;
      vertex.point = low;
      vertex.point[u] = isRight ? high[u] : low[u];
      vertex.point[v] = isUp ? high[v] : low[v];
      vertex.u = (static_cast<float>(box.tile[kind] % 8) + (isRight ? 31.0f : 1.0f) / 32.0f) / 8.0f;
      vertex.v = (static_cast<float>(box.tile[kind] / 8) + (isUp ? 31.0f : 1.0f) / 32.0f) / 8.0f;
      vertex.color = colorOf(box, axis, sign) | openness(vertex.point, axis, sign) << 24;
      mesh_.vertices.push_back(vertex);
    }
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh_.indices.push_back(first + i);
  }

  std::uint32_t colorOf(const Box& box, int axis, float sign) const {
    const float light = segment_.light[static_cast<std::size_t>(2 * axis) + (axis == 0 ? sign > 0.0f : sign < 0.0f)];
    std::uint32_t color = 0;
    for (int i = 0; i < 3; ++i) {
      const float half = box.color[static_cast<std::size_t>(axis)][i] * light * 0.5f * 255.0f;
      color |= static_cast<std::uint32_t>(std::clamp(half, 0.0f, 255.0f)) << (8 * i);
    }
    return color;
  }

  /// Rays evenly over the half sphere that leave the room, of 255.
  std::uint32_t openness(const Vec3& point, int axis, float sign) const {
    int open = 0;
    for (int i = 0; i < kRays; ++i) {
      const float height = (static_cast<float>(i) + 0.5f) / kRays, across = std::sqrt(1.0f - height * height);
      const float angle = 2.39996323f * static_cast<float>(i);  // the golden angle spreads them
      Vec3 ray;
      ray[axis] = sign * height;
      ray[(axis + 1) % 3] = across * std::cos(angle);
      ray[(axis + 2) % 3] = across * std::sin(angle);
      open += isBlocked(point + 0.02f * ray, ray) ? 0 : 1;
    }
    return static_cast<std::uint32_t>(open * 255 / kRays);
  }

  bool isBlocked(const Vec3& from, const Vec3& ray) const {
    return std::any_of(segment_.boxes.begin(), segment_.boxes.end(), [&](const Box& box) {
      float enter = 0.0f, leave = kReach;
      for (int i = 0; i < 3; ++i) {
        const float along = std::abs(ray[i]) < 1e-6f ? 1e-6f : ray[i];
        const float a = (box.position[i] - box.halfExtents[i] - from[i]) / along;
        const float b = (box.position[i] + box.halfExtents[i] - from[i]) / along;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
      }
      return box.visible && !box.hidden && enter < leave;
    });
  }

  const Segment& segment_;
  BakedMesh mesh_;
};

}  // namespace brittle::content
