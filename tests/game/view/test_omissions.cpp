// What pictures and sound leave out: behind the camera, beyond the budget of the preset; each is seen to be counted.
#include "game/view/omission.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/audio/mixer.h"
#include "engine/effects/has/smoke.h"
#include "engine/effects/has/splinters.h"
#include "engine/effects/has/water.h"
#include "game/view/cues.h"
#include "game/view/hud.h"
#include "game/view/particles.h"
#include "game/view/smoke.h"
#include "game/view/sound.h"
#include "game/view/surroundings.h"
#include "game/view/water.h"
#include "tests/game/view/packets.h"

namespace brittle::view {
namespace {

/// What remains to be seen of `count` events of a type at a place, and what does not.
struct Seen {
  render::Frame frame;
  Bounds bounds;
};

Memory memoryOf(sim::EventType type, int count, const Vec3& point) {
  Memory memory;
  sim::FramePacket packet = packetAt(40);
  for (int i = 0; i < count; ++i) {
    packet.events.push_back(eventOf(type, point));
    packet.events.back().size = 0.5f;
    packet.events.back().speed = 8.0f;
  }
  memory.tick(packet);
  return memory;
}

Seen particlesOf(int count, const Vec3& point, std::int32_t maxDebris) {
  Seen seen;
  seen.bounds.budget = seenBudget(maxDebris);
  seen.frame.camera.position = packetAt(40).camera.position;
  if constexpr (effects::kHasSplinters)
    addParticles(packetAt(40), memoryOf(sim::EventType::Break, count, point), 44.0, 44.0, seen.bounds, seen.frame);
  return seen;
}

TEST(Omissions, EventsBehindTheCameraCostNothing) {
  if (!effects::kHasSplinters) GTEST_SKIP();
  const Vec3 eye = packetAt(40).camera.position;
  const Seen seen = particlesOf(3, eye + Vec3(0.0f, 0.0f, 4.5f), 512);
  EXPECT_TRUE(seen.frame.glows.empty());
  EXPECT_TRUE(seen.frame.beams.empty());
  EXPECT_EQ(seen.bounds.omissions[Omission::BehindCamera], 3u);
  const Seen near = particlesOf(3, eye + Vec3(0.0f, 0.0f, 2.0f), 512);
  EXPECT_FALSE(near.frame.glows.empty()) << "what it throws may fly into the picture";
  EXPECT_EQ(near.bounds.omissions[Omission::BehindCamera], 0u);
}

// What the frontmost splinters of a burst do is the farthest that anything comes.
TEST(Omissions, NothingFliesFartherThanItsEventIsKeptFor) {
  if (!effects::kHasSplinters) GTEST_SKIP();
  const Vec3 point(0.0f, 1.0f, -3.0f);
  const Memory memory = memoryOf(sim::EventType::Break, 30, point);
  float farthest = 0.0f;
  for (int tick = 40; tick < 120; ++tick) {
    Seen seen;
    if constexpr (effects::kHasSplinters) addParticles(packetAt(40), memory, tick, tick, seen.bounds, seen.frame);
    for (const render::Glow& glow : seen.frame.glows)
      farthest = maxOf(farthest, std::fabs(glow.position.z() - point.z()) + glow.radius);
  }
  EXPECT_GT(farthest, 0.5f);
  EXPECT_LT(farthest, 4.0f);
}

TEST(Omissions, ParticlesKeepToTheirBudgetAndTheLatestAreKept) {
  if (!effects::kHasSplinters) GTEST_SKIP();
  const Vec3 point(0.0f, 1.0f, -3.0f);
  const Seen all = particlesOf(40, point, 1'000'000), few = particlesOf(40, point, 16);
  const SeenBudget budget = seenBudget(16);
  ASSERT_GT(all.frame.glows.size(), budget.glows);
  ASSERT_GT(all.frame.beams.size(), budget.streaks);
  EXPECT_EQ(few.frame.glows.size(), budget.glows);
  EXPECT_EQ(few.bounds.omissions[Omission::Glow], all.frame.glows.size() - budget.glows);
  EXPECT_EQ(few.bounds.omissions[Omission::Streak], all.frame.beams.size() - budget.streaks);
  EXPECT_EQ(few.frame.glows.back().position, all.frame.glows.back().position);
}

TEST(Omissions, BudgetsFollowTheDebrisOfThePreset) {
  const SeenBudget usual = seenBudget(512), phone = seenBudget(192);
  EXPECT_EQ(usual.puffs, 200u);
  EXPECT_EQ(usual.ripples, 24u);
  EXPECT_LT(phone.glows, usual.glows);
  EXPECT_LT(phone.shadows, usual.shadows);
  EXPECT_EQ(seenBudget(0).glows, 0u);
}

TEST(Omissions, PuffsAndRipples) {
  if (!effects::kHasSmoke || !effects::kHasWater) GTEST_SKIP();
  Seen smoke;
  const std::size_t puffs = smoke.bounds.budget.puffs;
  if constexpr (effects::kHasSmoke)
    addSmoke(packetAt(40), memoryOf(sim::EventType::Smoke, 250, Vec3(0.0f, 1.0f, -3.0f)), 44.0, smoke.bounds,
             smoke.frame);
  EXPECT_EQ(smoke.frame.puffs.size(), puffs);
  EXPECT_EQ(smoke.bounds.omissions[Omission::Puff], 250u - puffs);
  Seen water;
  sim::FramePacket packet = packetAt(40);
  packet.rooms[0].waters.push_back({Vec3(0.0f, 0.0f, -4.0f), Vec2(2.0f, 2.0f), {4, 4}});
  if constexpr (effects::kHasWater)
    addWaters(packet, memoryOf(sim::EventType::Splash, 30, Vec3(0.0f, 0.0f, -3.0f)), 44.0, water.bounds, water.frame);
  EXPECT_EQ(water.bounds.omissions[Omission::Ripple], 30u - water.bounds.budget.ripples);
}

TEST(Omissions, PicturesKeepWhatIsBeforeThemAndTheNearestShadows) {
  Seen seen;
  seen.bounds.budget.shadows = 2;
  for (const float z : {-5.0f, 1.0f, -1.0f}) {
    const Vec3 at(0.0f, 0.0f, z);
    seen.frame.glows.push_back({at, 0.5f});
    seen.frame.crumbs.push_back({at, 0.01f});
    seen.frame.puffs.push_back({at, 0.5f});
    seen.frame.beams.push_back({at, at - Vec3(0.0f, 0.0f, 0.2f), 0.01f});
    seen.frame.shadows.push_back({at});
  }
  keepWithin(seen.frame, seen.bounds);
  EXPECT_EQ(seen.frame.glows.size(), 2u);
  EXPECT_EQ(seen.frame.crumbs.size(), 2u);
  EXPECT_EQ(seen.frame.puffs.size(), 2u);
  EXPECT_EQ(seen.frame.beams.size(), 2u);
  EXPECT_EQ(seen.bounds.omissions[Omission::BehindCamera], 4u);
  ASSERT_EQ(seen.frame.shadows.size(), 2u);
  for (const render::Shadow& shadow : seen.frame.shadows) EXPECT_GT(shadow.position.z(), -2.0f);
  EXPECT_EQ(seen.bounds.omissions[Omission::Shadow], 1u);
}

TEST(Omissions, LampsThatAMirrorDoesNotShow) {
  sim::FramePacket packet = packetAt(40);
  auto look = std::make_shared<sim::SegmentLook>(*packet.rooms[0].segments[0].look);
  for (int i = 0; i < 11; ++i) {
    sim::LookBox lamp;
    lamp.center = Vec3(0.0f, 3.0f, -0.6f * static_cast<float>(i) - 0.5f);
    lamp.halfExtents = Vec3::Constant(0.1f);
    lamp.glow = 1.0f;
    look->boxes.push_back(lamp);
  }
  packet.rooms[0].segments[0].look = look;
  Bounds bounds;
  EXPECT_EQ(surroundingsOf(packet, bounds).lamps.size(), render::kMostMirroredLamps);
  EXPECT_EQ(bounds.omissions[Omission::Lamp], 11u - render::kMostMirroredLamps);
}

TEST(Omissions, SoundsOfACrowdedTick) {
  sim::FramePacket packet = packetAt(40);
  for (int i = 0; i < 30; ++i) packet.events.push_back(eventOf(sim::EventType::Break, Vec3(0.0f, 1.0f, -3.0f)));
  Masking masking;
  Random random(1);
  cuesOf(packet, 0, masking, random);
  EXPECT_GT(masking.quiet, 0u);
  for (int i = 0; i < 5; ++i) cuesOf(packet, 0, masking, random);
  EXPECT_GT(masking.covered, 0u);
  const audio::Bank bank;
  audio::Mixer mixer(bank);
  Sound sound(mixer);
  sound.tick(packet);
  const std::vector<NamedCount> counts = sound.omissions();
  ASSERT_FALSE(counts.empty());
  EXPECT_STREQ(counts[0].name, nameOf(Omission::QuietSound));
}

TEST(Omissions, AreListedBesideTheTimes) {
  render::Frame frame;
  addTimings({}, frame);
  const float right = frame.texts[1].at.offset.x();
  frame.texts.clear();
  addOmissions({{"crumbs recycled", 12}, {"cuts refused", 3}}, frame);
  ASSERT_EQ(frame.texts.size(), 5u);
  EXPECT_EQ(frame.texts[0].text, "left out since the start");
  EXPECT_EQ(frame.texts[1].text, "crumbs recycled");
  EXPECT_EQ(frame.texts[2].text, "12");
  EXPECT_EQ(frame.texts[4].text, "3");
  EXPECT_GT(frame.texts[1].at.offset.x(), right);
  EXPECT_LT(frame.texts[0].at.offset.y(), frame.texts[1].at.offset.y());
  EXPECT_LT(frame.texts[1].at.offset.y(), frame.texts[3].at.offset.y());
  frame.texts.clear();
  addOmissions({}, frame);
  EXPECT_TRUE(frame.texts.empty());
  EXPECT_STREQ(nameOf(Omission::CoveredSound), "covered sounds") << "a name for each";
}

}  // namespace
}  // namespace brittle::view
