#include "engine/physics/reach.h"

#include <algorithm>

#include "engine/physics/contact_graph.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

bool moves(const Body& body) {
  return body.isDynamic() && body.awake;
}

/// Takes in the contacts of a body and notes what they lead to.
void expand(const State& state, BodyHandle handle, Reach& reach) {
  if (reach.isInside[handle.index] != 0) return;
  reach.isInside[handle.index] = 1;
  forEachShape(state, state.bodies[handle], [&](ShapeHandle, const Shape& shape) {
    forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t side) {
      const Contact& contact = state.contacts.at(slot);
      if (contact.manifold.count == 0) return true;
      const BodyHandle other = state.shapes[side == 0 ? contact.b : contact.a].body;
      if (reach.isInside[other.index] != 0) return true;  // it came from there
      reach.contacts.push_back(slot);
      if (moves(state.bodies[other])) reach.next.push_back(other);
      return true;
    });
  });
}

void followJoints(const State& state, Reach& reach) {
  state.joints.forEach([&](JointHandle, const Joint& joint) {
    const Shape* a = state.shapes.find(joint.a);
    const Shape* b = state.shapes.find(joint.b);
    if (a == nullptr || b == nullptr) return;
    const bool insideA = reach.isInside[a->body.index] != 0;
    if (insideA == (reach.isInside[b->body.index] != 0)) return;
    const BodyHandle other = insideA ? b->body : a->body;
    if (moves(state.bodies[other])) reach.next.push_back(other);
  });
}

}  // namespace

void reachAll(const State& state, Reach& reach) {
  reach.isInside.assign(state.bodies.capacity(), 1);
  reach.contacts.clear();
  state.contacts.forEach([&](ContactHandle handle, const Contact& contact) {
    if (contact.manifold.count > 0) reach.contacts.push_back(handle.index);
  });
}

void reachFrom(const State& state, const std::vector<BodyHandle>& changed, int steps, Reach& reach) {
  reach.isInside.assign(state.bodies.capacity(), 0);
  reach.contacts.clear();
  reach.front = changed;
  for (int step = 0; step < steps && !reach.front.empty(); ++step) {
    reach.next.clear();
    for (const BodyHandle handle : reach.front) expand(state, handle, reach);
    followJoints(state, reach);
    reach.front.swap(reach.next);
  }
  std::sort(reach.contacts.begin(), reach.contacts.end());
}

}  // namespace brittle::physics
