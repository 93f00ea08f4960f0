// physics/stack.h - what stands on each other. A sweep of the solver carries a load on by about one body: how many it
// takes grows with the square of a stack's height, and for its bending with the fourth power. With the sweeps that
// other scenes need six blocks sink and lean by centimetres while their loads build up, a wall bends and falls, and
// plates of 1 mm sink into each other by half of it. So from four bodies on the solver runs more and better rounds; and
// the motion that sweeps and rounds leave to bodies that stand is taken out from below, each body seeing those under it
// as immovable. Impulses stay the solver's, and so does what must fall: rounds that have converged leave nothing to
// take out. Source: Guendelman, Bridson, Fedkiw, Nonconvex Rigid Bodies with Stacking, 2003 (shock propagation).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/physics/contact_rows.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

struct State;

/// A body slow enough to stand, and how high it is.
struct Standing {
  float height = 0.0f;  // of its centre, against gravity [m]
  BodyHandle body;
  friend bool operator<(const Standing& a, const Standing& b) {
    return a.height != b.height ? a.height < b.height : a.body < b.body;
  }
};

class Stacks {
 public:
  /// Once contacts are up to date: how many bodies stand on top of each other; unless Accuracy::stacks says not to.
  void measure(const State& state, float dt);
  /// What the solver needs for that: rounds of ContactSolver::solveTall; 0: its usual sweeps will do.
  int rounds() const;
  /// Of the tallest pile [bodies]; 0: nothing stands on another body that moves.
  int height() const { return height_; }
  /// Once velocities are final, before positions are integrated.
  void hold(State& state, float dt);

 private:
  /// A contact with a body underneath.
  struct Support {
    ContactRows<float> rows;
    std::uint32_t bodyA = 0, bodyB = 0;
    int points = 0;
  };
  void findStanding(const State& state, float dt);
  std::uint32_t findLevels(const State& state, float dt);
  void gatherSupports(const State& state, BodyHandle body, float dt);
  void holdBody(State& state, BodyHandle body, float dt);

  std::vector<Standing> standing_;    // in order of height
  std::vector<std::uint32_t> level_;  // by body slot: bodies between it and the ground, itself included; 0: none
  std::vector<Support> supports_;
  int height_ = 0;  // [bodies]
};

}  // namespace brittle::physics
