// B23: a chain of 20 links of glass swings down from the horizontal; the middle link is shot in the very tick in which
// its joint carries 90 % of the most it ever carries. No NaN; the largest anchor error afterwards is below twice the
// one before; energy does not rise in the tick of the break (beyond 1e-6 of what the bodies move) nor in any later one.
#include <gtest/gtest.h>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr int kLinks = 20;
constexpr float kSpacing = 0.2f;  // [m]; links leave room at the joints to bend

struct Chain {
  World world;
  BodyHandle links[kLinks];
  JointHandle joints[kLinks];

  Chain() {
    for (int i = 0; i < kLinks; ++i) {
      BodyDef def = bodyAt(Vec3(kSpacing * (static_cast<float>(i) + 0.5f), 5.0f, 0.0f));
      def.breakable.strength = 0.05f;
      def.breakable.material.pattern = fracture::Pattern::Block;
      def.breakable.material.carveRadius = 0.03f;
      links[i] = addBox(world, def, Vec3(0.085f, 0.03f, 0.03f), shapeDef(2500.0f));
      JointDef joint;
      joint.a = world.body(links[i]).firstShape;
      if (i > 0) joint.b = world.body(links[i - 1]).firstShape;
      joint.anchorA = Vec3(kSpacing * static_cast<float>(i), 5.0f, 0.0f);
      joints[i] = world.createJoint(joint);
    }
  }
  float load() const { return world.joint(joints[kLinks / 2]).linearImpulse.norm(); }
  float anchorError() const {
    float worst = 0.0f;
    for (const JointHandle handle : joints) {
      if (!world.isAlive(handle)) continue;
      const Joint& j = world.joint(handle);
      const Vec3 a = world.body(world.bodyOf(j.a)).pose.toWorld(j.localAnchorA);
      const Vec3 b = j.b ? world.body(world.bodyOf(j.b)).pose.toWorld(j.localAnchorB) : j.localAnchorB;
      worst = maxOf(worst, (a - b).norm());
    }
    return worst;
  }
  double energy() const {
    double sum = totalsOf(world).kineticEnergy;
    world.forEachBody([&](BodyHandle, const Body& b) { sum += 9.81 * double(b.mass) * double(b.center.y()); });
    return sum;
  }
  /// A bullet that meets the middle link within the next tick.
  void shoot() {
    const Body& link = world.body(links[kLinks / 2]);
    const Vec3 velocity = link.velocity + Vec3(0.0f, 0.0f, -60.0f);
    addBall(world, link.center + Vec3(0.0f, 0.0f, 0.03f + 0.02f + 0.3f), velocity, 0.02f, 0.1f);
  }
};

TEST(B23, AChainWhoseLoadedLinkBreaksStaysCalm) {
  constexpr int kTicks = 90;
  float most = 0.0f;
  {
    Chain chain;
    for (int i = 0; i < kTicks; ++i) {
      chain.world.step(kTick);
      most = maxOf(most, chain.load());
    }
  }
  Chain chain;
  float before = 0.0f;
  int tick = 0;
  for (; tick < kTicks && chain.load() < 0.9f * most; ++tick) {
    chain.world.step(kTick);
    before = maxOf(before, chain.anchorError());
  }
  ASSERT_LT(tick, kTicks);
  chain.shoot();
  double energy = chain.energy();
  const double moving = totalsOf(chain.world).kineticEnergy;
  chain.world.step(kTick);
  bool broke = false;
  for (const BreakEvent& event : chain.world.events().breaks) broke = broke || event.body == chain.links[kLinks / 2];
  ASSERT_TRUE(broke) << "the link breaks in this tick";
  float after = chain.anchorError();
  EXPECT_LE(chain.energy(), energy + 1e-6 * moving);
  for (int i = 0; i < 300; ++i) {
    energy = chain.energy();
    chain.world.step(kTick);
    after = maxOf(after, chain.anchorError());
    ASSERT_LE(chain.energy(), energy + 1e-6 * moving) << "tick " << i;
    chain.world.forEachBody([](BodyHandle, const Body& b) { ASSERT_TRUE(isFinite(b.center) && isFinite(b.velocity)); });
  }
  EXPECT_LT(after, 2.0f * before);
  EXPECT_TRUE(chain.world.events().quarantined.empty());
  hard::reportWorst("anchor error before", 1000.0 * double(before), "mm");
  hard::reportWorst("after", 1000.0 * double(after), "mm");
}

}  // namespace
}  // namespace brittle::physics
