// A box cut again and again by planes that go through what is there: vertices, edges, faces, and an ulp beside them.
// Every piece stays a valid polyhedron, and volumes add up.
#include "engine/geometry/split.h"

#include <cmath>
#include <vector>

#include "engine/core/assert.h"
#include "engine/geometry/make.h"
#include "engine/geometry/mass.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/target.h"

namespace {

using namespace brittle;
using namespace brittle::geometry;

Plane choosePlane(fuzz::Input& input, const Convex& piece, const Convex& other) {
  const std::uint32_t kind = input.nextBelow(4);
  const Plane& face = other.faces[input.nextBelow(static_cast<std::uint32_t>(other.faces.size()))].plane;
  if (kind == 0) return input.nextBelow(2) == 0 ? face : face.flipped();
  const ConvexView view = piece.view();
  const std::uint32_t edge =
      (input.nextByte() << 8 | input.nextByte()) % static_cast<std::uint32_t>(piece.edges.size());
  const Vec3 start = view.startOf(edge);
  Vec3 normal = input.nextDirection();
  if (kind == 1) normal = normalizedOr(Vec3((view.endOf(edge) - start).cross(normal)), normal);
  float offset = normal.dot(start);
  const std::uint32_t nudge = input.nextBelow(4);
  if (nudge == 1) offset = std::nextafter(offset, 1e9f);
  if (nudge == 2) offset = std::nextafter(offset, -1e9f);
  if (nudge == 3) offset += input.nextBits(1.0f);
  return {normal, offset};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input({data, size});
  const Vec3 half = input.nextVector(0.001f, 1.0f);
  std::vector<Convex> pieces{makeBox<float>(half, input.nextVector(-1.0f, 1.0f))};
  const double whole = massOf(pieces[0].view()).volume;
  SplitScratch scratch;
  Convex above, below;
  while (!input.isAtEnd() && pieces.size() < 64) {
    Convex& piece = pieces[input.nextBelow(static_cast<std::uint32_t>(pieces.size()))];
    const Convex& other = pieces[input.nextBelow(static_cast<std::uint32_t>(pieces.size()))];
    const Plane plane = choosePlane(input, piece, other);
    if (split<float>(piece.view(), plane, {}, scratch, above, below) != SplitOutcome::Split) continue;
    BR_ASSERT(findTopologyError(above.view()) == nullptr && findTopologyError(below.view()) == nullptr);
    piece.assign(above.view());
    pieces.push_back(below);
  }
  double sum = 0.0;
  for (const Convex& piece : pieces) sum += massOf(piece.view()).volume;
  // Caps are off their planes by up to a millionth of the frame's 1 m, which counts by the surface.
  const Vec3 turned(half.y(), half.z(), half.x());
  const double surface = 8.0 * static_cast<double>(half.dot(turned));
  BR_ASSERT(std::abs(sum - whole) <= 1e-4 * whole + 1e-6 * surface);
  return 0;
}
