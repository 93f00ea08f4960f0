#include "engine/render/renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/log.h"
#include "engine/geometry/make.h"
#include "engine/render/gl_null.h"

namespace brittle::render {
namespace {

using ::testing::IsEmpty;

class RendererOnNull : public ::testing::Test {
 protected:
  void make(const RendererDef& def = {.width = 320, .height = 180}) {
    auto made = Renderer::create(null_.table(), def);
    ASSERT_TRUE(made) << made.error().message;
    renderer_ = std::move(*made);
    null_.clearRecord();
  }
  void addCube(Frame& frame, geometry::MeshPool& pool, std::uint16_t material, std::size_t group = 0) {
    MeshGroup& g = frame.groups[group];
    g.pool = &pool;
    g.poolId = group + 1;
    const auto body = static_cast<std::uint32_t>(g.bodies.size());
    g.bodies.push_back({Vec3(0.0f, 0.0f, -4.0f), Quat::Identity()});
    g.meshes.push_back(
        {pool.add(geometry::makeBox<float>(Vec3(0.5f, 0.5f, 0.5f)), body, material), body, material, kWhite});
  }
  void TearDown() override {
    EXPECT_THAT(null_.complaints(), IsEmpty());
    renderer_.reset();
    EXPECT_EQ(null_.liveObjects(), 0u) << "GL objects were left behind";
  }

  NullGl null_;
  std::unique_ptr<Renderer> renderer_;
};

TEST_F(RendererOnNull, DrawsOnlyFogAndPictureOfAnEmptyFrame) {
  make();
  renderer_->draw(Frame{});
  EXPECT_EQ(null_.draws().size(), 2u);
  EXPECT_EQ(null_.calls("BlitFramebuffer"), 0u);  // no effect that nothing asks for
}

TEST_F(RendererOnNull, BuildsWhatAFrameAsksForAndNoMore) {
  auto made = Renderer::create(null_.table(), {.width = 320, .height = 180});
  ASSERT_TRUE(made) << made.error().message;
  renderer_ = std::move(*made);
  EXPECT_EQ(null_.calls("CreateProgram"), 2u);  // fog and picture
  const std::size_t atFirst = null_.liveObjects();
  renderer_->draw(Frame{});
  EXPECT_EQ(null_.calls("CreateProgram"), 2u);
  EXPECT_EQ(null_.liveObjects(), atFirst);
  Frame frame;
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -3.0f)});
  frame.sphereShadow = 0.0f;
  renderer_->draw(frame);
  renderer_->draw(frame);
  EXPECT_EQ(null_.calls("CreateProgram"), 3u);
}

TEST_F(RendererOnNull, AnOverlayIsADrawAPartAndOneUploadOfItsTexture) {
  make();
  Overlay overlay;
  overlay.texture = std::make_shared<OverlayTexture>(OverlayTexture{2, 1, {255, 0}});
  const std::size_t before = null_.liveObjects();
  renderer_->draw(Frame{}, &overlay);
  EXPECT_EQ(null_.liveObjects(), before);  // it is empty
  overlay.points.resize(4);
  overlay.indices = {0, 1, 2, 0, 2, 3};
  overlay.parts = {{0, 0, 320, 180, 0, 3}, {-5, 10, 1000, 20, 3, 3}};
  null_.clearRecord();
  renderer_->draw(Frame{}, &overlay);
  ASSERT_EQ(null_.draws().size(), 4u);
  EXPECT_EQ(null_.draws()[2].vertices, 3);
  renderer_->draw(Frame{}, &overlay);
  EXPECT_EQ(null_.calls("TexSubImage2D"), 1u);
}

TEST_F(RendererOnNull, BloomIsThreeSmallDraws) {
  make();
  Frame frame;
  frame.bloom = 0.5f;
  const std::size_t before = null_.liveObjects();
  renderer_->draw(frame);
  EXPECT_EQ(null_.draws().size(), 5u);
  EXPECT_EQ(null_.liveObjects(), before + 2 * 2 + 2);  // two small pictures, two programs
}

TEST_F(RendererOnNull, AMirrorFloorShowsRoomsSolidsAndSpheresAgain) {
  make();
  geometry::MeshPool pool;
  const std::vector<StaticVertex> vertices(6);
  const std::vector<std::uint32_t> indices = {0, 1, 2, 3, 4, 5};
  Frame frame;
  frame.statics.push_back({renderer_->createStatic(vertices, indices, 3), Vec3(0.0f, 0.0f, -3.0f)});
  addCube(frame, pool, kMetal);
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -3.0f)});
  frame.sphereShadow = 0.0f;
  renderer_->draw(frame);
  EXPECT_EQ(null_.draws().size(), 6u);  // fog, room, its polished floor, solid, spheres, picture
  frame.mirrorHeight = -1.0f;
  renderer_->draw(frame);
  EXPECT_EQ(null_.draws().size(), 6u + 6u + 3u);
}

TEST_F(RendererOnNull, DrawsEachKindOfThingInOneCall) {
  make();
  geometry::MeshPool pool;
  Frame frame;
  for (int i = 0; i < 20; ++i) {
    addCube(frame, pool, kGlass);
    addCube(frame, pool, kMetal);
    addCube(frame, pool, kMatte);
    frame.spheres.push_back({Vec3(0.0f, 0.0f, -3.0f)});
    frame.crumbs.push_back({Vec3(0.0f, 0.0f, -3.0f)});
    frame.glows.push_back({Vec3(0.0f, 0.0f, -3.0f)});
    frame.beams.push_back({Vec3(0.0f, 0.0f, -3.0f), Vec3(1.0f, 0.0f, -3.0f)});
  }
  frame.texts.push_back({{}, 0.05f, HudAlign::Left, kWhite, "25"});
  renderer_->draw(frame);
  // fog, solid, spheres, crumbs, shadows, glass, edges, beams, glows, picture, HUD
  EXPECT_EQ(null_.draws().size(), 11u);
  EXPECT_EQ(renderer_->counters().draws, 11u);
  EXPECT_EQ(null_.calls("BlitFramebuffer"), 2u);  // depth for the shadows, colour for the glass
}

TEST_F(RendererOnNull, SwitchesEffectsOff) {
  make({.width = 320, .height = 180, .shadows = false, .refraction = false});
  geometry::MeshPool pool;
  Frame frame;
  addCube(frame, pool, kGlass);
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -3.0f)});
  renderer_->draw(frame);
  renderer_->draw(frame);
  EXPECT_EQ(null_.calls("BlitFramebuffer"), 0u);
}

TEST_F(RendererOnNull, ResolvesOnceWhenMultisampled) {
  make({.width = 320, .height = 180, .samples = 4});
  renderer_->draw(Frame{});
  EXPECT_EQ(null_.calls("BlitFramebuffer"), 1u);
}

TEST_F(RendererOnNull, UploadsTheMeshPoolOnce) {
  make();
  geometry::MeshPool pool;
  Frame frame;
  addCube(frame, pool, kGlass);
  renderer_->draw(frame);
  EXPECT_EQ(renderer_->counters().verticesUploaded, pool.vertices().size());
  renderer_->draw(frame);
  EXPECT_EQ(renderer_->counters().verticesUploaded, 0u);
}

TEST_F(RendererOnNull, UploadsAnotherPoolInTheSameSlotAfresh) {
  make();
  geometry::MeshPool pool;
  Frame frame;
  addCube(frame, pool, kGlass);
  renderer_->draw(frame);
  frame.groups[0].poolId = 77;
  renderer_->draw(frame);
  EXPECT_EQ(renderer_->counters().verticesUploaded, pool.vertices().size());
}

TEST_F(RendererOnNull, KeepsTheGroupThatMovesToAnotherPlace) {
  make();
  geometry::MeshPool now, next;
  Frame frame;
  addCube(frame, now, kGlass, 0);
  addCube(frame, next, kGlass, 1);
  renderer_->draw(frame);
  EXPECT_EQ(null_.draws().size(), 6u);  // glass and edges of both
  Frame later;
  later.groups[0] = frame.groups[1];  // the next room became the current one
  renderer_->draw(later);
  EXPECT_EQ(renderer_->counters().verticesUploaded, 0u);
}

TEST_F(RendererOnNull, DrawsRoomsAndForgetsDestroyedOnes) {
  make();
  const StaticVertex corner;
  const std::vector<StaticVertex> vertices(3, corner);
  const std::vector<std::uint32_t> indices = {0, 1, 2};
  const StaticId id = renderer_->createStatic(vertices, indices);
  Frame frame;
  frame.statics.push_back({id, Vec3(0.0f, 0.0f, -3.0f)});
  renderer_->draw(frame);
  EXPECT_EQ(null_.draws().size(), 3u);
  renderer_->destroyStatic(id);
  renderer_->draw(frame);
  EXPECT_EQ(null_.draws().size(), 5u);
}

TEST_F(RendererOnNull, ReadsBackItsSize) {
  make();
  renderer_->resize(100, 50);
  renderer_->draw(Frame{});
  const Image image = renderer_->readBack();
  EXPECT_EQ(image.width, 100);
  EXPECT_EQ(image.pixels.size(), 100u * 50u * 4u);
}

TEST_F(RendererOnNull, GoesOnWithoutAPassWhoseShaderFails) {
  make();
  std::string logged;
  const LogSink old = setLogSink([&logged](LogLevel, std::string_view line) { logged += line; });
  null_.failNextShader("no such thing");
  Frame frame;
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -3.0f)});
  frame.sphereShadow = 0.0f;
  renderer_->draw(frame);
  renderer_->draw(frame);
  setLogSink(old);
  EXPECT_EQ(logged, "shader sphere (vertex): no such thing");  // once
  EXPECT_EQ(null_.draws().size(), 4u);
}

TEST_F(RendererOnNull, SaysThatAPictureIsTooLarge) {
  null_.table().CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT; };
  const auto made = Renderer::create(null_.table(), {.width = 16384, .height = 16384});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "a picture of 16384 x 16384 pixels: larger than the driver can make");
}

TEST_F(RendererOnNull, FailsWithTheShadersMessage) {
  null_.failNextShader("no such thing");
  const auto made = Renderer::create(null_.table(), {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "shader background (vertex): no such thing");
}

}  // namespace
}  // namespace brittle::render
