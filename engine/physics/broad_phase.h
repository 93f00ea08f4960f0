// physics/broad_phase.h - a dynamic tree of fat bounding boxes. Who overlaps whom, and what a box or a ray may touch.
// The tree's shape depends only on the calls made, so every query visits in the same order on every machine.
// Source: Catto, Dynamic Bounding Volume Hierarchies (GDC), 2019; balance by rotations and surface-area heuristic.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/archive.h"
#include "engine/math/aabb.h"

namespace brittle::physics {

class DynamicTree {
 public:
  /// Inserts a leaf with the box as it is (the caller fattens). Returns its proxy number. Amortised O(log n).
  std::uint32_t insert(const Aabb& box, std::uint32_t userData);
  void remove(std::uint32_t proxy);
  /// Replaces the leaf's box, re-inserting it.
  void move(std::uint32_t proxy, const Aabb& box);

  const Aabb& box(std::uint32_t proxy) const { return nodes_[proxy].box; }
  std::uint32_t userData(std::uint32_t proxy) const { return nodes_[proxy].userData; }

  /// Calls visit(userData) for every leaf whose box overlaps; stops when it answers false.
  template <class Visit>
  void query(const Aabb& box, Visit&& visit) const;
  /// Calls visit(userData) for every leaf whose box the segment may touch; the answer is the fraction to shorten the segment to
  /// (1: go on as before, 0: stop).
  template <class Visit>
  void castRay(const Vec3& from, const Vec3& to, Visit&& visit) const;

  /// Moves every box by the same offset [m].
  void shift(const Vec3& offset);
  std::uint32_t leafCount() const { return leafCount_; }
  int height() const;
  /// The first broken invariant as a sentence, or null.
  const char* findError() const;
  void reserve(std::uint32_t leaves) { nodes_.reserve(2 * leaves); }

  template <class Archive>
  void serialize(Archive& a) {
    a.vector(nodes_);
    a(root_);
    a(free_);
    a(leafCount_);
  }

 private:
  static constexpr std::uint32_t kNull = 0xffffffff;
  struct Node {
    Aabb box;
    std::uint32_t parent = kNull;  // free nodes: the next free one
    std::uint32_t child[2] = {kNull, kNull};
    std::int32_t height = 0;       // leaves 0, free nodes -1
    std::uint32_t userData = 0;
    bool isLeaf() const { return child[0] == kNull; }
    template <class Archive>
    void serialize(Archive& a) {
      a(box.low);
      a(box.high);
      a(parent);
      a(child);
      a(height);
      a(userData);
    }
  };
  std::vector<Node> nodes_;
  std::uint32_t root_ = kNull;
  std::uint32_t free_ = kNull;
  std::uint32_t leafCount_ = 0;
};

}  // namespace brittle::physics
