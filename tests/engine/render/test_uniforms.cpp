#include "engine/render/uniforms.h"

#include <gtest/gtest.h>

namespace brittle::render {
namespace {

Vec3 toPicture(const View& view, const Vec3& point) {
  const Vec4 clip = view.viewProjection * Vec4(point.x(), point.y(), point.z(), 1.0f);
  return Vec3(clip.x(), clip.y(), clip.z()) / clip.w();
}

TEST(View, ProjectsAlongTheAxesItNames) {
  Camera camera;
  camera.position = Vec3(1.0f, 2.0f, 3.0f);
  camera.rotation = rotationAbout(Vec3::UnitY(), 0.7f) * rotationAbout(Vec3::UnitX(), -0.3f);
  const View view = makeView(camera, 320, 180);
  EXPECT_FLOAT_EQ(view.tanHalfHeight, 0.57735f * 180.0f / 320.0f);
  const Vec3 ahead = view.eye + 5.0f * view.forward;
  EXPECT_NEAR(toPicture(view, ahead).head<2>().norm(), 0.0f, 1e-5f);
  const Vec3 corner = ahead + 5.0f * (view.tanHalfWidth * view.right + view.tanHalfHeight * view.up);
  EXPECT_NEAR(toPicture(view, corner).x(), 1.0f, 1e-5f);
  EXPECT_NEAR(toPicture(view, corner).y(), 1.0f, 1e-5f);
  EXPECT_NEAR(toPicture(view, view.eye + camera.nearPlane * view.forward).z(), -1.0f, 1e-4f);
  EXPECT_NEAR(toPicture(view, view.eye + camera.farPlane * view.forward).z(), 1.0f, 1e-4f);
}

TEST(View, SeesSpheresThatTouchThePyramid) {
  const View view = makeView({}, 320, 180);
  EXPECT_TRUE(view.sees(Vec3(0.0f, 0.0f, -5.0f), 0.1f, 25.0f));
  EXPECT_TRUE(view.sees(Vec3(0.0f, 0.0f, 0.05f), 0.1f, 25.0f));
  EXPECT_FALSE(view.sees(Vec3(0.0f, 0.0f, 0.2f), 0.1f, 25.0f));
  EXPECT_TRUE(view.sees(Vec3(0.0f, 0.0f, -25.05f), 0.1f, 25.0f));
  EXPECT_FALSE(view.sees(Vec3(0.0f, 0.0f, -25.2f), 0.1f, 25.0f));
  // The right border passes (tan * 5, 0, -5); its normal has length sqrt(1 + tan^2) = 1.1547.
  EXPECT_TRUE(view.sees(Vec3(2.88675f + 0.115f, 0.0f, -5.0f), 0.1f, 25.0f));
  EXPECT_FALSE(view.sees(Vec3(2.88675f + 0.117f, 0.0f, -5.0f), 0.1f, 25.0f));
}

TEST(Uniforms, OfAMirrorPutThingsWhereTheirImagesAre) {
  Frame frame;
  frame.camera.position = Vec3(0.3f, 1.0f, 2.0f);
  frame.camera.rotation = rotationAbout(Vec3::UnitY(), 0.2f) * rotationAbout(Vec3::UnitX(), -0.3f);
  const View view = makeView(frame.camera, 320, 180);
  const FrameUniforms seen = mirrored(makeFrameUniforms(frame, view, 320, 180), view, -1.0f);
  Mat4 viewProjection;
  for (int i = 0; i < 16; ++i) viewProjection(i % 4, i / 4) = seen.viewProjection[static_cast<std::size_t>(i)];
  const Vec3 point(0.5f, 0.4f, -4.0f), image(0.5f, -2.4f, -4.0f);
  const Vec4 clip = viewProjection * Vec4(point.x(), point.y(), point.z(), 1.0f);
  EXPECT_LT((Vec3(clip.head<3>() / clip.w()) - toPicture(view, image)).norm(), 1e-5f);
  // The depth that fog goes by is that of the way over the mirror.
  const Vec3 eye(seen.eye[0], seen.eye[1], seen.eye[2]), forward(seen.forward[0], seen.forward[1], seen.forward[2]);
  EXPECT_NEAR(forward.dot(point - eye), view.depthOf(image), 1e-5f);
}

TEST(Uniforms, TakeTheFirstLampsOfTheSurroundings) {
  Frame frame;
  frame.surroundings.lamps.resize(kMostMirroredLamps + 3);
  frame.surroundings.lamps[1].center = Vec3(1.0f, 2.0f, 3.0f);
  const FrameUniforms block = makeFrameUniforms(frame, makeView(frame.camera, 320, 180), 320, 180);
  EXPECT_EQ(block.lampColor[3], static_cast<float>(kMostMirroredLamps));
  EXPECT_EQ(block.lampPlace[1], (std::array<float, 4>{1.0f, 2.0f, 3.0f, 1.0f}));
}

TEST(Uniforms, RepeatTheLastMaterial) {
  const std::vector<Material> materials = builtInMaterials();
  const MaterialUniforms block = makeMaterialUniforms(materials);
  EXPECT_EQ(block.surface[kMaxMaterials - 1], block.surface[kBall]);
}

TEST(Uniforms, DecodeTheEndsOfTheScale) {
  EXPECT_NEAR(decodeColor(Rgb::Ones()).x(), 1.0f, 1e-6f);
  EXPECT_EQ(decodeColor(Rgb::Zero()).x(), 0.0f);
  EXPECT_NEAR(decodeColor(Rgb::Constant(0.5f)).x(), 0.2140f, 0.002f);
}

TEST(Colours, PackRoundedAndClamped) {
  EXPECT_EQ(packRgba(Rgb(1.0f, 0.0f, 2.0f)), 0xffff00ffu);
  EXPECT_EQ(packRgba(Rgb(-1.0f, 0.5f, 0.0f), 0.0f), 0x00008000u);
}

}  // namespace
}  // namespace brittle::render
