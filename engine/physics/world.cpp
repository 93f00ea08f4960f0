#include "engine/physics/world.h"

#include "engine/core/profile.h"
#include "engine/effects/has/debris.h"
#include "engine/effects/has/drives.h"
#include "engine/effects/has/fracture.h"
#include "engine/effects/has/joints.h"
#include "engine/effects/has/stacks.h"
#include "engine/physics/breakage.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/deactivation.h"
#include "engine/physics/debris_step.h"
#include "engine/physics/fracture_stage.h"
#include "engine/physics/integrate.h"
#include "engine/physics/quarantine.h"
#include "engine/physics/reach.h"
#include "engine/physics/recycle.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

// Contact steps from a change to the last contact solved again. Measured: beyond, no test of momentum, energy or exit
// speed sees it.
constexpr int kContactSteps = 4;

void solve(State& state, float dt, bool isFirstPass) {
  BR_ZONE("solve");
  ContactSolver& solver = state.contactSolver;
  if constexpr (effects::kHasJoints) state.jointSolver.prepare(state, dt, isFirstPass);
  if constexpr (effects::kHasDrives) state.driveSolver.prepare(state, dt, isFirstPass);
  solver.prepare(state, dt, isFirstPass);
  // Later passes start from the first one's answer and only take in what a breaking changed.
  const int iterations = state.accuracy.iterations;
  const int tallRounds = effects::kHasStacks && isFirstPass ? state.stacks.rounds() : 0;
  if constexpr (effects::kHasStacks)
    if (tallRounds > 0) solver.solveTall(state, maxOf(tallRounds, iterations / 2));
  if (tallRounds == 0) solver.solve(state, isFirstPass ? iterations : (iterations + 1) / 2);
  solver.store(state);
  solver.storeBodies(state);
}

/// Steps 3 to 5: solve under the strikes' limits, break what they saturate, solve again with what is left.
void solveAndBreak(State& state, float dt) {
  bool goesOn = true;
  for (int round = 0, pass = 0; goesOn; ++pass) {
    state.contactSolver.loadBodies(state);
    if (pass == 0)
      reachAll(state, state.reach);
    else
      reachFrom(state, state.touchedBodies, kContactSteps, state.reach);
    if constexpr (effects::kHasFracture) limitImpulses(state, dt);
    solve(state, dt, pass == 0);
    ++state.counters.passes;
    goesOn = false;
    if constexpr (effects::kHasFracture) goesOn = breakOrAdvance(state, round, dt);
  }
}

/// One sub-step: 1 integrate velocities, 2 find contacts, 3 limit impulses, 4 solve, 5 break and limit again, 6
/// integrate positions.
void step(State& state, float dt) {
  quarantine(state);
  if constexpr (effects::kHasJoints) wakeByJoints(state);
  if constexpr (effects::kHasDrives) wakeByDrives(state);
  integrateVelocities(state, dt);  // 1
  if constexpr (effects::kHasFracture) beginBreaking(state, dt);
  detectCollisions(state, dt);  // 2
  if constexpr (effects::kHasStacks) state.stacks.measure(state, dt);
  solveAndBreak(state, dt);  // 3 to 5
  if constexpr (effects::kHasFracture) endBreaking(state, dt);
  if constexpr (effects::kHasStacks) state.stacks.hold(state, dt);
  integratePositions(state, dt);  // 6
  state.contactSolver.applyRestitution(state);
  correctPositions(state);
  if constexpr (effects::kHasFracture) fractureAfterStep(state);
  finishContacts(state);
  state.contactSolver.forgetImpacts(state, dt);
  if constexpr (effects::kHasDebris) stepDebris(state, dt);
  recycleBodies(state);
  if (state.accuracy.deactivation) deactivate(state, dt);
}

void beginTick(State& state) {
  state.events.breaks.clear();
  state.events.hits.clear();
  state.events.quarantined.clear();
  const Counters old = state.counters;
  state.counters = {};
  state.counters.totalBreaks = old.totalBreaks;
  state.counters.omissions = old.omissions;
}

void countWhatIsThere(State& state) {
  Counters& counters = state.counters;
  counters.bodies = static_cast<std::uint32_t>(state.bodies.size());
  counters.shapes = static_cast<std::uint32_t>(state.shapes.size());
  counters.contacts = static_cast<std::uint32_t>(state.contacts.size());
  if constexpr (effects::kHasStacks) counters.tallest = static_cast<std::uint32_t>(state.stacks.height());
  state.bodies.forEach(
      [&](BodyHandle, const Body& body) { counters.awakeBodies += body.isDynamic() && body.awake ? 1 : 0; });
  state.contacts.forEach([&](ContactHandle, const Contact& contact) {
    counters.points += static_cast<std::uint32_t>(contact.manifold.count);
  });
}

}  // namespace

World::World(const WorldDef& def) : state_(std::make_unique<State>()) {
  BR_ASSERT(isFinite(def.gravity) && isWithinRange(def.accuracy));
  state_->gravity = def.gravity;
  state_->accuracy = def.accuracy;
  state_->seed = def.seed;
}

World::~World() = default;

void World::step(float dt) {
  BR_ASSERT(dt >= 1.0f / 1000.0f && dt <= 1.0f / 20.0f);
  State& state = *state_;
  beginTick(state);
  const int substeps = maxOf(state.accuracy.substeps, 1);
  for (int i = 0; i < substeps; ++i) physics::step(state, dt / static_cast<float>(substeps));
  if constexpr (effects::kHasFracture) closeBudgets(state);
  countWhatIsThere(state);
  ++state.tick;
}

}  // namespace brittle::physics
