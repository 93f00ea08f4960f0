// What stands, hangs or lies, where nothing should move, or as a pendulum does.
#include <array>
#include <cmath>

#include "tests/engine/physics/scene.h"
#include "tools/accuracy/scene_list.h"

namespace brittle::accuracy {
namespace {

using physics::BodyHandle;
using physics::World;

constexpr double kGravity = 9.81;  // [m/s2]

/// Angle of a physical pendulum that is released at rest; classical Runge-Kutta in steps of 0.1 ms.
class Pendulum {
 public:
  /// `rate`: m g l / I [1/s2].
  Pendulum(double angle, double rate) : angle_(angle), rate_(rate) {}

  double angleAt(double time) const {
    double angle = angle_, speed = 0.0;
    const int steps = static_cast<int>(std::ceil(time / 1e-4));
    const double dt = steps == 0 ? 0.0 : time / steps;
    for (int i = 0; i < steps; ++i) {
      const double k1 = pull(angle), v2 = speed + 0.5 * dt * k1;
      const double k2 = pull(angle + 0.5 * dt * speed), v3 = speed + 0.5 * dt * k2;
      const double k3 = pull(angle + 0.5 * dt * v2), v4 = speed + dt * k3;
      const double k4 = pull(angle + dt * v3);
      angle += dt / 6.0 * (speed + 2.0 * v2 + 2.0 * v3 + v4);
      speed += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return angle;
  }

 private:
  double pull(double angle) const { return -rate_ * std::sin(angle); }
  double angle_, rate_;
};

/// How far bodies are from where they were, on average. [mm]
std::function<double(const World&)> displacement(const World& world) {
  std::vector<std::pair<BodyHandle, Vec3>> places;
  world.forEachBody([&](BodyHandle handle, const physics::Body& body) {
    if (body.isDynamic()) places.emplace_back(handle, body.center);
  });
  return [places](const World& now) {
    double sum = 0.0;
    for (const auto& [handle, place] : places)
      sum += now.isAlive(handle) ? static_cast<double>((now.body(handle).center - place).norm()) : 1.0;
    return places.empty() ? 0.0 : 1000.0 * sum / static_cast<double>(places.size());
  };
}

double still(double) {
  return 0.0;
}

}  // namespace

Stage buildStack(World& world, int variant) {
  constexpr float kHalf = 0.2f, kRadius = 0.25f;
  constexpr int kBlocks = 6;  // lower than what the solver takes for a tall stack
  physics::addFloor(world);
  const float aside = 0.01f * static_cast<float>(variant);  // every second block stands aside [m]
  for (int i = 0; i < kBlocks; ++i) {
    physics::BodyDef block =
        physics::bodyAt(Vec3(i % 2 == 0 ? 0.0f : aside, kHalf * (2.0f * static_cast<float>(i) + 1.0f), 0.0f));
    block.breakable.strength = 900.0f;  // the lowest bears 290 N s in 1/60 s
    block.breakable.material.pattern = fracture::Pattern::Block;
    physics::addBox(world, block, Vec3::Constant(kHalf), physics::shapeDef(2500.0f));
  }
  const float top = 2.0f * kHalf * kBlocks;
  physics::ShapeDef steel = physics::shapeDef(7800.0f);
  const BodyHandle ball = world.createBody(physics::bodyAt(Vec3(0.5f * aside, top + kRadius, 0.0f)));
  world.addSphere(ball, steel, kRadius);
  Stage stage;
  stage.watched = ball;
  stage.seconds = 3.0f;
  stage.analytics = {{"displacement", "mm", displacement(world), still}};
  return stage;
}

Stage buildSwing(World& world, int variant) {
  const float angle = kPi / 3.0f - 0.1f * static_cast<float>(variant);  // from hanging straight down [rad]
  const Vec3 half(0.4f, 0.6f, 0.02f);
  const Vec3 hinge(0.0f, 3.0f, 0.0f);
  physics::BodyDef def = physics::bodyAt(hinge);
  def.pose.rotation = integrateRotation(Quat::Identity(), Vec3(-angle, 0.0f, 0.0f), 1.0f);
  def.pose.position = hinge + def.pose.rotate(Vec3(0.0f, -half.y(), 0.0f));
  const BodyHandle pane = physics::addBox(world, def, half, physics::shapeDef(2500.0f));
  physics::JointDef joint;
  joint.type = physics::JointType::Hinge;
  joint.a = world.body(pane).firstShape;
  joint.anchorA = hinge;
  joint.axis = Vec3::UnitX();
  world.createJoint(joint);
  const auto angleNow = [pane, hinge](const World& now) {
    const Vec3 arm = now.body(pane).center - hinge;
    return static_cast<double>(180.0f / kPi) * std::atan2(static_cast<double>(arm.z()), static_cast<double>(-arm.y()));
  };
  const double arm = static_cast<double>(half.y()), thin = static_cast<double>(half.z());
  const Pendulum exact(angleNow(world) / static_cast<double>(180.0f / kPi),
                       kGravity * arm / ((arm * arm + thin * thin) / 3.0 + arm * arm));
  Stage stage;
  stage.watched = pane;
  stage.seconds = 4.0f;
  stage.analytics = {{"angle of the pane", "deg", angleNow,
                      [exact](double time) { return static_cast<double>(180.0f / kPi) * exact.angleAt(time); }}};
  return stage;
}

Stage buildPacked(World& world, int variant) {
  const float half = 0.5f, wall = 0.25f;
  physics::addFloor(world);
  for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
    physics::addBox(world, physics::bodyAt(Vec3(0.0f, half, 0.0f) + side * (half + wall), physics::BodyType::Static),
                    side.x() != 0.0f ? Vec3(wall, half, 2.0f) : Vec3(2.0f, half, wall));
  physics::BodyDef block = physics::bodyAt(Vec3(0.0f, half, 0.0f));
  block.breakable.strength = 1e6f;  // once is enough
  block.breakable.material.pattern = variant == 0 ? fracture::Pattern::Tempered : fracture::Pattern::Block;
  block.breakable.material.carveRadius = 0.6f;
  block.breakable.material.density = 5.0f;
  block.breakable.material.dieSize = 0.5f;
  const BodyHandle body = physics::addBox(world, block, Vec3::Constant(half), physics::shapeDef(2500.0f));
  world.breakBody(body, Vec3(0.1f, 2.0f * half, -0.05f), Vec3(0.0f, -1.0f, 0.0f), 10.0f, 0.05f);
  Stage stage;
  stage.seconds = 1.5f;
  stage.analytics = {{"displacement", "mm", displacement(world), still}};
  return stage;
}

}  // namespace brittle::accuracy
