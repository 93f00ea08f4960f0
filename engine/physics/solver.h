// physics/solver.h - sequential impulses over contacts: warm started, four independent contacts at a time, colour by
// colour, in an order that does not depend on the width. Contacts with something breakable are solved one by one after
// the batches, under a common cap per strike. Joints take part through JointSolver. Source: Catto, Iterative Dynamics
// with Temporal Coherence, 2005; Tonge, Iterative Rigid Body Solvers (GDC), 2013 (colouring).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/physics/contact_block.h"
#include "engine/physics/contact_rows.h"

namespace brittle::physics {

struct Contact;
struct State;

/// How the rows of a contact with a breakable body treat a gap.
enum class GapRule : std::uint8_t {
  Speculative,  // the approach may go on until the gap is closed
  Touching,     // as if there were none: the sweep has confirmed the touch
};

class ContactSolver {
 public:
  /// Copies velocities and masses of all bodies in.
  void loadBodies(State& state);
  void storeBodies(State& state) const;

  /// Builds the rows of every contact within State::reach that has an awake body: batches for the unlimited, one by one
  /// for those of active strikes. `warmStart`: apply the accumulated impulses (first pass of a tick); otherwise they
  /// are in the velocities.
  void prepare(State& state, float dt, bool warmStart);
  /// Runs `iterations` sweeps over joints, batches and strikes.
  void solve(State& state, int iterations);
  /// The same for tall stacks, which sweeps alone would not get to the ground of: after each sweep there and back all
  /// impulses go on along the way they took. Source: Silcowitz, Niebe, Erleben, A Nonsmooth Nonlinear Conjugate
  /// Gradient Method for Interactive Contact Force Problems, 2010.
  void solveTall(State& state, int rounds);
  /// Puts the accumulated impulses back into the manifolds and the strikes.
  void store(State& state) const;
  /// Rebound of contacts that carried an impulse and are not saturated. After the bodies have moved: until then a
  /// speculative contact has not closed its gap, and the body would rebound in the air. Source: Box2D v3's
  /// relax-then-restitute order.
  void applyRestitution(State& state);
  /// At the end of a tick: contacts of a light body that something much heavier ran into start the next one without
  /// impulses.
  void forgetImpacts(State& state, float dt);

 private:
  struct Batch {
    ContactRows<Float4> rows;
    std::uint32_t bodyA[kLanes], bodyB[kLanes], contact[kLanes];
    int lanes = 0;
    int points = 0;
  };
  /// Singles solved together: a light body's, or a strike's.
  struct Group {
    std::uint32_t first = 0, end = 0;
    std::uint32_t light = kNobody;
    std::uint32_t block = 0;  // a light body's, in blocks_
  };
  /// Of the impulses of one batch: as they were, then what a round changed of them, and the way they go on along.
  struct Course {
    Float4 change[kMaxPoints + 3], way[kMaxPoints + 3];
  };
  static constexpr std::uint32_t kNobody = 0xffffffff;

  void colorContacts(State& state);
  void buildBatches(State& state, float dt);
  std::uint32_t lighterOf(const State& state, const Contact& contact) const;
  void findLightBodies(State& state);
  void buildBlock(State& state, std::uint32_t light, float dt);
  void buildStrikes(State& state, float dt);
  void addSingle(State& state, std::uint32_t contact, float dt);
  void warmStartRows(State& state);
  void sweep(State& state, bool backwards);
  void solveBatches(bool backwards);
  void beginRound();
  double lengthOfRound();
  void goOn(float share);
  void solveGroups(State& state);
  void solveLightBody(State& state, const Group& group);
  void solveStrike(State& state, const Group& group);
  void scaleNormals(const Group& group, float scale);
  float sumOf(std::uint32_t first, std::uint32_t end) const;

  static constexpr int kColors = 24;  // beyond, contacts are solved one lane at a time
  std::vector<SolverBody>* bodies_ = nullptr;
  std::vector<std::uint32_t> colorMasks_;            // by body slot
  std::vector<std::uint32_t> byColor_[kColors + 1];  // contact slots
  std::vector<Batch> batches_;
  std::vector<Course> courses_;  // by batch
  std::vector<Single> singles_;
  std::vector<Group> groups_;
  std::vector<std::uint8_t> isLight_;  // by body slot
  std::vector<Block> blocks_;
  std::uint32_t blockCount_ = 0;
  std::vector<std::uint32_t> blockContacts_;
  std::vector<BlockLimit> limits_;
  std::uint32_t batchCount_ = 0;
};

}  // namespace brittle::physics
