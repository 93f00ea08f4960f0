// What too few rounds cost: `bench --benchmark_filter=panes`. A ball of 1 kg through six anchored panes 5 cm apart, by
// speed, rounds in a tick (0: no bound; no more for what is fast) and tick length, worst of 16 phases of the gap within
// the tick: speed_error_percent: how far the exit speed is from v0 - 6 J/M; late_ms, late_m: how long after, and how
// far behind, a ball that loses J/M at each pane it leaves the last one; push_Ns: momentum its shards took, least over
// the phases.
#include <benchmark/benchmark.h>

#include <cmath>

#include "engine/geometry/make.h"
#include "engine/physics/world.h"

namespace {

using namespace brittle;
using namespace brittle::physics;

constexpr int kPanes = 6, kPhases = 16;
constexpr float kStrength = 1.9f, kSpacing = 0.05f, kHalfThickness = 0.002f, kRadius = 0.05f,
                kStart = 0.5f;                     // [N s], [m]; M = 1 kg
constexpr float kEnd = -kSpacing * kPanes - 0.5f;  // the ball's centre is measured there [m]

BodyHandle build(World& world, float speed, float gap) {
  for (int i = 0; i < kPanes; ++i) {
    BodyDef def;
    def.type = BodyType::Static;
    def.pose.position = Vec3(0.0f, 0.0f, -kSpacing * static_cast<float>(i));
    def.breakable.strength = kStrength;
    ShapeDef shape;
    shape.surface.density = 2.0f;  // all shards in the way weigh less than a thousandth of the ball
    shape.anchored = true;
    world.addConvex(world.createBody(def), shape, geometry::makeBox<float>(Vec3(0.3f, 0.3f, kHalfThickness)).view());
  }
  BodyDef ball;
  ball.pose.position = Vec3(0.003f, 0.002f, gap);
  ball.velocity = Vec3(0.0f, 0.0f, -speed);
  ShapeDef steel;
  steel.surface.density = 3.0f / (4.0f * kPi * kRadius * kRadius * kRadius);
  steel.surface.restitution = 0.0f;
  const BodyHandle handle = world.createBody(ball);
  world.addSphere(handle, steel, kRadius);
  return handle;
}

/// When a ball that loses J/M at every pane is at kEnd. [s]
double exactTime(float speed, float gap) {
  double at = static_cast<double>(gap), v = static_cast<double>(speed), time = 0.0;
  for (int i = 0; i < kPanes; ++i) {
    const double touch = -static_cast<double>(kSpacing) * i + static_cast<double>(kHalfThickness + kRadius);
    time += (at - touch) / v;
    at = touch;
    v -= static_cast<double>(kStrength);
  }
  return time + (at - static_cast<double>(kEnd)) / v;
}

struct Flight {
  double exitSpeed = 0.0;  // [m/s]
  double late = 0.0;       // [s]
  double push = 0.0;       // [N s]
};

Flight fly(float speed, float dt, int phase, int rounds) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.fractureRounds = rounds;
  def.accuracy.fastRounds = 0;
  def.accuracy.patternDensity = 0.3f;
  World world(def);
  const float gap = kStart + speed * dt * static_cast<float>(phase) / static_cast<float>(kPhases);
  const BodyHandle ball = build(world, speed, gap);
  int ticks = 0;
  while (world.body(ball).center.z() > kEnd && ticks < 4000) {
    world.step(dt);
    ++ticks;
  }
  Flight flight;
  flight.exitSpeed = -static_cast<double>(world.body(ball).velocity.z());
  const double beyond = static_cast<double>(kEnd - world.body(ball).center.z());
  flight.late = static_cast<double>(dt) * ticks - beyond / flight.exitSpeed - exactTime(speed, gap);
  world.forEachBody([&](BodyHandle handle, const Body& body) {
    if (body.isDynamic() && !(handle == ball)) flight.push -= static_cast<double>(body.mass * body.velocity.z());
  });
  return flight;
}

void throughPanes(benchmark::State& state) {
  const float speed = static_cast<float>(state.range(0));
  const float dt = 1.0f / static_cast<float>(state.range(2));
  const double exact = static_cast<double>(speed) - kPanes * static_cast<double>(kStrength);
  double error = 0.0, late = 0.0, push = 1e30;
  for (auto iteration : state) {
    for (int phase = 0; phase < kPhases; ++phase) {
      const Flight flight = fly(speed, dt, phase, static_cast<int>(state.range(1)));
      error = std::max(error, std::abs(flight.exitSpeed - exact) / exact);
      late = std::max(late, flight.late);
      push = std::min(push, flight.push);
    }
  }
  state.counters["speed_error_percent"] = 100.0 * error;
  state.counters["late_ms"] = 1000.0 * late;
  state.counters["late_m"] = late * exact;
  state.counters["push_Ns"] = push;
}
BENCHMARK(throughPanes)
    ->Name("panes/six")
    ->ArgNames({"speed", "rounds", "hertz"})
    ->ArgsProduct({{20, 100}, {1, 2, 3, 0}, {30, 60, 120, 240}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
