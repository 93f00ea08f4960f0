// What bursts: nothing but conservation is exact, the rest is compared with the converged reference as distributions.
#include "engine/core/random.h"
#include "tests/engine/physics/scene.h"
#include "tools/accuracy/scene_list.h"

namespace brittle::accuracy {
namespace {

using physics::World;

/// On three sides: the balls come through the fourth.
void addWalls(World& world, float half) {
  for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, -1)})
    physics::addBox(world, physics::bodyAt(Vec3(0.0f, 2.0f, 0.0f) + side * (half + 0.5f), physics::BodyType::Static),
                    side.x() != 0.0f ? Vec3(0.5f, 3.0f, half + 1.0f) : Vec3(half + 1.0f, 3.0f, 0.5f));
}

void addStandingPane(World& world, float z) {
  physics::BodyDef pane = physics::bodyAt(Vec3(0.0f, 1.0f, z), physics::BodyType::Static);
  pane.breakable.strength = 20.0f;
  world.anchor(physics::addBox(world, pane, Vec3(1.5f, 1.0f, 0.015f), physics::shapeDef(2500.0f)));
}

void addBlock(World& world, const Vec3& center) {
  physics::BodyDef block = physics::bodyAt(center);
  block.breakable.strength = 60.0f;
  block.breakable.material.pattern = fracture::Pattern::Block;
  block.breakable.material.minVolume = 1e-4f;
  physics::addBox(world, block, Vec3::Constant(0.2f), physics::shapeDef(2500.0f));
}

}  // namespace

Stage buildShatter(World& world, int variant) {
  Random random(11, static_cast<std::uint64_t>(variant));
  physics::BodyDef block = physics::bodyAt(Vec3::Zero());
  block.velocity = Vec3(1.0f, 0.5f, 3.0f);
  block.angularVelocity = Vec3(1.0f, 2.0f, -0.5f);
  block.breakable.strength = 200.0f;
  block.breakable.material.pattern = fracture::Pattern::Block;
  block.breakable.material.carveRadius = 0.35f;
  block.breakable.material.density = 0.5f;
  physics::addBox(world, block, Vec3::Constant(0.3f), physics::shapeDef(2500.0f));
  const float x = random.nextFloat(-0.15f, 0.15f);
  const float y = random.nextFloat(-0.15f, 0.15f);
  const float gap = random.nextFloat(0.0f, 1.0f) * kTick * 23.0f;
  Stage stage;
  stage.watched = physics::addBall(world, Vec3(x, y, 1.0f + gap), Vec3(0.0f, 0.0f, -20.0f), 0.15f, 110.0f);
  stage.seconds = 1.0f;
  return stage;
}

Stage buildFlood(World& world, int variant) {
  Random random(12, static_cast<std::uint64_t>(variant));
  physics::addFloor(world);
  addWalls(world, 3.0f);
  for (int i = 0; i < 2; ++i) addStandingPane(world, 0.5f - 1.5f * static_cast<float>(i));
  for (int i = 0; i < 4; ++i) addBlock(world, Vec3(-0.9f + 0.6f * static_cast<float>(i), 0.2f, -2.1f));
  for (int i = 0; i < 6; ++i) {
    const float x = random.nextFloat(-1.2f, 1.2f);
    const float y = random.nextFloat(0.4f, 1.6f);
    const float flight = 0.05f + 0.15f * static_cast<float>(i);  // until it is where it was aimed at [s]
    const Vec3 velocity(0.0f, 0.5f * 9.81f * flight, -18.0f);
    physics::addBall(world, Vec3(x, y, 1.5f + 18.0f * flight), velocity, 0.1f, 8.0f, 0.2f);
  }
  Stage stage;
  stage.seconds = 2.0f;
  return stage;
}

}  // namespace brittle::accuracy
