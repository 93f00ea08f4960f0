#include "tools/accuracy/float_study.h"

#include <algorithm>
#include <cmath>

#include "tests/engine/physics/scene.h"
#include "tools/accuracy/observe.h"

namespace brittle::accuracy {
namespace {

using physics::World;

constexpr float kFeather = 0.002f;  // [kg/m3] shards so light that what they take of a ball is below rounding

double exitSpeedError(int panes, int phase, int phases) {
  PanesDef def{.panes = panes, .phase = static_cast<float>(phase) / static_cast<float>(phases)};
  def.density = kFeather;
  return observePanes(def, {}).missedAtEnd[0] / static_cast<double>(def.speed);
}

double momentumError(int variant) {
  return observe(*findScene("shatter"), {}, variant).momentumLost;
}

/// A box of a weight and size of its own that has been standing for two seconds, never put to rest: the speed it still
/// has, of what gravity adds in a tick.
double restError(int variant) {
  World world(physics::alwaysAwake());
  physics::addFloor(world);
  const float half = 0.1f + 0.07f * static_cast<float>(variant);
  const physics::BodyHandle box =
      physics::addBox(world, physics::bodyAt(Vec3(0.3f, half, -0.2f)), Vec3::Constant(half));
  for (int tick = 0; tick < 120; ++tick) world.step(kTick);
  return static_cast<double>(world.body(box).velocity.norm() / (9.81f * kTick));
}

/// A ball that flies freely for ten seconds: its place, of the way it went.
double flightError(int variant) {
  physics::WorldDef def;
  def.gravity = Vec3::Zero();
  World world(def);
  const float speed = 3.0f + 0.7f * static_cast<float>(variant);
  const physics::BodyHandle ball = physics::addBall(world, Vec3::Zero(), Vec3(0.0f, 0.0f, -speed), 0.1f, 1.0f);
  for (int tick = 0; tick < 600; ++tick) world.step(kTick);
  const double exact = 600.0 * static_cast<double>(kTick) * static_cast<double>(speed);
  return std::abs(-static_cast<double>(world.body(ball).center.z()) / exact - 1.0);
}

}  // namespace

std::vector<FloatRow> measureFloat(const Effort& effort, const Advance& advance) {
  const int phases = effort.quick ? 8 : 64, seeds = effort.quick ? 2 : 32, few = effort.quick ? 4 : 16;
  std::vector<FloatRow> rows;
  const auto measure = [&](const char* what, int variants, auto&& play) {
    FloatRow& row = rows.emplace_back(FloatRow{what, 0.0, variants});
    for (int i = 0; i < variants; ++i) row.worst = std::max<double>(row.worst, play(i));
    advance();
  };
  measure("exit speed behind one pane, of its speed", phases, [&](int i) { return exitSpeedError(1, i, phases); });
  measure("exit speed behind six panes, of its speed", phases, [&](int i) { return exitSpeedError(6, i, phases); });
  measure("momentum while a block shatters (1 s), of all there is", seeds, momentumError);
  measure("speed of a box at rest, of what gravity adds in a tick", few, restError);
  measure("place after a flight of 600 ticks, of the way", few, flightError);
  return rows;
}

}  // namespace brittle::accuracy
