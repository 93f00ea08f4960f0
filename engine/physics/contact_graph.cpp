#include "engine/physics/contact_graph.h"

#include <cmath>

#include "engine/physics/deactivation.h"

namespace brittle::physics {
namespace {

void link(State& state, std::uint32_t slot, std::uint32_t side, ShapeHandle handle) {
  Shape& shape = state.shapes[handle];
  Contact& contact = state.contacts.at(slot);
  contact.next[side] = shape.firstContact;
  contact.previous[side] = kNoContact;
  if (shape.firstContact != kNoContact)
    state.contacts.at(shape.firstContact >> 1).previous[shape.firstContact & 1] = slot * 2 + side;
  shape.firstContact = slot * 2 + side;
  ++shape.contactCount;
}

void unlink(State& state, std::uint32_t slot, std::uint32_t side, ShapeHandle handle) {
  Shape& shape = state.shapes[handle];
  const Contact& contact = state.contacts.at(slot);
  const std::uint32_t next = contact.next[side];
  const std::uint32_t previous = contact.previous[side];
  if (previous == kNoContact)
    shape.firstContact = next;
  else
    state.contacts.at(previous >> 1).next[previous & 1] = next;
  if (next != kNoContact) state.contacts.at(next >> 1).previous[next & 1] = previous;
  --shape.contactCount;
}

}  // namespace

ContactHandle addContact(State& state, ShapeHandle a, ShapeHandle b) {
  if (state.contacts.size() >= kMaxContacts) {
    state.counters.omissions.add(Omission::RefusedContact);
    return {};
  }
  if (b.index < a.index) std::swap(a, b);
  const Surface& surfaceA = state.shapes[a].surface;
  const Surface& surfaceB = state.shapes[b].surface;
  Contact contact;
  contact.a = a;
  contact.b = b;
  contact.friction = std::sqrt(surfaceA.friction * surfaceB.friction);
  contact.restitution = maxOf(surfaceA.restitution, surfaceB.restitution);
  const ContactHandle handle = state.contacts.insert(contact);
  link(state, handle.index, 0, a);
  link(state, handle.index, 1, b);
  return handle;
}

void removeContact(State& state, ContactHandle handle) {
  const Contact& contact = state.contacts[handle];
  unlink(state, handle.index, 0, contact.a);
  unlink(state, handle.index, 1, contact.b);
  state.contacts.erase(handle);
}

ContactHandle findContact(const State& state, ShapeHandle a, ShapeHandle b) {
  const Shape& shapeA = state.shapes[a];
  const Shape& shapeB = state.shapes[b];
  const bool walkA = shapeA.contactCount <= shapeB.contactCount;
  const ShapeHandle other = walkA ? b : a;
  ContactHandle found;
  forEachContact(state, walkA ? shapeA : shapeB, [&](std::uint32_t slot, std::uint32_t side) {
    const Contact& contact = state.contacts.at(slot);
    if ((side == 0 ? contact.b : contact.a) == other) found = state.contacts.handleAt(slot);
    return !found;
  });
  return found;
}

void removeContactsOf(State& state, ShapeHandle shape) {
  wakeTouching(state, shape);
  forEachContact(state, state.shapes[shape], [&](std::uint32_t slot, std::uint32_t) {
    removeContact(state, state.contacts.handleAt(slot));
    return true;
  });
}

}  // namespace brittle::physics
