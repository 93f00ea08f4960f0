#include "engine/fracture/neighbours.h"

#include <algorithm>

#include "engine/geometry/clip.h"

namespace brittle::fracture {

std::uint32_t mainCorners(std::span<const Vec3> polygon, const Vec3& normal, Vec3 (&corners)[4]) {
  if (polygon.size() <= 4) {
    for (std::size_t i = 0; i < polygon.size(); ++i) corners[i] = polygon[i];
    return static_cast<std::uint32_t>(polygon.size());
  }
  // The corner farthest from the first, the one farthest from that, and the outermost on both sides of the line between
  // them.
  const auto farthestFrom = [&](const Vec3& point) {
    std::size_t best = 0;
    float most = -1.0f;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const float squared = (polygon[i] - point).squaredNorm();
      if (squared > most) {
        most = squared;
        best = i;
      }
    }
    return best;
  };
  const std::size_t a = farthestFrom(polygon[0]);
  const std::size_t b = farthestFrom(polygon[a]);
  const Vec3 aside = normal.cross(polygon[b] - polygon[a]);
  std::size_t right = a, left = a;
  float least = 0.0f, most = 0.0f;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const float at = aside.dot(polygon[i] - polygon[a]);
    if (at < least) {
      least = at;
      right = i;
    }
    if (at > most) {
      most = at;
      left = i;
    }
  }
  std::uint32_t count = 0;
  corners[count++] = polygon[a];
  if (right != a) corners[count++] = polygon[right];
  corners[count++] = polygon[b];
  if (left != a) corners[count++] = polygon[left];
  return count;
}

void SharedFaceFinder::find(std::span<const Node> pieces, float leastArea, std::vector<SharedFace>& shared) {
  shared.clear();
  collect(pieces);
  for (std::size_t first = 0, last = 0; first < caps_.size(); first = last) {
    // The caps of one cut lie in one plane; those that face the same way are on the same side of it.
    above_.clear();
    below_.clear();
    const Vec3& facing = pieces[caps_[first].piece].convex.faces[caps_[first].face].plane.normal;
    for (last = first; last < caps_.size() && caps_[last].cut == caps_[first].cut; ++last) {
      const Vec3& normal = pieces[caps_[last].piece].convex.faces[caps_[last].face].plane.normal;
      (normal.dot(facing) > 0.0f ? above_ : below_).push_back(caps_[last]);
    }
    for (const CutFace& a : above_) {
      for (const CutFace& b : below_) {
        if (!pieces[a.piece].box.overlaps(pieces[b.piece].box)) continue;
        pair(pieces, a.piece < b.piece ? a : b, a.piece < b.piece ? b : a, leastArea, shared);
      }
    }
  }
  std::sort(shared.begin(), shared.end(), [](const SharedFace& a, const SharedFace& b) {
    return a.seed.pieceA != b.seed.pieceA ? a.seed.pieceA < b.seed.pieceA : a.seed.pieceB < b.seed.pieceB;
  });
}

void SharedFaceFinder::collect(std::span<const Node> pieces) {
  caps_.clear();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].isUsed) continue;
    for (std::size_t f = 0; f < pieces[i].convex.faces.size(); ++f) {
      const std::uint32_t cut = pieces[i].convex.faces[f].cut;
      if (cut != 0) caps_.push_back({cut, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(f)});
    }
  }
  std::sort(caps_.begin(), caps_.end(), [](const CutFace& a, const CutFace& b) {
    if (a.cut != b.cut) return a.cut < b.cut;
    return a.piece != b.piece ? a.piece < b.piece : a.face < b.face;
  });
}

void SharedFaceFinder::pair(std::span<const Node> pieces, const CutFace& a, const CutFace& b, float leastArea,
                            std::vector<SharedFace>& shared) {
  geometry::facePolygon(pieces[a.piece].convex, a.face, Transform{}, polygon_);
  geometry::clipToFace(pieces[b.piece].convex, b.face, Transform{}, clip_, polygon_);
  if (polygon_.size() < 3) return;
  const float area = geometry::polygonArea(polygon_);
  if (!(area > leastArea)) return;
  SharedFace& face = shared.emplace_back();
  face.area = area;
  face.seed.pieceA = a.piece;
  face.seed.pieceB = b.piece;
  face.seed.normal = pieces[a.piece].convex.faces[a.face].plane.normal;
  face.seed.pointCount = mainCorners(polygon_, face.seed.normal, face.seed.points);
}

}  // namespace brittle::fracture
