// A compound of a few boxes, broken again and again by anything: whatever the impact, no volume is lost, every piece is
// a valid polyhedron in one group, and nothing is not finite.
#include <cmath>
#include <vector>

#include "engine/core/assert.h"
#include "engine/fracture/fracture.h"
#include "engine/geometry/make.h"
#include "engine/geometry/mass.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/target.h"

namespace {

using namespace brittle;
using namespace brittle::fracture;

FractureMaterial chooseMaterial(fuzz::Input& input) {
  FractureMaterial material;
  material.pattern = static_cast<Pattern>(input.nextBelow(4));
  material.carveRadius = input.nextFloat(0.01f, 1.0f);
  material.density = input.nextFloat(0.1f, 3.0f);
  material.dieSize = input.nextFloat(0.05f, 0.5f);
  material.minVolume = input.nextFloat(0.0f, 1e-4f);
  return material;
}

Impact chooseImpact(fuzz::Input& input) {
  Impact impact;
  impact.point = input.nextVector(-1.5f, 1.5f);
  impact.direction = input.nextDirection();
  impact.speed = input.nextFloat(0.0f, 300.0f);
  impact.strikerRadius = input.nextFloat(0.0f, 0.5f);
  impact.toCenter = input.nextVector(-1.0f, 1.0f);
  return impact;
}

double volumeOf(const std::vector<Part>& parts) {
  double sum = 0.0;
  for (const Part& part : parts) sum += geometry::massOf(part.convex).volume;
  return sum;
}

void expectSound(const std::vector<Part>& parts, const Fracture& made) {
  double sum = 0.0;
  for (const Piece& piece : made.pieces) {
    BR_ASSERT(piece.group < made.groups.size() && piece.source < parts.size());
    BR_ASSERT(piece.mass.volume > 0.0f && isFinite(piece.mass.center));
    if (!piece.isWhole) BR_ASSERT(geometry::findTopologyError(made.convexes[piece.convex].view()) == nullptr);
    sum += piece.mass.volume;
  }
  for (const Crumb& crumb : made.crumbs) {
    BR_ASSERT(crumb.volume >= 0.0f && isFinite(crumb.center));
    sum += crumb.volume;
  }
  BR_ASSERT(std::abs(sum - volumeOf(parts)) <= 1e-5 * volumeOf(parts));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input({data, size});
  std::vector<geometry::Convex> convexes;
  for (std::uint32_t i = 1 + input.nextBelow(4); i > 0; --i) {
    const Vec3 half = input.nextVector(0.005f, 0.6f);
    convexes.push_back(geometry::makeBox<float>(half, input.nextVector(-0.8f, 0.8f)));
  }
  const FractureMaterial material = chooseMaterial(input);
  Fracturer fracturer;
  for (int round = 0; round < 3; ++round) {
    std::vector<Part> parts;
    for (const geometry::Convex& convex : convexes)
      parts.push_back({convex.view(), input.nextBelow(3) == 0, static_cast<std::uint32_t>(parts.size()), {}});
    std::vector<Impact> impacts;
    for (std::uint32_t i = 1 + input.nextBelow(2); i > 0; --i) impacts.push_back(chooseImpact(input));
    const Fracture& made = fracturer.fracture(parts, impacts, material, 1e-4f, input.nextByte());
    expectSound(parts, made);
    std::vector<geometry::Convex> next;  // the next round breaks what this one made
    for (const Piece& piece : made.pieces) {
      if (next.size() == 40) break;
      next.emplace_back();
      next.back().assign(piece.isWhole ? parts[piece.source].convex : made.convexes[piece.convex].view());
    }
    if (next.empty() || input.isAtEnd()) break;
    convexes = std::move(next);
  }
  return 0;
}
