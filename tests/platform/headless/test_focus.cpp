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
