// Looking: World's read-only side.
#include "engine/physics/state.h"
#include "engine/physics/world.h"

namespace brittle::physics {

bool World::isAlive(BodyHandle body) const {
  return state_->bodies.contains(body);
}
bool World::isAlive(ShapeHandle shape) const {
  return state_->shapes.contains(shape);
}
const Body& World::body(BodyHandle handle) const {
  return state_->bodies[handle];
}
const Shape& World::shape(ShapeHandle handle) const {
  return state_->shapes[handle];
}
BodyHandle World::bodyOf(ShapeHandle shape) const {
  return state_->shapes[shape].body;
}
const geometry::MeshPool& World::meshes() const {
  return state_->meshes;
}
geometry::MeshPool& World::meshes() {
  return state_->meshes;
}
const Debris& World::debris() const {
  return state_->debris;
}
const Events& World::events() const {
  return state_->events;
}
const Counters& World::counters() const {
  return state_->counters;
}
std::int32_t World::tick() const {
  return state_->tick;
}
const Accuracy& World::accuracy() const {
  return state_->accuracy;
}

void World::heapOf(BodyHandle body, Heap& heap) const {
  gatherHeap(*state_, body, heap);
}

void World::forEachBody(const std::function<void(BodyHandle, const Body&)>& visit) const {
  static_cast<const State&>(*state_).bodies.forEach(visit);
}

void World::bodiesOf(std::uint32_t assembly, std::vector<BodyHandle>& bodies) const {
  bodies.clear();
  static_cast<const State&>(*state_).bodies.forEach([&](BodyHandle handle, const Body& body) {
    if (body.assembly == assembly) bodies.push_back(handle);
  });
}

}  // namespace brittle::physics
