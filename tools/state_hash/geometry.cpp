#include "engine/core/hash.h"
#include "engine/core/random.h"
#include "engine/fracture/fracture.h"
#include "engine/geometry/make.h"
#include "engine/geometry/mass.h"
#include "engine/geometry/split.h"
#include "tools/state_hash/sections.h"

namespace brittle {
namespace {

void add(StateHash& hash, const Vec3& v) {
  for (int i = 0; i < 3; ++i) hash.add(v[i]);
}

void add(StateHash& hash, const geometry::MassProperties& mass) {
  hash.add(mass.volume);
  add(hash, mass.center);
  for (int i = 0; i < 9; ++i) hash.add(mass.inertia.data()[i]);
}

void add(StateHash& hash, const geometry::ConvexView& convex) {
  for (const geometry::Vertex& vertex : convex.vertices) {
    add(hash, vertex.point);
    hash.add(vertex.normal);
  }
  for (const geometry::Face& face : convex.faces) {
    add(hash, face.plane.normal);
    hash.add(face.plane.offset);
    hash.add(static_cast<std::uint32_t>(face.edge));
  }
  for (const geometry::Edge& edge : convex.edges) {
    hash.add(static_cast<std::uint32_t>(edge.face) << 16 | edge.vertex);
    hash.add(static_cast<std::uint32_t>(edge.next) << 16 | edge.opposite);
  }
}

Vec3 randomVector(Random& random, float size) {
  const float x = random.nextFloat(-size, size);
  const float y = random.nextFloat(-size, size);
  const float z = random.nextFloat(-size, size);
  return Vec3(x, y, z);
}

/// A box cut a thousand times, each time a piece chosen at random by a plane near its centre.
std::uint64_t cuts() {
  StateHash hash;
  Random random(21);
  std::vector<geometry::Convex> pieces = {geometry::makeBox<float>(Vec3(1.0f, 0.8f, 0.05f))};
  geometry::SplitScratch scratch;
  geometry::Convex above, below;
  for (int i = 0; i < 1000; ++i) {
    const std::uint32_t which = random.nextBelow(static_cast<std::uint32_t>(pieces.size()));
    const Vec3 normal = normalizedOr(randomVector(random, 1.0f), Vec3::UnitX());
    const Vec3 center = geometry::massOf<float>(pieces[which].view()).center;
    const auto outcome =
        geometry::split<float>(pieces[which].view(), planeThrough(center, normal), {}, scratch, above, below);
    hash.add(static_cast<std::uint32_t>(outcome));
    if (outcome != geometry::SplitOutcome::Split) continue;
    pieces[which].assign(above.view());
    pieces.push_back(below);
  }
  for (const geometry::Convex& piece : pieces) {
    add(hash, piece.view());
    add(hash, geometry::massOf<float>(piece.view()));
  }
  return hash.value();
}

std::uint64_t hulls() {
  StateHash hash;
  Random random(22);
  for (int i = 0; i < 100; ++i) {
    std::vector<Vec3> points;
    const std::uint32_t count = 4 + random.nextBelow(28);
    for (std::uint32_t k = 0; k < count; ++k) points.push_back(randomVector(random, 1.0f));
    const auto hull = geometry::makeHull(points);
    hash.add(static_cast<bool>(hull));
    if (hull) add(hash, hull->view());
  }
  add(hash, geometry::makeCylinder(0.5f, 1.0f, 24).view());
  return hash.value();
}

std::uint64_t breaking(fracture::Pattern pattern, const Vec3& halfExtents) {
  StateHash hash;
  Random random(23);
  fracture::Fracturer fracturer;
  const geometry::Convex box = geometry::makeBox<float>(halfExtents);
  const fracture::Part part{box.view(), true, 1};
  fracture::FractureMaterial material;
  material.pattern = pattern;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    fracture::Impact impact;
    impact.point = randomVector(random, 0.4f);
    impact.speed = random.nextFloat(4.0f, 30.0f);
    impact.strikerRadius = 0.13f;
    const fracture::Fracture& result = fracturer.fracture({&part, 1}, {&impact, 1}, material, 0.002f, seed);
    for (const fracture::Piece& piece : result.pieces) {
      add(hash, piece.mass);
      hash.add(piece.group);
      if (!piece.isWhole) add(hash, result.convexes[piece.convex].view());
    }
    for (const fracture::Crumb& crumb : result.crumbs) hash.add(crumb.volume);
  }
  return hash.value();
}

}  // namespace

void addGeometry(std::vector<Line>& lines) {
  lines.push_back({"a thousand cuts", cuts()});
  lines.push_back({"hulls", hulls()});
  lines.push_back({"breaking a pane", breaking(fracture::Pattern::Pane, Vec3(1.0f, 0.7f, 0.02f))});
  lines.push_back({"breaking a block", breaking(fracture::Pattern::Block, Vec3(0.5f, 0.5f, 0.4f))});
  lines.push_back({"breaking tempered glass", breaking(fracture::Pattern::Tempered, Vec3(0.25f, 0.2f, 0.02f))});
}

}  // namespace brittle
