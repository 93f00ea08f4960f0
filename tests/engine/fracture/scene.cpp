#include "tests/engine/fracture/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/core/hash.h"
#include "engine/core/random.h"
#include "engine/geometry/make.h"

namespace brittle::fracture {

namespace {

double volumeOf(const geometry::ConvexView& convex) {
  const Vec3d origin = convex.vertices[0].point.cast<double>();
  double sixfold = 0.0;
  for (const geometry::Face& face : convex.faces) {
    const Vec3d first = convex.startOf(face.edge).cast<double>() - origin;
    for (std::uint32_t edge = convex.edges[face.edge].next; edge != face.edge; edge = convex.edges[edge].next) {
      const Vec3d a = convex.startOf(edge).cast<double>() - origin;
      const Vec3d b = convex.endOf(edge).cast<double>() - origin;
      sixfold += first.dot(a.cross(b));
    }
  }
  return sixfold / 6.0;
}

bool isInside(const geometry::ConvexView& convex, const Vec3& point, float margin) {
  for (const geometry::Face& face : convex.faces)
    if (face.plane.distance(point) > margin) return false;
  return true;
}

struct Hasher {
  std::uint64_t value = 0;
  template <class T>
  void add(const T& bits) {
    value = hashBytes(&bits, sizeof bits, value);
  }
  void add(const geometry::MassProperties& mass) {
    add(mass.volume);
    add(mass.center);
    add(mass.inertia);
  }
};

}  // namespace

Part& Scene::add(geometry::Convex convex, bool anchored) {
  convexes.push_back(std::move(convex));
  Part part;
  part.convex = convexes.back().view();
  part.anchored = anchored;
  part.id = static_cast<std::uint32_t>(parts.size()) + 100;
  parts.push_back(part);
  return parts.back();
}

Part& Scene::addBox(const Vec3& halfExtents, const Vec3& center, bool anchored) {
  return add(geometry::makeBox<float>(halfExtents, center), anchored);
}

double Scene::volume() const {
  double sum = 0.0;
  for (const Part& part : parts) sum += volumeOf(part.convex);
  return sum;
}

Scene pane() {
  Scene scene;
  scene.addBox({0.5f, 0.5f, 0.01f}, Vec3::Zero());
  return scene;
}

Scene panesWithSeam() {
  Scene scene;
  scene.addBox({0.25f, 0.5f, 0.01f}, {-0.25f, 0.0f, 0.0f});
  scene.addBox({0.25f, 0.5f, 0.01f}, {0.25f, 0.0f, 0.0f});
  return scene;
}

Scene block() {
  Scene scene;
  scene.addBox({0.25f, 0.25f, 0.25f}, Vec3::Zero());
  return scene;
}

Impact straightAt(const Vec3& point, float speed, float strikerRadius) {
  return {point, -Vec3::UnitZ(), speed, strikerRadius};
}

geometry::ConvexView viewOf(const Scene& scene, const Fracture& made, const Piece& piece) {
  if (!piece.isWhole) return made.convexes[piece.convex].view();
  for (const Part& part : scene.parts) {
    if (part.id == piece.source) return part.convex;
  }
  ADD_FAILURE() << "a piece of no part: " << piece.source;
  return {};
}

void expectSound(const Scene& scene, const Fracture& made) {
  double volume = 0.0, measured = 0.0;
  std::set<std::uint32_t> slots;
  for (const Piece& piece : made.pieces) {
    const geometry::ConvexView view = viewOf(scene, made, piece);
    const char* error = geometry::findTopologyError<float>(view);
    EXPECT_EQ(error, nullptr) << error;
    EXPECT_LE(geometry::convexityError(view), 4e-6f);
    EXPECT_LT(piece.group, made.groups.size());
    EXPECT_GT(piece.mass.volume, 0.0f);
    volume += piece.mass.volume;
    measured += volumeOf(view);
    if (piece.isWhole) continue;
    EXPECT_LT(piece.convex, made.convexCount);
    EXPECT_TRUE(slots.insert(piece.convex).second) << "two pieces share a convex";
  }
  EXPECT_EQ(slots.size(), made.convexCount);
  for (const Crumb& crumb : made.crumbs) {
    EXPECT_GE(crumb.volume, 0.0f);
    volume += crumb.volume;
    measured += crumb.volume;
  }
  EXPECT_NEAR(volume / scene.volume(), 1.0, 1e-6);
  EXPECT_NEAR(measured / scene.volume(), 1.0, 1e-6);

  std::vector<double> groupVolume(made.groups.size(), 0.0);
  for (const Piece& piece : made.pieces) groupVolume[piece.group] += piece.mass.volume;
  int kept = 0;
  for (std::size_t i = 0; i < made.groups.size(); ++i) {
    EXPECT_NEAR(made.groups[i].mass.volume / groupVolume[i], 1.0, 1e-5);
    kept += made.groups[i].keepsBody ? 1 : 0;
    EXPECT_FALSE(i > 0 && made.groups[i].anchored) << "anchored groups are one, the first";
  }
  EXPECT_LE(kept, 1);
  for (const Neighbours& pair : made.neighbours) {
    EXPECT_LT(pair.pieceA, pair.pieceB);
    EXPECT_NE(made.pieces[pair.pieceA].group, made.pieces[pair.pieceB].group);
    EXPECT_NEAR(pair.normal.norm(), 1.0f, 1e-5f);
    EXPECT_GE(pair.pointCount, 3u);
  }
}

void expectPartition(const Scene& scene, const Fracture& made, const Vec3& half, int samples) {
  Random random(7);
  int onBorders = 0;
  for (int i = 0; i < samples; ++i) {
    Vec3 point;
    for (int k = 0; k < 3; ++k) point[k] = half[k] * random.nextFloat(-1.0f, 1.0f);
    int strictly = 0, loosely = 0;
    for (const Piece& piece : made.pieces) {
      const geometry::ConvexView view = viewOf(scene, made, piece);
      if (!isInside(view, point, 2e-6f)) continue;
      ++loosely;
      strictly += isInside(view, point, -2e-6f) ? 1 : 0;
    }
    ASSERT_LE(strictly, 1) << "two pieces overlap at " << point.transpose();
    ASSERT_GE(loosely, 1) << "a gap at " << point.transpose();
    onBorders += strictly == 0 ? 1 : 0;
  }
  EXPECT_LT(onBorders, samples / 100);
}

std::uint64_t hashOf(const Fracture& made) {
  Hasher hasher;
  for (const Piece& piece : made.pieces) {
    hasher.add(piece.source);
    hasher.add(piece.isWhole);
    hasher.add(piece.anchored);
    hasher.add(piece.isFragment);
    hasher.add(piece.group);
    hasher.add(piece.mass);
    if (piece.isWhole) continue;
    for (const geometry::Vertex& vertex : made.convexes[piece.convex].vertices) hasher.add(vertex.point);
    for (const geometry::Edge& edge : made.convexes[piece.convex].edges) hasher.add(edge);
  }
  for (const Group& group : made.groups) {
    hasher.add(group.keepsBody);
    hasher.add(group.mass);
  }
  for (const Neighbours& pair : made.neighbours) {
    hasher.add(pair.pieceA);
    hasher.add(pair.pieceB);
    hasher.add(pair.normal);
    for (std::uint32_t i = 0; i < pair.pointCount; ++i) hasher.add(pair.points[i]);
  }
  for (const Crumb& crumb : made.crumbs) {
    hasher.add(crumb.center);
    hasher.add(crumb.volume);
  }
  hasher.add(made.refusedCuts);
  return hasher.value;
}

float distanceFromLine(const geometry::ConvexView& convex, const Vec3& point, const Vec3& direction) {
  // Seen along the line the convex is the hull of its vertices' shadows: the distance of the origin from that hull.
  const Vec3 right = perpendicular(direction);
  const Vec3 up = direction.cross(right);
  std::vector<std::pair<double, double>> shadow;
  for (const geometry::Vertex& vertex : convex.vertices) {
    const Vec3 offset = vertex.point - point;
    shadow.emplace_back(offset.dot(right), offset.dot(up));
  }
  // Separated along some direction if at all: the hull's edges and corners give the candidates.
  double best = -1.0;
  for (const auto& a : shadow) {
    for (const auto& b : shadow) {
      double x = a.second - b.second, y = b.first - a.first;
      if (&a == &b) x = a.first, y = a.second;
      const double length = std::sqrt(x * x + y * y);
      if (length < 1e-12) continue;
      double least = 1e30;
      for (const auto& c : shadow) least = std::min(least, (c.first * x + c.second * y) / length);
      best = std::max(best, least);
    }
  }
  return static_cast<float>(std::max(best, 0.0));
}

}  // namespace brittle::fracture
