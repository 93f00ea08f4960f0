#include "engine/render/instances.h"

#include <gtest/gtest.h>

#include "engine/render/text.h"

namespace brittle::render {
namespace {

Instances packed(const Frame& frame, int width = 320, int height = 180, bool withShadows = true) {
  Instances instances;
  instances.pack(frame, makeView(frame.camera, width, height), width, height, withShadows);
  return instances;
}

TEST(Instances, LeaveOutWhatTheViewCannotSee) {
  Frame frame;
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -3.0f)});
  frame.spheres.push_back({Vec3(0.0f, 0.0f, 3.0f)});
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -60.0f)});  // beyond the fog
  EXPECT_EQ(packed(frame).spheres.size(), 1u);
}

TEST(Instances, GiveEverySphereAShadowUnlessSwitchedOff) {
  Frame frame;
  frame.spheres.push_back({Vec3(0.0f, 0.0f, -3.0f)});
  frame.shadows.push_back({Vec3(0.0f, 0.0f, -4.0f)});
  EXPECT_EQ(packed(frame).shadows.size(), 2u);
  EXPECT_EQ(packed(frame, 320, 180, false).shadows.size(), 0u);
  frame.sphereShadow = 0.0f;
  EXPECT_EQ(packed(frame).shadows.size(), 1u);
}

TEST(Instances, PlaceTheHudByAnchorAndOffset) {
  Frame frame;
  frame.quads.push_back({{Vec2(1.0f, 0.5f), Vec2(-0.1f, 0.2f)}, Vec2(0.1f, 0.2f), kWhite});
  const HudInstance quad = packed(frame, 400, 200).hud.at(0);
  EXPECT_FLOAT_EQ(quad.ends[0], 380.0f);
  EXPECT_FLOAT_EQ(quad.ends[1], 140.0f);
  EXPECT_FLOAT_EQ(quad.ends[2], 10.0f);  // half the width
  EXPECT_FLOAT_EQ(quad.ends[3], 20.0f);
}

TEST(Instances, AlignText) {
  Frame frame;
  for (const HudAlign align : {HudAlign::Left, HudAlign::Center, HudAlign::Right}) {
    frame.texts.push_back({{Vec2(0.5f, 0.5f), Vec2::Zero()}, 0.12f, align, kWhite, "A B"});
  }
  const std::vector<HudInstance> hud = packed(frame, 400, 200).hud;
  ASSERT_EQ(hud.size(), 6u);  // spaces draw nothing
  const float wide = textWidth(3) * 24.0f;
  EXPECT_FLOAT_EQ(hud[0].ends[0], 200.0f);
  EXPECT_FLOAT_EQ(hud[2].ends[0], 200.0f - 0.5f * wide);
  EXPECT_FLOAT_EQ(hud[4].ends[0], 200.0f - wide);
  EXPECT_FLOAT_EQ(hud[0].ends[1], 112.0f);  // the base line is half a capital below the point
}

TEST(Text, HasStrokesOfEveryPrintableCharacterWithinItsGrid) {
  for (int row = 0; row < kGlyphRows; ++row) {
    const std::vector<Stroke> strokes = glyphStrokes(row);
    EXPECT_EQ(strokes.empty(), row == glyphRow(' ')) << "row " << row;
    EXPECT_LE(strokes.size(), static_cast<std::size_t>(kMaxStrokes));
    for (const Stroke& s : strokes) {
      EXPECT_LE(s.x0, kGlyphWidth) << "row " << row;
      EXPECT_LE(s.x1, kGlyphWidth) << "row " << row;
      EXPECT_LE(s.y0, kGlyphHeight) << "row " << row;
      EXPECT_LE(s.y1, kGlyphHeight) << "row " << row;
    }
  }
}

TEST(Text, ShowsSmallLettersAsCapitalsAndUnknownBytesAsABox) {
  EXPECT_EQ(glyphStrokes(glyphRow('q')).size(), glyphStrokes(glyphRow('Q')).size());
  EXPECT_EQ(glyphRow('\x80'), kGlyphRows - 1);
  EXPECT_EQ(glyphRow('\n'), kGlyphRows - 1);
  EXPECT_EQ(glyphStrokes(kGlyphRows - 1).size(), 4u);
  EXPECT_EQ(glyphStrokes(glyphRow('~')).size(), 3u);  // the rows after the small letters
  EXPECT_EQ(glyphStrokes(glyphRow('L')).size(), 2u);
}

}  // namespace
}  // namespace brittle::render
