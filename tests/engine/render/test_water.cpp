#include "engine/render/water.h"

#include "on_null.h"

namespace brittle::render {
namespace {

/// A surface whose height is `slope` times x.
Water slantedWater(float slope) {
  Water water;
  water.center = Vec3(0.0f, -1.0f, -5.0f);
  water.halfSize = Vec2(2.0f, 1.0f);
  water.columns = 8;
  water.rows = 3;
  for (int row = 0; row <= water.rows; ++row)
    for (int column = 0; column <= water.columns; ++column)
      water.heights.push_back(slope * (0.5f * static_cast<float>(column) - 2.0f));
  water.foam.assign(water.heights.size(), 0.25f);
  return water;
}

TEST(WaterPacking, GivesCornersSlopesAndTwoTrianglesACell) {
  std::vector<WaterVertex> vertices;
  std::vector<std::uint32_t> indices;
  packWater(slantedWater(0.1f), vertices, indices);
  ASSERT_EQ(vertices.size(), 9u * 4u);
  EXPECT_EQ(indices.size(), 6u * 8u * 3u);
  EXPECT_EQ(vertices.front().point, Vec3(-2.0f, -1.2f, -6.0f));
  EXPECT_EQ(vertices.back().point, Vec3(2.0f, -0.8f, -4.0f));
  EXPECT_NEAR(vertices[13].slopeX, 0.1f, 1e-6f);
  EXPECT_NEAR(vertices[13].slopeZ, 0.0f, 1e-6f);
  EXPECT_EQ(vertices[13].foam, 0.25f);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return vertices[indices[i + k]].point; };
    EXPECT_GT((at(1) - at(0)).cross(at(2) - at(0)).y(), 0.0f) << "seen from above";
  }
}

class WaterOnNull : public OnNull {};

TEST_F(WaterOnNull, CostsNothingWhereThereIsNone) {
  expectNothingMade();
}

TEST_F(WaterOnNull, IsADrawASurfaceAndTwoCopies) {
  Frame frame;
  frame.waters = {slantedWater(0.1f), slantedWater(0.0f)};
  draw(frame, true);
  EXPECT_EQ(draws_, 4u);  // fog, two surfaces, picture
  EXPECT_EQ(programs_, 1u);
  EXPECT_EQ(blits_, 2u);  // depth and colour of what is below
  draw(frame, false);
  EXPECT_EQ(draws_, 4u);
  EXPECT_EQ(blits_, 0u);
}

}  // namespace
}  // namespace brittle::render
