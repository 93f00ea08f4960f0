#include "engine/render/batch.h"

#include <array>

#include "engine/core/assert.h"
#include "engine/math/trig.h"

namespace brittle::render {

namespace {

constexpr int kRings = 16, kSectors = 28;  // its silhouette stays within 0.7 % of the radius

template <class T>
void upload(const Gl& gl, GLenum target, GLuint buffer, const T& data) {
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(data[0])), data.data(), GL_STATIC_DRAW);
}

std::vector<Vec3> spherePoints() {
  std::vector<Vec3> points;
  for (int ring = 0; ring <= kRings; ++ring) {
    const float polar = kPi * static_cast<float>(ring) / kRings;
    for (int sector = 0; sector <= kSectors; ++sector) {
      const float turn = 2.0f * kPi * static_cast<float>(sector) / kSectors;
      points.emplace_back(sine(polar) * cosine(turn), cosine(polar), -sine(polar) * sine(turn));
    }
  }
  return points;
}

std::vector<std::uint16_t> sphereIndices() {
  std::vector<std::uint16_t> indices;
  for (int ring = 0; ring < kRings; ++ring) {
    for (int sector = 0; sector < kSectors; ++sector) {
      const auto a = static_cast<std::uint16_t>(ring * (kSectors + 1) + sector);
      const auto b = static_cast<std::uint16_t>(a + kSectors + 1);
      const auto next = [](std::uint16_t i) { return static_cast<std::uint16_t>(i + 1); };
      if (ring > 0) indices.insert(indices.end(), {a, b, next(a)});
      if (ring < kRings - 1) indices.insert(indices.end(), {next(a), b, next(b)});
    }
  }
  return indices;
}

}  // namespace

StaticMesh::StaticMesh(const Gl& gl, std::span<const StaticVertex> vertices, std::span<const std::uint32_t> indices)
    : vertices_(gl), indices_(gl), array_(gl), indexCount_(static_cast<std::uint32_t>(indices.size())) {
  static_assert(sizeof(StaticVertex) == 24, "the layout below");
  for (const std::uint32_t index : indices) BR_ASSERT(index < vertices.size());
  using As = Attribute::As;
  const std::array<Attribute, 3> layout = {{{0, 3, GL_FLOAT, As::Float, 0},
                                            {1, 2, GL_FLOAT, As::Float, 12},
                                            {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 20}}};
  gl.BindVertexArray(array_.name());
  upload(gl, GL_ARRAY_BUFFER, vertices_.name(), vertices);
  attach(gl, vertices_.name(), sizeof(StaticVertex), layout);
  upload(gl, GL_ELEMENT_ARRAY_BUFFER, indices_.name(), indices);
}

void StaticMesh::draw(const Gl& gl) const {
  gl.BindVertexArray(array_.name());
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indexCount_), GL_UNSIGNED_INT, nullptr);
}

InstanceBatch::InstanceBatch(const Gl& gl, GLsizei stride, std::span<const Attribute> layout) : buffer_(gl), array_(gl) {
  gl.BindVertexArray(array_.name());
  attach(gl, buffer_.name(), stride, layout, 1);
}

SphereBatch::SphereBatch(const Gl& gl, GLsizei stride, std::span<const Attribute> layout)
    : vertices_(gl), indices_(gl), instances_(gl), array_(gl) {
  const std::array<Attribute, 1> pointLayout = {{{0, 3, GL_FLOAT, Attribute::As::Float, 0}}};
  const std::vector<std::uint16_t> indices = sphereIndices();
  indexCount_ = static_cast<std::uint32_t>(indices.size());
  gl.BindVertexArray(array_.name());
  upload(gl, GL_ARRAY_BUFFER, vertices_.name(), spherePoints());
  attach(gl, vertices_.name(), sizeof(Vec3), pointLayout);
  upload(gl, GL_ELEMENT_ARRAY_BUFFER, indices_.name(), indices);
  attach(gl, instances_.name(), stride, layout, 1);
}

}  // namespace brittle::render
