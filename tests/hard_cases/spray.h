// A spray of glass shards onto a plate: the scene of hard case B40 and of its benchmark. The shards are what the engine
// cuts from blocks, 0.05 to 0.15 m long; they fly and spin in random directions within a cone, and collide with one
// another.
#pragma once

#include <cmath>
#include <deque>
#include <vector>

#include "engine/core/random.h"
#include "engine/physics/world.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {

inline constexpr int kSprayShards = 400;

struct SprayDef {
  float speed = 60.0f;                // of the shards, downwards within 0.2 rad [m/s]
  float thickness = 0.02f;            // of the plate [m]
  BodyType plate = BodyType::Static;  // a dynamic one is of steel and flies without weight
  Vec3 plateVelocity = Vec3::Zero();  // [m/s]
  std::uint64_t seed = 40;            // of places, directions and spins
  Vec3 plateCenter = Vec3::Zero();    // beneath the spray; far away: the same without a plate
};

inline float lengthOf(const geometry::ConvexView& convex) {
  float squared = 0.0f;
  for (const geometry::Vertex& a : convex.vertices)
    for (const geometry::Vertex& b : convex.vertices) squared = maxOf(squared, (a.point - b.point).squaredNorm());
  return std::sqrt(squared);
}

/// Shards cut from blocks of glass, as bodies of worlds that only keep them.
struct ShardSet {
  std::deque<World> worlds;
  std::vector<geometry::ConvexView> shards;
  ShardSet() {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) cutBlock(seed);
    BR_ASSERT(shards.size() >= kSprayShards);
  }
  void cutBlock(std::uint64_t seed) {
    const float half = 0.04f + 0.008f * static_cast<float>(seed);
    WorldDef def;
    def.seed = seed;
    World& world = worlds.emplace_back(def);
    BodyDef block = bodyAt(Vec3::Zero());
    block.breakable.strength = 1.0f;
    block.breakable.material.pattern = fracture::Pattern::Block;
    block.breakable.material.carveRadius = 0.6f;
    block.breakable.material.density = 20.0f;
    world.breakBody(addBox(world, block, Vec3(half, half, half)), Vec3(0.0f, half, 0.0f), -Vec3::UnitY(), 10.0f, 0.05f);
    world.forEachBody([&](BodyHandle, const Body& body) {
      const geometry::ConvexView convex = world.meshes().view(world.shape(body.firstShape).mesh);
      const float length = lengthOf(convex);
      if (length >= 0.05f && length <= 0.15f) shards.push_back(convex);
    });
  }
};

inline Vec3 randomInBall(Random& random) {
  for (;;) {
    const float x = random.nextFloat(-1.0f, 1.0f);
    const float y = random.nextFloat(-1.0f, 1.0f);
    const float z = random.nextFloat(-1.0f, 1.0f);
    const Vec3 point(x, y, z);
    if (point.squaredNorm() <= 1.0f) return point;
  }
}

struct Spray {
  SprayDef def;
  World world;
  BodyHandle plate;
  std::vector<BodyHandle> shards;

  explicit Spray(const SprayDef& sprayDef) : def(sprayDef) {
    static const ShardSet set;
    addPlate();
    Random random(def.seed);
    for (int i = 0; i < kSprayShards; ++i)
      addShard(set.shards[static_cast<std::size_t>(i) * set.shards.size() / kSprayShards], i, random);
  }

  void step() {
    if (def.plate == BodyType::Animated) {
      Transform target = world.body(plate).pose;
      target.position += def.plateVelocity * kTick;
      world.animate(world.body(plate).assembly, target);
    }
    world.step(kTick);
  }

  Vec3 plateHalfExtents() const {
    return Vec3(def.plateVelocity.x() != 0.0f ? 24.0f : 3.0f, 0.5f * def.thickness, 3.0f);
  }

 private:
  void addPlate() {
    BodyDef body = bodyAt(def.plateCenter, def.plate);
    body.gravityScale = 0.0f;
    if (def.plate == BodyType::Dynamic) body.velocity = def.plateVelocity;
    plate = addBox(world, body, plateHalfExtents(), shapeDef(7800.0f));
  }

  /// Ten by ten in four layers, the lowest half a metre above the plate.
  void addShard(const geometry::ConvexView& convex, int i, Random& random) {
    const Vec3 place(0.17f * (static_cast<float>(i % 10) - 4.5f), 0.5f + 0.17f * static_cast<float>(i / 100),
                     0.17f * (static_cast<float>(i / 10 % 10) - 4.5f));
    const Vec3 turn = randomInBall(random) * 3.0f;
    const Vec3 aside = randomInBall(random) * 0.2f;
    BodyDef body;
    body.angularVelocity = randomInBall(random) * 20.0f;
    body.pose.rotation = integrateRotation(Quat::Identity(), turn, 1.0f);
    body.pose.position = place - body.pose.rotation * geometry::massOf(convex).center;
    body.velocity = def.speed * Vec3(aside.x(), -1.0f, aside.z()).normalized();
    const BodyHandle shard = world.createBody(body);
    world.addConvex(shard, shapeDef(2500.0f), convex);
    shards.push_back(shard);
  }
};

}  // namespace brittle::physics
