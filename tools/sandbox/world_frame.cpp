#include "tools/sandbox/world_frame.h"

#include "engine/math/aabb.h"
#include "engine/math/trig.h"

namespace brittle::sandbox {
namespace {

using physics::Body;
using physics::BodyHandle;
using physics::Shape;
using physics::World;

constexpr float kMostRise = 1.4f;  // [rad]
constexpr float kClose = 2.8f;     // the distance in radii of what is looked at
constexpr std::uint32_t kAtRest = render::kWhite - 0x00505050;

std::uint16_t materialOf(const Body& body) {
  if (body.breakable) return render::kGlass;
  return body.isDynamic() ? render::kCrystal : render::kMatte;
}

/// Calls visit(handle, shape) for each shape of a body.
template <class Visit>
void forEachShape(const World& world, const Body& body, const Visit& visit) {
  for (physics::ShapeHandle handle = body.firstShape; world.isAlive(handle); handle = world.shape(handle).next)
    visit(world.shape(handle));
}

void addBody(const World& world, BodyHandle handle, const Body& body, bool restDark, render::Frame& frame) {
  render::MeshGroup& group = frame.groups[0];
  if (group.bodies.size() <= handle.index) group.bodies.resize(handle.index + 1);
  group.bodies[handle.index] = body.pose;
  const std::uint32_t tint = restDark && body.isDynamic() && !body.awake ? kAtRest : render::kWhite;
  forEachShape(world, body, [&](const Shape& shape) {
    if (shape.isSphere())
      frame.spheres.push_back({body.pose.toWorld(shape.center), shape.radius, body.pose.rotation, render::kBall, tint});
    else
      group.meshes.push_back({shape.mesh, handle.index, materialOf(body), tint});
  });
}

}  // namespace

Orbit orbitFor(const World& world) {
  Aabb breakable, moving;
  world.forEachBody([&](BodyHandle, const Body& body) {
    if (!body.isDynamic() && !body.breakable) return;
    (body.breakable ? breakable : moving).include(Aabb{body.center, body.center}.grownBy(body.radius));
  });
  const Aabb& all = breakable.isEmpty() ? moving : breakable;
  Orbit orbit;
  if (all.isEmpty()) return orbit;
  orbit.about = all.center();
  orbit.distance = clampTo(kClose * 0.5f * all.extent().norm(), 1.0f, 30.0f);
  return orbit;
}

Transform viewFrom(const Orbit& orbit) {
  const float rise = clampTo(orbit.rise, -kMostRise, kMostRise);
  const Quat rotation = rotationAbout(Vec3::UnitY(), orbit.turn) * rotationAbout(Vec3::UnitX(), -rise);
  return {orbit.about + rotation * Vec3(0.0f, 0.0f, orbit.distance), rotation};
}

void fillFrame(World& world, std::uint64_t poolId, const Orbit& orbit, bool restDark, render::Frame& frame) {
  frame.clear();
  const Transform view = viewFrom(orbit);
  frame.camera.position = view.position;
  frame.camera.rotation = view.rotation;
  frame.camera.nearPlane = 0.02f;
  frame.fog.start = orbit.distance * 2.0f;
  frame.fog.end = orbit.distance * 8.0f;
  frame.groups[0].pool = &world.meshes();
  frame.groups[0].poolId = poolId;
  world.forEachBody([&](BodyHandle handle, const Body& body) { addBody(world, handle, body, restDark, frame); });
  for (const physics::Crumb& crumb : world.debris().crumbs)
    frame.crumbs.push_back({crumb.position, crumb.radius, crumb.color});
}

}  // namespace brittle::sandbox
