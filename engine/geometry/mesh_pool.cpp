#include "engine/geometry/mesh_pool.h"

#include <algorithm>
#include <type_traits>

#include "engine/core/assert.h"

namespace brittle::geometry {
// Sizes 8, 12, 16, 24, 32, 48, ...: at most a third of a block is unused.
std::uint32_t MeshPool::classSize(std::uint32_t sizeClass) {
  return (sizeClass % 2 == 0 ? 8u : 12u) << (sizeClass / 2);
}

std::uint32_t MeshPool::sizeClass(std::uint32_t count) {
  std::uint32_t result = 0;
  while (classSize(result) < count) ++result;
  return result;
}

template <class T>
Range MeshPool::allocate(FreeList& list, std::vector<T>& storage, std::uint32_t count) {
  const std::uint32_t index = sizeClass(count);
  if (index < list.byClass.size() && !list.byClass[index].empty()) {
    const std::uint32_t first = list.byClass[index].back();
    list.byClass[index].pop_back();
    return {first, count};
  }
  const auto first = static_cast<std::uint32_t>(storage.size());
  T blank{};
  if constexpr (std::is_same_v<T, Vertex>)
    blank.point = Vec3::Zero();  // unused ones are saved too: the same bits every time
  storage.resize(storage.size() + classSize(index), blank);
  return {first, count};
}

void MeshPool::release(FreeList& list, Range range) {
  const std::uint32_t index = sizeClass(range.count);
  if (list.byClass.size() <= index) list.byClass.resize(index + 1);
  list.byClass[index].push_back(range.first);
}

void MeshPool::reserve(std::uint32_t meshes, std::uint32_t vertices, std::uint32_t faces, std::uint32_t edges) {
  constexpr std::uint32_t kClasses = 28;  // up to 2^16 elements
  meshes_.reserve(meshes);
  freeSlots_.reserve(meshes);
  vertices_.reserve(vertices);
  faces_.reserve(faces);
  edges_.reserve(edges);
  dirty_.reserve(2 * meshes);
  for (FreeList* list : {&freeVertices_, &freeFaces_, &freeEdges_}) {
    if (list->byClass.size() < kClasses) list->byClass.resize(kClasses);
    for (std::uint32_t i = 0; i < kClasses; ++i)
      list->byClass[i].reserve(std::min(meshes, vertices / classSize(i) + 1));
  }
}

MeshSlot MeshPool::add(const ConvexView& convex, std::uint32_t bodySlot, std::uint16_t material, std::uint16_t flags) {
  MeshSlot slot = static_cast<MeshSlot>(meshes_.size());
  if (freeSlots_.empty()) {
    meshes_.emplace_back();
  } else {
    slot = freeSlots_.back();
    freeSlots_.pop_back();
  }
  MeshInfo& mesh = meshes_[slot];
  mesh.bodySlot = bodySlot;
  mesh.material = material;
  mesh.flags = flags;
  mesh.alive = true;
  ++aliveCount_;
  write(slot, convex);
  return slot;
}

void MeshPool::remove(MeshSlot slot) {
  BR_ASSERT(isAlive(slot));
  MeshInfo& mesh = meshes_[slot];
  release(freeVertices_, mesh.vertices);
  release(freeFaces_, mesh.faces);
  release(freeEdges_, mesh.edges);
  mesh = MeshInfo{};
  freeSlots_.push_back(slot);
  --aliveCount_;
}

void MeshPool::replace(MeshSlot slot, const ConvexView& convex) {
  BR_ASSERT(isAlive(slot));
  const MeshInfo& mesh = meshes_[slot];
  release(freeVertices_, mesh.vertices);
  release(freeFaces_, mesh.faces);
  release(freeEdges_, mesh.edges);
  write(slot, convex);
}

void MeshPool::write(MeshSlot slot, const ConvexView& convex) {
  MeshInfo& mesh = meshes_[slot];
  mesh.vertices = allocate(freeVertices_, vertices_, static_cast<std::uint32_t>(convex.vertices.size()));
  mesh.faces = allocate(freeFaces_, faces_, static_cast<std::uint32_t>(convex.faces.size()));
  mesh.edges = allocate(freeEdges_, edges_, static_cast<std::uint32_t>(convex.edges.size()));
  Vertex* to = vertices_.data() + mesh.vertices.first;
  for (const Vertex& vertex : convex.vertices) {
    *to = vertex;
    to->slot = slot;
    ++to;
  }
  std::copy(convex.faces.begin(), convex.faces.end(), faces_.begin() + mesh.faces.first);
  std::copy(convex.edges.begin(), convex.edges.end(), edges_.begin() + mesh.edges.first);
  dirty_.push_back(mesh.vertices);
}

void MeshPool::setColor(MeshSlot slot, std::uint32_t rgba) {
  const Range range = meshes_[slot].vertices;
  for (std::uint32_t i = 0; i < range.count; ++i) vertices_[range.first + i].color = rgba;
  dirty_.push_back(range);
}

ConvexView MeshPool::view(MeshSlot slot) const {
  BR_ASSERT(isAlive(slot));
  const MeshInfo& mesh = meshes_[slot];
  return {{vertices_.data() + mesh.vertices.first, mesh.vertices.count},
          {faces_.data() + mesh.faces.first, mesh.faces.count},
          {edges_.data() + mesh.edges.first, mesh.edges.count}};
}

const std::vector<Range>& MeshPool::dirtyRanges() const {
  const auto isBefore = [](const Range& a, const Range& b) {
    return a.first != b.first ? a.first < b.first : a.count < b.count;
  };
  std::sort(dirty_.begin(), dirty_.end(), isBefore);
  std::size_t kept = 0;
  for (const Range& range : dirty_) {
    if (kept > 0 && range.first <= dirty_[kept - 1].first + dirty_[kept - 1].count) {
      Range& last = dirty_[kept - 1];
      last.count = std::max(last.count, range.first + range.count - last.first);
    } else {
      dirty_[kept++] = range;
    }
  }
  dirty_.resize(kept);
  return dirty_;
}

void MeshPool::markAllDirty() {
  dirty_.clear();
  if (!vertices_.empty()) dirty_.push_back({0, static_cast<std::uint32_t>(vertices_.size())});
}

}  // namespace brittle::geometry
