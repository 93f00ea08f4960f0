#include "engine/render/mesh_store.h"

#include <cstring>

#include "engine/render/material.h"
#include "engine/render/shader.h"

namespace brittle::render {

namespace {

constexpr std::size_t kTexelsPerRow = 1024;
constexpr std::size_t kWordsPerRow = 4 * kTexelsPerRow;
// Two dirty ranges this close go up in one call: a call costs more than the bytes between them. Chosen by eye.
// [vertices]
constexpr std::uint32_t kMergeGap = 64;

static_assert(sizeof(geometry::Vertex) == 24, "the vertex layout below");

std::uint32_t wordOf(float value) {
  std::uint32_t word = 0;
  std::memcpy(&word, &value, sizeof(word));
  return word;
}

void setNearest(const Gl& gl) {
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

void TableTexture::grow(std::size_t rows) {
  // Storage is immutable, so a larger table is a new texture; doubling keeps that rare.
  std::size_t height = 1;
  while (height < rows) height *= 2;
  texture_ = GlTexture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_.name());
  gl_.TexStorage2D(GL_TEXTURE_2D, 1, kind_ == Kind::Float ? GL_RGBA32F : GL_RGBA32UI,
                   static_cast<GLsizei>(kTexelsPerRow), static_cast<GLsizei>(height));
  setNearest(gl_);
  uploaded_.clear();
  uploaded_.resize(height * kWordsPerRow, 0xffffffffu);  // differs from anything real, so all rows go up
}

std::uint32_t TableTexture::upload(std::vector<std::uint32_t>& words) {
  const std::size_t rows = maxOf<std::size_t>((words.size() + kWordsPerRow - 1) / kWordsPerRow, 1);
  words.resize(rows * kWordsPerRow, 0);
  if (uploaded_.size() < words.size()) grow(rows);
  gl_.BindTexture(GL_TEXTURE_2D, texture_.name());
  std::uint32_t count = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::uint32_t* from = &words[row * kWordsPerRow];
    if (std::memcmp(from, &uploaded_[row * kWordsPerRow], kWordsPerRow * 4) == 0) continue;
    std::memcpy(&uploaded_[row * kWordsPerRow], from, kWordsPerRow * 4);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), static_cast<GLsizei>(kTexelsPerRow), 1,
                      kind_ == Kind::Float ? GL_RGBA : GL_RGBA_INTEGER,
                      kind_ == Kind::Float ? GL_FLOAT : GL_UNSIGNED_INT, from);
    ++count;
  }
  return count;
}

void TableTexture::bind(GLint unit) const {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, texture_.name());
}

MeshStore::MeshStore(const Gl& gl)
    : gl_(gl),
      vertices_(gl),
      indices_(gl),
      array_(gl),
      bodies_(gl, TableTexture::Kind::Float),
      shapes_(gl, TableTexture::Kind::Whole) {
  using As = Attribute::As;
  const std::array<Attribute, 4> layout = {{{0, 3, GL_FLOAT, As::Float, 0},
                                            {1, 4, GL_BYTE, As::Normalized, 12},
                                            {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 16},
                                            {3, 1, GL_UNSIGNED_INT, As::Whole, 20}}};
  gl_.BindVertexArray(array_.name());
  attach(gl_, vertices_.name(), sizeof(geometry::Vertex), layout);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
}

void MeshStore::reallocate(const geometry::MeshPool& pool) {
  capacity_ = maxOf(pool.vertices().size() + pool.vertices().size() / 2, std::size_t{1024});
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_ * sizeof(geometry::Vertex)), nullptr,
                 GL_DYNAMIC_DRAW);
}

std::uint32_t MeshStore::syncVertices(geometry::MeshPool& pool) {
  const std::vector<geometry::Vertex>& source = pool.vertices();
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  std::uint32_t count = 0;
  const auto send = [&](geometry::Range range) {
    if (range.count == 0) return;
    gl_.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(range.first * sizeof(geometry::Vertex)),
                      static_cast<GLsizeiptr>(range.count * sizeof(geometry::Vertex)), &source[range.first]);
    count += range.count;
  };
  if (source.size() > capacity_) {
    reallocate(pool);
    send({0, static_cast<std::uint32_t>(source.size())});
  } else {
    geometry::Range open;
    for (const geometry::Range& range : pool.dirtyRanges()) {
      if (open.count != 0 && range.first <= open.first + open.count + kMergeGap) {
        open.count = range.first + range.count - open.first;
      } else {
        send(open);
        open = range;
      }
    }
    send(open);
  }
  pool.clearDirty();
  return count;
}

void MeshStore::syncTables(const MeshGroup& group) {
  bodyWords_.clear();
  for (const Transform& body : group.bodies) {
    const Quat& q = body.rotation;
    for (const float value :
         {body.position.x(), body.position.y(), body.position.z(), 0.0f, q.x(), q.y(), q.z(), q.w()}) {
      bodyWords_.push_back(wordOf(value));
    }
  }
  bodies_.upload(bodyWords_);

  for (const VisibleMesh& mesh : group.meshes) {
    const std::size_t at = 4u * mesh.slot;
    if (shapeWords_.size() < at + 4) shapeWords_.resize(at + 4, 0);
    shapeWords_[at] = mesh.body;
    shapeWords_[at + 1] = minOf<std::uint32_t>(mesh.material, kMaxMaterials - 1);
    shapeWords_[at + 2] = mesh.tint;
  }
  shapes_.upload(shapeWords_);
}

void MeshStore::bind() const {
  gl_.BindVertexArray(array_.name());
  bindTables();
}

void MeshStore::bindTables() const {
  bodies_.bind(kUnitBodies);
  shapes_.bind(kUnitShapes);
}

}  // namespace brittle::render
