#include "tools/accuracy/threshold_study.h"

#include "engine/core/random.h"
#include "tests/engine/physics/scene.h"
#include "tools/accuracy/csv.h"
#include "tools/accuracy/panes_study.h"

namespace brittle::accuracy {
namespace {

using physics::World;

constexpr int kTicks = 8;         // the slowest ball is there in the second, and a break that was put off in the third
constexpr float kRadius = 0.05f;  // of the ball [m]
constexpr float kHalfPane = 0.01f;  // [m]

/// One ball that comes with `ratio` of the momentum that breaks the pane. The same for every setting.
bool breaks(const physics::Accuracy& accuracy, int number, double ratio) {
  Random random(78, static_cast<std::uint64_t>(number));
  physics::WorldDef def;
  def.accuracy = accuracy;
  def.accuracy.patternDensity = 0.2f;  // what it breaks into is not asked
  def.gravity = Vec3::Zero();
  World world(def);
  physics::addPane(world, Vec3::Zero(), Vec3(0.3f, 0.3f, kHalfPane), kPaneStrength, 1.0f);
  const float mass = random.nextFloat(0.2f, 2.0f);
  const float x = random.nextFloat(-0.2f, 0.2f);
  const float y = random.nextFloat(-0.2f, 0.2f);
  const float way = kPaneStrength / mass * kTick * random.nextFloat(0.5f, 1.5f);
  const float restitution = random.nextFloat(0.0f, 1.0f);
  const Vec3 start(x, y, kHalfPane + kRadius + way);
  const physics::BodyHandle ball = physics::addBall(world, start, Vec3::Zero(), kRadius, mass, restitution);
  const double speed = static_cast<double>(kPaneStrength) * ratio / static_cast<double>(world.body(ball).mass);
  world.setVelocity(ball, Vec3(0.0f, 0.0f, -static_cast<float>(speed)), Vec3::Zero());
  for (int tick = 0; tick < kTicks; ++tick) {
    world.step(kTick);
    if (world.counters().breaks > 0) return true;
  }
  return false;
}

std::vector<Setting> settings() {
  std::vector<Setting> all = fractureModes();
  const auto add = [&](int number, const char* what, std::int32_t physics::Accuracy::*knob) {
    Setting& setting = all.emplace_back();
    setting.value = shortly(number) + what;
    setting.accuracy.*knob = number;
  };
  for (const int iterations : {2, 4}) add(iterations, " iterations", &physics::Accuracy::iterations);
  for (const int substeps : {2, 4, 8}) add(substeps, " sub-steps", &physics::Accuracy::substeps);
  return all;
}

}  // namespace

std::vector<ThresholdRow> thresholdRows(const Effort& effort) {
  std::vector<ThresholdRow> rows;
  const std::vector<double> distances = effort.quick
                                            ? std::vector<double>{1.0, 0.1, 1e-6}
                                            : std::vector<double>{3.0, 1.0, 0.3, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6};
  for (const Setting& setting : settings())
    for (const double beside : distances)
      rows.push_back({setting.value, beside, effort.quick ? 24 : 1000, setting.accuracy, 0.0, 0.0});
  return rows;
}

void playThreshold(std::vector<ThresholdRow>& rows, const Advance& advance) {
  for (ThresholdRow& row : rows) {
    int falsely = 0, missed = 0;
    for (int number = 0; number < row.throws; ++number) {
      falsely += breaks(row.accuracy, number, 1.0 / (1.0 + row.beside)) ? 1 : 0;
      missed += breaks(row.accuracy, number, 1.0 + row.beside) ? 0 : 1;
    }
    row.falseBreaks = 1e4 * falsely / row.throws;
    row.missedBreaks = 1e4 * missed / row.throws;
    advance();
  }
}

}  // namespace brittle::accuracy
