#include "tools/accuracy/observe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tools/bench/cpu_time.h"

namespace brittle::accuracy {
namespace {

using physics::Body;
using physics::BodyHandle;
using physics::World;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

int ticksOf(float seconds) {
  return static_cast<int>(std::ceil(seconds / kTick));
}

/// Steps a world and notes what that cost.
void stepTimed(World& world, Observation& seen) {
  const double before = cpuMilliseconds();
  world.step(kTick);
  seen.tickMs.push_back(cpuMilliseconds() - before);
}

/// All glass and steel there is, debris included. [m3]
double volumeOf(const World& world) {
  double volume = world.debris().recycledVolume;
  for (const physics::Crumb& crumb : world.debris().crumbs) volume += static_cast<double>(crumb.volume);
  world.forEachBody([&](BodyHandle, const Body& body) {
    for (physics::ShapeHandle shape = body.firstShape; world.isAlive(shape); shape = world.shape(shape).next)
      volume += static_cast<double>(world.shape(shape).massProperties.volume);
  });
  return volume;
}

struct Motion {
  Vec3d momentum = Vec3d::Zero();
  double energy = 0.0;
};

/// Of bodies and debris. What debris weighs is known by its volume, and in every scene it is of glass.
Motion motionOf(const World& world) {
  constexpr double kDensity = 2500.0;  // [kg/m3]
  const physics::Totals totals = physics::totalsOf(world);
  Motion motion{totals.momentum, totals.kineticEnergy};
  for (const physics::Crumb& crumb : world.debris().crumbs) {
    const Vec3d v = crumb.velocity.cast<double>();
    const double mass = kDensity * static_cast<double>(crumb.volume);
    motion.momentum += mass * v;
    motion.energy += 0.5 * mass * v.squaredNorm();
  }
  return motion;
}

bool hasFixedBodies(const World& world) {
  bool fixed = false;
  world.forEachBody([&](BodyHandle, const Body& body) { fixed = fixed || !body.isDynamic(); });
  return fixed;
}

/// Looks at a world as it goes.
class Observer {
 public:
  Observer(const World& world, const Stage& stage, bool gravity)
      : world_(world), stage_(stage), gravity_(gravity), volume_(volumeOf(world)), first_(motionOf(world)) {
    seen_.missedAtWorst.resize(stage.analytics.size(), 0.0);
    isFree_ = !hasFixedBodies(world) && !gravity;
    leastEnergy_ = first_.energy;
    if (!isFree_) seen_.momentumLost = seen_.energyGained = kNoNumber;
  }

  void look(double time) {
    for (const physics::BreakEvent& event : world_.events().breaks) broken_.insert(event.assembly);
    for (std::size_t i = 0; i < stage_.analytics.size(); ++i) {
      const Analytic& one = stage_.analytics[i];
      seen_.missedAtWorst[i] = std::max(seen_.missedAtWorst[i], std::abs(one.value(world_) - one.exact(time)));
    }
    seen_.held += world_.counters().held;
    seen_.spoilt += static_cast<double>(world_.events().quarantined.size());
    if (isFree_) lookAtMotion();
    lookAtOverlaps();
  }

  Observation& finish(double time) {
    for (const Analytic& one : stage_.analytics) {
      seen_.exactAtEnd.push_back(one.exact(time));
      seen_.missedAtEnd.push_back(std::abs(one.value(world_) - seen_.exactAtEnd.back()));
    }
    seen_.broken = static_cast<double>(broken_.size());
    seen_.breaks = static_cast<double>(world_.counters().totalBreaks);
    seen_.overlap = overlaps_ == 0 ? 0.0 : std::sqrt(squares_ / static_cast<double>(overlaps_));
    seen_.volumeLost = std::abs(volumeOf(world_) / volume_ - 1.0);
    for (const physics::Crumb& crumb : world_.debris().crumbs)
      seen_.crumbVolume += static_cast<double>(crumb.volume) / volume_;
    seen_.crumbVolume += world_.debris().recycledVolume / volume_;
    lookAtBodies();
    seen_.hash = world_.stateHash();
    return seen_;
  }
  Observation& seen() { return seen_; }

 private:
  void lookAtMotion() {
    const Motion now = motionOf(world_);
    const double scale = std::max(first_.momentum.norm(), 1e-9);
    seen_.momentumLost = std::max(seen_.momentumLost, (now.momentum - first_.momentum).norm() / scale);
    seen_.energyGained = std::max(seen_.energyGained, (now.energy - leastEnergy_) / first_.energy);
    leastEnergy_ = std::min(leastEnergy_, now.energy);
  }

  void lookAtOverlaps() {
    world_.state().contacts.forEach([&](physics::ContactHandle, const physics::Contact& contact) {
      if (contact.passable) return;  // it may go through
      for (int i = 0; i < contact.manifold.count; ++i) {
        const double depth = -1000.0 * static_cast<double>(contact.manifold.points[i].separation);
        if (depth <= 0.0) continue;
        seen_.deepest = std::max(seen_.deepest, depth);
        squares_ += depth * depth;
        ++overlaps_;
      }
    });
  }

  void lookAtBodies() {
    world_.forEachBody([&](BodyHandle handle, const Body& body) {
      if (!body.isDynamic()) return;
      if (gravity_ && body.center.y() < -1.5f) seen_.escaped += 1.0;
      if (handle == stage_.watched) {
        const Vec3 v = body.velocity;
        const double aside = std::hypot(static_cast<double>(v.x()), static_cast<double>(v.y()));
        seen_.turned = 180.0 / 3.14159265358979 * std::atan2(aside, static_cast<double>(-v.z()));
        return;
      }
      seen_.push -= static_cast<double>(body.mass * body.velocity.z());
      seen_.speeds.push_back(body.velocity.norm());
    });
  }

  const World& world_;
  const Stage& stage_;
  bool gravity_, isFree_ = false;
  double volume_;
  Motion first_;
  double leastEnergy_ = 0.0;
  double squares_ = 0.0;
  std::size_t overlaps_ = 0;
  std::set<std::uint32_t> broken_;
  Observation seen_;
};

Observation play(World& world, const Stage& stage, bool gravity) {
  Observer observer(world, stage, gravity);
  const int ticks = ticksOf(stage.seconds);
  for (int tick = 1; tick <= ticks; ++tick) {
    stepTimed(world, observer.seen());
    observer.look(static_cast<double>(tick) * static_cast<double>(kTick));
  }
  return observer.finish(static_cast<double>(ticks) * static_cast<double>(kTick));
}

}  // namespace

Observation observe(const Scene& scene, const physics::Accuracy& accuracy, int variant) {
  const std::unique_ptr<World> world = makeWorld(scene, accuracy, variant);
  const Stage stage = scene.build(*world, variant);
  return play(*world, stage, scene.gravity);
}

Observation observePanes(const PanesDef& def, const physics::Accuracy& accuracy) {
  physics::WorldDef worldDef;
  worldDef.accuracy = accuracy;
  worldDef.gravity = Vec3::Zero();
  World world(worldDef);
  const Stage stage = buildPanes(world, def);
  return play(world, stage, false);
}

}  // namespace brittle::accuracy
