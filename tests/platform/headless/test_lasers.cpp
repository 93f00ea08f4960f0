// Lasers on a software GL.
#include "studio.h"

namespace brittle::render {
namespace {

Frame beam() {
  Frame frame = clearAir();
  frame.fog.bottom = frame.fog.top = Rgb::Constant(0.1f);
  frame.lasers.push_back({Vec3(-1.0f, 0.0f, -4.0f), Vec3(1.0f, 0.0f, -4.0f), 0.03f, packRgba(Rgb(1.0f, 0.1f, 0.1f))});
  return frame;
}

TEST(LaserPictures, OfBothBackendsAgree) {
  const ImageDifference difference = compare(Studio(kSmall, platform::HeadlessBackend::Egl).draw(beam()),
                                             Studio(kSmall, platform::HeadlessBackend::OsMesa).draw(beam()));
  EXPECT_LE(difference.largest, 16);
  EXPECT_LT(difference.mean, 0.25);
}

TEST(LaserPictures, BurnWhiteInAColouredHalo) {
  const Image image = Studio(kSmall).draw(beam());
  const Vec3 core = pixel(image, 160, 90), halo = pixel(image, 160, 96), dark = pixel(image, 160, 30);
  EXPECT_GT(core.minCoeff(), 180.0f);
  EXPECT_GT(halo.x(), dark.x() + 15.0f);
  EXPECT_LT(halo.y(), halo.x() - 12.0f);
}

}  // namespace
}  // namespace brittle::render
