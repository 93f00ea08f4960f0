// physics/events.h - what happened in a tick, for the game and its sounds. Valid until the next step.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/tally.h"
#include "engine/math/types.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

struct BreakEvent {
  BodyHandle body;  // what broke; stale if nothing of it stayed
  BodyHandle striker;
  std::uint32_t assembly = 0;
  std::uint32_t userData = 0;   // of the broken body
  Vec3 point = Vec3::Zero();    // world [m]
  Vec3 normal = Vec3::UnitY();  // the way the striker went
  float speed = 0.0f;           // approach speed [m/s]
  float impulse = 0.0f;         // paid by the striker [N s]
  std::uint32_t pieces = 0;     // new bodies
};

struct HitEvent {
  BodyHandle a, b;
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();
  float speed = 0.0f;    // approach speed [m/s]
  float impulse = 0.0f;  // [N s]
};

struct Events {
  std::vector<BreakEvent> breaks;
  std::vector<HitEvent> hits;           // new touches faster than 0.5 m/s
  std::vector<BodyHandle> quarantined;  // removed because a number in them was not finite
};

/// What the engine puts off, refuses or recycles.
enum class Omission : std::uint8_t {
  HeldBreak,        // a breaking waits for the next tick: the rounds of this one are spent
  StoppedStriker,   // and so does what struck it
  RecycledBody,     // a piece became a crumb: Accuracy::maxBodies
  RecycledCrumb,    // gave way to a younger one: Accuracy::maxDebris
  RemovedCrumb,     // World::removeCrumbs
  RefusedContact,   // kMaxContacts
  RefusedCut,       // a split that would have been thinner than geometry can hold
  QuarantinedBody,  // a number in it was not finite
  Count
};
const char* nameOf(Omission omission);

/// Always on, cheap; shown by the overlay and the bench. Of the last tick unless said.
struct Counters {
  std::uint32_t bodies = 0, awakeBodies = 0, shapes = 0, contacts = 0, points = 0, pairsTested = 0;
  std::uint32_t rounds = 0;  // fracture rounds
  std::uint32_t passes = 0;  // times the solver ran
  std::uint32_t breaks = 0, pieces = 0, crumbs = 0;
  std::uint32_t held = 0;                  // bodies that are to break but wait for the next tick
  std::uint32_t tallest = 0;               // bodies of the tallest pile that is treated as one; 0: none
  std::uint32_t swept = 0;                 // fast bodies swept
  std::uint32_t sweeps = 0, confined = 0;  // ways searched for their first obstacle; bodies set back from one
  std::uint64_t totalBreaks = 0;           // since the start
  Tally<Omission> omissions;               // too; or since it was restored
};

}  // namespace brittle::physics
