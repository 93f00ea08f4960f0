// geometry/mesh_pool.h - the shared convex mesh buffer. Physics allocates and splits in it; the renderer mirrors its
// dirty vertex ranges and draws them, and needs to know nothing else. One slot per shape: vertices carry the slot,
// slots carry the body.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/byte_stream.h"
#include "engine/geometry/convex.h"

namespace brittle::geometry {

using MeshSlot = std::uint32_t;
inline constexpr MeshSlot kNoMesh = 0xffffffff;

/// A range of elements [first, first + count).
struct Range {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// What the renderer needs to know of a slot beside its vertices.
struct MeshInfo {
  Range vertices, faces, edges;  // in the pool's arrays; edge and face indices inside are local to the convex
  std::uint32_t bodySlot = 0;    // which transform moves it
  std::uint16_t material = 0;    // game-defined draw material
  std::uint16_t flags = 0;       // game-defined
  bool alive = false;
};

class MeshPool {
 public:
  /// Reserves room so that warm use allocates nothing; the pool still grows beyond it.
  void reserve(std::uint32_t meshes, std::uint32_t vertices, std::uint32_t faces, std::uint32_t edges);

  /// Copies a convex in. Slots, and the place in the buffers, depend only on the calls made so far.
  MeshSlot add(const ConvexView& convex, std::uint32_t bodySlot, std::uint16_t material, std::uint16_t flags = 0);
  void remove(MeshSlot slot);
  /// Replaces the mesh of a slot, keeping slot, body and material.
  void replace(MeshSlot slot, const ConvexView& convex);
  void setBody(MeshSlot slot, std::uint32_t bodySlot) { meshes_[slot].bodySlot = bodySlot; }
  void setMaterial(MeshSlot slot, std::uint16_t material) { meshes_[slot].material = material; }
  void setColor(MeshSlot slot, std::uint32_t rgba);

  /// Valid until the next add, remove or replace.
  ConvexView view(MeshSlot slot) const;
  const MeshInfo& info(MeshSlot slot) const { return meshes_[slot]; }
  bool isAlive(MeshSlot slot) const { return slot < meshes_.size() && meshes_[slot].alive; }
  std::uint32_t slotCount() const { return static_cast<std::uint32_t>(meshes_.size()); }
  std::uint32_t aliveCount() const { return aliveCount_; }

  const std::vector<Vertex>& vertices() const { return vertices_; }
  /// Vertex ranges written since the last clearDirty, merged and in ascending order.
  const std::vector<Range>& dirtyRanges() const;
  void clearDirty() { dirty_.clear(); }
  void markAllDirty();

  /// Everything, free lists included: restored, the pool behaves bit for bit as the saved one.
  void save(ByteWriter& out) const;
  /// False, the reader bad and the pool empty, if the bytes are not a pool's. All vertices are dirty afterwards.
  bool restore(ByteReader& in);

 private:
  /// First-fit blocks by size class, so that freed blocks are reused without fragmenting the buffers.
  struct FreeList {
    std::vector<std::vector<std::uint32_t>> byClass;
  };
  static std::uint32_t sizeClass(std::uint32_t count);
  static std::uint32_t classSize(std::uint32_t sizeClass);
  template <class T>
  Range allocate(FreeList& list, std::vector<T>& storage, std::uint32_t count);
  static void release(FreeList& list, Range range);
  void write(MeshSlot slot, const ConvexView& convex);
  bool read(ByteReader& in);
  bool isConsistent() const;

  std::vector<MeshInfo> meshes_;
  std::vector<MeshSlot> freeSlots_;
  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  FreeList freeVertices_, freeFaces_, freeEdges_;
  mutable std::vector<Range> dirty_;
  std::uint32_t aliveCount_ = 0;
};

}  // namespace brittle::geometry
