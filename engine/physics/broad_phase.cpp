#include "engine/physics/broad_phase.h"

#include "engine/core/assert.h"

namespace brittle::physics {

namespace {

/// Heights of two siblings may differ by this much. With 2, n leaves need at least n(h) = n(h-1) + n(h-3), so the
/// height stays below 1.82 log2 n; 1 (AVL) would force more rotations against the surface-area heuristic.
constexpr std::int32_t kMaxImbalance = 2;

float unionArea(const Aabb& a, const Aabb& b) {
  return unionOf(a, b).halfArea();
}

}  // namespace

std::uint32_t DynamicTree::allocate() {
  if (free_ == kNull) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t index = free_;
  free_ = nodes_[index].parent;
  nodes_[index] = Node{};
  return index;
}

void DynamicTree::release(std::uint32_t index) {
  nodes_[index] = Node{};
  nodes_[index].height = -1;
  nodes_[index].parent = free_;
  free_ = index;
}

std::uint32_t DynamicTree::insert(const Aabb& box, std::uint32_t userData) {
  const std::uint32_t leaf = allocate();
  nodes_[leaf].box = box;
  nodes_[leaf].userData = userData;
  attach(leaf);
  ++leafCount_;
  return leaf;
}

void DynamicTree::remove(std::uint32_t proxy) {
  BR_ASSERT(proxy < nodes_.size() && nodes_[proxy].height == 0);
  detach(proxy);
  release(proxy);
  --leafCount_;
}

void DynamicTree::move(std::uint32_t proxy, const Aabb& box) {
  BR_ASSERT(proxy < nodes_.size() && nodes_[proxy].height == 0);
  detach(proxy);
  nodes_[proxy].box = box;
  attach(proxy);
}

/// Greedy descent: pairing with `index` costs the area of the new parent plus what all ancestors grow; going on into a
/// child costs at least what that child grows. Ties go to the lower child, so equal boxes still make a balanced tree.
std::uint32_t DynamicTree::bestSibling(const Aabb& box) const {
  std::uint32_t index = root_;
  float inherited = 0.0f;
  while (!nodes_[index].isLeaf()) {
    const Node& node = nodes_[index];
    const float area = node.box.halfArea();
    const float here = unionArea(node.box, box);
    const float pairing = inherited + here;
    inherited += here - area;
    float cost[2];
    for (int side = 0; side < 2; ++side) {
      const Node& child = nodes_[node.child[side]];
      const float joined = unionArea(child.box, box);
      cost[side] = inherited + (child.isLeaf() ? joined : joined - child.box.halfArea());
    }
    const int lower = nodes_[node.child[1]].height < nodes_[node.child[0]].height ? 1 : 0;
    const int side = cost[0] < cost[1] ? 0 : (cost[1] < cost[0] ? 1 : lower);
    if (pairing <= cost[side]) return index;
    index = node.child[side];
  }
  return index;
}

void DynamicTree::replaceChild(std::uint32_t parent, std::uint32_t from, std::uint32_t to) {
  nodes_[to].parent = parent;
  if (parent == kNull) {
    root_ = to;
  } else {
    nodes_[parent].child[nodes_[parent].child[0] == from ? 0 : 1] = to;
  }
}

void DynamicTree::attach(std::uint32_t leaf) {
  if (root_ == kNull) {
    root_ = leaf;
    nodes_[leaf].parent = kNull;
    return;
  }
  const std::uint32_t sibling = bestSibling(nodes_[leaf].box);
  const std::uint32_t joint = allocate();
  replaceChild(nodes_[sibling].parent, sibling, joint);
  nodes_[joint].child[0] = sibling;
  nodes_[joint].child[1] = leaf;
  nodes_[sibling].parent = joint;
  nodes_[leaf].parent = joint;
  refitUp(joint);
}

void DynamicTree::detach(std::uint32_t leaf) {
  const std::uint32_t joint = nodes_[leaf].parent;
  nodes_[leaf].parent = kNull;
  if (joint == kNull) {
    root_ = kNull;
    return;
  }
  const std::uint32_t sibling = nodes_[joint].child[nodes_[joint].child[0] == leaf ? 1 : 0];
  const std::uint32_t parent = nodes_[joint].parent;
  replaceChild(parent, joint, sibling);
  release(joint);
  refitUp(parent);
}

void DynamicTree::refit(std::uint32_t index) {
  Node& node = nodes_[index];
  const Node& a = nodes_[node.child[0]];
  const Node& b = nodes_[node.child[1]];
  node.box = unionOf(a.box, b.box);
  node.height = 1 + maxOf(a.height, b.height);
}

bool DynamicTree::isBalanced(std::uint32_t index) const {
  const std::int32_t a = nodes_[nodes_[index].child[0]].height, b = nodes_[nodes_[index].child[1]].height;
  return a - b <= kMaxImbalance && b - a <= kMaxImbalance;
}

void DynamicTree::refitUp(std::uint32_t index) {
  while (index != kNull) {
    refit(index);
    rotate(index);
    index = nodes_[index].parent;
  }
}

/// Exchanges the child `side` of `top` with a grandchild under the other child.
void DynamicTree::swapDown(std::uint32_t top, int side, int grandchild) {
  const std::uint32_t down = nodes_[top].child[side];
  const std::uint32_t other = nodes_[top].child[1 - side];
  const std::uint32_t up = nodes_[other].child[grandchild];
  nodes_[top].child[side] = up;
  nodes_[up].parent = top;
  nodes_[other].child[grandchild] = down;
  nodes_[down].parent = other;
  refit(other);
  refit(top);
}

/// One rotation, forced where the heights differ too much (the taller grandchild goes up, and where that leaves the
/// lower node out of balance, one there too), else the exchange of a child with a grandchild that saves the most area,
/// as long as no height and no balance changes for the worse.
void DynamicTree::rotate(std::uint32_t index) {
  const Node& node = nodes_[index];
  const std::int32_t heights[2] = {nodes_[node.child[0]].height, nodes_[node.child[1]].height};
  for (int side = 0; side < 2; ++side) {
    if (heights[1 - side] <= heights[side] + kMaxImbalance) continue;
    const Node& tall = nodes_[node.child[1 - side]];
    const std::int32_t left = nodes_[tall.child[0]].height, right = nodes_[tall.child[1]].height;
    const std::uint32_t other = node.child[1 - side];
    swapDown(index, side, right > left ? 1 : 0);
    if (!isBalanced(other)) {  // a leaf paired with a tall node far from it sinks until it is among its like
      rotate(other);
      refit(index);
    }
    return;
  }
  int bestSide = -1, bestGrandchild = 0;
  float bestSaving = 0.0f;
  for (int side = 0; side < 2; ++side) {
    const Node& down = nodes_[node.child[side]];
    const Node& other = nodes_[node.child[1 - side]];
    if (other.isLeaf()) continue;
    for (int grandchild = 0; grandchild < 2; ++grandchild) {
      const Node& up = nodes_[other.child[grandchild]];
      const Node& stays = nodes_[other.child[1 - grandchild]];
      const std::int32_t joined = 1 + maxOf(down.height, stays.height);
      const bool balanced = down.height - stays.height <= kMaxImbalance &&
                            stays.height - down.height <= kMaxImbalance && joined - up.height <= kMaxImbalance &&
                            up.height - joined <= kMaxImbalance;
      if (!balanced || 1 + maxOf(joined, up.height) != node.height) continue;
      const float saving = other.box.halfArea() - unionArea(down.box, stays.box);
      if (saving > bestSaving) {
        bestSaving = saving;
        bestSide = side;
        bestGrandchild = grandchild;
      }
    }
  }
  if (bestSide >= 0) swapDown(index, bestSide, bestGrandchild);
}

void DynamicTree::shift(const Vec3& offset) {
  for (Node& node : nodes_) {
    if (node.height < 0) continue;
    node.box.low += offset;
    node.box.high += offset;
  }
}

const char* DynamicTree::findNodeError(std::uint32_t index) const {
  const Node& node = nodes_[index];
  if (node.isLeaf())
    return node.height == 0 && node.child[1] == kNull ? nullptr : "a leaf has a height or half a child";
  for (const std::uint32_t child : node.child) {
    if (child >= nodes_.size()) return "a child is out of range";
    if (nodes_[child].parent != index) return "a child has another parent";
    if (!node.box.contains(nodes_[child].box)) return "a box does not hold its child's";
  }
  const std::int32_t a = nodes_[node.child[0]].height, b = nodes_[node.child[1]].height;
  if (node.child[0] == node.child[1]) return "a node has the same child twice";
  if (a < 0 || b < 0) return "a child is free";
  if (node.height != 1 + maxOf(a, b)) return "a height is wrong";
  if (a - b > kMaxImbalance || b - a > kMaxImbalance) return "the tree is out of balance";
  return nullptr;
}

const char* DynamicTree::findError() const {
  std::size_t inUse = 0, leaves = 0, free = 0;
  if ((root_ == kNull) != (leafCount_ == 0)) return "leaves without a root, or a root without leaves";
  if (root_ != kNull && (root_ >= nodes_.size() || nodes_[root_].parent != kNull || nodes_[root_].height < 0))
    return "the root is not a root";
  for (std::uint32_t index = 0; index < nodes_.size(); ++index) {
    if (nodes_[index].height < 0) continue;
    ++inUse;
    leaves += nodes_[index].isLeaf() ? 1 : 0;
    if (index != root_ && nodes_[index].parent >= nodes_.size()) return "a node hangs on nothing";
    if (const char* error = findNodeError(index)) return error;
  }
  if (leaves != leafCount_) return "the leaf count is wrong";
  if (inUse != (leaves == 0 ? 0 : 2 * leaves - 1)) return "the number of nodes does not fit the number of leaves";
  for (std::uint32_t index = free_; index != kNull; index = nodes_[index].parent) {
    if (index >= nodes_.size() || nodes_[index].height >= 0) return "the free list leaves the free nodes";
    if (++free > nodes_.size()) return "the free list runs in a circle";
  }
  if (free + inUse != nodes_.size()) return "nodes are lost";
  return nullptr;
}

}  // namespace brittle::physics
