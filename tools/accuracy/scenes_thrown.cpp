// What is thrown at panes, where the result is known exactly: through several of them, and past one.
#include <cmath>

#include "engine/core/random.h"
#include "tests/engine/physics/scene.h"
#include "tools/accuracy/scene_list.h"

namespace brittle::accuracy {
namespace {

using physics::World;

constexpr float kRadius = 0.05f;          // of the ball [m]
constexpr float kHalfThickness = 0.002f;  // of a pane [m]
constexpr float kStart = 0.5f;            // before the first pane [m]
constexpr float kBehind = 0.5f;           // the last one, where the ball is looked at [m]
constexpr float kPatience = 0.35f;        // for a ball that waits a tick at each pane [s]

/// The flight of a ball that loses J/M at each pane and nothing else.
class ExactFlight {
 public:
  ExactFlight(const PanesDef& def, double start) : def_(def), start_(start) {}

  double positionAt(double time) const { return at(time).position; }
  double speedAt(double time) const { return at(time).speed; }
  /// When it passes `position`. [s]
  double timeAt(double position) const {
    double from = start_, speed = static_cast<double>(def_.speed), time = 0.0;
    for (int i = 0; i < def_.panes && touch(i) > position; ++i) {
      time += (from - touch(i)) / speed;
      from = touch(i);
      speed -= static_cast<double>(kPaneStrength / kBallMass);
    }
    return time + (from - position) / speed;
  }

 private:
  struct Moment {
    double position, speed;
  };
  /// Where the ball's centre is when it touches pane i. [m]
  double touch(int i) const {
    return -static_cast<double>(def_.spacing) * i + static_cast<double>(kHalfThickness + kRadius);
  }
  Moment at(double time) const {
    double from = start_, speed = static_cast<double>(def_.speed);
    for (int i = 0; i < def_.panes; ++i) {
      const double needed = (from - touch(i)) / speed;
      if (time < needed) break;
      time -= needed;
      from = touch(i);
      speed -= static_cast<double>(kPaneStrength / kBallMass);
    }
    return {from - speed * time, speed};
  }

  PanesDef def_;
  double start_;
};

}  // namespace

Stage buildPanes(World& world, const PanesDef& def) {
  const float density = minOf(def.density, 8.0f / static_cast<float>(def.panes));
  for (int i = 0; i < def.panes; ++i) {
    physics::BodyDef pane =
        physics::bodyAt(Vec3(0.0f, 0.0f, -def.spacing * static_cast<float>(i)), physics::BodyType::Static);
    pane.breakable.strength = kPaneStrength;
    pane.breakable.material.density = 0.3f;  // fewer shards: what is tested is the ball
    physics::ShapeDef shape = physics::shapeDef(density);
    shape.anchored = true;
    physics::addBox(world, pane, Vec3(0.3f, 0.3f, kHalfThickness), shape);
  }
  const float start = kStart + def.speed * kTick * def.phase;
  Stage stage;
  const physics::BodyHandle ball =
      physics::addBall(world, Vec3(0.003f, 0.002f, start), Vec3(0.0f, 0.0f, -def.speed), kRadius, kBallMass);
  stage.watched = ball;
  const ExactFlight flight(def, static_cast<double>(start));
  stage.analytics = {
      {"speed of the ball", "m/s",
       [ball](const World& now) { return static_cast<double>(now.body(ball).velocity.norm()); },
       [flight](double time) { return flight.speedAt(time); }},
      {"way of the ball", "m",
       [ball, start](const World& now) { return static_cast<double>(start - now.body(ball).center.z()); },
       [flight, start](double time) { return static_cast<double>(start) - flight.positionAt(time); }},
  };
  const double end = -static_cast<double>(def.spacing) * def.panes - static_cast<double>(kBehind);
  stage.seconds = static_cast<float>(flight.timeAt(end)) + kPatience;
  return stage;
}

Stage buildSixPanes(World& world, int variant) {
  PanesDef def;
  def.phase = static_cast<float>(variant % 64) / 64.0f;
  return buildPanes(world, def);
}

Stage buildGraze(World& world, int variant) {
  constexpr float kHalfWidth = 0.4f;
  Random random(77, static_cast<std::uint64_t>(variant));
  physics::addPane(world, Vec3::Zero(), Vec3(kHalfWidth, 0.3f, 0.01f), 0.05f, 1.0f);
  const bool misses = variant % 2 == 0;
  const float gap = misses ? random.nextFloat(1e-4f, 0.015f) : random.nextFloat(-0.03f, -0.01f);
  const float speed = random.nextFloat(20.0f, 120.0f);
  const float height = random.nextFloat(-0.2f, 0.2f);
  const float start = 0.6f + speed * kTick * random.nextFloat(0.0f, 1.0f);
  Stage stage;
  const physics::BodyHandle ball =
      physics::addBall(world, Vec3(kHalfWidth + kRadius + gap, height, start), Vec3(0.0f, 0.0f, -speed), kRadius, 1.0f);
  stage.watched = ball;
  stage.analytics = {
      {"panes broken", "", [](const World& now) { return now.counters().totalBreaks > 0 ? 1.0 : 0.0; },
       [misses](double) { return misses ? 0.0 : 1.0; }},
  };
  stage.seconds = 2.0f * start / speed + 0.1f;
  return stage;
}

}  // namespace brittle::accuracy
