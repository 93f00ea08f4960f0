// physics/strikes.h - who strikes what breakable body, and what it may spend. A strike may spend at most what is left
// of the strength J over all its contact points, rounds and sub-steps of 1/60 s; when that does not stop it, the body
// breaks. What was spent is kept by budgets.h, who gets there first is found by arrivals.h, the breaking is breakage's.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/fracture/fracture.h"
#include "engine/physics/events.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

struct State;

inline constexpr float kWeakRatio = 0.25f;  // a closing impulse below this part of the capacity need not be swept [-]
inline constexpr float kAllSpent = 0.99f;   // part of it that counts as all; what is not stopped decides [-]

/// One body against one breakable body, over all their contacts, in one pass of the solver.
struct Strike {
  BodyHandle body;                 // the other party of the contacts
  BodyHandle striker, struck;      // the parties to the budget: a fresh piece spends its maker's
  std::uint32_t firstContact = 0;  // range in Strikes::contacts
  std::uint32_t contactCount = 0;
  float capacity = 0.0f;                 // what is left of J before this tick's accumulated impulse [N s]
  float limit = 0.0f;                    // what this body alone may spend of it [N s]
  float impulse = 0.0f;                  // accumulated in this tick by contacts that still exist [N s]
  float approachSpeed = 0.0f;            // before the solve, along the normal [m/s]
  float leftSpeed = 0.0f;                // after the solve, along the normal [m/s]
  float mass = 0.0f;                     // effective, along the normal: the largest of its points [kg]
  Vec3 relativeVelocity = Vec3::Zero();  // of the striker at the point, before the solve [m/s]
  Vec3 velocityBefore = Vec3::Zero();    // of `body` before the solve [m/s]
  Vec3 point = Vec3::Zero();             // world [m]
  bool touching = false;                 // there is no gap, or the sweep has closed it
  bool active = false;                   // takes part in the solve
  bool isCapped = true;                  // off: rigid until it breaks (comparison)
  bool mayBreak = true;                  // off: what is left of something that broke in this tick
  bool saturated = false;
};

/// A contact with something breakable, before contacts are gathered into strikes.
struct StrikeCandidate {
  BodyHandle struck, striker, body;
  std::uint32_t contact = 0;
  friend bool operator<(const StrikeCandidate& a, const StrikeCandidate& b) {
    if (!(a.struck == b.struck)) return a.struck < b.struck;
    if (!(a.striker == b.striker)) return a.striker < b.striker;
    if (!(a.body == b.body)) return a.body < b.body;
    return a.contact < b.contact;
  }
};

/// Scratch of arrivals: a strike whose swept body gets there within the tick.
struct Arrival {
  std::uint32_t strike = 0;  // index into Strikes::list
  BodyHandle body;
  float time = 0.0f;  // [s] from where the body is now
};

struct Strikes {
  std::vector<Strike> list;             // sorted by struck, striker, body
  std::vector<std::uint32_t> contacts;  // slots
  std::vector<StrikeCandidate> candidates;
  std::vector<Arrival> arrivals;
  void clear() {
    list.clear();
    contacts.clear();
  }
};

/// A body that breaks now, and where it was hit: `impactCount` of State::impacts from `firstImpact` on.
struct Breaking {
  BreakEvent event;
  std::uint32_t firstImpact = 0, impactCount = 0;
};

/// A body whose breaking was put off to the next tick; its striker waits at it and has paid.
struct Held {
  BodyHandle striker, struck;
  fracture::Impact impact;  // in the struck body's frame
  float impulse = 0.0f;     // paid [N s]

  template <class Archive>
  void serialize(Archive& a) {
    a(striker);
    a(struck);
    a(impact.point);
    a(impact.direction);
    a(impact.speed);
    a(impact.strikerRadius);
    a(impact.toCenter);
    a(impulse);
  }
};

/// The body whose way is swept: the one that comes, or the struck one if the other stands still.
BodyHandle sweptBody(const State& state, const Strike& strike);

/// What the other bodies of the same budget (a striker and its fresh pieces) spend on the same struck body. [N s]
inline float spentByPartners(const Strikes& strikes, std::size_t s) {
  const std::vector<Strike>& list = strikes.list;
  const auto isPartner = [&](std::size_t i) {
    return list[i].striker == list[s].striker && list[i].struck == list[s].struck;
  };
  float spent = 0.0f;
  for (std::size_t i = s; i > 0 && isPartner(i - 1); --i) spent += list[i - 1].impulse;
  for (std::size_t i = s + 1; i < list.size() && isPartner(i); ++i) spent += list[i].impulse;
  return spent;
}

/// Charges what the contacts that are left at the end of a tick carried.
void chargeStrikes(State& state, float dt);

/// Finds the strikes among the contacts, with what is left of each one's budget. Those that touch, or are too weak to
/// break anything, take part in the solve; those still on their way wait for advanceStrikers.
void limitImpulses(State& state, float dt);
/// After a solve: which strikes were not stopped by all they may spend. Per striking body only those count that it
/// reached.
bool findSaturated(State& state);
/// Whether something that is to break was struck by what goes farther than its own size within the tick.
bool isStruckFast(const State& state, float dt);
/// After the last round: what is saturated breaks next tick; its striker's motion ends where it is.
void holdSaturated(State& state, float dt);

/// The impact of a strike in the frame of what it struck.
fracture::Impact impactOf(const State& state, const Strike& strike);

}  // namespace brittle::physics
