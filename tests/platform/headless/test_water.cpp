// Water on a software GL.
#include "studio.h"

namespace brittle::render {
namespace {

BakeBox ground() {
  BakeBox box;
  box.center = Vec3(0.0f, -2.5f, -6.0f);
  box.halfExtents = Vec3(6.0f, 0.5f, 6.0f);
  box.color.fill(Rgb(0.9f, 0.2f, 0.2f));
  return box;
}

/// A camera that looks down at water above red ground.
Frame pool(Studio& studio, float height) {
  Frame frame = clearAir();
  frame.camera.rotation = rotationAbout(Vec3::UnitX(), -0.5f);
  const BakeBox box = ground();
  frame.statics.push_back({studio.addStatic(bake(std::span(&box, 1), {})), Vec3::Zero()});
  Water water;
  water.center = Vec3(0.0f, height, -6.0f);
  water.halfSize = Vec2(5.0f, 5.0f);
  water.columns = water.rows = 24;
  for (int i = 0; i < 25 * 25; ++i) {
    water.heights.push_back(0.02f * static_cast<float>(i % 7) - 0.06f);
    water.foam.push_back(i % 25 > 12 ? 1.0f : 0.0f);
  }
  frame.waters.push_back(water);
  return frame;
}

/// One context at a time.
Image poolOn(const RendererDef& def, platform::HeadlessBackend backend = platform::HeadlessBackend::Egl) {
  Studio studio(def, backend);
  return studio.draw(pool(studio, -1.0f));
}

TEST(WaterPictures, OfBothBackendsAgree) {
  const Image egl = poolOn(kSmall, platform::HeadlessBackend::Egl);
  const ImageDifference difference = compare(egl, poolOn(kSmall, platform::HeadlessBackend::OsMesa));
  EXPECT_GT(pixel(egl, 150, 110).maxCoeff(), 60.0f) << "not black";
  EXPECT_LE(difference.largest, 16);
  EXPECT_LT(difference.mean, 0.25);
}

TEST(WaterPictures, TheDeeperTheLessRedComesThrough) {
  Studio studio(kSmall);
  const auto redness = [&](float height) {
    const Vec3 c = pixel(studio.draw(pool(studio, height)), 150, 110);
    return c.x() / c.mean();
  };
  Frame dry = pool(studio, -1.0f);
  dry.waters.clear();
  const Vec3 bare = pixel(studio.draw(dry), 150, 110);
  EXPECT_GT(bare.x() / bare.mean(), redness(-1.6f));
  EXPECT_GT(redness(-1.6f), 1.05f * redness(-0.8f));
}

TEST(WaterPictures, AreAlikeMultisampled) {
  RendererDef fine = kSmall;
  fine.samples = 4;
  EXPECT_LT(compare(poolOn(kSmall), poolOn(fine)).mean, 4.0);
}

TEST(WaterPictures, AreWholeWithoutRefraction) {
  RendererDef plain = kSmall;
  plain.refraction = false;
  Studio studio(plain);
  const Vec3 water = pixel(studio.draw(pool(studio, -1.0f)), 150, 110);
  Frame dry = pool(studio, -1.0f);
  dry.waters.clear();
  const Vec3 ground = pixel(studio.draw(dry), 150, 110);
  EXPECT_LT(water.x() / water.mean(), 0.8f * ground.x() / ground.mean());
}

TEST(WaterPictures, FoamIsWhite) {
  Studio studio(kSmall);
  const Image image = studio.draw(pool(studio, -1.0f));
  const Vec3 clear = pixel(image, 140, 120), foam = pixel(image, 240, 120);
  EXPECT_GT(foam.minCoeff(), clear.minCoeff() + 30.0f);
}

TEST(WaterPictures, WhatStandsBeforeItIsNotSeenThroughIt) {
  Studio studio(kSmall);
  Frame frame = pool(studio, -1.0f);
  frame.sphereShadow = 0.0f;
  frame.spheres.push_back({Vec3(0.0f, -0.8f, -2.0f), 0.2f, Quat::Identity(), kMatte, packRgba(Rgb(0.0f, 1.0f, 0.0f))});
  const Image with = studio.draw(frame);
  frame.waters.clear();
  const Image dry = studio.draw(frame);
  const auto green = [](const Image& image) {
    int count = 0;
    for (int y = 0; y < 180; ++y)
      for (int x = 0; x < 320; ++x) {
        const Vec3 c = pixel(image, x, y);
        count += c.y() > 1.4f * c.x() && c.y() > 1.4f * c.z() ? 1 : 0;
      }
    return count;
  };
  EXPECT_NEAR(green(with), green(dry), 12) << "the ball is as large, and has no ghost";
  EXPECT_GT(green(dry), 200);
}

}  // namespace
}  // namespace brittle::render
