#include "engine/geometry/simplex.h"

namespace brittle::geometry {

namespace {

/// Below this fraction of its largest possible size an area or volume counts as flat; double has 1e-16, and the float
/// vertices of a sliver of aspect 1e-4 stay far above it.
constexpr double kFlat = 1e-13;

/// Which of up to four vertices are kept, with which weights, and how far from the origin the point is.
struct Nearest {
  int kept[4] = {0, 0, 0, 0};
  double weights[4] = {1.0, 0.0, 0.0, 0.0};
  int count = 1;
  double squared = 0.0;
};

Nearest ofPoint(const Simplex& s, int i) {
  Nearest result;
  result.kept[0] = i;
  result.squared = s.vertices[i].w.squaredNorm();
  return result;
}

Nearest ofSegment(const Simplex& s, int i, int j) {
  const Vec3d& a = s.vertices[i].w;
  const Vec3d ab = s.vertices[j].w - a;
  const double along = -a.dot(ab), length = ab.squaredNorm();
  if (along <= 0.0) return ofPoint(s, i);
  if (along >= length) return ofPoint(s, j);
  Nearest result;
  result.count = 2;
  result.kept[0] = i;
  result.kept[1] = j;
  result.weights[1] = along / length;
  result.weights[0] = 1.0 - result.weights[1];
  result.squared = (a + result.weights[1] * ab).squaredNorm();
  return result;
}

const Nearest& nearer(const Nearest& a, const Nearest& b) {
  return b.squared < a.squared ? b : a;
}

Nearest ofTriangle(const Simplex& s, int i, int j, int k) {
  const Vec3d& a = s.vertices[i].w;
  const Vec3d& b = s.vertices[j].w;
  const Vec3d& c = s.vertices[k].w;
  const Vec3d ab = b - a, ac = c - a;
  const Vec3d n = ab.cross(ac);
  const double area = n.squaredNorm();
  // Weights by the areas of the three triangles with the projected origin.
  const double u = n.dot(b.cross(c)), v = n.dot(c.cross(a)), w = n.dot(a.cross(b));
  if (area > kFlat * kFlat * ab.squaredNorm() * ac.squaredNorm() && u > 0.0 && v > 0.0 && w > 0.0) {
    Nearest result;
    result.count = 3;
    const int kept[3] = {i, j, k};
    const double areas[3] = {u, v, w};
    const double scale = 1.0 / (u + v + w);
    for (int m = 0; m < 3; ++m) {
      result.kept[m] = kept[m];
      result.weights[m] = areas[m] * scale;
    }
    const double height = n.dot(a);
    result.squared = height * height / area;
    return result;
  }
  // An edge is nearest: where the origin projects outside of the triangle it is one of those it lies beyond.
  const bool flat = !(area > kFlat * kFlat * ab.squaredNorm() * ac.squaredNorm());
  Nearest best;
  best.squared = 1.0e300;
  if (flat || u <= 0.0) best = nearer(best, ofSegment(s, j, k));
  if (flat || v <= 0.0) best = nearer(best, ofSegment(s, k, i));
  if (flat || w <= 0.0) best = nearer(best, ofSegment(s, i, j));
  return best;
}

Nearest ofTetrahedron(const Simplex& s) {
  static constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
  Nearest best;
  best.squared = 1.0e300;
  bool inside = true;
  for (const int(&face)[4] : kFaces) {
    const Vec3d& a = s.vertices[face[0]].w;
    const Vec3d ab = s.vertices[face[1]].w - a, ac = s.vertices[face[2]].w - a, ad = s.vertices[face[3]].w - a;
    const Vec3d n = ab.cross(ac);
    const double fourth = n.dot(ad), origin = -n.dot(a);
    const bool flat = fourth * fourth <= kFlat * kFlat * n.squaredNorm() * ad.squaredNorm();
    if (!flat && fourth * origin >= 0.0) continue;
    inside = false;
    best = nearer(best, ofTriangle(s, face[0], face[1], face[2]));
  }
  if (!inside) return best;
  Nearest all;
  all.count = 4;
  for (int i = 0; i < 4; ++i) {
    all.kept[i] = i;
    all.weights[i] = 0.25;
  }
  return all;
}

}  // namespace

void reduceToNearest(Simplex& simplex) {
  Nearest nearest;
  switch (simplex.count) {
    case 1:
      nearest = ofPoint(simplex, 0);
      break;
    case 2:
      nearest = ofSegment(simplex, 0, 1);
      break;
    case 3:
      nearest = ofTriangle(simplex, 0, 1, 2);
      break;
    default:
      nearest = ofTetrahedron(simplex);
      break;
  }
  if (nearest.count == simplex.count) {
    for (int i = 0; i < nearest.count; ++i) simplex.weights[i] = nearest.weights[i];
    return;
  }
  SimplexVertex kept[3];
  for (int i = 0; i < nearest.count; ++i) kept[i] = simplex.vertices[nearest.kept[i]];
  for (int i = 0; i < nearest.count; ++i) {
    simplex.vertices[i] = kept[i];
    simplex.weights[i] = nearest.weights[i];
  }
  simplex.count = nearest.count;
}

}  // namespace brittle::geometry
