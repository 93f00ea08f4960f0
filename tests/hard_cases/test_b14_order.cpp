// B14: the order of cuts does not matter. The same planes are applied to a box in every order. Cut exactly, the cells
// are the same set each time, corner for corner; cut in floats, each has its exact volume to 1e-6. Voro++, told the
// half-spaces of a cell, finds the same volume and as many faces.
// Planes: at random; all through one point; through corners and edges of the box; on its faces, twice each.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "tests/engine/geometry/exact.h"
#include "tests/hard_cases/case.h"
#include "tests/hard_cases/half_spaces.h"

namespace brittle::geometry {
namespace {

const Vec3 kHalf(0.5f, 0.25f, 0.5f);

/// A plane with a float normal that goes through a float point exactly, and the same with a rounded offset.
struct Wall {
  PlaneT<Exact> exact;
  Plane rounded;

  /// The same in doubles: a float's rounding shows as a sliver along an edge where the wall slants only little.
  PlaneT<double> almostExact() const { return {rounded.normal.cast<double>(), static_cast<double>(exact.offset)}; }
};

Wall wallThrough(const Vec3& point, const Vec3& normal) {
  const Vec3T<Exact> n = exactOf(normal), p = exactOf(point);
  const Exact offset = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
  return {{n, offset}, {normal, static_cast<float>(offset)}};
}
const PlaneT<Exact>& planeOf(const Wall& wall, Exact) {
  return wall.exact;
}
const Plane& planeOf(const Wall& wall, float) {
  return wall.rounded;
}

enum class Walls { AtRandom, ThroughOnePoint, ThroughCornersAndEdges, OnFaces };

/// Planes about as many cells can come of; offsets of the float planes are off by their rounding.
std::vector<Wall> drawWalls(Walls kind, int count, Random& random) {
  std::vector<Wall> walls;
  const Vec3 meeting = drawVector(random).cwiseProduct(kHalf) * 0.5f;
  while (static_cast<int>(walls.size()) < count) {
    const Vec3 normal = normalizedOr(drawVector(random), Vec3::UnitX());
    Vec3 point = drawVector(random).cwiseProduct(kHalf) * 0.6f;
    if (kind == Walls::ThroughOnePoint) point = meeting;
    if (kind == Walls::ThroughCornersAndEdges) {
      for (int i = 0; i < 3; ++i) point[i] = random.nextBelow(2) == 0 ? kHalf[i] : -kHalf[i];
      if (random.nextBelow(2) == 0) {  // through the whole edge along one axis
        const int axis = static_cast<int>(random.nextBelow(3));
        Vec3 across = normal;
        across[axis] = 0.0f;
        walls.push_back(wallThrough(point, normalizedOr(across, Vec3::Unit((axis + 1) % 3))));
        continue;
      }
    }
    walls.push_back(wallThrough(point, normal));
    if (kind == Walls::OnFaces && static_cast<int>(walls.size()) < count) {
      const Vec3 side = Vec3::Unit(static_cast<int>(random.nextBelow(3)));
      walls.push_back(random.nextBelow(2) == 0 ? walls.back() : wallThrough(kHalf, side));
    }
  }
  return walls;
}

/// A piece, and for each plane whether it lies above.
template <class S>
struct Cell {
  ConvexT<S> convex;
  std::uint32_t sides = 0;
};

template <class S>
bool liesAbove(const ConvexT<S>& convex, const PlaneT<S>& plane) {
  S highest = S(0), lowest = S(0);
  for (const VertexT<S>& vertex : convex.vertices) {
    const S distance = plane.distance(vertex.point);
    if (highest < distance) highest = distance;
    if (distance < lowest) lowest = distance;
  }
  return S(-lowest) < highest;
}

template <class S>
std::vector<Cell<S>> cutAll(const std::vector<Wall>& walls, const std::vector<std::size_t>& order) {
  std::vector<Cell<S>> cells(1), next;
  cells[0].convex = makeBox<S>(Vec3T<S>(S(kHalf.x()), S(kHalf.y()), S(kHalf.z())));
  SplitScratchT<S> scratch;
  Cell<S> above, below;
  for (const std::size_t index : order) {
    const PlaneT<S>& plane = planeOf(walls[index], S());
    next.clear();
    for (const Cell<S>& cell : cells) {
      above.sides = cell.sides | 1u << index;
      below.sides = cell.sides;
      if (split<S>(cell.convex.view(), plane, {}, scratch, above.convex, below.convex) == SplitOutcome::Split) {
        next.push_back(above);
        next.push_back(below);
      } else {
        next.push_back({cell.convex, liesAbove(cell.convex, plane) ? above.sides : below.sides});
      }
    }
    cells.swap(next);
  }
  return cells;
}

using Corner = std::array<Exact, 3>;
using CellSet = std::set<std::pair<std::uint32_t, std::set<Corner>>>;

/// Cells as sets of corners: the same bodies whatever their numbers and however often a corner is named.
CellSet asSet(const std::vector<Cell<Exact>>& cells) {
  CellSet result;
  for (const Cell<Exact>& cell : cells) {
    std::set<Corner> corners;
    for (const VertexT<Exact>& vertex : cell.convex.vertices)
      corners.insert({vertex.point[0], vertex.point[1], vertex.point[2]});
    result.emplace(cell.sides, corners);
  }
  return result;
}

template <class S>
std::map<std::uint32_t, double> volumesOf(const std::vector<Cell<S>>& cells) {
  std::map<std::uint32_t, double> volumes;
  for (const Cell<S>& cell : cells) volumes[cell.sides] += static_cast<double>(volumeOf<Exact>(cell.convex));
  return volumes;
}

void expectSameVolumes(std::map<std::uint32_t, double> found, const std::map<std::uint32_t, double>& expected) {
  for (const auto& [sides, volume] : expected) found[sides] -= volume;
  for (const auto& [sides, off] : found) {
    EXPECT_LE(std::abs(off), 1e-6) << "cell " << sides;
    hard::reportWorst("volume off by", std::abs(off), "m3");
  }
}

/// Every cell that is more than a speck, from its half-spaces alone.
void expectOtherCellsAgree(const std::vector<Wall>& walls, const std::vector<Cell<Exact>>& cells) {
  for (const Cell<Exact>& cell : cells) {
    const auto volume = static_cast<double>(volumeOf<Exact>(cell.convex));
    if (volume < 1e-5) continue;
    Vec3d inside = Vec3d::Zero();
    for (const VertexT<Exact>& vertex : cell.convex.vertices)
      for (int i = 0; i < 3; ++i) inside[i] += static_cast<double>(vertex.point[i]);
    inside /= static_cast<double>(cell.convex.vertices.size());
    std::vector<PlaneT<double>> planes;
    for (std::size_t i = 0; i < walls.size(); ++i)
      planes.push_back((cell.sides >> i & 1) != 0 ? walls[i].almostExact().flipped() : walls[i].almostExact());
    const OtherCell other = otherCell(kHalf.cast<double>(), inside, planes);
    EXPECT_NEAR(other.volume, volume, 1e-6);
    EXPECT_EQ(other.faces, facesOf(cell.convex));
    hard::reportSum("cells as Voro++ has them", 1);
  }
}

class B14 : public testing::TestWithParam<Walls> {};

TEST_P(B14, CellsAreTheSameInEveryOrder) {
  const int count = hard::counted(5, 6);
  for (int seed = 0; seed < hard::counted(1, 10); ++seed) {
    Random random(91, static_cast<std::uint64_t>(seed));
    const std::vector<Wall> walls = drawWalls(GetParam(), count, random);
    std::vector<std::size_t> order(walls.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::vector<Cell<Exact>> first = cutAll<Exact>(walls, order);
    const CellSet expected = asSet(first);
    const std::map<std::uint32_t, double> volumes = volumesOf(first);
    expectOtherCellsAgree(walls, first);
    do {
      ASSERT_EQ(asSet(cutAll<Exact>(walls, order)), expected);
      expectSameVolumes(volumesOf(cutAll<float>(walls, order)), volumes);
      hard::reportSum("orders", 1);
    } while (std::next_permutation(order.begin(), order.end()));
    hard::reportSum("cells", static_cast<double>(expected.size()));
  }
}

INSTANTIATE_TEST_SUITE_P(Walls, B14,
                         testing::Values(Walls::AtRandom, Walls::ThroughOnePoint, Walls::ThroughCornersAndEdges,
                                         Walls::OnFaces));

}  // namespace
}  // namespace brittle::geometry
