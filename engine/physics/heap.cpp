#include "engine/physics/heap.h"

#include <algorithm>

#include "engine/physics/contact_graph.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

void add(Heap& heap, BodyHandle body) {
  if (heap.isIn[body.index]) return;
  heap.isIn[body.index] = true;
  heap.bodies.push_back(body);
}

void addNeighbours(const State& state, const Shape& shape, Heap& heap) {
  forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t side) {
    const Contact& contact = state.contacts.at(slot);
    if (!contact.touching) return true;
    const BodyHandle other = state.shapes[side == 0 ? contact.b : contact.a].body;
    const Body& body = state.bodies[other];
    heap.isCarried = heap.isCarried || body.type == BodyType::Animated;
    if (body.isDynamic()) add(heap, other);
    return true;
  });
}

bool hangs(const State& state, const Heap& heap) {
  const auto holds = [&](ShapeHandle handle) {
    const Shape* shape = state.shapes.find(handle);
    return shape != nullptr && heap.isIn[shape->body.index];
  };
  bool found = false;
  state.joints.forEach(
      [&](JointHandle, const Joint& joint) { found = found || holds(joint.a) || (joint.b && holds(joint.b)); });
  return found;
}

bool isDriven(const State& state, const Heap& heap) {
  bool found = false;
  state.drives.forEach([&](DriveHandle, const Drive& drive) {
    found = found || std::any_of(heap.bodies.begin(), heap.bodies.end(),
                                 [&](BodyHandle body) { return state.bodies[body].assembly == drive.def.assembly; });
  });
  return found;
}

}  // namespace

void gatherHeap(const State& state, BodyHandle body, Heap& heap) {
  heap.isCarried = false;
  heap.bodies.clear();
  heap.isIn.assign(state.bodies.capacity(), false);
  add(heap, body);
  for (std::size_t i = 0; i < heap.bodies.size(); ++i)
    forEachShape(state, state.bodies[heap.bodies[i]],
                 [&](ShapeHandle, const Shape& shape) { addNeighbours(state, shape, heap); });
  heap.isCarried = heap.isCarried || hangs(state, heap) || isDriven(state, heap);
}

}  // namespace brittle::physics
