// Any bytes as a segment, under any bytes as templates (split at the first NUL): what is read is in range, and every
// problem says what is wrong, of names that nobody knows as well.
#include <cmath>
#include <string>

#include "engine/core/assert.h"
#include "game/content/level_names.h"
#include "game/content/segment.h"
#include "tests/fuzz/target.h"

using namespace brittle;
using namespace brittle::content;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t end = text.find('\0');
  const TemplateSet templates =
      readTemplates(end == std::string::npos ? "<templates/>" : text.substr(end + 1), "t.xml");
  const Segment segment = readSegment(text.substr(0, end), "s.xml", templates);
  BR_ASSERT(isFinite(segment.size) && segment.size.minCoeff() > 0.0f);
  for (const Box& box : segment.boxes) {
    BR_ASSERT(isFinite(box.position) && isFinite(box.halfExtents) && box.halfExtents.minCoeff() > 0.0f);
    BR_ASSERT(box.line >= 1);
  }
  for (const Obstacle& obstacle : segment.obstacles)
    BR_ASSERT(isFinite(obstacle.position) && isFinite(obstacle.rotation) && !obstacle.type.empty());
  for (const Decal& decal : segment.decals)
    BR_ASSERT(decal.tile >= -4 && decal.tile <= 63 && std::isfinite(decal.blend));
  for (const Problem& problem : segment.problems) BR_ASSERT(!problem.what.empty());
  const Problems unknown = unknownNames(text.substr(0, end), "s.xml", "segment");
  for (const Problem& problem : unknown) BR_ASSERT(problem.line >= 1 && !problem.expected.empty());
  BR_ASSERT(unknown.size() <= 1001);
  return 0;
}
