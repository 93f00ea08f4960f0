// game/sim/obstacle.h - one obstacle of a room: its place and parameters, the bodies its script made, and its script.
// Numbers that a script holds (of bodies, shapes, joints, buttons) are indices + 1 here, so a script's state is plain
// numbers. Positions a script names are in the obstacle's frame.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/math/transform.h"
#include "engine/physics/ids.h"
#include "engine/physics/joint.h"
#include "engine/script/sandbox.h"
#include "game/sim/frame_packet.h"
#include "game/sim/material.h"

namespace brittle::sim {

class Room;

/// What a segment or a room script asked for.
struct ObstacleDef {
  std::string type;              // obstacles/TYPE.lua
  Vec3 position = Vec3::Zero();  // room frame [m]
  Vec3 rotation = Vec3::Zero();  // about X, Y, Z [rad]
  std::map<std::string, std::string> parameters;
  std::set<std::string> shared;  // names of those that come from its template
  std::string where;             // "file:line" that asked
};

/// A drive as the script set it, in the obstacle's frame.
struct ScriptDrive {
  physics::DriveHandle handle;
  bool moves = false, turns = false;
  Vec3 position = Vec3::Zero();
  Quat rotation = Quat::Identity();
  float strength = 100.0f, maxSpeed = 50.0f, maxAngularSpeed = 50.0f;

  template <class Archive>
  void serialize(Archive& a) {
    a(handle);
    a(moves);
    a(turns);
    a(position);
    a(rotation);
    a(strength);
    a(maxSpeed);
    a(maxAngularSpeed);
  }
};

struct ScriptBody {
  physics::BodyHandle handle;  // null until its first shape is made
  std::uint32_t assembly = 0;  // all that became of it
  Transform pose;              // as asked for, obstacle frame
  ScriptDrive drive;
  Look look = Look::Glass;
  float volume = 0.0f;    // as built [m3]
  float strength = 0.0f;  // of its weakest shape [N s]; 0: unbreakable
  std::uint32_t breaks = 0;
  bool gone = false;  // fell or was left behind

  template <class Archive>
  void serialize(Archive& a) {
    a(handle);
    a(assembly);
    a(pose.position);
    a(pose.rotation);
    a(drive);
    a(look);
    a(volume);
    a(strength);
    a(breaks);
    a(gone);
  }
};

struct ScriptShape {
  physics::ShapeHandle handle;
  std::uint32_t body = 0;     // as built: number in Obstacle::bodies
  Vec3 moved = Vec3::Zero();  // since it was made, in its body's frame [m]
  template <class Archive>
  void serialize(Archive& a) {
    a(handle);
    a(body);
    a(moved);
  }
};

struct ScriptButton {
  std::uint32_t body = 0;  // number in Obstacle::bodies
  bool down = false, justPressed = false;
  template <class Archive>
  void serialize(Archive& a) {
    a(body);
    a(down);
    a(justPressed);
  }
};

/// What the next shape is made with: the script's setters change it and it stays.
struct Pen {
  Material material;
  float color[4] = {0.75f, 0.9f, 0.95f, 1.0f};
  Vec3 scale = Vec3::Ones();
  template <class Archive>
  void serialize(Archive& a) {
    a(material);
    a(color);
    a(scale);
  }
};

enum class Stage : std::uint8_t { Waiting, Alive, Gone };

struct Obstacle {
  // From the content; the same whenever the room is made anew.
  const ObstacleDef* def = nullptr;
  std::uint32_t number = 0;  // from 1, in its room: Body::userData of all it made
  Room* room = nullptr;

  // State.
  Stage stage = Stage::Waiting;
  bool failed = false;  // its script stopped with an error
  bool cleared = false;
  bool touched = false;      // the camera has crashed into it
  std::uint32_t ticks = 0;   // since it came alive
  std::int32_t crystal = 0;  // balls it is worth; 0: none
  bool crystalDone = false;  // won or missed
  bool laser = false;        // a beam hits the camera this tick
  Pen pen;
  std::vector<ScriptBody> bodies;
  std::vector<ScriptShape> shapes;
  std::vector<physics::JointHandle> joints;
  std::vector<ScriptButton> buttons;
  std::unique_ptr<script::Sandbox> script;  // while alive
  std::vector<BeamView> beams;              // lasers of this tick, local frame; made anew every tick
  std::vector<BodyDecal> decals;            // of this tick too
  bool paints = false;                      // has asked for one before: they are demanded once
  bool muted = false;                       // while its source is loaded again by a restore

  /// Since it came alive. [ticks of the game's time]
  float age() const;
  /// From the obstacle's frame to its room's local frame of now.
  Transform pose() const;
  ScriptBody* bodyAt(int index) {
    return index > 0 && index <= static_cast<int>(bodies.size()) ? &bodies[index - 1] : nullptr;
  }
  /// The number of a body that this obstacle's things belong to, or of any other body (which gets a number). 0: no such
  /// body.
  int numberOf(physics::BodyHandle handle);

  /// Reads the script and calls its init(). What fails is reported, and what was made so far stays. Answers what that
  /// took, in instructions.
  std::int64_t start();
  /// Presses or releases a button of its own, whose colour says which: orange while it waits for a ball.
  void setDown(ScriptButton& button, bool down);
  /// Calls its tick() if `mayRun`, before the world's step; what that took, in instructions.
  std::int64_t tickScript(bool mayRun);
  /// Likewise its draw(), after the step: every tick, seen or not, so that what it changes of the script's state is the
  /// same in every run.
  std::int64_t drawScript(bool mayRun);
  /// Loads the script again after a restore, without effect on the world; then its saved state.
  bool restoreScript(ByteReader& in);
  void saveScript(ByteWriter& out) const;
  /// Of its script's state; 0 if it has none.
  std::uint64_t scriptHash() const;

  template <class Archive>
  void serialize(Archive& a) {
    a(stage);
    a(failed);
    a(cleared);
    a(touched);
    a(ticks);
    a(crystal);
    a(crystalDone);
    a(laser);
    a(pen);
    a.vector(bodies);
    a.vector(shapes);
    a.vector(joints);
    a.vector(buttons);
  }

 private:
  Status load();
  std::int64_t callScript(const char* function);
  mutable std::uint64_t scriptHash_ = 0;  // of the state it had when last asked
  mutable bool scriptHashed_ = false;
};

/// The calls that obstacle scripts may make; Call::user() is the Obstacle.
const script::Library& obstacleLibrary();

}  // namespace brittle::sim
