// physics/budgets.h - who owns a breakable body's strength: what each striker has spent on each struck body within the
// last 1/60 s, over all contact points, rounds and sub-steps. Two strikers pay a body's strength each; what a striker
// broke loose spends on its maker's account. Knows nothing of contacts: strikes.h says what is spent.
#pragma once

#include <cstdint>

#include "engine/physics/ids.h"

namespace brittle::physics {

struct State;

/// What a striker has spent on a breakable body lately: the owner of a strength budget.
struct Budget {
  BodyHandle striker, struck;
  float spent = 0.0f;  // [N s], fading over 1/60 s

  template <class Archive>
  void serialize(Archive& a) {
    a(striker);
    a(struck);
    a(spent);
  }
};

/// Who pays for what `body` spends: a fresh piece the striker that broke it loose, everything else itself.
BodyHandle payerOf(const State& state, BodyHandle body);
/// What `striker` has spent on `struck` of late; 0 if it never struck it. [N s]
float spentOn(const State& state, BodyHandle striker, BodyHandle struck);
/// Adds to what `striker` has spent on `struck`.
void charge(State& state, BodyHandle striker, BodyHandle struck, float impulse);
/// Lets spending fade: what counts is the last 1/60 s, whatever dt is. Once a sub-step. What was spent on something
/// that breaks in this tick stays: whoever paid passes through what is left of it until the tick ends.
void fadeBudgets(State& state, float dt);
/// At the end of a tick: what was spent on something that broke went with the glass that bore it. What is left has its
/// whole strength, or shards that slide down beside it would break it again and again with the rest.
void closeBudgets(State& state);

}  // namespace brittle::physics
