// accuracy/scenes.h - the scenes that the study of accuracy and its cost is made on, for any program that shows or
// measures a world: each begins as it is built and goes on by itself. Knows nothing of how it is measured.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/physics/world.h"

namespace brittle::accuracy {

inline constexpr float kTick = 1.0f / 60.0f;  // [s]

/// Something that an exact result is known of, while the scene plays.
struct Analytic {
  std::string_view what;  // "speed of the ball"
  std::string_view unit;
  std::function<double(const physics::World&)> value;  // as it is
  std::function<double(double time)> exact;            // as it should be, `time` after the start [s]
};

/// What a scene has built.
struct Stage {
  physics::BodyHandle watched;      // null: none
  std::vector<Analytic> analytics;  // none: there is only a converged reference to compare with
  float seconds = 1.0f;             // after which everything has happened
};

struct Scene {
  std::string_view name;
  std::string_view what;  // one sentence
  int variants;           // start phases or seeds, from 0
  bool gravity;
  Stage (*build)(physics::World& world, int variant);
};

/// In the order in which they are shown.
std::span<const Scene> allScenes();
/// Null: there is none of that name.
const Scene* findScene(std::string_view name);
/// An empty world for a scene: its seed is that of the variant.
std::unique_ptr<physics::World> makeWorld(const Scene& scene, const physics::Accuracy& accuracy, int variant);

/// A ball of 1 kg through anchored panes one behind another. All shards in its way weigh less than a thousandth of it.
struct PanesDef {
  int panes = 6;
  float speed = 20.0f;    // [m/s]
  float phase = 0.0f;     // of the gap to the first pane within a tick's way [-], 0 to 1
  float spacing = 0.05f;  // [m]
  float density = 2.0f;   // of the glass [kg/m3]; less for many panes
};
inline constexpr float kPaneStrength = 1.9f;  // [N s]
inline constexpr float kBallMass = 1.0f;      // [kg]
Stage buildPanes(physics::World& world, const PanesDef& def);
/// What it leaves the last pane with. [m/s]
inline double exitSpeedOf(const PanesDef& def) {
  return static_cast<double>(def.speed) - def.panes * static_cast<double>(kPaneStrength / kBallMass);
}

}  // namespace brittle::accuracy
