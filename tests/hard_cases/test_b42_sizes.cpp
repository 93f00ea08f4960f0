// B42: tolerances follow size. Glass cut to shards of 1 mm, 1 cm, 10 cm and 1 m, packed in a bin, and piles of prisms
// down to 0.1 mm thin, laid on each other: at rest no two shards overlap by 2 % of the smaller one's size or more, no
// two prisms by 2 % of their thickness; mass, centre and inertia are those of the shape (1e-6, 1e-6 of the size, 1e-5);
// and no shard has changed its shape.
#include <gtest/gtest.h>

#include <vector>

#include "engine/core/random.h"
#include "engine/geometry/mass.h"
#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"
#include "tests/hard_cases/spray.h"

namespace brittle::physics {
namespace {

/// Four walls and a floor around a square of the given half width.
void addBin(World& world, float half) {
  const float wall = 2.0f * half;
  addBox(world, bodyAt(Vec3(0.0f, -wall, 0.0f), BodyType::Static), Vec3(4.0f * half, wall, 4.0f * half));
  for (const float side : {-1.0f, 1.0f}) {
    addBox(world, bodyAt(Vec3(side * (half + wall), 0.0f, 0.0f), BodyType::Static),
           Vec3(wall, 8.0f * half, 4.0f * half));
    addBox(world, bodyAt(Vec3(0.0f, 0.0f, side * (half + wall)), BodyType::Static),
           Vec3(4.0f * half, 8.0f * half, wall));
  }
}

double sizeOf(const World& world, const Shape& shape) {
  return static_cast<double>(lengthOf(world.meshes().view(shape.mesh)));
}

double thicknessOf(const World&, const Shape& shape) {
  return 2.0 * static_cast<double>(shape.innerRadius);
}

using Measure = double (*)(const World&, const Shape&);

/// Of all pairs with at least one shard: the deepest overlap, relative to the smaller shard's measure.
double deepestOverlap(const World& world, Measure measure) {
  const State& state = world.state();
  double deepest = 0.0;
  state.shapes.forEach([&](ShapeHandle handleA, const Shape& a) {
    if (!state.bodyOf(a).isDynamic()) return;
    state.shapes.forEach([&](ShapeHandle handleB, const Shape& b) {
      const Body& other = state.bodyOf(b);
      if (handleA == handleB || (other.isDynamic() && handleB < handleA)) return;
      if (other.isDynamic() && (state.bodyOf(a).center - other.center).norm() > state.bodyOf(a).radius + other.radius)
        return;
      geometry::SimplexCache cache;
      const float distance = geometry::separation(proxyOf(a, state.meshes), state.bodyOf(a).pose,
                                                  proxyOf(b, state.meshes), other.pose, cache)
                                 .distance;
      const double size = other.isDynamic() ? minOf(measure(world, a), measure(world, b)) : measure(world, a);
      deepest = maxOf(deepest, static_cast<double>(-distance) / size);
    });
  });
  return deepest;
}

geometry::ConvexT<double> doubleOf(const geometry::ConvexView& convex) {
  geometry::ConvexT<double> result;
  for (const geometry::Vertex& vertex : convex.vertices) result.vertices.push_back({vertex.point.cast<double>()});
  for (const geometry::Face& face : convex.faces)
    result.faces.push_back({{face.plane.normal.cast<double>(), double(face.plane.offset)}, face.edge, face.kind});
  result.edges.assign(convex.edges.begin(), convex.edges.end());
  return result;
}

void expectExactMasses(const World& world) {
  const State& state = world.state();
  std::vector<double> masses(state.bodies.capacity(), 0.0);
  state.shapes.forEach([&](ShapeHandle, const Shape& shape) {
    const auto exact = geometry::massOf<double>(doubleOf(world.meshes().view(shape.mesh)).view());
    const geometry::MassProperties& found = shape.massProperties;
    EXPECT_NEAR(double(found.volume) / exact.volume, 1.0, 1e-6);
    EXPECT_LT((found.center.cast<double>() - exact.center).norm(), 1e-6 * sizeOf(world, shape));
    EXPECT_LT((found.inertia.cast<double>() - exact.inertia).norm(), 1e-5 * exact.inertia.norm());
    masses[shape.body.index] += exact.volume * double(shape.surface.density);
  });
  world.forEachBody([&](BodyHandle handle, const Body& body) {
    if (!body.isDynamic()) return;
    EXPECT_NEAR(double(body.mass) / masses[handle.index], 1.0, 1e-6);
  });
}

/// The bits of all shards' vertices.
std::vector<float> shapesOf(const World& world) {
  std::vector<float> all;
  world.state().shapes.forEach([&](ShapeHandle, const Shape& shape) {
    for (const geometry::Vertex& vertex : world.meshes().view(shape.mesh).vertices)
      for (int i = 0; i < 3; ++i) all.push_back(vertex.point[i]);
  });
  return all;
}

/// Lets them come to rest, still awake, and says what the criterion asks for.
void expectSoundAtRest(World& world, const char* what, float size, Measure measure) {
  SCOPED_TRACE(std::string(what) + " of " + std::to_string(1000.0f * size) + " mm");
  const std::vector<float> before = shapesOf(world);
  ASSERT_LT(deepestOverlap(world, measure), 1e-3);
  for (int tick = 0; tick < 360; ++tick) world.step(kTick);
  EXPECT_EQ(shapesOf(world), before);
  expectExactMasses(world);
  const double overlap = deepestOverlap(world, measure);
  EXPECT_LT(overlap, 0.02);
  hard::reportWorst(what + std::string(" overlap"), 100.0 * overlap,
                    measure == sizeOf ? "% of the size" : "% of the thickness");
  hard::reportSum("shards", static_cast<double>(world.state().bodies.size() - 5));
}

WorldDef awake() {
  WorldDef def;
  def.accuracy.deactivation = false;
  return def;
}

TEST(B42, PackedShardsOfAnySize) {
  for (const float size : {0.001f, 0.01f, 0.1f, 1.0f}) {
    World world(awake());
    addBin(world, 2.4f * size);
    BodyDef block = bodyAt(Vec3(0.0f, 2.01f * size, 0.0f));
    block.breakable.strength = 1e9f;
    block.breakable.material.pattern = fracture::Pattern::Block;
    block.breakable.material.carveRadius = 2.4f * size;
    block.breakable.material.density = 6.0f;
    block.breakable.material.minVolume = 1e-3f * size * size * size;
    const BodyHandle body = addBox(world, block, Vec3::Constant(2.0f * size), shapeDef(2500.0f));
    world.breakBody(body, Vec3(0.2f * size, 4.0f * size, 0.1f * size), -Vec3::UnitY(), 10.0f, 0.2f * size);
    EXPECT_GE(world.state().bodies.size(), 45u) << size;
    expectSoundAtRest(world, "shards", size, sizeOf);
  }
}

TEST(B42, PrismsDownToATenthOfAMillimetre) {
  const Vec2 triangle[] = {Vec2(-0.5f, -0.4f), Vec2(0.5f, -0.3f), Vec2(0.1f, 0.5f)};
  for (const float thickness : {0.0001f, 0.0003f, 0.001f, 0.01f}) {
    for (const float width : {10.0f * thickness, 100.0f * thickness}) {
      World world(awake());
      addBin(world, 0.9f * width);
      Vec2 corners[3];
      for (int i = 0; i < 3; ++i) corners[i] = triangle[i] * width;
      const auto prism = geometry::makePrism(corners, 0.5f * thickness);
      ASSERT_TRUE(static_cast<bool>(prism));
      Random random(42, 1);
      const Quat flat(0.70710678f, 0.70710678f, 0.0f, 0.0f);
      for (int i = 0; i < 30; ++i) {
        BodyDef def = bodyAt(Vec3(0.0f, thickness * (0.5f + 1.01f * static_cast<float>(i)), 0.0f));
        def.pose.rotation = rotationAbout(Vec3::UnitY(), random.nextFloat(-3.0f, 3.0f)) * flat;
        world.addConvex(world.createBody(def), shapeDef(2500.0f), prism->view());
      }
      expectSoundAtRest(world, "prisms", thickness, thicknessOf);
    }
  }
}

}  // namespace
}  // namespace brittle::physics
