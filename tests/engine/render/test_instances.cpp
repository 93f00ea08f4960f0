#include "engine/render/instances.h"

#include <gtest/gtest.h>

#include "engine/render/decal_atlas.h"
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

TEST(Instances, GiveDecalsTheirCellAndSides) {
  Frame frame;
  Decal decal;
  decal.position = Vec3(0.0f, 0.0f, -3.0f);
  decal.rotation = rotationAbout(Vec3::UnitY(), 1.5707963f);
  decal.halfSize = Vec2(2.0f, 0.5f);
  decal.tile = -2;
  frame.decals.push_back(decal);
  decal.position.z() = 60.0f;  // behind
  frame.decals.push_back(decal);
  const Instances seen = packed(frame);
  ASSERT_EQ(seen.decals.size(), 1u);
  EXPECT_EQ(seen.decals[0].place[3], 65.0f);
  EXPECT_NEAR(seen.decals[0].right[2], -2.0f, 1e-5f);
  EXPECT_NEAR(seen.decals[0].up[1], 0.5f, 1e-5f);
}

TEST(Decals, EverySpriteShowsSomethingAndStaysInsideItsCell) {
  const std::vector<std::uint8_t> atlas = paintDecals();
  constexpr int kWidth = kDecalsAcross * kDecalPixels;
  for (int cell = 0; cell < 64 + kEmblems; ++cell) {
    int most = 0;
    const int left = cell % kDecalsAcross * kDecalPixels, top = cell / kDecalsAcross * kDecalPixels;
    for (int y = 0; y < kDecalPixels; ++y)
      for (int x = 0; x < kDecalPixels; ++x)
        most = maxOf(most, static_cast<int>(atlas[static_cast<std::size_t>((top + y) * kWidth + left + x)]));
    EXPECT_GT(most, 180) << "cell " << cell;
  }
}

TEST(Decals, TilesBeyondTheAtlasAreWrapped) {
  EXPECT_EQ(decalCell(63), 63);
  EXPECT_EQ(decalCell(64), 0);
  EXPECT_EQ(decalCell(-1), 64);
  EXPECT_EQ(decalCell(-4), 67);
  EXPECT_EQ(decalCell(-5), 59);
}

TEST(Instances, ShrinkTheHudWhereThePictureIsNarrow) {
  Frame frame;
  frame.quads.push_back({{Vec2(0.5f, 1.0f), Vec2(0.0f, -0.1f)}, Vec2(kHudWidth, 0.1f), kWhite});
  frame.arcs.push_back({{Vec2(0.5f, 0.0f), Vec2(0.0f, 0.0f)}, 0.1f, 0.2f, 0.0f, 1.0f, kWhite});
  frame.texts.push_back({{Vec2(0.5f, 0.5f), Vec2::Zero()}, 0.1f, HudAlign::Center, kWhite, "I"});
  const std::vector<HudInstance> wide = packed(frame, 600, 400).hud, narrow = packed(frame, 240, 400).hud;
  EXPECT_FLOAT_EQ(wide.at(0).ends[2], 0.5f * kHudWidth * 400.0f);
  EXPECT_FLOAT_EQ(narrow.at(0).ends[2], 120.0f);  // as wide as the picture
  EXPECT_FLOAT_EQ(narrow[0].ends[1], 400.0f - 0.1f * 240.0f / kHudWidth);
  EXPECT_FLOAT_EQ(narrow.at(1).form[0] / wide.at(1).form[0], 240.0f / kHudWidth / 400.0f);
  EXPECT_FLOAT_EQ(narrow.at(2).ends[2] / wide.at(2).ends[2], 240.0f / kHudWidth / 400.0f);
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
  const float wide = textWidth("A B") * 24.0f;
  EXPECT_FLOAT_EQ(hud[0].ends[0], 200.0f);
  EXPECT_FLOAT_EQ(hud[2].ends[0], 200.0f - 0.5f * wide);
  EXPECT_FLOAT_EQ(hud[4].ends[0], 200.0f - wide);
  EXPECT_FLOAT_EQ(hud[0].ends[1], 112.0f);  // the base line is half a capital below the point
}

TEST(Text, HasStrokesOfEveryPrintableCharacterWithinItsGrid) {
  for (int row = 0; row < kGlyphRows; ++row) {
    const std::vector<Stroke> strokes = glyphStrokes(row);
    EXPECT_EQ(strokes.empty(), row == glyphRow(' ')) << "row " << row;
    for (const Stroke& stroke : strokes) {
      EXPECT_GE(stroke.size(), 2u);
      for (const Vec2& point : stroke) {
        EXPECT_GE(point.minCoeff(), 0.0f) << "row " << row;
        EXPECT_LE(point.x(), kGlyphWidth) << "row " << row;
        EXPECT_LE(point.y(), kGlyphHeight) << "row " << row;
      }
    }
  }
}

TEST(Text, PointsStandAsCloseToWhatIsBeforeThemAsToWhatFollows) {
  for (const char c : {'.', ',', ':', ';'}) {
    float left = kGlyphWidth;
    for (const Stroke& stroke : glyphStrokes(glyphRow(c)))
      for (const Vec2& point : stroke) left = minOf(left, point.x());
    EXPECT_EQ(left, 0.0f) << c;
  }
  EXPECT_LT(textWidth("1.25"), textWidth("1225") - 4.0f / kGlyphHeight);
}

TEST(Text, ShowsSmallLettersAsCapitalsAndUnknownBytesAsABox) {
  EXPECT_EQ(glyphStrokes(glyphRow('q')), glyphStrokes(glyphRow('Q')));
  EXPECT_EQ(glyphRow('\x80'), kGlyphRows - 1);
  EXPECT_EQ(glyphRow('\n'), kGlyphRows - 1);
  EXPECT_EQ(glyphStrokes(kGlyphRows - 1)[0].size(), 5u);
  EXPECT_EQ(glyphStrokes(glyphRow('~')).size(), 1u);  // the rows after the small letters
}

TEST(Text, RoundsBluntCornersAndKeepsSharpOnes) {
  EXPECT_EQ(glyphStrokes(glyphRow('L'))[0].size(), 3u);
  const Stroke round = glyphStrokes(glyphRow('O'))[0];
  EXPECT_GT(round.size(), 40u);
  for (std::size_t i = 2; i < round.size(); ++i) {
    const Vec2 in = round[i - 1] - round[i - 2], out = round[i] - round[i - 1];
    if (in.norm() < 1e-3f || out.norm() < 1e-3f) continue;
    EXPECT_GT(in.normalized().dot(out.normalized()), 0.95f);
  }
}

TEST(Text, FiguresAreEquallyWideAndLettersAreNot) {
  for (char c = '0'; c <= '9'; ++c) EXPECT_EQ(glyphAdvance(c), glyphAdvance('8'));
  EXPECT_LT(glyphAdvance('I'), 0.5f * glyphAdvance('M'));
  EXPECT_FLOAT_EQ(textWidth("88") - textWidth("8"), glyphAdvance('8') / kGlyphHeight);
  EXPECT_EQ(textWidth(""), 0.0f);
}

TEST(Text, TheAtlasHoldsDistancesToTheStrokes) {
  const std::vector<std::uint8_t> atlas = paintGlyphs();
  const auto at = [&atlas](char c, int x, int y) {  // in texels of the character's grid, y down
    const int row = glyphRow(c);
    const int left = row % kGlyphColumns * kCellWidth + kGlyphMargin * kGlyphTexels;
    const int top = row / kGlyphColumns * kCellHeight + kGlyphMargin * kGlyphTexels;
    return static_cast<int>(atlas[static_cast<std::size_t>((top + y) * kGlyphAtlasWidth + left + x)]);
  };
  EXPECT_NEAR(at('I', 0, 12), 16, 2);  // a quarter of a unit from the stem: 0.25 / 4 * 255
  EXPECT_NEAR(at('I', 2, 12), 80, 2);
  EXPECT_EQ(at('I', 12, 12), 255);
  EXPECT_EQ(at(' ', 8, 12), 255);
}

}  // namespace
}  // namespace brittle::render
