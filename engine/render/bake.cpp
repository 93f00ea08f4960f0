#include "engine/render/bake.h"

#include <cmath>
#include <map>

#include "engine/render/bake_lines.h"
#include "engine/render/bake_shade.h"
#include "engine/render/lamp.h"
#include "engine/render/occlusion.h"
#include "engine/render/tiles.h"

namespace brittle::render {

namespace {

constexpr float kSmallestTile = 0.1f;        // [m]
constexpr float kEndless = 1e6f;             // [m]
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
  /// Side of a tile; a plain one has no end. [m]
  float tile() const { return box.tile[kind()] == 0 ? kEndless : maxOf(box.tileSize[kind()], kSmallestTile); }
  Aabb face() const {
    Aabb flat = boundsOf(box);
    if (sign > 0.0f)
      flat.low[axis] = flat.high[axis];
    else
      flat.high[axis] = flat.low[axis];
    return flat;
  }
};

/// The crossings of a face's lines that are a corner of some rectangle: whoever has one on its border bends there, too,
/// or the picture would show cracks.
class Corners {
 public:
  explicit Corners(const Shade& shade) : width_(shade.us.size()), used_(shade.colors.size(), false) {}
  void use(const Patch& p) {
    for (const std::size_t j : {p.low, p.high})
      for (const std::size_t i : {p.left, p.right}) used_[j * width_ + i] = true;
  }
  /// The corners on a rectangle's border, counter-clockwise from its lowest.
  std::vector<std::size_t> around(const Patch& p) const {
    std::vector<std::size_t> border;
    const auto add = [&](std::size_t i, std::size_t j) {
      if (used_[j * width_ + i]) border.push_back(j * width_ + i);
    };
    for (std::size_t i = p.left; i < p.right; ++i) add(i, p.low);
    for (std::size_t j = p.low; j < p.high; ++j) add(p.right, j);
    for (std::size_t i = p.right; i > p.left; --i) add(i, p.high);
    for (std::size_t j = p.high; j > p.low; --j) add(p.left, j);
    return border;
  }

 private:
  std::size_t width_;
  std::vector<bool> used_;
};

/// Of two colours, byte by byte.
std::uint32_t meanOf(std::uint32_t a, std::uint32_t b) {
  return (a & b) + (((a ^ b) & 0xfefefefeu) >> 1);
}

}  // namespace

struct Baker::Parts {
  Parts(std::span<const BakeBox> all, const BakeDef& definition)
      : boxes(all.begin(), all.end()), def(definition), occlusion_(boundsOf(all, def.beyond), def.occlusionReach) {
    for (const std::span<const BakeBox> some : {all, def.beyond}) addLamps(some, lamps_);
    def.beyond = {};  // its memory is the caller's
  }

  /// Of box number / 6, on one of its six sides.
  bool bakeSide(std::size_t number) {
    const BakeBox& box = boxes[number / 6];
    const int axis = static_cast<int>(number % 6 / 2);
    const float sign = number % 2 == 0 ? 1.0f : -1.0f;
    if (!isSeen(box, axis, sign)) return false;
    addFace({box, axis, sign});
    return true;
  }

  BakedMesh take() {
    mesh_.polished = static_cast<std::uint32_t>(polished_.size());
    mesh_.indices.insert(mesh_.indices.end(), polished_.begin(), polished_.end());
    return std::move(mesh_);
  }

  std::vector<BakeBox> boxes;
  BakeDef def;
  std::size_t next = 0;  // side to bake

 private:
  /// The camera flies along -Z at x = 0, y = 1: it never sees what looks away from there.
  bool isSeen(const BakeBox& box, int axis, float sign) const {
    if (def.allFaces) return true;
    if (axis == 2) return sign > 0.0f;
    const float travel = axis == 1 ? 1.0f : 0.0f;
    return (travel - (box.center[axis] + sign * box.halfExtents[axis])) * sign > 0.0f;
  }

  float lightOf(int axis, float sign) const {
    const FaceLight& l = def.light;
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
    const std::vector<std::size_t> us = tileLines(shade.us, side.tile()), vs = tileLines(shade.vs, side.tile());
    std::vector<std::vector<Patch>> tiles;
    Corners corners(shade);
    for (std::size_t j = 0; j + 1 < vs.size(); ++j)
      for (std::size_t i = 0; i + 1 < us.size(); ++i) {
        tiles.push_back(evenPatches(shade, {us[i], us[i + 1], vs[j], vs[j + 1]}));
        for (const Patch& patch : tiles.back()) corners.use(patch);
      }
    for (const std::vector<Patch>& tile : tiles) addTile(side, face, shade, corners, tile);
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

  /// Rectangles of one tile share their vertices; the first one begins where the tile does.
  void addTile(const Side& side, const Aabb& face, const Shade& shade, const Corners& corners,
               const std::vector<Patch>& patches) {
    const Vec2 tileStart(shade.us[patches[0].left], shade.vs[patches[0].low]);
    const auto vertexAt = [&](float u, float v, std::uint32_t color) {
      StaticVertex vertex;
      vertex.point = pointAt(face, side, u, v);
      setTile(side, (u - tileStart.x()) / side.tile(), (v - tileStart.y()) / side.tile(), vertex);
      vertex.color = color;
      mesh_.vertices.push_back(vertex);
      return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    };
    std::map<std::size_t, std::uint32_t> known;  // by crossing
    for (const Patch& p : patches) {
      std::vector<std::uint32_t> border;
      for (const std::size_t at : corners.around(p)) {
        const std::size_t i = at % shade.us.size(), j = at / shade.us.size();
        const auto found = known.find(at);
        border.push_back(found != known.end() ? found->second : vertexAt(shade.us[i], shade.vs[j], shade.colors[at]));
        known[at] = border.back();
      }
      if (border.size() == 4) {
        addQuad(side, border);
        continue;
      }
      const std::uint32_t color = meanOf(meanOf(shade.at(p.left, p.low), shade.at(p.right, p.high)),
                                         meanOf(shade.at(p.left, p.high), shade.at(p.right, p.low)));
      addFan(
          side, border,
          vertexAt(0.5f * (shade.us[p.left] + shade.us[p.right]), 0.5f * (shade.vs[p.low] + shade.vs[p.high]), color));
    }
  }

  void addTriangle(const Side& side, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::vector<std::uint32_t>& indices = side.box.reflects ? polished_ : mesh_.indices;
    indices.insert(indices.end(), {a, b, c});
  }

  /// Cut along the diagonal that is closer in shade, or a dark corner shows as a zigzag.
  void addQuad(const Side& side, const std::vector<std::uint32_t>& c) {
    const auto open = [&](std::size_t k) { return static_cast<int>(mesh_.vertices[c[k]].color >> 24); };
    const std::size_t turn = std::abs(open(0) - open(2)) <= std::abs(open(1) - open(3)) ? 0 : 1;
    addTriangle(side, c[turn], c[1 + turn], c[2 + turn]);
    addTriangle(side, c[turn], c[2 + turn], c[(3 + turn) % 4]);
  }

  void addFan(const Side& side, const std::vector<std::uint32_t>& border, std::uint32_t middle) {
    for (std::size_t i = 0; i < border.size(); ++i)
      addTriangle(side, middle, border[i], border[(i + 1) % border.size()]);
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

  Occlusion occlusion_;
  std::vector<Lamp> lamps_;
  BakedMesh mesh_;
  std::vector<std::uint32_t> polished_;
};

Baker::Baker(std::span<const BakeBox> boxes, const BakeDef& def) : parts_(std::make_unique<Parts>(boxes, def)) {}
Baker::~Baker() = default;
Baker::Baker(Baker&&) noexcept = default;
Baker& Baker::operator=(Baker&&) noexcept = default;

bool Baker::step() {
  while (parts_->next < 6 * parts_->boxes.size())
    if (parts_->bakeSide(parts_->next++)) return true;
  return false;
}

BakedMesh Baker::finish() {
  while (step()) {
  }
  return parts_->take();
}

BakedMesh bake(std::span<const BakeBox> boxes, const BakeDef& def) {
  return Baker(boxes, def).finish();
}

}  // namespace brittle::render
