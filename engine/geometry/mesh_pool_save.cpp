// Saving and restoring the mesh pool.
#include "engine/geometry/mesh_pool.h"

namespace brittle::geometry {
namespace {

// Vertices, faces and edges are saved as their bytes: no padding may hide in them.
static_assert(sizeof(Vertex) == 24 && sizeof(Face) == 24 && sizeof(Edge) == 8);

template <class T>
void saveArray(ByteWriter& out, const std::vector<T>& values) {
  out.write(static_cast<std::uint32_t>(values.size()));
  out.writeBytes(values.data(), values.size() * sizeof(T));
}

template <class T>
bool restoreArray(ByteReader& in, std::vector<T>& values) {
  const std::size_t count = in.read<std::uint32_t>();
  if (count > in.remaining() / sizeof(T)) {
    in.fail();
    return false;
  }
  values.resize(count);
  in.readBytes(values.data(), count * sizeof(T));
  return in.ok();
}

bool isWithin(Range range, std::size_t size) {
  return range.first <= size && range.count <= size - range.first;
}

}  // namespace

void MeshPool::save(ByteWriter& out) const {
  out.write(static_cast<std::uint32_t>(meshes_.size()));
  for (const MeshInfo& mesh : meshes_) {
    for (const Range& range : {mesh.vertices, mesh.faces, mesh.edges}) {
      out.write(range.first);
      out.write(range.count);
    }
    out.write(mesh.bodySlot);
    out.write(mesh.material);
    out.write(mesh.flags);
    out.write(mesh.alive);
  }
  saveArray(out, freeSlots_);
  saveArray(out, vertices_);
  saveArray(out, faces_);
  saveArray(out, edges_);
  for (const FreeList* list : {&freeVertices_, &freeFaces_, &freeEdges_}) {
    out.write(static_cast<std::uint32_t>(list->byClass.size()));
    for (const std::vector<std::uint32_t>& blocks : list->byClass) saveArray(out, blocks);
  }
  out.write(aliveCount_);
}

bool MeshPool::restore(ByteReader& in) {
  MeshPool restored;
  const bool isGood = restored.read(in);
  if (!isGood) {
    in.fail();
    restored = MeshPool();
  }
  *this = std::move(restored);
  markAllDirty();
  return isGood;
}

bool MeshPool::read(ByteReader& in) {
  constexpr std::uint32_t kBytesPerMesh = 33;
  const auto meshCount = in.read<std::uint32_t>();
  if (meshCount > in.remaining() / kBytesPerMesh) return false;
  meshes_.resize(meshCount);
  for (MeshInfo& mesh : meshes_) {
    for (Range* range : {&mesh.vertices, &mesh.faces, &mesh.edges}) {
      range->first = in.read<std::uint32_t>();
      range->count = in.read<std::uint32_t>();
    }
    mesh.bodySlot = in.read<std::uint32_t>();
    mesh.material = in.read<std::uint16_t>();
    mesh.flags = in.read<std::uint16_t>();
    mesh.alive = in.read<bool>();
  }
  if (!restoreArray(in, freeSlots_) || !restoreArray(in, vertices_) || !restoreArray(in, faces_) ||
      !restoreArray(in, edges_)) {
    return false;
  }
  for (FreeList* list : {&freeVertices_, &freeFaces_, &freeEdges_}) {
    const auto classes = in.read<std::uint32_t>();
    if (classes > 32) return false;
    list->byClass.resize(classes);
    for (std::vector<std::uint32_t>& blocks : list->byClass) {
      if (!restoreArray(in, blocks)) return false;
    }
  }
  aliveCount_ = in.read<std::uint32_t>();
  return in.ok() && isConsistent();
}

/// What a damaged snapshot could break: every index stays within the arrays it points into. Meshes lie apart: half a
/// million that share the same edges would take hours to look at.
bool MeshPool::isConsistent() const {
  std::uint32_t alive = 0;
  std::size_t edges = 0;
  for (const MeshInfo& mesh : meshes_) edges += mesh.alive ? mesh.edges.count : 0;
  if (edges > edges_.size()) return false;
  for (const MeshInfo& mesh : meshes_) {
    if (!isWithin(mesh.vertices, vertices_.size()) || !isWithin(mesh.faces, faces_.size()) ||
        !isWithin(mesh.edges, edges_.size())) {
      return false;
    }
    if (mesh.alive && findTopologyError(view(static_cast<MeshSlot>(&mesh - meshes_.data()))) != nullptr) return false;
    alive += mesh.alive ? 1 : 0;
  }
  for (const MeshSlot slot : freeSlots_) {
    if (slot >= meshes_.size() || meshes_[slot].alive) return false;
  }
  const auto fits = [](const FreeList& list, std::size_t size) {
    for (std::uint32_t i = 0; i < list.byClass.size(); ++i) {
      for (const std::uint32_t first : list.byClass[i]) {
        if (!isWithin({first, classSize(i)}, size)) return false;
      }
    }
    return true;
  };
  return alive == aliveCount_ && fits(freeVertices_, vertices_.size()) && fits(freeFaces_, faces_.size()) &&
         fits(freeEdges_, edges_.size());
}

}  // namespace brittle::geometry
