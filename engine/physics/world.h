// physics/world.h - rigid bodies that break inside the step. The one class the game talks to. Never sees a clock, a
// window or GL: step(dt) is a function of the state, and the state hashes to the same 64 bits on every machine.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "engine/core/result.h"
#include "engine/physics/accuracy.h"
#include "engine/physics/body.h"
#include "engine/physics/debris.h"
#include "engine/physics/drive.h"
#include "engine/physics/events.h"
#include "engine/physics/heap.h"
#include "engine/physics/joint.h"
#include "engine/physics/shape.h"

namespace brittle::physics {

struct State;

struct WorldDef {
  Vec3 gravity = Vec3(0.0f, -9.81f, 0.0f);  // [m/s2]
  Accuracy accuracy;
  std::uint64_t seed = 1;  // of every fracture pattern
};

struct RayResult {
  bool hit = false;
  ShapeHandle shape;
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();
  float fraction = 1.0f;
};

class World {
 public:
  explicit World(const WorldDef& def = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // Making and unmaking. Definitions are checked: finite, in range; a broken one asserts.
  BodyHandle createBody(const BodyDef& def);
  /// `convex` in the body's local frame, copied into the mesh pool.
  ShapeHandle addConvex(BodyHandle body, const ShapeDef& def, const geometry::ConvexView& convex);
  ShapeHandle addSphere(BodyHandle body, const ShapeDef& def, float radius, const Vec3& center = Vec3::Zero());
  void removeShape(ShapeHandle shape);
  void destroyBody(BodyHandle body);
  /// Finds which shapes of a breakable body touch static geometry face to face and marks them anchored. A static
  /// breakable body that touches none is anchored everywhere. Returns how many are anchored.
  std::uint32_t anchor(BodyHandle body);
  JointHandle createJoint(const JointDef& def);
  void destroyJoint(JointHandle joint);
  void setMotor(JointHandle joint, bool on, float speed, float limit);
  DriveHandle createDrive(const DriveDef& def);
  void setDrive(DriveHandle drive, const DriveDef& def);
  void destroyDrive(DriveHandle drive);
  /// Every body that the shapes of an assembly now belong to, each once, in slot order.
  void bodiesOf(std::uint32_t assembly, std::vector<BodyHandle>& bodies) const;
  /// Where an animated body's frame is to be at the end of the next step (animates each body of its assembly).
  void animate(std::uint32_t assembly, const Transform& target);

  /// One tick. dt in [1/1000, 1/20] s.
  void step(float dt);

  // Looking.
  bool isAlive(BodyHandle body) const;
  bool isAlive(ShapeHandle shape) const;
  bool isAlive(JointHandle joint) const;
  const Body& body(BodyHandle handle) const;
  const Shape& shape(ShapeHandle handle) const;
  const Joint& joint(JointHandle handle) const;
  BodyHandle bodyOf(ShapeHandle shape) const;
  void forEachBody(const std::function<void(BodyHandle, const Body&)>& visit) const;
  const geometry::MeshPool& meshes() const;
  geometry::MeshPool& meshes();  // the renderer clears dirty ranges
  const Debris& debris() const;
  const Events& events() const;
  const Counters& counters() const;
  std::int32_t tick() const;
  /// What touches a dynamic body, and what touches that.
  void heapOf(BodyHandle body, Heap& heap) const;

  // Changing.
  void setVelocity(BodyHandle body, const Vec3& velocity, const Vec3& angularVelocity);
  void setPose(BodyHandle body, const Transform& pose);
  /// What a medium does to an awake body, tick by tick: it may come to rest in it.
  void drag(BodyHandle body, const Vec3& velocity, const Vec3& angularVelocity);
  void setBreakable(BodyHandle body, const Breakable& breakable);
  void setAccuracy(const Accuracy& accuracy);
  const Accuracy& accuracy() const;
  void applyImpulse(BodyHandle body, const Vec3& impulse, const Vec3& point);
  void wake(BodyHandle body);
  /// Takes out the light debris that `isGone` says yes to, and counts it.
  void removeCrumbs(const std::function<bool(const Crumb&)>& isGone);
  /// Breaks a body now, as if hit at `point` (world) with `speed` [m/s] along `direction`, by something of `radius`
  /// [m].
  void breakBody(BodyHandle body, const Vec3& point, const Vec3& direction, float speed, float radius);

  // Queries. `mask` selects shapes by category.
  RayResult castRay(const Vec3& from, const Vec3& to, std::uint32_t mask = ~0u) const;
  /// First shape a sphere meets on its way; fraction of the way at which it touches.
  RayResult castSphere(const Vec3& from, const Vec3& to, float radius, std::uint32_t mask = ~0u) const;
  /// Calls visit for every shape that a sphere overlaps, in slot order; stops when it answers false.
  void overlapSphere(const Vec3& center, float radius, std::uint32_t mask,
                     const std::function<bool(ShapeHandle)>& visit) const;
  void overlapBox(const Aabb& box, std::uint32_t mask, const std::function<bool(ShapeHandle)>& visit) const;

  /// Moves the origin: every position and every cached one becomes itself minus `offset` [m], which must be a multiple
  /// of 2^-8.
  void shiftOrigin(const Vec3& offset);

  /// Everything the next step reads, and nothing else, in 64 bits.
  std::uint64_t stateHash() const;
  /// A world of more than kMostRestoredSlots (core/slot_pool.h) bodies, shapes or joints is written, but not read
  /// again.
  void save(ByteWriter& out) const;
  /// False, and the world unchanged, if the bytes are not a snapshot of this version.
  bool restore(ByteReader& in);

  /// For the solver's own files and tests.
  State& state() { return *state_; }
  const State& state() const { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

}  // namespace brittle::physics
