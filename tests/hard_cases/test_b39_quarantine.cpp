// B39: in a pile of 125 bodies one number of one body (velocity, spin, position, orientation) becomes NaN or infinite.
// It is caught in the same step, named in a diagnostic, that body alone is removed, and no other is affected: the world
// goes on bit for bit as one from which that body was taken by hand.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "engine/core/log.h"
#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr int kBodies = 125;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Fault {
  const char* what;  // as the diagnostic has it
  void (*inject)(Body& body, float value);
};

const Fault kFaults[] = {
    {"velocity", [](Body& body, float value) { body.velocity.y() = value; }},
    {"angular velocity", [](Body& body, float value) { body.angularVelocity.x() = value; }},
    {"pose", [](Body& body, float value) { body.pose.position.z() = value; }},
    {"pose", [](Body& body, float value) { body.center.x() = value; }},
    {"pose", [](Body& body, float value) { body.pose.rotation.w() = value; }},
};

/// A pile of 5 x 5 x 5 boxes after half a second: landed, touching, still awake.
struct Pile {
  World world;
  std::vector<BodyHandle> boxes;
  Pile() {
    addFloor(world);
    for (int i = 0; i < kBodies; ++i) {
      const Vec3 at(0.22f * static_cast<float>(i % 5), 0.13f + 0.22f * static_cast<float>(i / 25),
                    0.22f * static_cast<float>(i / 5 % 5));
      boxes.push_back(addBox(world, bodyAt(at), Vec3(0.1f, 0.1f, 0.1f)));
    }
    for (int tick = 0; tick < 30; ++tick) world.step(kTick);
  }
  std::vector<unsigned char> saved() const {
    ByteWriter out;
    world.save(out);
    return out.bytes();
  }
};

class Diagnostics {
 public:
  Diagnostics() {
    old_ = setLogSink([this](LogLevel, std::string_view message) { lines.emplace_back(message); });
  }
  ~Diagnostics() { setLogSink(std::move(old_)); }
  std::vector<std::string> lines;

 private:
  LogSink old_;
};

void restore(World& world, const std::vector<unsigned char>& bytes) {
  ByteReader in(bytes);
  ASSERT_TRUE(world.restore(in));
}

TEST(B39, TheBadBodyAloneGoesAndTheOthersNeverNotice) {
  const Pile pile;
  const std::vector<unsigned char> start = pile.saved();
  World struck;
  World reference;
  int victim = 0;
  for (const Fault& fault : kFaults) {
    for (const float value : {kNan, kInfinity, -kInfinity}) {
      victim = (victim + 37) % kBodies;  // corners, faces, the middle
      SCOPED_TRACE(std::string(fault.what) + " " + std::to_string(value) + " in box " + std::to_string(victim));
      restore(struck, start);
      restore(reference, start);
      const BodyHandle bad = pile.boxes[static_cast<std::size_t>(victim)];
      fault.inject(struck.state().bodies[bad], value);
      reference.destroyBody(bad);

      const Diagnostics diagnostics;
      struck.step(kTick);
      reference.step(kTick);
      ASSERT_EQ(struck.events().quarantined.size(), 1u);
      EXPECT_TRUE(struck.events().quarantined[0] == bad);
      ASSERT_EQ(diagnostics.lines.size(), 1u);
      EXPECT_NE(diagnostics.lines[0].find("body " + std::to_string(bad.index) + " "), std::string::npos)
          << diagnostics.lines[0];
      EXPECT_NE(diagnostics.lines[0].find(fault.what), std::string::npos) << diagnostics.lines[0];

      int alive = 0;
      for (const BodyHandle box : pile.boxes) alive += struck.isAlive(box) ? 1 : 0;
      hard::reportSum("faults", 1);
      hard::reportWorst("bodies lost to one", kBodies - alive);
      EXPECT_EQ(alive, kBodies - 1);
      EXPECT_EQ(struck.stateHash(), reference.stateHash());
      for (int tick = 0; tick < 10; ++tick) {
        struck.step(kTick);
        reference.step(kTick);
        EXPECT_TRUE(struck.events().quarantined.empty());
      }
      EXPECT_EQ(struck.stateHash(), reference.stateHash());
      hard::reportSum("worlds affected", struck.stateHash() == reference.stateHash() ? 0 : 1);
    }
  }
}

TEST(B39, ImpulsesAndVelocitiesThatAreNoNumbersAreCaughtToo) {
  Pile pile;
  const Diagnostics diagnostics;
  pile.world.applyImpulse(pile.boxes[12], Vec3(kNan, 0.0f, 0.0f), Vec3::Zero());
  pile.world.setVelocity(pile.boxes[60], Vec3(0.0f, kInfinity, 0.0f), Vec3::Zero());
  pile.world.step(kTick);
  EXPECT_EQ(pile.world.events().quarantined.size(), 2u);
  EXPECT_EQ(diagnostics.lines.size(), 2u);
  int alive = 0;
  pile.world.forEachBody([&](BodyHandle, const Body& body) {
    EXPECT_TRUE(isFinite(body.center) && isFinite(body.velocity) && isFinite(body.angularVelocity));
    alive += body.isDynamic() ? 1 : 0;
  });
  EXPECT_EQ(alive, kBodies - 2);
}

}  // namespace
}  // namespace brittle::physics
