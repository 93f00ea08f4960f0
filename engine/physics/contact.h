// physics/contact.h - a pair of shapes close enough to matter. Lives from tick to tick and carries the impulses that
// warm start it.
#pragma once

#include <cstdint>

#include "engine/core/archive.h"
#include "engine/core/slot_pool.h"
#include "engine/physics/ids.h"
#include "engine/physics/manifold.h"

namespace brittle::physics {

/// A world holds no more contacts, since shapes on one spot have as many as the square of their number; pairs found
/// later get none. Chosen: 22 MB, and not twice the 35165 of the tests' most crowded scene, a pile of 1000 boxes.
inline constexpr std::size_t kMaxContacts = 65'536;
static_assert(kMaxContacts <= kMostRestoredSlots, "a world that was saved must be restored");

struct Contact {
  ShapeHandle a, b;
  Manifold manifold;
  float friction = 0.0f;
  float restitution = 0.0f;
  bool touching = false;             // had a point within the slop at the end of the last tick
  bool fromCut = false;              // between pieces of one breaking
  float approach[kMaxPoints] = {};   // this tick, before the solver: closing speed per point [m/s]
  bool passable = false;             // this tick: what strikes moves and has paid all it can, the way is free
  bool solvedAlone = false;          // this pass: not in a batch
  bool waits = false;                // this tick: only a sweep may close its gap, no impulse acts through it
  bool reached = false;              // this tick: a sweep has closed its gap
  bool met = false;                  // this tick: a sweep ended at it
  Vec3 side = Vec3::UnitY();         // then: the normal there, from A towards B
  std::uint32_t strike = kNoStrike;  // this tick: index of its strike
  std::uint32_t search = 0;          // State::searches when it was last brought up to date within a tick
  std::uint32_t next[2] = {0, 0};    // lists of shape a and shape b: contact slot * 2 + side, or kNoContact
  std::uint32_t previous[2] = {0, 0};

  template <class Archive>
  void serialize(Archive& ar) {
    ar(a);
    ar(b);
    ar(manifold);
    ar(friction);
    ar(restitution);
    ar(touching);
    ar(fromCut);
    ar(next);
    ar(previous);
  }
};

}  // namespace brittle::physics
