// Smoke on a software GL.
#include "studio.h"

namespace brittle::render {
namespace {

/// A puff whose middle is `before` [m] before a dark wall.
Frame puff(Studio& studio, float before) {
  BakeBox wall;
  wall.center = Vec3(0.0f, 0.0f, -5.5f);
  wall.halfExtents = Vec3(6.0f, 6.0f, 0.5f);
  wall.color.fill(Rgb::Constant(0.15f));
  Frame frame = clearAir();
  frame.statics.push_back({studio.addStatic(bake(std::span(&wall, 1), {})), Vec3::Zero()});
  frame.puffs.push_back({Vec3(0.0f, 0.0f, -5.0f + before), 1.0f, kWhite, 0.3f, 2.0f});
  return frame;
}

TEST(SmokePictures, OfBothBackendsAgree) {
  const auto on = [](platform::HeadlessBackend backend) {
    Studio studio(kSmall, backend);
    return studio.draw(puff(studio, 0.5f));
  };
  const Image egl = on(platform::HeadlessBackend::Egl);
  const ImageDifference difference = compare(egl, on(platform::HeadlessBackend::OsMesa));
  EXPECT_GT(brightness(egl, 160, 90), 60.0f) << "not black";
  EXPECT_LE(difference.largest, 16);
  EXPECT_LT(difference.mean, 0.25);
}

TEST(SmokePictures, ThinOutWhereTheyMeetAWall) {
  Studio studio(kSmall);
  const auto light = [&](float before) { return brightness(studio.draw(puff(studio, before)), 160, 90); };
  const float free = light(1.2f), halfway = light(0.0f), behind = light(-1.2f);
  EXPECT_GT(free, behind + 40.0f);
  EXPECT_GT(free, halfway + 10.0f);
  EXPECT_GT(halfway, behind + 10.0f);
}

}  // namespace
}  // namespace brittle::render
