// B30: glancing, tangential and spinning hits. The friction of a contact whose normal impulse is capped at J is at most
// mu J; nothing gains kinetic energy; a hit without normal speed breaks nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/core/random.h"
#include "engine/math/trig.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kStrength = 1.0f;  // [N s]
constexpr float kMass = 1.0f;      // [kg]
constexpr float kRadius = 0.05f;   // [m]

struct Hit {
  float normal = 20.0f, tangential = 0.0f;  // speeds [m/s]
  Vec3 spin = Vec3::Zero();                 // [rad/s]
  float friction = 0.5f;
};

struct Outcome {
  bool broke = false;
  float normalImpulse = 0.0f, tangentialImpulse = 0.0f;  // given up by the ball until the pane breaks, or in all [N s]
};

Outcome strike(const Hit& hit, const std::string& name) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.patternDensity = 0.3f;
  World world(def);
  BodyDef pane = bodyAt(Vec3::Zero(), BodyType::Static);
  pane.breakable.strength = kStrength;
  ShapeDef shape = shapeDef(0.25f, hit.friction);
  shape.anchored = true;
  addBox(world, pane, Vec3(0.6f, 0.6f, 0.004f), shape);
  const BodyHandle ball = addBall(world, Vec3(-0.2f * (hit.tangential > 0.0f ? 1.0f : 0.0f), 0.01f, kRadius + 0.0041f),
                                  Vec3(hit.tangential, 0.0f, -hit.normal), kRadius, kMass);
  world.setVelocity(ball, Vec3(hit.tangential, 0.0f, -hit.normal), hit.spin);
  double energy = totalsOf(world).kineticEnergy;
  Outcome outcome;
  const auto measure = [&](const Vec3& velocity) {
    const Vec3 gained = velocity - Vec3(hit.tangential, 0.0f, -hit.normal);
    outcome.normalImpulse = gained.z() * kMass;
    outcome.tangentialImpulse = Vec2(gained.x(), gained.y()).norm() * kMass;
  };
  for (int tick = 0; tick < 4; ++tick) {
    world.step(kTick);
    if (!outcome.broke) measure(world.body(ball).velocity);
    const double now = totalsOf(world).kineticEnergy;
    EXPECT_LE(now, energy * (1.0 + 1e-6)) << name << ", tick " << tick;
    if (energy > 0.0) hard::reportWorst("energy changes by at most", now / energy - 1.0);
    energy = now;
    outcome.broke = outcome.broke || world.counters().breaks > 0;
  }
  return outcome;
}

TEST(B30, FrictionIsBoundedByTheCappedImpulse) {
  Random random(30, 1);
  for (int i = 0; i < 200; ++i) {
    Hit hit;
    const float angle = random.nextFloat(0.0f, 1.5f);  // from the normal [rad]
    const float speed = random.nextFloat(5.0f, 80.0f);
    const float x = random.nextFloat(-200.0f, 200.0f);
    const float y = random.nextFloat(-200.0f, 200.0f);
    const float z = random.nextFloat(-200.0f, 200.0f);
    hit.spin = i % 3 == 0 ? Vec3(Vec3::Zero()) : Vec3(x, y, z);
    hit.friction = i % 2 == 0 ? 0.5f : 1.0f;
    hit.normal = speed * cosine(angle);
    hit.tangential = speed * sine(angle);
    const Outcome outcome = strike(hit, "hit " + std::to_string(i));
    const float mu = std::sqrt(0.5f * hit.friction);  // the ball's own is 0.5; a pair uses the geometric mean
    // (Later a glancing ball meets the rim of its hole, which breaks again: the tick of the first break is looked at.
    // What the shards in its way take, they weigh about a thousandth of it, is in the second term.)
    const float shards = 2e-3f * kMass * speed;
    EXPECT_LE(outcome.normalImpulse, kStrength + shards) << "hit " << i;
    hard::reportWorst("friction / allowed", double(outcome.tangentialImpulse / (mu * kStrength + shards)));
    EXPECT_LE(outcome.tangentialImpulse, mu * kStrength + shards)
        << "hit " << i << " at " << angle << " rad, " << speed << " m/s";
    if (hit.normal * kMass > 1.01f * kStrength) {
      EXPECT_TRUE(outcome.broke) << "hit " << i;
    } else if (hit.normal * kMass < 0.99f * kStrength) {
      EXPECT_FALSE(outcome.broke) << "hit " << i;
    }
  }
}

TEST(B30, WithoutNormalSpeedNothingBreaks) {
  for (const float spin : {0.0f, 50.0f, 200.0f}) {
    for (const float tangential : {0.0f, 5.0f, 50.0f}) {
      Hit hit;
      hit.normal = 0.0f;
      hit.tangential = tangential;
      hit.spin = Vec3(0.3f * spin, spin, spin);
      const Outcome outcome = strike(hit, "spin " + std::to_string(spin));
      EXPECT_FALSE(outcome.broke);
      EXPECT_LE(outcome.tangentialImpulse, 1e-4f);
    }
  }
}

}  // namespace
}  // namespace brittle::physics
