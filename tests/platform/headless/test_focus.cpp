// Depth of field on a software GL.
#include "studio.h"

#include <cmath>

namespace brittle::render {
namespace {

/// A near ball on the left and a far one on the right, both black on grey.
Frame balls(float strength) {
  Frame frame = clearAir();
  const std::uint32_t black = packRgba(Rgb::Zero());
  frame.sphereShadow = 0.0f;
  frame.spheres.push_back({Vec3(-0.8f, 0.0f, -3.0f), 0.4f, Quat::Identity(), kMatte, black});
  frame.spheres.push_back({Vec3(4.0f, 0.0f, -15.0f), 2.0f, Quat::Identity(), kMatte, black});
  frame.focus = {5.0f, 8.0f, strength};
  return frame;
}

/// The largest step between two neighbours of the middle row.
float sharpness(const Image& image, int from, int to) {
  float most = 0.0f;
  for (int x = from; x < to; ++x)
    most = maxOf(most, std::fabs(brightness(image, x, 90) - brightness(image, x + 1, 90)));
  return most;
}

TEST(FocusPictures, OfBothBackendsAgree) {
  const ImageDifference difference = compare(Studio(kSmall, platform::HeadlessBackend::Egl).draw(balls(1.0f)),
                                             Studio(kSmall, platform::HeadlessBackend::OsMesa).draw(balls(1.0f)));
  EXPECT_LE(difference.largest, 16);
  EXPECT_LT(difference.mean, 0.25);
}

TEST(FocusPictures, BlurWhatIsFarAndKeepWhatIsNear) {
  Studio studio(kSmall);
  const Image sharp = studio.draw(balls(0.0f)), soft = studio.draw(balls(1.0f));
  EXPECT_LT(sharpness(soft, 180, 300), 0.5f * sharpness(sharp, 180, 300));
  EXPECT_GT(sharpness(soft, 20, 140), 0.9f * sharpness(sharp, 20, 140));
}

/// How much sharper the two halves of a picture are without the blur than with it.
struct Kept {
  float near, far;
};
Kept keptOf(Studio& studio, Frame frame) {
  frame.focus = {5.0f, 8.0f, 1.0f};
  const Image soft = studio.draw(frame);
  frame.focus.strength = 0.0f;
  const Image sharp = studio.draw(frame);
  return {sharpness(soft, 20, 158) / sharpness(sharp, 20, 158), sharpness(soft, 180, 300) / sharpness(sharp, 180, 300)};
}

TEST(FocusPictures, BlurGlassThatIsFarAndKeepWhatIsNear) {
  Studio studio(kSmall);
  Frame frame = clearAir();
  geometry::MeshPool pool;
  addPane(frame, pool, Vec3(-1.3f, 0.0f, -4.5f), Rgb(0.2f, 0.3f, 0.4f));
  addPane(frame, pool, Vec3(4.0f, 0.0f, -15.0f), Rgb(0.2f, 0.3f, 0.4f));
  const Kept kept = keptOf(studio, frame);
  EXPECT_GT(kept.near, 0.9f);
  EXPECT_LT(kept.far, 0.5f);
}

TEST(FocusPictures, BlurRopesThatAreFarAndKeepWhatIsNear) {
  Studio studio(kSmall);
  Frame frame = clearAir();
  frame.beams.push_back({Vec3(-1.0f, -1.0f, -4.5f), Vec3(-1.0f, 1.0f, -4.5f), 0.05f});
  frame.beams.push_back({Vec3(4.0f, -2.0f, -15.0f), Vec3(4.0f, 2.0f, -15.0f), 0.15f});
  const Kept kept = keptOf(studio, frame);
  EXPECT_GT(kept.near, 0.9f);
  EXPECT_LT(kept.far, 0.5f);
}

TEST(FocusPictures, BringGlassIntoFocusByAndBy) {
  Studio studio(kSmall);
  float before = 0.0f;
  for (float depth = 14.0f; depth > 4.0f; depth -= 0.5f) {
    Frame frame = clearAir();
    geometry::MeshPool pool;
    addPane(frame, pool, Vec3(1.0f + 0.2f * depth, 0.0f, -depth), Rgb(0.2f, 0.3f, 0.4f));
    addPane(frame, pool, Vec3(-1.3f, 0.0f, -4.5f), Rgb(0.2f, 0.3f, 0.4f));
    const float now = keptOf(studio, frame).far;
    if (before > 0.0f) {
      EXPECT_NEAR(now, before, 0.25f) << "at " << depth << " m";
    }
    before = now;
  }
  EXPECT_GT(before, 0.9f);
}

TEST(FocusPictures, WorkMultisampledAndAtOddSizes) {
  RendererDef fine = kSmall, odd = kSmall;
  fine.samples = 4;
  ++odd.width;
  ++odd.height;
  EXPECT_LT(compare(Studio(fine).draw(balls(1.0f)), Studio(kSmall).draw(balls(1.0f))).mean, 4.0);
  const Image uneven = Studio(odd).draw(balls(1.0f));
  EXPECT_LT(sharpness(uneven, 180, 300), 0.5f * sharpness(Studio(odd).draw(balls(0.0f)), 180, 300));
}

}  // namespace
}  // namespace brittle::render
