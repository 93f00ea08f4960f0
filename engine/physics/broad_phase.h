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

  /// Calls visit(userData) for every leaf whose box overlaps; stops when it answers false. The visitor may not change
  /// the tree.
  template <class Visit>
  void query(const Aabb& box, Visit&& visit) const;
  /// Calls visit(userData) for every leaf whose box the segment, swept by a ball of `radius` [m], may touch; the answer
  /// is the fraction to shorten the segment to (1: go on as before, 0: stop).
  template <class Visit>
  void castRay(const Vec3& from, const Vec3& to, Visit&& visit, float radius = 0.0f) const;

  /// Moves every box by the same offset [m].
  void shift(const Vec3& offset);
  bool isLeaf(std::uint32_t proxy) const { return proxy < nodes_.size() && nodes_[proxy].height == 0; }
  std::uint32_t leafCount() const { return leafCount_; }
  /// Steps from the root to the deepest leaf: at most 1.82 log2(leaves) + 1, whatever the boxes.
  int height() const { return root_ == kNull ? 0 : nodes_[root_].height; }
  /// The first broken invariant as a sentence, or null. Safe on any bytes (a damaged snapshot).
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
    std::int32_t height = 0;  // leaves 0, free nodes -1
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

  std::uint32_t allocate();
  void release(std::uint32_t index);
  std::uint32_t bestSibling(const Aabb& box) const;
  void attach(std::uint32_t leaf);
  void detach(std::uint32_t leaf);
  void replaceChild(std::uint32_t parent, std::uint32_t from, std::uint32_t to);
  void refit(std::uint32_t index);
  void refitUp(std::uint32_t index);
  bool isBalanced(std::uint32_t index) const;
  void rotate(std::uint32_t index);
  void swapDown(std::uint32_t top, int side, int grandchild);
  const char* findNodeError(std::uint32_t index) const;

  /// The node that follows `index` and all below it in depth-first order. Climbing by parents needs no stack, so no
  /// height of the tree can overflow one.
  std::uint32_t nextAfter(std::uint32_t index) const {
    for (;;) {
      const std::uint32_t parent = nodes_[index].parent;
      if (parent == kNull) return kNull;
      if (nodes_[parent].child[0] == index) return nodes_[parent].child[1];
      index = parent;
    }
  }

  std::vector<Node> nodes_;
  std::uint32_t root_ = kNull;
  std::uint32_t free_ = kNull;
  std::uint32_t leafCount_ = 0;
};

/// True if the segment may touch the box: separating axes, widened for rounding. `middle` and `half` describe the
/// segment. Source: Ericson, Real-Time Collision Detection, 2005, 5.3.3.
inline bool mayTouch(const Aabb& box, const Vec3& middle, const Vec3& half, float radius) {
  const Vec3 extent = 0.5f * (box.high - box.low);
  const Vec3 m = middle - 0.5f * (box.high + box.low);
  const float slack = 1e-5f * (m.cwiseAbs().maxCoeff() + extent.maxCoeff());
  const Vec3 e = extent + Vec3::Constant(radius + slack);
  const Vec3 h = half.cwiseAbs();
  for (int i = 0; i < 3; ++i)
    if (std::abs(m[i]) > e[i] + h[i]) return false;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (std::abs(m[j] * half[k] - m[k] * half[j]) > (e[j] + slack) * h[k] + (e[k] + slack) * h[j]) return false;
  }
  return true;
}

template <class Visit>
void DynamicTree::query(const Aabb& box, Visit&& visit) const {
  std::uint32_t index = root_;
  while (index != kNull) {
    const Node& node = nodes_[index];
    if (node.box.overlaps(box)) {
      if (!node.isLeaf()) {
        index = node.child[0];
        continue;
      }
      if (!visit(node.userData)) return;
    }
    index = nextAfter(index);
  }
}

template <class Visit>
void DynamicTree::castRay(const Vec3& from, const Vec3& to, Visit&& visit, float radius) const {
  float fraction = 1.0f;
  Vec3 half = 0.5f * (to - from);
  Vec3 middle = from + half;
  Aabb around{from.cwiseMin(to), from.cwiseMax(to)};  // most nodes are nowhere near: six comparisons say so
  around = around.grownBy(radius + 1e-5f * (from.cwiseAbs().maxCoeff() + to.cwiseAbs().maxCoeff()));
  std::uint32_t index = root_;
  while (index != kNull) {
    const Node& node = nodes_[index];
    if (node.box.overlaps(around) && mayTouch(node.box, middle, half, radius)) {
      if (!node.isLeaf()) {
        index = node.child[0];
        continue;
      }
      const float answer = visit(node.userData);
      if (answer <= 0.0f) return;
      if (answer < fraction) {
        fraction = answer;
        half = (0.5f * fraction) * (to - from);
        middle = from + half;
      }
    }
    index = nextAfter(index);
  }
}

}  // namespace brittle::physics
