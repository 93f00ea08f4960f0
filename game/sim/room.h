// game/sim/room.h - one room and its physics world. Its coordinates: the room's frame has its start at z = 0 and runs
// along -Z; the local frame (of the world, of what is shown) is that plus (0, 0, shift), which keeps the camera near
// the origin. A room's state depends on its content, its seed and what happens in it: not on where it lies, nor on what
// was played before it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/byte_stream.h"
#include "engine/physics/world.h"
#include "engine/replay/input_frame.h"
#include "game/sim/ball.h"
#include "game/sim/obstacle.h"
#include "game/sim/room_plan.h"
#include "game/sim/session.h"
#include "game/sim/sight.h"
#include "game/sim/unseen.h"
#include "game/sim/water.h"

namespace brittle::sim {

/// As the game asks for, less what is switched off.
physics::Accuracy accuracyOf(const Session& session);

class Room {
 public:
  /// Runs the room's script. `globals` is what mgGet sees and mgSet changes while it runs.
  Room(Session& session, const RoomEntry& entry, std::uint64_t number, std::uint32_t slot);

  /// One tick with the camera `distance` [m] from the room's start (negative: before it), moving at `speed` [m/s],
  /// `ticks` and `tickPart` of one after it entered the room. All in the game's time, of which `time` passes.
  void tick(float distance, float speed, std::int32_t ticks, const TimeStep& time = {}, float tickPart = 0.0f);
  /// All balls get the charge, or of a barrel the middle one.
  void throwBalls(const Camera& camera, const replay::Throw& aim, int count, Charge charge = Charge::None);
  /// Balls that have left through the end of the room, taken out of it; in the frame of the next room.
  std::vector<BallStart> takeLeavingBalls();
  void addBall(const BallStart& start);
  /// Tests the camera's volume; a crash is scored, and what can break breaks.
  void crashTest();

  // What obstacles ask for.
  physics::World& world() { return *world_; }
  const physics::World& world() const { return *world_; }
  Session& session() { return session_; }
  const Viewpoint& viewpoint() const { return viewpoint_; }
  float shift() const { return shift_; }
  float gravity() const { return plan_.settings.gravity; }
  std::uint32_t ticks() const { return ticks_; }
  /// What passes in this tick.
  const TimeStep& time() const { return time_; }
  /// That there has been a room. [ticks of the game's time]
  float age() const { return static_cast<float>(ticks_) + static_cast<float>(time_.part) / kWholeTick; }
  std::uint64_t seed() const { return seed_; }
  Result<std::string> readScript(const std::string& path);
  /// Whether the obstacles that are alive may make another body, or shape.
  bool hasPlaceForBody() const;
  bool hasPlaceForShape() const;
  /// What a ray between two places of the local frame may have to look at, at most: boxes of the room and shapes.
  std::uint32_t crowdBetween(const Vec3& from, const Vec3& to) const;
  /// Whether the camera's volume fits along its line through what is left of the obstacle.
  bool canPass(const Obstacle& obstacle) const;
  void clearObstacle(Obstacle& obstacle);
  void emit(Event event);
  void demand(effects::Effect effect, std::string who) { plan_.effects.demand(effect, std::move(who)); }
  /// For what asks again and again: noted only while nobody else has asked.
  void demandOnce(effects::Effect effect, const char* who) {
    if (!plan_.effects.has(effect)) plan_.effects.demand(effect, who);
  }
  /// Demanded, compiled in and not switched off.
  bool runs(effects::Effect effect) const { return plan_.effects.runs(effect); }
  /// For power-ups that were collected in another room: once.
  void demandFor(PowerUp kind);
  void shakeCamera(float strength) { shake_ = maxOf(shake_, strength); }

  // Looking.
  const RoomSettings& settings() const { return plan_.settings; }
  const RoomEntry& entry() const { return entry_; }
  /// Whether other modes have obstacles in it that this one has not.
  bool hasOtherModes() const { return plan_.hasOtherModes; }
  const effects::EffectSet& effects() const { return plan_.effects; }
  std::uint64_t number() const { return number_; }
  std::uint32_t slot() const { return slot_; }
  float shake() const { return shake_; }
  const std::vector<Ball>& balls() const { return balls_; }
  /// Added to this room's local positions when it is shown in the frame of another: set by the track.
  void setFrameOffset(const Vec3& offset) { frameOffset_ = offset; }
  /// Appends what can be seen from the camera, by obstacle; of each threat what is nearest to the camera's way.
  void look(std::vector<Sight>& sights) const;
  /// Whether nothing of this room but `owner` and balls is on the line to a place, given in the axes of Sight.
  bool isInSight(const Vec3& position, std::uint32_t owner) const;
  void copyView(RoomView& view, std::vector<BallView>& balls) const;

  std::uint64_t stateHash() const;
  void save(ByteWriter& out) const;
  /// Into a room made of the same entry with the same globals.
  bool restore(ByteReader& in);

 private:
  struct BuiltSegment {
    physics::BodyHandle body;
    bool built = false, dropped = false;
    template <class Archive>
    void serialize(Archive& a) {
      a(body);
      a(built);
      a(dropped);
    }
  };

  struct Pickup {
    Stage stage = Stage::Waiting;
    physics::BodyHandle body;
    template <class Archive>
    void serialize(Archive& a) {
      a(stage);
      a(body);
    }
  };

  /// One of two that met.
  struct Party {
    Look look = Look::Static;
    float size = 0.0f;  // cube root of its volume [m]; 0: of the room
    bool isBall = false;
  };

  void updateShift(float distance);
  void buildSegments(float distance);
  void buildSegment(std::size_t index);
  void startObstacles(float distance);
  void runScripts(std::int64_t (Obstacle::*run)(bool));
  std::uint32_t scriptShapes() const;
  std::vector<std::uint32_t> countContacts() const;
  void thinOut();
  void takeOut(Obstacle& obstacle);
  static void retire(Obstacle& obstacle);
  void readEvents();
  void breakByCamera(physics::BodyHandle handle, const Vec3& point);
  void startPickups(float distance);
  void startPickup(std::size_t index);
  void collectPickups();
  bool isHit(const Vec3& place) const;
  void lookAtPickups(std::vector<Sight>& sights) const;
  void copyPickups(RoomView& view) const;
  bool hasOwnPickups() const;
  // The module of explosions.
  void explodeBalls();
  void touch(physics::BodyHandle ball, const Vec3& point, const Vec3& back);
  Vec3 centerOfBlast(const Vec3& touched, const Vec3& back, float standOff) const;
  void explode(const Vec3& center, Charge charge);
  void readBreak(const physics::BreakEvent& broken);
  void readHit(const physics::HitEvent& hit);
  void pressButton(physics::BodyHandle handle);
  Party partyOf(physics::BodyHandle handle);
  void removeBehind();
  void removeUnseen(std::vector<std::uint32_t>& bodiesOf);
  bool isForgotten(physics::BodyHandle handle);
  void settleObstacles(const std::vector<std::uint32_t>& bodiesOf);
  bool checkLasers() const;
  bool blocks(physics::ShapeHandle shape) const;
  void readSplashes();
  void copyWaters(RoomView& view) const;
  void copyRopes(RoomView& view) const;
  void copySegments(RoomView& view) const;
  bool seeAs(const Obstacle& obstacle, physics::BodyHandle handle, Sight& sight) const;
  bool seeThreat(physics::BodyHandle handle, Sight& sight) const;
  const ScriptButton* buttonOf(const Obstacle& obstacle, physics::BodyHandle handle) const;
  Vec3 nearestPoint(physics::ShapeHandle shape, const Vec3& to) const;
  Obstacle* obstacleOf(std::uint32_t userData);
  template <class Archive>
  void serialize(Archive& a);
  bool isConsistent() const;

  Session& session_;
  const RoomEntry entry_;
  std::uint64_t number_;
  std::uint32_t slot_;
  std::uint64_t seed_;
  std::map<std::string, std::string> globalsBefore_;
  RoomPlan plan_;
  std::unique_ptr<physics::World> world_;
  Waters waters_;  // holds nothing between two ticks

  // State.
  std::uint32_t ticks_ = 0;
  float shift_ = 0.0f;  // [m], a multiple of rules::kShiftEvery
  float shake_ = 0.0f;
  TimeStep time_;  // made anew every tick
  Viewpoint viewpoint_;
  std::vector<BuiltSegment> built_;
  std::vector<std::unique_ptr<Obstacle>> obstacles_;
  std::vector<Pickup> pickups_;  // of each in the plan
  std::vector<Ball> balls_;
  std::uint32_t nextBall_ = 1;
  std::vector<Unseen> unseen_;     // pieces, in slot order
  std::vector<Vec3> ballsBefore_;  // where pickups wait: before the step; made anew every tick

  Vec3 frameOffset_ = Vec3::Zero();
};

}  // namespace brittle::sim
