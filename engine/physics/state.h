// physics/state.h - everything a world is, and the scratch memory of its stages. Only physics' own files look in here.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/slot_pool.h"
#include "engine/fracture/fracture.h"
#include "engine/geometry/mesh_pool.h"
#include "engine/physics/accuracy.h"
#include "engine/physics/body.h"
#include "engine/physics/broad_phase.h"
#include "engine/physics/budgets.h"
#include "engine/physics/contact.h"
#include "engine/physics/debris.h"
#include "engine/physics/drive.h"
#include "engine/physics/events.h"
#include "engine/physics/joint.h"
#include "engine/physics/reach.h"
#include "engine/physics/shape.h"
#include "engine/physics/solver.h"
#include "engine/physics/strikes.h"
#include "engine/physics/solver_body.h"
#include "engine/physics/stack.h"
#include "engine/physics/sweep.h"

namespace brittle::physics {

struct State {
  // The state proper: saved, restored, and hashed by one description (see snapshot.cpp).
  SlotPool<Body, BodyHandle> bodies;
  SlotPool<Shape, ShapeHandle> shapes;
  SlotPool<Contact, ContactHandle> contacts;
  SlotPool<Joint, JointHandle> joints;
  SlotPool<Drive, DriveHandle> drives;
  geometry::MeshPool meshes;
  DynamicTree tree;
  Debris debris;
  std::vector<Budget> budgets;  // by striker, then struck
  std::vector<Held> held;
  Accuracy accuracy;
  Vec3 gravity = Vec3(0.0f, -9.81f, 0.0f);
  std::uint64_t seed = 1;
  std::int32_t tick = 0;
  std::uint32_t nextAssembly = 1;
  std::vector<ShapeHandle> newShapes;  // made since the pairs were last searched
  std::uint32_t nextSerial = 1;        // numbers bodies in order of making: seeds their breaking

  // Rebuilt every tick; never read across ticks.
  std::vector<SolverBody> solverBodies;
  std::vector<Aabb> shapeBoxes;  // by shape slot: tight, at the start of the tick
  std::vector<ShapeHandle> wakeQueue;
  std::vector<ShapeHandle> movedShapes;   // left their box in the tree
  std::vector<ShapeHandle> knownPairOf;   // by shape slot: a moved shape it has a contact with
  std::uint32_t searches = 0;             // collision detections within ticks so far
  std::vector<bool> jointedBodies;        // by body slot: has a joint
  std::vector<BodyHandle> touchedBodies;  // made or moved within the tick: collided again before the next pass
  Reach reach;                            // what the present pass of the solver takes in
  std::vector<Placement> placements;      // by body slot, of those awake: before positions are integrated
  std::vector<Heavy> moveOrder;           // of those dynamic and awake
  std::vector<Meeting> meetings;
  std::vector<std::uint32_t> overlapping;   // contact slots
  std::vector<std::uint32_t> firstMeeting;  // by body slot, or kNoMeeting
  JointSolver jointSolver;
  DriveSolver driveSolver;
  ContactSolver contactSolver;
  Stacks stacks;
  Strikes strikes;
  std::shared_ptr<fracture::Fracturer> fracturer;  // made by the first breaking
  std::vector<Held> breakingNow;
  std::vector<fracture::Impact> impacts;
  std::vector<Breaking> breakings;
  std::vector<bool> groupFlags;
  Events events;
  Counters counters;

  Body& bodyOf(const Shape& shape) { return bodies[shape.body]; }
  const Body& bodyOf(const Shape& shape) const { return bodies[shape.body]; }
};

}  // namespace brittle::physics
