#include "engine/render/water.h"

#include "engine/core/assert.h"

namespace brittle::render {
namespace {

/// The heights of a surface by corner, with the slopes between them; beyond its border it goes on level.
class WaterGrid {
 public:
  explicit WaterGrid(const Water& water)
      : water_(water),
        step_(2.0f * water.halfSize.x() / static_cast<float>(water.columns),
              2.0f * water.halfSize.y() / static_cast<float>(water.rows)) {}

  WaterVertex at(int column, int row) const {
    const Vec3 low = water_.center - Vec3(water_.halfSize.x(), 0.0f, water_.halfSize.y());
    const Vec3 off(static_cast<float>(column) * step_.x(), height(column, row), static_cast<float>(row) * step_.y());
    return {low + off, slope(height(column - 1, row), height(column + 1, row), step_.x()),
            slope(height(column, row - 1), height(column, row + 1), step_.y()), water_.foam[index(column, row)]};
  }
  std::uint32_t index(int column, int row) const {
    return static_cast<std::uint32_t>(row * (water_.columns + 1) + column);
  }

 private:
  float height(int column, int row) const {
    return water_.heights[index(clampTo(column, 0, water_.columns), clampTo(row, 0, water_.rows))];
  }
  static float slope(float before, float after, float step) { return (after - before) / (2.0f * step); }

  const Water& water_;
  Vec2 step_;  // [m]
};

}  // namespace

void packWater(const Water& water, std::vector<WaterVertex>& vertices, std::vector<std::uint32_t>& indices) {
  const auto corners = static_cast<std::size_t>((water.columns + 1) * (water.rows + 1));
  BR_ASSERT(water.columns > 0 && water.rows > 0);
  BR_ASSERT(water.heights.size() == corners && water.foam.size() == corners);
  vertices.clear();
  indices.clear();
  const WaterGrid grid(water);
  for (int row = 0; row <= water.rows; ++row)
    for (int column = 0; column <= water.columns; ++column) vertices.push_back(grid.at(column, row));
  for (int row = 0; row < water.rows; ++row)
    for (int column = 0; column < water.columns; ++column) {
      const std::uint32_t a = grid.index(column, row), b = grid.index(column, row + 1);
      indices.insert(indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
}

}  // namespace brittle::render
