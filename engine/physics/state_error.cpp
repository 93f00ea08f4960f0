#include "engine/physics/state_error.h"

#include <algorithm>
#include <iterator>

namespace brittle::physics {
namespace {

const char* findPoolError(const State& state) {
  const bool arePools = state.bodies.isConsistent() && state.shapes.isConsistent() && state.contacts.isConsistent() &&
                        state.joints.isConsistent() && state.drives.isConsistent();
  if (!arePools) return "a pool's free slots are not the empty ones";
  return state.tree.findError();
}

/// Every shape in the list of its body, once.
const char* findListError(const State& state) {
  std::size_t listed = 0;
  const char* error = nullptr;
  state.bodies.forEach([&](BodyHandle handle, const Body& body) {
    if (error != nullptr) return;  // lists that run in circles cost their length once, not once for each body
    if (body.type > BodyType::Animated || body.breaking.material.pattern > fracture::Pattern::Laminated)
      return void(error = "a body is of no type");
    std::uint32_t count = 0;
    for (ShapeHandle shape = body.firstShape; shape && count <= state.shapes.size(); shape = state.shapes[shape].next) {
      const Shape* found = state.shapes.find(shape);
      if (found == nullptr || !(found->body == handle)) return void(error = "a body lists a shape that is not its own");
      ++count;
    }
    if (count != body.shapeCount) error = "a body has another number of shapes than it lists";
    listed += count;
  });
  if (error != nullptr) return error;
  return listed == state.shapes.size() ? nullptr : "a shape is in no body's list";
}

bool isHeldInTree(const State& state, ShapeHandle handle, const Shape& shape) {
  return state.tree.isLeaf(shape.proxy) && state.tree.userData(shape.proxy) == handle.index;
}

/// Every side of every contact in the list of its shape, once.
const char* findContactError(const State& state, ShapeHandle handle, const Shape& shape, std::size_t& listed) {
  std::uint32_t previous = kNoContact, count = 0;
  for (std::uint32_t edge = shape.firstContact; edge != kNoContact;) {
    if (!state.contacts.isAlive(edge >> 1) || ++count > shape.contactCount) return "a shape lists no contact";
    const Contact& contact = state.contacts.at(edge >> 1);
    const std::uint32_t side = edge & 1;
    if (!((side == 0 ? contact.a : contact.b) == handle) || contact.previous[side] != previous)
      return "a shape lists another's contact";
    previous = edge;
    edge = contact.next[side];
  }
  listed += count;
  return count == shape.contactCount ? nullptr : "a shape has another number of contacts than it lists";
}

bool areAnchorsSound(const Shape& shape) {
  if (shape.anchorCount > kMaxAnchors) return false;
  return std::all_of(shape.anchors, shape.anchors + shape.anchorCount,
                     [](const fracture::Anchor& anchor) { return anchor.pointCount <= std::size(anchor.points); });
}

const char* findShapeError(const State& state) {
  std::size_t contactSides = 0;
  const char* error = nullptr;
  state.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
    if (!shape.isSphere() && !state.meshes.isAlive(shape.mesh)) error = "a shape has no mesh";
    if (!isHeldInTree(state, handle, shape)) error = "a shape is not in the tree";
    if (!areAnchorsSound(shape)) error = "a shape has too many anchors, or an anchor too many points";
    if (const char* found = findContactError(state, handle, shape, contactSides)) error = found;
  });
  if (error != nullptr) return error;
  if (state.shapes.size() != state.tree.leafCount()) return "the tree holds what is no shape";
  return contactSides == 2 * state.contacts.size() ? nullptr : "a contact is in no shape's list";
}

const char* findPairError(const State& state) {
  const char* error = nullptr;
  state.contacts.forEach([&](ContactHandle, const Contact& contact) {
    if (contact.manifold.count < 0 || contact.manifold.count > kMaxPoints) error = "a contact has too many points";
  });
  state.joints.forEach([&](JointHandle, const Joint& joint) {
    if (joint.type > JointType::Weld) error = "a joint is of no type";
  });
  return error;
}

}  // namespace

const char* findError(const State& state) {
  if (!isWithinRange(state.accuracy)) return "the accuracy is out of range";
  for (const auto find : {findPoolError, findListError, findShapeError, findPairError})
    if (const char* error = find(state)) return error;
  return nullptr;
}

}  // namespace brittle::physics
