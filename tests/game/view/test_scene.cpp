#include "game/view/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/hash.h"
#include "engine/geometry/make.h"
#include "engine/render/gl_null.h"
#include "game/content/asset_source.h"
#include "game/sim/game.h"
#include "packets.h"

namespace brittle::view {
namespace {

constexpr float kAspect = 16.0f / 9.0f;

class SceneOnNull : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = render::Renderer::create(null_.table(), {.width = 320, .height = 180});
    ASSERT_TRUE(made) << made.error().message;
    renderer_ = std::move(*made);
    null_.clearRecord();
  }
  void TearDown() override {
    EXPECT_THAT(null_.complaints(), ::testing::IsEmpty());
    renderer_.reset();
    EXPECT_EQ(null_.liveObjects(), 0u);
  }
  /// Boxes of one look in front of the camera, each a body.
  void addBoxes(sim::FramePacket& packet, sim::Look look, int count) {
    for (int i = 0; i < count; ++i) {
      const auto body = static_cast<std::uint32_t>(packet.rooms[0].bodies.size());
      const Vec3 place(0.2f * static_cast<float>(i % 5) - 0.4f, 1.0f, -4.0f - 0.1f * static_cast<float>(i));
      packet.rooms[0].bodies.push_back({{place, Quat::Identity()}, 1});
      pool_.add(geometry::makeBox<float>(Vec3(0.1f, 0.1f, 0.1f)), body, static_cast<std::uint16_t>(look));
    }
  }
  std::uint32_t drawsOf(Scene& scene, const sim::FramePacket& packet) {
    scene.tick(packet);
    renderer_->draw(scene.build(1.0f, kAspect, {&pool_, nullptr}));
    return renderer_->counters().draws;
  }

  render::NullGl null_;
  std::unique_ptr<render::Renderer> renderer_;
  geometry::MeshPool pool_;
};

TEST_F(SceneOnNull, StagesThatNoSegmentAsksForAreNotRun) {
  Scene scene(*renderer_);
  sim::FramePacket packet = packetAt(1000);
  auto look = std::make_shared<sim::SegmentLook>(*packet.rooms[0].segments[0].look);
  look->softShadow = 0.0f;
  packet.rooms[0].segments[0].look = look;
  const auto frameOf = [&] {
    scene.tick(packet);
    return scene.build(1.0f, kAspect, {&pool_, nullptr});
  };
  const render::Frame plain = frameOf();
  EXPECT_EQ(plain.bloom, 0.0f);
  EXPECT_FALSE(plain.mirrorHeight);
  EXPECT_EQ(plain.sphereShadow, 0.0f);
  EXPECT_THAT(plain.shadows, ::testing::IsEmpty());
  EXPECT_THAT(plain.decals, ::testing::IsEmpty());
  EXPECT_THAT(plain.glows, ::testing::IsEmpty());
  look->boxes[0].reflects = true;
  look->boxes[0].glow = 1.0f;
  look->softShadow = 0.5f;
  look->decals.push_back({});
  const render::Frame full = frameOf();
  EXPECT_GT(full.bloom, 0.0f);
  EXPECT_TRUE(full.mirrorHeight);
  EXPECT_GT(full.sphereShadow, 0.0f);
  EXPECT_THAT(full.decals, ::testing::SizeIs(1));
}

TEST_F(SceneOnNull, DrawsOncePerMaterialHoweverManyThingsThereAre) {
  Scene scene(*renderer_);
  sim::FramePacket packet = packetAt(1000);
  packet.balls.push_back({1, {Vec3(0.0f, 1.0f, -3.0f), Quat::Identity()}, 0.13f});
  packet.rooms[0].crumbs.push_back({Vec3(0.0f, 0.5f, -3.0f), 0.01f, 0xffffffff});
  addBoxes(packet, sim::Look::Glass, 1);
  addBoxes(packet, sim::Look::Metal, 1);
  const std::uint32_t few = drawsOf(scene, packet);
  addBoxes(packet, sim::Look::Glass, 40);
  addBoxes(packet, sim::Look::Metal, 40);
  addBoxes(packet, sim::Look::Wood, 5);
  for (std::uint32_t i = 2; i < 12; ++i) packet.balls.push_back({i, packet.balls[0].pose, 0.13f});
  packet.rooms[0].crumbs.resize(50, packet.rooms[0].crumbs[0]);
  ++packet.tick;
  EXPECT_EQ(drawsOf(scene, packet), few);
  // fog, room, opaque convexes, balls, crumbs, shadows, glass, edges, picture, HUD; no lamp, so no bloom
  EXPECT_EQ(few, 10u);
}

TEST_F(SceneOnNull, LeavesOutWhatTheBakedRoomShows) {
  Scene scene(*renderer_);
  sim::FramePacket packet = packetAt(1000);
  addBoxes(packet, sim::Look::Static, 3);
  addBoxes(packet, sim::Look::Glass, 2);
  scene.tick(packet);
  EXPECT_EQ(scene.build(1.0f, kAspect, {&pool_, nullptr}).groups[0].meshes.size(), 2u);
}

TEST_F(SceneOnNull, BakesALookOnceForAllItsPlaces) {
  Scene scene(*renderer_);
  sim::FramePacket packet = packetAt(1);
  packet.rooms[0].segments.push_back(packet.rooms[0].segments[0]);
  packet.rooms[0].segments[1].origin = Vec3(0.0f, 0.0f, -8.0f);
  scene.tick(packet);
  const render::Frame& frame = scene.build(1.0f, kAspect, {&pool_, nullptr});
  ASSERT_EQ(frame.statics.size(), 2u);
  EXPECT_EQ(frame.statics[0].id, frame.statics[1].id);
  EXPECT_EQ(frame.statics[1].offset, Vec3(0.0f, 0.0f, -8.0f));
}

TEST_F(SceneOnNull, ShakesOnlyWhenAsked) {
  Scene scene(*renderer_);
  sim::FramePacket packet = packetAt(5);
  scene.tick(packet);
  EXPECT_EQ(scene.build(1.0f, kAspect, {&pool_, nullptr}).camera.position, packet.camera.position);
  packet = packetAt(6);
  packet.shake = 1.0f;
  scene.tick(packet);
  const float moved = (scene.build(1.0f, kAspect, {&pool_, nullptr}).camera.position - packet.camera.position).norm();
  EXPECT_GT(moved, 0.0f);
  EXPECT_LT(moved, 0.1f);
}

TEST_F(SceneOnNull, ThrowsSplintersAndBlursOnlyWhereThatRuns) {
  const auto frameOf = [&](effects::EffectMask off) {
    Scene scene(*renderer_);
    sim::FramePacket packet = packetAt(5);
    packet.events.push_back(eventOf(sim::EventType::Break, Vec3(0.0f, 1.0f, -4.0f)));
    packet.rooms[0].focus[1] = packet.rooms[0].focus[2] = 1.0f;
    packet.rooms[0].effects = effects::EffectMask::ofBits(~off.bits());
    scene.tick(packet);
    return scene.build(1.0f, kAspect, {&pool_, nullptr});
  };
  using effects::Effect;
  const render::Frame with = frameOf({});
  EXPECT_THAT(with.glows, ::testing::Not(::testing::IsEmpty()));
  EXPECT_EQ(with.focus.strength, 1.0f);
  const render::Frame without = frameOf(effects::EffectMask().with(Effect::Splinters).with(Effect::DepthOfField));
  EXPECT_THAT(without.glows, ::testing::IsEmpty());
  EXPECT_EQ(without.focus.strength, 0.0f);
}

TEST_F(SceneOnNull, BlendsTheFogOfTwoRooms) {
  Scene scene(*renderer_);
  sim::FramePacket packet = packetAt(5);
  packet.rooms[0].fogTop = Vec3::Zero();
  scene.tick(packet);
  packet = packetAt(6);
  packet.rooms[0].fogTop = Vec3::Ones();
  packet.events.push_back(eventOf(sim::EventType::RoomEntered, Vec3::Zero()));
  scene.tick(packet);
  EXPECT_EQ(scene.build(1.0f, kAspect, {&pool_, nullptr}).fog.top, Vec3(0.0f, 0.0f, 0.0f));
  packet.events.clear();
  for (packet.tick = 7; packet.tick < 200; ++packet.tick) scene.tick(packet);
  EXPECT_EQ(scene.build(1.0f, kAspect, {&pool_, nullptr}).fog.top, Vec3(1.0f, 1.0f, 1.0f));
}

void addWords(StateHash& hash, const Vec3& v) {
  for (int i = 0; i < 3; ++i) hash.add(v[i]);
}

/// Of all that a frame shows; mesh pools by the vertices of the meshes seen.
std::uint64_t hashOf(const render::Frame& frame) {
  StateHash hash;
  addWords(hash, frame.camera.position);
  addWords(hash, frame.fog.top);
  for (int i = 0; i < 4; ++i) hash.add(frame.camera.rotation.coeffs()[i]);
  for (int i = 0; i < 4; ++i) hash.add(frame.border[i]);
  for (const render::MeshGroup& group : frame.groups) {
    for (const render::VisibleMesh& mesh : group.meshes) {
      hash.add(mesh.slot);
      hash.add(static_cast<std::uint32_t>(mesh.material));
      addWords(hash, group.bodies[mesh.body].position);
      for (const geometry::Vertex& vertex : group.pool->view(mesh.slot).vertices) addWords(hash, vertex.point);
    }
  }
  for (const render::VisibleStatic& still : frame.statics) addWords(hash, still.offset);
  for (const render::Sphere& sphere : frame.spheres) addWords(hash, sphere.position);
  for (const render::Crumb& crumb : frame.crumbs) addWords(hash, crumb.position);
  for (const render::Shadow& shadow : frame.shadows) addWords(hash, shadow.position);
  for (const render::Beam& beam : frame.beams) addWords(hash, beam.to);
  for (const render::Beam& laser : frame.lasers) addWords(hash, laser.to);
  for (const render::Puff& puff : frame.puffs) addWords(hash, puff.position);
  for (const render::Water& water : frame.waters) {
    for (const float height : water.heights) hash.add(height);
    for (const float foam : water.foam) hash.add(foam);
    hash.add(water.seconds);
  }
  for (const render::Glow& glow : frame.glows) {
    addWords(hash, glow.position);
    hash.add(glow.color);
  }
  for (const render::Decal& decal : frame.decals) {
    addWords(hash, decal.position);
    hash.add(decal.color);
  }
  for (const render::HudArc& arc : frame.arcs) {
    hash.add(arc.at.offset.y());
    hash.add(arc.color);
  }
  for (const render::Surroundings::Lamp& lamp : frame.surroundings.lamps) hash.add(lamp.light);
  addWords(hash, frame.surroundings.left);
  for (const render::HudText& text : frame.texts) {
    hash.addBytes(text.text.data(), text.text.size());
    hash.add(text.color);
    hash.add(text.height);
  }
  return hash.value();
}

class SceneOfAGame : public SceneOnNull {
 protected:
  static constexpr std::uint32_t kThrow = 190, kFirst = 240, kLast = 270;

  std::unique_ptr<sim::Game> newGame(const sim::GameDef& def = {}) {
    auto game = sim::Game::create(assets_, def);
    EXPECT_TRUE(game) << game.error().message;
    return std::move(*game);
  }
  static void play(sim::Game& game) {
    replay::InputFrame input;
    if (game.tickCount() == kThrow || game.tickCount() == 60) input.throws.push_back({});
    game.tick(input);
  }
  static void show(sim::Game& game, Scene& scene) {
    sim::FramePacket packet;
    game.copyFrame(packet);
    scene.tick(packet);
  }
  /// Hashes of the frames of [kFirst, kLast], the game and the scene being at a tick before.
  std::vector<std::uint64_t> framesOf(sim::Game& game, Scene& scene) {
    std::vector<std::uint64_t> hashes;
    while (true) {
      show(game, scene);
      if (game.tickCount() >= kFirst)
        for (const float alpha : {0.5f, 1.0f})
          hashes.push_back(hashOf(scene.build(alpha, kAspect, {game.meshes(0), game.meshes(1)})));
      if (game.tickCount() >= kLast) return hashes;
      play(game);
    }
  }

  void expectRangeAlone(const sim::GameDef& def);

  content::FolderSource assets_{{BRITTLE_SOURCE_DIR "/assets"}};
};

void SceneOfAGame::expectRangeAlone(const sim::GameDef& def) {
  const auto game = newGame(def);
  Scene whole(*renderer_);
  const std::vector<std::uint64_t> all = framesOf(*game, whole);
  ASSERT_EQ(all.size(), 2u * (kLast - kFirst + 1));

  const auto early = newGame(def);
  while (early->tickCount() < kFirst - kMemoryTicks) play(*early);
  ByteWriter bytes;
  early->save(bytes);
  const auto restored = newGame(def);
  ByteReader reader(bytes.bytes());
  ASSERT_TRUE(restored->restore(reader));
  Scene part(*renderer_);
  const std::vector<std::uint64_t> alone = framesOf(*restored, part);
  ASSERT_EQ(alone.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(alone[i], all[i]) << "frame " << kFirst + i / 2;
}

TEST_F(SceneOfAGame, ARangeOfFramesAloneIsAsInAFullRun) {
  expectRangeAlone({});
}

TEST_F(SceneOfAGame, ARangeOfFramesWithWaterSmokeOrLasersToo) {
  for (const std::uint32_t room : {12u, 13u, 14u}) {
    SCOPED_TRACE(room);
    sim::GameDef def;
    def.level = "showroom";
    def.firstRoom = room;
    expectRangeAlone(def);
  }
}

TEST_F(SceneOfAGame, DrawingOrNotDrawingChangesNothing) {
  const auto game = newGame();
  Scene often(*renderer_), once(*renderer_);
  std::uint64_t last = 0;
  while (game->tickCount() < 100) {
    play(*game);
    show(*game, often);
    show(*game, once);
    for (const float alpha : {0.0f, 0.3f, 0.9f, 1.0f})
      last = hashOf(often.build(alpha, kAspect, {game->meshes(0), game->meshes(1)}));
  }
  EXPECT_EQ(hashOf(once.build(1.0f, kAspect, {game->meshes(0), game->meshes(1)})), last);
}

}  // namespace
}  // namespace brittle::view
