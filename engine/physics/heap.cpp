#include "engine/physics/heap.h"

#include <algorithm>

#include "engine/physics/contact_graph.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

void addNeighbours(const State& state, const Shape& shape, Heap& heap) {
  forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t side) {
    const Contact& contact = state.contacts.at(slot);
    if (!contact.touching) return true;
    const BodyHandle other = state.shapes[side == 0 ? contact.b : contact.a].body;
    const Body& body = state.bodies[other];
    heap.isCarried = heap.isCarried || body.type == BodyType::Animated;
    const bool isKnown = std::find(heap.bodies.begin(), heap.bodies.end(), other) != heap.bodies.end();
    if (body.isDynamic() && !isKnown) heap.bodies.push_back(other);
    return true;
  });
}

bool hangs(const State& state, const Heap& heap) {
  const auto holds = [&](ShapeHandle handle) {
    const Shape* shape = state.shapes.find(handle);
    return shape != nullptr && std::find(heap.bodies.begin(), heap.bodies.end(), shape->body) != heap.bodies.end();
  };
  bool found = false;
  state.joints.forEach(
      [&](JointHandle, const Joint& joint) { found = found || holds(joint.a) || (joint.b && holds(joint.b)); });
  return found;
}

}  // namespace

void gatherHeap(const State& state, BodyHandle body, Heap& heap) {
  heap.isCarried = false;
  heap.bodies.assign(1, body);
  for (std::size_t i = 0; i < heap.bodies.size(); ++i)
    forEachShape(state, state.bodies[heap.bodies[i]],
                 [&](ShapeHandle, const Shape& shape) { addNeighbours(state, shape, heap); });
  heap.isCarried = heap.isCarried || hangs(state, heap);
}

}  // namespace brittle::physics
