#include "game/content/baked_mesh.h"

#include <cmath>
#include <optional>

#include "engine/core/byte_stream.h"
#include "game/content/asset_source.h"

namespace brittle::content {
namespace {

constexpr std::size_t kVertexBytes = 24, kTriangleBytes = 12;
const std::string kExpected = "a zlib archive of at most " + std::to_string(kLongestFile) + " bytes";
constexpr float kFarthest = 10'000.0f;  // of a position [m], as of a segment's elements; of u and v

/// A fault of the file, without its name.
using Fault = std::optional<Problem>;

Fault faultOf(std::string what, std::string value, std::string expected) {
  return Problem{{}, 0, "baked mesh: " + what, std::move(value), std::move(expected)};
}

bool isSane(float value) {
  return std::abs(value) <= kFarthest;  // false for NaN, too
}

Result<std::string> contentsOf(const std::string& bytes) {
  if (!isGzip(bytes)) return inflated(bytes);
  const Result<std::string> archive = inflated(bytes);
  return archive ? inflated(*archive) : archive;
}

BakedVertex readVertex(ByteReader& in) {
  BakedVertex vertex;
  for (int i = 0; i < 3; ++i) vertex.point[i] = in.read<float>();
  vertex.u = in.read<float>();
  vertex.v = in.read<float>();
  vertex.color = in.read<std::uint32_t>();
  return vertex;
}

Fault readVertices(ByteReader& in, std::vector<BakedVertex>& vertices) {
  if (in.remaining() < sizeof(std::uint32_t)) return faultOf("it is empty", {}, "a vertex count");
  const auto count = in.read<std::uint32_t>();
  const std::size_t held = in.remaining() / kVertexBytes;
  if (count > held)
    return faultOf("vertex count", std::to_string(count), "up to the " + std::to_string(held) + " it holds");
  vertices.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const BakedVertex vertex = readVertex(in);
    for (const float value : {vertex.point.x(), vertex.point.y(), vertex.point.z(), vertex.u, vertex.v})
      if (!isSane(value)) return faultOf("vertex " + std::to_string(i), std::to_string(value), "numbers up to 10000");
    vertices.push_back(vertex);
  }
  return std::nullopt;
}

Fault readIndices(ByteReader& in, std::size_t vertices, std::vector<std::uint32_t>& indices) {
  if (in.remaining() < sizeof(std::uint32_t)) return faultOf("it ends after its vertices", {}, "a count and indices");
  in.read<std::uint32_t>();  // how many triangles, and other things by other editors
  if (in.remaining() % kTriangleBytes != 0)
    return faultOf("bytes of indices", std::to_string(in.remaining()), "12 for each triangle");
  indices.resize(in.remaining() / sizeof(std::uint32_t));
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = in.read<std::uint32_t>();
    if (indices[i] >= vertices)
      return faultOf("index " + std::to_string(i), std::to_string(indices[i]),
                     "a vertex, of which there are " + std::to_string(vertices));
  }
  return std::nullopt;
}

Fault readInto(const std::string& bytes, BakedMesh& mesh) {
  const Result<std::string> contents = contentsOf(bytes);
  if (!contents) return faultOf(contents.error().message, {}, kExpected);
  ByteReader in({reinterpret_cast<const unsigned char*>(contents->data()), contents->size()});
  const Fault fault = readVertices(in, mesh.vertices);
  return fault ? fault : readIndices(in, mesh.vertices.size(), mesh.indices);
}

}  // namespace

BakedMesh readBakedMesh(const std::string& bytes, const std::string& file) {
  BakedMesh mesh;
  Fault fault = readInto(bytes, mesh);
  if (!fault) return mesh;
  fault->file = file;
  return {{}, {}, {*fault}};
}

}  // namespace brittle::content
