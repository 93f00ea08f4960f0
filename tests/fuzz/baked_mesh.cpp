// Any bytes as a baked mesh, as they are and as what its archive holds: what is read can be drawn, or one problem says
// why not.
#include <zlib.h>

#include <cmath>
#include <string>

#include "engine/core/assert.h"
#include "game/content/baked_mesh.h"
#include "tests/fuzz/target.h"

using namespace brittle;
using namespace brittle::content;

namespace {

void tryReading(const std::string& bytes) {
  const BakedMesh mesh = readBakedMesh(bytes, "a.mesh");
  BR_ASSERT(mesh.problems.size() <= 1 && mesh.indices.size() % 3 == 0);
  BR_ASSERT(mesh.problems.empty() || (mesh.vertices.empty() && mesh.indices.empty() && !mesh.problems[0].what.empty()));
  for (const BakedVertex& vertex : mesh.vertices)
    BR_ASSERT(isFinite(vertex.point) && std::isfinite(vertex.u) && std::isfinite(vertex.v));
  for (const std::uint32_t index : mesh.indices) BR_ASSERT(index < mesh.vertices.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tryReading(std::string(reinterpret_cast<const char*>(data), size));
  std::string archive(compressBound(static_cast<uLong>(size)), '\0');
  auto length = static_cast<uLongf>(archive.size());
  const int status = compress2(reinterpret_cast<Bytef*>(archive.data()), &length, data, static_cast<uLong>(size), 0);
  BR_ASSERT(status == Z_OK);
  archive.resize(length);
  tryReading(archive);
  return 0;
}
