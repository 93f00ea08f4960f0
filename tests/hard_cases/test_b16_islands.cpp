// B16: an arch, a ring, a comb and a chain of 100 convexes. Whichever one is taken away, the islands are those that a
// union-find of its own counts from how the thing was built. Then each one is struck where it stands: every convex of
// what remains is in exactly one body, and the groups that the breaking found from its cuts are those found when all
// pieces are tested against each other anew.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "engine/fracture/connect.h"
#include "engine/geometry/make.h"
#include "engine/math/transform.h"
#include "tests/engine/fracture/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::fracture {
namespace {

constexpr int kParts = 100;

/// Sets by links to any other member, without ranks or short cuts: slow, and unlike the engine's.
class Islands {
 public:
  explicit Islands(std::size_t count) : link_(count) {
    for (std::size_t i = 0; i < count; ++i) link_[i] = i;
  }
  void join(std::size_t a, std::size_t b) { link_[last(a)] = last(b); }
  /// Islands numbered by their first member.
  std::vector<std::uint32_t> numbers() const {
    std::vector<std::uint32_t> result;
    std::map<std::size_t, std::uint32_t> known;
    for (std::size_t i = 0; i < link_.size(); ++i)
      result.push_back(known.emplace(last(i), static_cast<std::uint32_t>(known.size())).first->second);
    return result;
  }

 private:
  std::size_t last(std::size_t i) const {
    while (link_[i] != i) i = link_[i];
    return i;
  }
  std::vector<std::size_t> link_;
};

struct Structure {
  const char* name;
  std::function<geometry::Convex(int)> part;
  std::function<bool(std::size_t, std::size_t)> touch;  // by construction, for a < b
};
void PrintTo(const Structure& structure, std::ostream* out) {
  *out << structure.name;
}

/// A stone of a ring in the XY plane, from angle to angle [rad].
geometry::Convex stone(float from, float to) {
  std::vector<Vec3> points;
  for (const float z : {-0.2f, 0.2f})
    for (const float angle : {from, to})
      for (const float radius : {3.0f, 3.5f}) points.push_back({radius * cosine(angle), radius * sine(angle), z});
  return geometry::makeHull(points).value();
}

geometry::Convex stoneOf(float whole, int i) {
  const float step = whole / static_cast<float>(kParts);
  return stone(step * static_cast<float>(i), step * static_cast<float>(i + 1));
}

bool isNext(std::size_t a, std::size_t b) {
  return a + 1 == b;
}

/// A spine of 50 blocks, each with a tooth.
geometry::Convex tineOf(int i) {
  const float x = 0.2f * static_cast<float>(i / 2);
  return i % 2 == 0 ? geometry::makeBox<float>({0.1f, 0.1f, 0.1f}, {x, 0.0f, 0.0f})
                    : geometry::makeBox<float>({0.05f, 0.2f, 0.1f}, {x, -0.3f, 0.0f});
}

class B16 : public testing::TestWithParam<Structure> {
 protected:
  Scene scene;
  void SetUp() override {
    for (int i = 0; i < kParts; ++i) scene.add(GetParam().part(i));
  }
};

TEST_P(B16, AnyOneTakenAway) {
  for (std::size_t removed = 0; removed < kParts; ++removed) {
    std::vector<Part> parts;
    std::vector<std::size_t> names;
    for (std::size_t i = 0; i < kParts; ++i) {
      if (i == removed) continue;
      parts.push_back(scene.parts[i]);
      names.push_back(i);
    }
    Islands islands(names.size());
    for (std::size_t a = 0; a < names.size(); ++a)
      for (std::size_t b = a + 1; b < names.size(); ++b)
        if (GetParam().touch(names[a], names[b])) islands.join(a, b);
    std::vector<std::uint32_t> groups;
    connectParts(parts, kSlop, groups);
    ASSERT_EQ(groups, islands.numbers()) << "without part " << removed;
    hard::reportSum("parts taken away", 1);
  }
}

/// The groups of what was not broken out, as numbers by first member, and the pieces themselves as parts.
struct Remains {
  Scene pieces;
  std::vector<std::uint32_t> groups;

  Remains(const Scene& scene, const Fracture& made) {
    std::map<std::uint32_t, std::uint32_t> known;
    for (const Piece& piece : made.pieces) {
      if (piece.isFragment) continue;
      geometry::Convex copy;
      copy.assign(viewOf(scene, made, piece));
      pieces.add(std::move(copy));
      groups.push_back(known.emplace(piece.group, static_cast<std::uint32_t>(known.size())).first->second);
    }
  }
};

TEST_P(B16, AnyOneStruck) {
  Fracturer fracturer;
  FractureMaterial material;
  material.pattern = Pattern::Block;
  material.carveRadius = 0.08f;
  material.minVolume = 0.0f;
  for (std::size_t struck = 0; struck < kParts; ++struck) {
    const Vec3 at = boxOf(scene.parts[struck].convex).center();
    for (int seed = 0; seed < hard::counted(1, 100); ++seed) {
      const Impact impact = straightAt(at, 10.0f, 0.02f);
      const Fracture& made =
          fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, static_cast<std::uint64_t>(seed));
      expectSound(scene, made);
      const Remains remains(scene, made);
      std::vector<std::uint32_t> anew;
      connectParts(remains.pieces.parts, kSlop, anew);
      ASSERT_EQ(remains.groups, anew) << "part " << struck << ", seed " << seed;
      hard::reportSum("parts struck", 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Structures, B16,
    testing::Values(
        Structure{"chain",
                  [](int i) {
                    return geometry::makeBox<float>(Vec3::Constant(0.05f), {0.1f * static_cast<float>(i), 0.0f, 0.0f});
                  },
                  isNext},
        Structure{"arch", [](int i) { return stoneOf(kPi, i); }, isNext},
        Structure{"ring", [](int i) { return stoneOf(2.0f * kPi, i); },
                  [](std::size_t a, std::size_t b) { return a + 1 == b || (a == 0 && b == kParts - 1); }},
        Structure{"comb", tineOf,
                  [](std::size_t a, std::size_t b) { return a % 2 == 0 && (a + 1 == b || a + 2 == b); }}));

}  // namespace
}  // namespace brittle::fracture
