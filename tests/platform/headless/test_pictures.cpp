// Pictures on a software GL, by statistics and against one small stored picture.
#include <gtest/gtest.h>

#include <cmath>

#include "studio.h"

namespace brittle::render {
namespace {

using platform::HeadlessBackend;

TEST(Pictures, OfBothBackendsAgree) {
  const Image egl = Studio(kSmall, HeadlessBackend::Egl).drawGallery();
  const Image osmesa = Studio(kSmall, HeadlessBackend::OsMesa).drawGallery();
  const ImageDifference difference = compare(egl, osmesa);
  // Measured: identical on one machine. The limit allows for the two drivers being of different builds.
  EXPECT_LE(difference.largest, 16);
  EXPECT_LT(difference.mean, 0.25);
}

TEST(Pictures, GalleryLooksAsStored) {
  const Image image = Studio(kSmall).drawGallery();
  const std::string path = BRITTLE_SOURCE_DIR "/tests/golden/gallery.png";
  const Result<Image> stored = readPng(path);
  const ImageDifference difference = stored ? compare(image, *stored) : ImageDifference{};
  // The mean says whether the look changed; single pixels at edges may differ a lot between drivers.
  if (difference.mean < 1.0) return;
  const std::string seen = BRITTLE_BINARY_DIR "/gallery.png";
  ASSERT_TRUE(writePng(image, seen));
  ADD_FAILURE() << "mean difference " << difference.mean << " from " << path << "; the new picture is " << seen
                << ": look at both, and copy it over if the change is meant";
}

TEST(Pictures, AreTheSameEveryTime) {
  const Image first = Studio(kSmall).drawGallery();
  Studio studio(kSmall);
  EXPECT_EQ(first.pixels, studio.drawGallery().pixels);
  EXPECT_EQ(first.pixels, studio.drawGallery().pixels);
}

TEST(Pictures, MultisampledOnesDifferAtEdgesOnly) {
  RendererDef fine = kSmall;
  fine.samples = 4;
  const ImageDifference difference = compare(Studio(kSmall).drawGallery(), Studio(fine).drawGallery());
  EXPECT_GT(difference.largest, 20);
  EXPECT_LT(difference.mean, 4.0);
}

TEST(Pictures, ShowFogColoursAsAuthored) {
  Frame frame;
  frame.fog.bottom = Rgb(0.2f, 0.4f, 0.8f);
  frame.fog.top = Rgb(2.0f, -1.0f, 0.5f);  // beyond the displayable: clamps after blending
  const Image image = Studio(kSmall).draw(frame);
  // 7 of 255: the corners and borders are darkened a little, as by a lens.
  EXPECT_LT((pixel(image, 160, 179) - 255.0f * frame.fog.bottom).cwiseAbs().maxCoeff(), 7.0f);
  EXPECT_LT((pixel(image, 160, 0) - Vec3(255.0f, 0.0f, 127.5f)).cwiseAbs().maxCoeff(), 7.0f);
}

TEST(Pictures, ShowTintedGlassInItsColour) {
  geometry::MeshPool pool;
  Frame frame = clearAir();
  addPane(frame, pool, Vec3(0.0f, 0.0f, -3.0f), Rgb(1.0f, 0.4f, 0.4f));
  const Vec3 through = pixel(Studio(kSmall).draw(frame), 165, 95);
  EXPECT_GT(through.x(), 90.0f);
  EXPECT_LT(through.y(), 0.75f * through.x());
}

TEST(Pictures, ShowColouredGlassLitByTheRoom) {
  // Both let as much red through; only the one that takes out the rest shines with what it catches.
  geometry::MeshPool coloured, clear;
  Frame red = clearAir(), white = clearAir();
  addPane(red, coloured, Vec3(0.0f, 0.0f, -3.0f), Rgb(1.0f, 0.3f, 0.3f));
  addPane(white, clear, Vec3(0.0f, 0.0f, -3.0f), Rgb(1.0f, 1.0f, 1.0f));
  Studio studio(kSmall);
  white.groups[0].poolId = 1;
  EXPECT_GT(pixel(studio.draw(red), 165, 95).x(), pixel(studio.draw(white), 165, 95).x() + 3.0f);
}

TEST(Pictures, ShowTheEndsOfCylindersFlat) {
  // Seen along its axis: no part of the disc may be brighter than another by more than its mirror image explains.
  geometry::MeshPool pool;
  Frame frame = clearAir();
  geometry::Convex disc = geometry::makeCylinder(1.0f, 0.05f, 12);
  MeshGroup& group = frame.groups[0];
  group.pool = &pool;
  group.bodies.push_back({Vec3(0.0f, 0.0f, -3.0f), rotationAbout(Vec3::UnitX(), 0.5f * kPi)});
  group.meshes.push_back({pool.add(disc, 0, kMatte), 0, kMatte, kWhite});
  const Image picture = Studio(kSmall).draw(frame);
  float least = 255.0f, most = 0.0f;
  for (int i = 0; i < 16; ++i) {
    const float angle = kPi * static_cast<float>(i) / 8.0f;
    const auto at = [](float way) { return static_cast<int>(way); };
    const float light = brightness(picture, 160 + at(60.0f * std::cos(angle)), 90 + at(60.0f * std::sin(angle)));
    least = minOf(least, light);
    most = maxOf(most, light);
  }
  EXPECT_LT(most - least, 12.0f);
}

TEST(Pictures, ShowGlassBehindGlass) {
  geometry::MeshPool pool;
  Frame one = clearAir(), two = clearAir();
  addPane(one, pool, Vec3(0.0f, 0.0f, -3.0f), Rgb(0.9f, 0.9f, 0.9f));
  geometry::MeshPool both;
  addPane(two, both, Vec3(0.0f, 0.0f, -3.0f), Rgb(0.9f, 0.9f, 0.9f));
  addPane(two, both, Vec3(0.0f, 0.0f, -4.0f), Rgb(0.9f, 0.3f, 0.9f));  // only seen through the first
  Studio studio(kSmall);
  two.groups[0].poolId = 1;
  const Vec3 alone = pixel(studio.draw(one), 165, 95), stacked = pixel(studio.draw(two), 165, 95);
  EXPECT_LT(stacked.y() / stacked.x(), 0.8f * alone.y() / alone.x());
}

TEST(Pictures, DrawTheSameWhateverTheOrderOfMeshes) {
  Studio studio(kSmall);
  geometry::MeshPool pool;
  Frame frame = clearAir();
  addPane(frame, pool, Vec3(0.0f, 0.0f, -3.0f), Rgb(1.0f, 0.5f, 0.5f));
  addPane(frame, pool, Vec3(0.0f, 0.0f, -5.0f), Rgb(0.5f, 0.5f, 1.0f));
  const Image image = studio.draw(frame);
  std::swap(frame.groups[0].meshes[0], frame.groups[0].meshes[1]);
  EXPECT_EQ(image.pixels, studio.draw(frame).pixels);
}

TEST(Pictures, DrawTheSameWhateverTheOrderOfGroups) {
  Studio studio(kSmall);
  geometry::MeshPool now, next;
  Frame frame = clearAir();
  addPane(frame, now, Vec3(0.0f, 0.0f, -3.0f), Rgb(1.0f, 0.5f, 0.5f));
  frame.groups[1] = frame.groups[0];
  frame.groups[0] = {};
  addPane(frame, next, Vec3(0.0f, 0.0f, -5.0f), Rgb(0.5f, 0.5f, 1.0f));
  const Image image = studio.draw(frame);
  std::swap(frame.groups[0], frame.groups[1]);
  EXPECT_EQ(image.pixels, studio.draw(frame).pixels);
}

TEST(Pictures, MoveMeshesWithTheirBodies) {
  Studio studio(kSmall);
  geometry::MeshPool pool;
  Frame frame = clearAir();
  addPane(frame, pool, Vec3(0.0f, 0.0f, -6.0f), Rgb(1.0f, 0.1f, 0.1f), kMatte);
  EXPECT_GT(pixel(studio.draw(frame), 160, 90).x(), 2.0f * pixel(studio.draw(frame), 160, 90).y());
  frame.groups[0].bodies[0].position.x() = 2.0f;
  const Image moved = studio.draw(frame);
  EXPECT_NEAR(pixel(moved, 160, 90).x(), 127.0f, 4.0f);  // fog again
  EXPECT_GT(pixel(moved, 240, 90).x(), 2.0f * pixel(moved, 240, 90).y());
}

TEST(Pictures, TintMeshesOfOneFrameOnly) {
  Studio studio(kSmall);
  geometry::MeshPool pool;
  Frame frame = clearAir();
  addPane(frame, pool, Vec3(0.0f, 0.0f, -6.0f), Rgb::Ones(), kMatte);
  const Vec3 plain = pixel(studio.draw(frame), 160, 90);
  frame.groups[0].meshes[0].tint = packRgba(Rgb(1.0f, 0.2f, 0.2f));
  const Vec3 tinted = pixel(studio.draw(frame), 160, 90);
  EXPECT_LT(tinted.y(), 0.7f * plain.y());
  EXPECT_GT(tinted.x(), 0.9f * plain.x());
}

TEST(Pictures, DarkenTheFloorUnderABall) {
  BakeBox floor;
  floor.center = Vec3(0.0f, -1.5f, -5.0f);
  floor.halfExtents = Vec3(5.0f, 0.5f, 5.0f);
  floor.color.fill(Rgb::Constant(0.5f));
  Studio studio(kSmall);
  Frame frame = clearAir();
  frame.camera.position = Vec3(0.0f, 0.5f, 0.0f);
  frame.camera.rotation = rotationAbout(Vec3::UnitX(), -0.3f);
  frame.statics.push_back({studio.addStatic(bake(std::span(&floor, 1), {})), Vec3::Zero()});
  frame.shadows.push_back({Vec3(0.0f, -0.9f, -4.5f), Vec2(0.4f, 0.3f), 0.5f, 0.8f});  // a caster that is not drawn
  const Image with = studio.draw(frame);
  frame.shadows.clear();
  const Image without = studio.draw(frame);
  EXPECT_LT(brightness(with, 160, 96), 0.75f * brightness(without, 160, 96));
  EXPECT_EQ(pixel(with, 40, 150), pixel(without, 40, 150));  // elsewhere nothing changes
  EXPECT_EQ(pixel(with, 160, 20), pixel(without, 160, 20));
}

TEST(Pictures, ShowABallInAMirrorFloor) {
  BakeBox floor;
  floor.center = Vec3(0.0f, -1.5f, -8.0f);
  floor.halfExtents = Vec3(5.0f, 0.5f, 8.0f);
  floor.color.fill(Rgb::Constant(0.2f));
  floor.reflects = true;
  Studio studio(kSmall);
  Frame frame = clearAir();
  frame.light.ambient = 1.0f;
  const BakedMesh mesh = bake(std::span(&floor, 1), {});
  const StaticId id = mesh.polished > 0 ? studio.addStatic(mesh) : 0;
  frame.statics.push_back({id, Vec3::Zero()});
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -9.0f), 0.3f, Quat::Identity(), kMatte, packRgba(Rgb(1.0f, 0.1f, 0.1f))});
  frame.sphereShadow = 0.0f;
  const auto redness = [](const Vec3& c) { return c.x() - c.y(); };
  const int down = 90 + static_cast<int>(2.0f / 9.0f / (0.57735f / 320.0f * 180.0f) * 90.0f);  // the image is at y = -2
  EXPECT_LT(redness(pixel(studio.draw(frame), 160, down)), 4.0f);
  frame.mirrorHeight = -1.0f;
  EXPECT_GT(redness(pixel(studio.draw(frame), 160, down)), 20.0f);
}

TEST(Pictures, ShineBeyondTheOutlineOfBrightThings) {
  Studio studio(kSmall);
  Frame frame = clearAir();
  frame.fog.bottom = frame.fog.top = Rgb::Constant(0.1f);
  frame.glows.push_back({Vec3(0.0f, 0.0f, -3.0f), 0.5f, kWhite});
  for (int i = 0; i < 4; ++i) frame.glows.push_back(frame.glows[0]);
  const Image plain = studio.draw(frame);
  frame.bloom = 1.0f;
  const Image shining = studio.draw(frame);
  EXPECT_GT(brightness(shining, 160 + 34, 90), brightness(plain, 160 + 34, 90) + 4.0f);
  EXPECT_EQ(pixel(shining, 20, 20), pixel(plain, 20, 20));
}

TEST(Pictures, ShowLampsAndWallsInABall) {
  Studio studio(kSmall);
  Frame frame = clearAir();
  frame.spheres.push_back({Vec3(0.0f, 1.0f, -1.2f), 0.4f});
  frame.camera.position = Vec3(0.0f, 1.0f, 0.0f);
  frame.surroundings.left = Rgb(1.0f, 0.1f, 0.1f);
  frame.surroundings.right = Rgb(0.1f, 0.1f, 1.0f);
  const Image dark = studio.draw(frame);
  EXPECT_GT(pixel(dark, 100, 90).x(), 1.3f * pixel(dark, 100, 90).z());
  EXPECT_GT(pixel(dark, 220, 90).z(), 1.3f * pixel(dark, 220, 90).x());
  frame.surroundings.lamps.push_back({Vec3(0.0f, 4.0f, -1.0f), Vec3(0.5f, 0.02f, 0.5f), 1.0f});
  EXPECT_GT(compare(studio.draw(frame), dark).largest, 40);
}

TEST(Pictures, LayDecalsOnSurfacesUnderWhatStandsBefore) {
  BakeBox wall;
  wall.center = Vec3(0.0f, 0.0f, -5.5f);
  wall.halfExtents = Vec3(5.0f, 5.0f, 0.5f);
  wall.color.fill(Rgb::Constant(0.5f));
  Studio studio(kSmall);
  Frame frame = clearAir();
  frame.statics.push_back({studio.addStatic(bake(std::span(&wall, 1), {})), Vec3::Zero()});
  const Vec3 plain = pixel(studio.draw(frame), 160, 90);
  frame.decals.push_back(
      {Vec3(0.0f, 0.0f, -5.0f), Quat::Identity(), Vec2(0.5f, 0.5f), 0, packRgba(Rgb(1.0f, 0.0f, 0.0f)), 1.0f});
  const Image marked = studio.draw(frame);
  EXPECT_GT(pixel(marked, 160, 90).x(), plain.x() + 60.0f);
  EXPECT_LT(pixel(marked, 160, 90).y(), 30.0f);
  frame.decals[0].cover = 0.0f;
  EXPECT_GT(pixel(studio.draw(frame), 160, 90).y(), plain.y() - 2.0f);  // it only adds
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -4.0f), 0.3f});
  EXPECT_LT(pixel(studio.draw(frame), 160, 90).x() - pixel(studio.draw(frame), 160, 90).y(), 60.0f);
}

TEST(Pictures, ShowNothingThroughGlassThatStandsBeforeIt) {
  RendererDef flat = kSmall;
  flat.refraction = false;
  geometry::MeshPool bent, straight;
  const auto edgeOf = [](Studio& studio, geometry::MeshPool& pool) {
    Frame frame = clearAir();
    addPane(frame, pool, Vec3(0.0f, 0.0f, -4.0f), Rgb::Ones());
    frame.groups[0].bodies[0].rotation = rotationAbout(Vec3::UnitY(), 0.5f);  // tilted: it bends
    frame.spheres.push_back({Vec3(0.0f, 0.0f, -2.0f), 0.2f, Quat::Identity(), kMatte, packRgba(Rgb(1.0f, 0.0f, 0.0f))});
    frame.sphereShadow = 0.0f;
    const Image image = studio.draw(frame);
    int red = 0;
    for (int x = 100; x < 220; ++x) red += pixel(image, x, 90).x() > 1.3f * pixel(image, x, 90).y() ? 1 : 0;
    return red;
  };
  Studio with(kSmall), without(flat);
  EXPECT_EQ(edgeOf(with, bent), edgeOf(without, straight)) << "the ball in front is as wide";
}

TEST(Pictures, BendWhatIsBehindGlass) {
  RendererDef flat = kSmall;
  flat.refraction = false;
  const Image bent = Studio(kSmall).drawGallery(), straight = Studio(flat).drawGallery();
  EXPECT_GT(compare(bent, straight).largest, 20);
  EXPECT_LT(compare(bent, straight).mean, 8.0);
}

TEST(Pictures, CoverWithTintAndBorder) {
  Studio studio(kSmall);
  Frame frame = clearAir();
  frame.border = Vec4(1.0f, 0.0f, 0.0f, 1.0f);
  const Image crash = studio.draw(frame);
  EXPECT_GT(pixel(crash, 1, 90).x(), 240.0f);
  EXPECT_LT(pixel(crash, 1, 90).y(), 20.0f);
  EXPECT_NEAR(pixel(crash, 160, 90).y(), 127.0f, 4.0f);
  frame.border = Vec4::Zero();
  frame.tint = Vec4(0.0f, 0.0f, 0.0f, 0.5f);
  EXPECT_NEAR(pixel(studio.draw(frame), 160, 90).y(), 64.0f, 4.0f);
}

TEST(Pictures, WriteLettersWhereTheyBelong) {
  Frame frame = clearAir();
  frame.fog.bottom = frame.fog.top = Rgb::Zero();
  frame.texts.push_back({{Vec2(0.5f, 0.5f), Vec2::Zero()}, 0.4f, HudAlign::Center, kWhite, "T"});
  const Image image = Studio(kSmall).draw(frame);
  EXPECT_GT(brightness(image, 160, 90), 200.0f);  // the stem
  EXPECT_GT(brightness(image, 144, 54), 200.0f);  // the bar
  EXPECT_GT(brightness(image, 176, 54), 200.0f);
  EXPECT_LT(brightness(image, 150, 90), 20.0f);
  EXPECT_LT(brightness(image, 160, 40), 20.0f);
}

TEST(Pictures, FillArcsClockwiseFromTheTop) {
  Frame frame = clearAir();
  frame.fog.bottom = frame.fog.top = Rgb::Zero();
  frame.arcs.push_back({{Vec2(0.5f, 0.5f), Vec2::Zero()}, 0.2f, 0.3f, 0.0f, 0.25f, kWhite});
  const Image image = Studio(kSmall).draw(frame);
  const int r = 45;  // the ring's middle [pixels]
  EXPECT_GT(brightness(image, 160 + r * 7 / 10, 90 - r * 7 / 10), 200.0f);
  EXPECT_LT(brightness(image, 160 - r * 7 / 10, 90 - r * 7 / 10), 20.0f);
  EXPECT_LT(brightness(image, 160 + r * 7 / 10, 90 + r * 7 / 10), 20.0f);
}

TEST(Pictures, ShowAnOverlayWithinItsClipAndCoverageOnly) {
  Overlay overlay;
  overlay.texture = std::make_shared<OverlayTexture>(OverlayTexture{2, 1, {255, 0}});
  const auto corner = [](float x, float y, float u) { return OverlayPoint{x, y, u, 0.5f, 0xff0000ffu}; };
  // Red over the left half of the picture by its coverage, of which the upper left quarter is let through.
  overlay.points = {corner(0, 0, 0.0f), corner(320, 0, 1.0f), corner(320, 180, 1.0f), corner(0, 180, 0.0f)};
  overlay.indices = {0, 1, 2, 0, 2, 3};
  overlay.parts = {{0, 0, 160, 90, 0, 6}};
  Studio studio(kSmall);
  const Image plain = studio.draw(Frame{}), seen = studio.draw(Frame{}, &overlay), after = studio.draw(Frame{});
  EXPECT_EQ(seen.at(40, 45)[0], 255);
  EXPECT_EQ(seen.at(40, 45)[1], 0);
  for (const auto& [x, y] : {std::pair{40, 120}, {200, 45}, {161, 10}, {40, 90}})
    for (int i = 0; i < 3; ++i) EXPECT_EQ(seen.at(x, y)[i], plain.at(x, y)[i]) << x << ' ' << y;
  EXPECT_EQ(compare(plain, after).largest, 0);  // and it leaves no state behind
}

TEST(Pictures, KeepTheirSizeWhenResized) {
  auto device = platform::createHeadless(HeadlessBackend::Egl, {64, 64});
  ASSERT_TRUE(device) << device.error().message;
  Result<Gl> gl = loadGl((*device)->glLoader());
  ASSERT_TRUE(gl) << gl.error().message;
  const auto renderer = Renderer::create(*gl, {.width = 64, .height = 64, .samples = 4});
  ASSERT_TRUE(renderer) << renderer.error().message;
  for (const int side : {1, 33, 200}) {
    (*renderer)->resize(side, 2 * side);
    (*renderer)->draw(Frame{});
    EXPECT_EQ((*renderer)->readBack().height, 2 * side);
  }
  EXPECT_EQ(glErrorName(gl->GetError()), "no error");
}

}  // namespace
}  // namespace brittle::render
