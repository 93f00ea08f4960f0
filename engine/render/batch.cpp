#include "engine/render/batch.h"

#include <array>

#include "engine/core/assert.h"
#include "engine/math/trig.h"
#include "engine/render/shader.h"

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

void clip(const Gl& gl, const OverlayPart& part, int width, int height) {
  const int left = clampTo(part.left, 0, width), right = clampTo(part.right, left, width);
  const int top = clampTo(part.top, 0, height), bottom = clampTo(part.bottom, top, height);
  gl.Scissor(left, height - bottom, right - left, bottom - top);
}

}  // namespace

StaticMesh::StaticMesh(const Gl& gl, std::span<const StaticVertex> vertices, std::span<const std::uint32_t> indices,
                       std::uint32_t polished)
    : vertices_(gl),
      indices_(gl),
      array_(gl),
      dull_(static_cast<std::uint32_t>(indices.size()) - polished),
      polished_(polished) {
  static_assert(sizeof(StaticVertex) == 24, "the layout below");
  for (const std::uint32_t index : indices) BR_ASSERT(index < vertices.size());
  using As = Attribute::As;
  const std::array<Attribute, 3> layout = {
      {{0, 3, GL_FLOAT, As::Float, 0}, {1, 2, GL_FLOAT, As::Float, 12}, {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 20}}};
  gl.BindVertexArray(array_.name());
  upload(gl, GL_ARRAY_BUFFER, vertices_.name(), vertices);
  attach(gl, vertices_.name(), sizeof(StaticVertex), layout);
  upload(gl, GL_ELEMENT_ARRAY_BUFFER, indices_.name(), indices);
}

void StaticMesh::draw(const Gl& gl, bool polished) const {
  gl.BindVertexArray(array_.name());
  const void* first = reinterpret_cast<const void*>(polished ? sizeof(std::uint32_t) * dull_ : 0);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(polished ? polished_ : dull_), GL_UNSIGNED_INT, first);
}

void InstanceBatch::make(const Gl& gl) {
  buffer_ = GlBuffer(gl);
  array_ = GlVertexArray(gl);
  gl.BindVertexArray(array_.name());
  attach(gl, buffer_.name(), stride_, layout_, 1);
}

void StreamBatch::make(const Gl& gl) {
  vertices_ = GlBuffer(gl);
  indices_ = GlBuffer(gl);
  array_ = GlVertexArray(gl);
  gl.BindVertexArray(array_.name());
  attach(gl, vertices_.name(), stride_, layout_);
}

void SphereBatch::make(const Gl& gl) {
  const std::array<Attribute, 1> pointLayout = {{{0, 3, GL_FLOAT, Attribute::As::Float, 0}}};
  const std::vector<std::uint16_t> indices = sphereIndices();
  indexCount_ = static_cast<std::uint32_t>(indices.size());
  vertices_ = GlBuffer(gl);
  indices_ = GlBuffer(gl);
  instances_ = GlBuffer(gl);
  array_ = GlVertexArray(gl);
  gl.BindVertexArray(array_.name());
  upload(gl, GL_ARRAY_BUFFER, vertices_.name(), spherePoints());
  attach(gl, vertices_.name(), sizeof(Vec3), pointLayout);
  upload(gl, GL_ELEMENT_ARRAY_BUFFER, indices_.name(), indices);
  attach(gl, instances_.name(), stride_, layout_, 1);
}

void OverlayBatch::make(const Gl& gl) {
  using As = Attribute::As;
  constexpr std::array<Attribute, 3> kLayout = {
      {{0, 2, GL_FLOAT, As::Float, 0}, {1, 2, GL_FLOAT, As::Float, 8}, {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 16}}};
  static_assert(sizeof(OverlayPoint) == 20, "the layout above");
  points_ = GlBuffer(gl);
  indices_ = GlBuffer(gl);
  array_ = GlVertexArray(gl);
  gl.BindVertexArray(array_.name());
  attach(gl, points_.name(), sizeof(OverlayPoint), kLayout);
}

void OverlayBatch::upload(const Gl& gl, const std::shared_ptr<const OverlayTexture>& texture) {
  BR_ASSERT(texture->width > 0 && texture->height > 0);
  BR_ASSERT(texture->coverage.size() == static_cast<std::size_t>(texture->width) * texture->height);
  uploaded_ = texture;
  texture_ = makeByteTexture(gl, texture->width, texture->height, 1, texture->coverage);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

std::uint32_t OverlayBatch::draw(const Gl& gl, const Overlay& overlay, int width, int height) {
  BR_ASSERT(overlay.texture != nullptr);
  if (!array_) make(gl);
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(kUnitOverlay));
  if (uploaded_ != overlay.texture) upload(gl, overlay.texture);
  gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  gl.BindVertexArray(array_.name());
  stream(gl, GL_ARRAY_BUFFER, points_.name(), overlay.points);
  stream(gl, GL_ELEMENT_ARRAY_BUFFER, indices_.name(), overlay.indices);
  gl.Enable(GL_SCISSOR_TEST);
  std::uint32_t triangles = 0;
  for (const OverlayPart& part : overlay.parts) {
    clip(gl, part, width, height);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                    reinterpret_cast<const void*>(sizeof(std::uint32_t) * part.first));
    triangles += part.count / 3;
  }
  gl.Disable(GL_SCISSOR_TEST);
  return triangles;
}

}  // namespace brittle::render
