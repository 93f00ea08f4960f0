// physics/contact_graph.h - which shapes are in contact: the pair list, threaded through the shapes so that the
// contacts of one shape are found without a search. Used by collision, breaking, deactivation and removal.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// A new contact of two shapes of different bodies; `a` becomes the one with the lower slot. Null, and counted, if the
/// world holds kMaxContacts.
ContactHandle addContact(State& state, ShapeHandle a, ShapeHandle b);
void removeContact(State& state, ContactHandle contact);
/// The contact of two shapes, or null. Walks the shorter list.
ContactHandle findContact(const State& state, ShapeHandle a, ShapeHandle b);

/// Visits the contacts of a shape, newest first: visit(slot, side) -> bool (false stops); side 0: the shape is
/// contact.a. The visitor may remove the contact.
template <class Visit>
void forEachContact(const State& state, const Shape& shape, Visit&& visit) {
  std::uint32_t edge = shape.firstContact;
  while (edge != kNoContact) {
    const std::uint32_t slot = edge >> 1;
    const std::uint32_t side = edge & 1;
    edge = state.contacts.at(slot).next[side];
    if (!visit(slot, side)) return;
  }
}

/// Visits every shape of a body, newest first: visit(handle, shape). The visitor may move the shape to another body.
template <class StateType, class Visit>
void forEachShape(StateType& state, const Body& body, Visit&& visit) {
  ShapeHandle handle = body.firstShape;
  while (handle) {
    auto& shape = state.shapes[handle];
    const ShapeHandle next = shape.next;
    visit(handle, shape);
    handle = next;
  }
}

/// Removes every contact of a shape, waking what rested on it.
void removeContactsOf(State& state, ShapeHandle shape);

}  // namespace brittle::physics
