#include "engine/render/bake.h"

#include <cmath>

#include "engine/render/bake_lines.h"
#include "engine/render/lamp.h"
#include "engine/render/occlusion.h"
#include "engine/render/tiles.h"

namespace brittle::render {

namespace {

constexpr float kSmallestTile = 0.1f;        // [m]
constexpr float kTileInset = 1.0f / 256.0f;  // keeps bilinear look-ups inside a tile [of the atlas]

Aabb boundsOf(const BakeBox& box) {
  return {box.center - box.halfExtents, box.center + box.halfExtents};
}

std::vector<Aabb> boundsOf(std::span<const BakeBox> boxes, std::span<const BakeBox> beyond) {
  std::vector<Aabb> bounds;
  // A lamp is a thin thing that lights what is next to it: it casts no shade.
  for (const std::span<const BakeBox> some : {boxes, beyond})
    for (const BakeBox& box : some)
      if (box.glow <= 0.0f) bounds.push_back(boundsOf(box));
  return bounds;
}

/// Light beyond what can be shown bends towards white instead of being cut off, so that a wall by a lamp keeps its
/// shape.
Rgb exposed(const Rgb& color) {
  constexpr float kKnee = 0.8f, kMost = 0.97f;
  Rgb result = color;
  for (int i = 0; i < 3; ++i)
    if (color[i] > kKnee) result[i] = kMost - (kMost - kKnee) * (kMost - kKnee) / (color[i] - 2.0f * kKnee + kMost);
  return result;
}

/// What openness is stored as. The shader shows 1 - (1 - a)^2 of the light, for the sake of ready-made meshes: an edge
/// of two walls, open 0.5, is to keep 0.7, and the middle of a corridor's wall all.
float shadeOf(float open) {
  constexpr float kOpen = 0.86f;
  const float share = minOf(open / kOpen, 1.0f);
  return share * std::sqrt(share);
}

/// One side of a box: u and v run along the other two axes so that (u, v, normal) is right-handed.
struct Side {
  const BakeBox& box;
  int axis;
  float sign;

  int u() const { return sign > 0.0f ? (axis + 1) % 3 : (axis + 2) % 3; }
  int v() const { return sign > 0.0f ? (axis + 2) % 3 : (axis + 1) % 3; }
  std::size_t kind() const { return static_cast<std::size_t>(axis); }
  float tile() const { return maxOf(box.tileSize[kind()], kSmallestTile); }
  Aabb face() const {
    Aabb flat = boundsOf(box);
    if (sign > 0.0f)
      flat.low[axis] = flat.high[axis];
    else
      flat.high[axis] = flat.low[axis];
    return flat;
  }
};

/// Light and openness at the crossings of a face's lines.
struct Shade {
  std::vector<float> us, vs;
  std::vector<std::uint32_t> colors;  // by row of v

  std::uint32_t at(std::size_t i, std::size_t j) const { return colors[j * us.size() + i]; }
};

class Baker {
 public:
  Baker(std::span<const BakeBox> boxes, const BakeDef& def)
      : boxes_(boxes), def_(def), occlusion_(boundsOf(boxes, def.beyond), def.occlusionReach) {
    for (const std::span<const BakeBox> some : {boxes, def.beyond}) addLamps(some, lamps_);
  }

  BakedMesh run() {
    for (const BakeBox& box : boxes_) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {1.0f, -1.0f})
          if (isSeen(box, axis, sign)) addFace({box, axis, sign});
      }
    }
    mesh_.polished = static_cast<std::uint32_t>(polished_.size());
    mesh_.indices.insert(mesh_.indices.end(), polished_.begin(), polished_.end());
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

  void addFace(const Side& side) {
    const Aabb face = side.face();
    occlusion_.focus(face, side.axis, side.sign);
    Shade shade;
    shade.us = cutLines({face, side.axis, side.u(), side.tile()}, occlusion_.near());
    shade.vs = cutLines({face, side.axis, side.v(), side.tile()}, occlusion_.near());
    for (const float v : shade.vs)
      for (const float u : shade.us) shade.colors.push_back(colorAt(side, pointAt(face, side, u, v)));
    for (std::size_t j = 0; j + 1 < shade.vs.size(); ++j)
      for (std::size_t i = 0; i + 1 < shade.us.size(); ++i) addQuad(side, face, shade, i, j);
  }

  static Vec3 pointAt(const Aabb& face, const Side& side, float u, float v) {
    Vec3 point = face.low;
    point[side.u()] += u;
    point[side.v()] += v;
    return point;
  }

  std::uint32_t colorAt(const Side& side, const Vec3& point) const {
    const Rgb& color = side.box.color[side.kind()];
    if (side.box.glow > 0.0f) return packRgba(0.5f * color);
    Vec3 normal = Vec3::Zero();
    normal[side.axis] = side.sign;
    const Vec3 light = lightAt(point, normal, lamps_, occlusion_) + Vec3::Constant(lightOf(side.axis, side.sign));
    return packRgba(0.5f * exposed(color.cwiseProduct(light)),
                    shadeOf(occlusion_.openness(point, side.axis, side.sign)));
  }

  void addQuad(const Side& side, const Aabb& face, const Shade& shade, std::size_t i, std::size_t j) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    // Whole tiles begin at multiples of the tile's size, and no quad lies across two.
    const auto tileOf = [&side](float low, float high) {
      return std::floor(0.5f * (low + high) / side.tile()) * side.tile();
    };
    const float tileU = tileOf(shade.us[i], shade.us[i + 1]), tileV = tileOf(shade.vs[j], shade.vs[j + 1]);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::size_t right = i + (corner == 1 || corner == 2 ? 1 : 0), up = j + (corner >= 2 ? 1 : 0);
      StaticVertex vertex;
      vertex.point = pointAt(face, side, shade.us[right], shade.vs[up]);
      setTile(side, (shade.us[right] - tileU) / side.tile(), (shade.vs[up] - tileV) / side.tile(), vertex);
      vertex.color = shade.at(right, up);
      mesh_.vertices.push_back(vertex);
    }
    // Cut along the diagonal that is closer in shade, or a dark corner shows as a zigzag.
    const auto open = [this, first](std::uint32_t k) {
      return static_cast<int>(mesh_.vertices[first + k].color >> 24);
    };
    const std::uint32_t turn = std::abs(open(0) - open(2)) <= std::abs(open(1) - open(3)) ? 0 : 1;
    std::vector<std::uint32_t>& indices = side.box.reflects ? polished_ : mesh_.indices;
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + (k + turn) % 4);
  }

  static void setTile(const Side& side, float x, float y, StaticVertex& vertex) {
    for (int i = 0; i < (side.box.tileRotation[side.kind()] & 3); ++i) {
      const float old = x;
      x = 1.0f - y;
      y = old;
    }
    const float width = 1.0f / kTilesAcross;
    const int index = side.box.tile[side.kind()] & (kTilesAcross * kTilesAcross - 1);
    vertex.u = static_cast<float>(index % kTilesAcross) * width + kTileInset + x * (width - 2.0f * kTileInset);
    vertex.v = static_cast<float>(index / kTilesAcross) * width + kTileInset + y * (width - 2.0f * kTileInset);
  }

  std::span<const BakeBox> boxes_;
  const BakeDef& def_;
  Occlusion occlusion_;
  std::vector<Lamp> lamps_;
  BakedMesh mesh_;
  std::vector<std::uint32_t> polished_;
};

}  // namespace

BakedMesh bake(std::span<const BakeBox> boxes, const BakeDef& def) {
  return Baker(boxes, def).run();
}

}  // namespace brittle::render
