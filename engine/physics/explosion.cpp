#include "engine/physics/explosion.h"

#include <algorithm>
#include <cmath>

#include "engine/core/profile.h"
#include "engine/geometry/clip.h"
#include "engine/geometry/gjk.h"

namespace brittle::physics {
namespace {

constexpr float kSkin = 1e-3f;       // a ray that goes on behind a surface begins so far behind it [m]
constexpr int kMostCrossed = 64;     // pieces of bursting glass on one line of sight
constexpr float kLeastPush = 1e-6f;  // [N s]

/// Something that may break, at its nearest point.
struct Target {
  BodyHandle body;
  Vec3 point = Vec3::Zero();
  float distance = 0.0f;
};

struct Push {
  BodyHandle body;
  Vec3 point = Vec3::Zero(), impulse = Vec3::Zero();
};

class Blast {
 public:
  Blast(World& world, const ExplosionDef& def) : world_(world), def_(def) {}

  Explosion run() {
    for (const Target& target : breakable())
      if (isInSight(target.point, target.body)) burst(target);
    for (const Push& push : pushes()) give(push);
    return std::move(result_);
  }

 private:
  /// Nearest first; of equals the lower slot.
  std::vector<Target> breakable() const {
    std::vector<Target> targets;
    world_.overlapSphere(def_.center, def_.breakReach, ~0u, [&](ShapeHandle handle) {
      const Shape& shape = world_.shape(handle);
      if (!world_.body(shape.body).breakable || shape.isSphere()) return true;
      const Target found = nearestOf(shape);
      const auto known =
          std::find_if(targets.begin(), targets.end(), [&](const Target& t) { return t.body == found.body; });
      if (known == targets.end())
        targets.push_back(found);
      else if (found.distance < known->distance)
        *known = found;
      return true;
    });
    std::sort(targets.begin(), targets.end(), [](const Target& a, const Target& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.body.index < b.body.index;
    });
    return targets;
  }

  Target nearestOf(const Shape& shape) const {
    geometry::SimplexCache cache;
    const geometry::Proxy center{{}, Vec3::Zero(), 0.001f};
    const Vec3 point = geometry::separation(center, {def_.center, Quat::Identity()}, proxyOf(shape, world_.meshes()),
                                            world_.body(shape.body).pose, cache)
                           .pointB;
    return {shape.body, point, (point - def_.center).norm()};
  }

  /// What became of one thing does not shield it.
  bool isInSight(const Vec3& to, BodyHandle target) const {
    const std::uint32_t own = world_.body(target).assembly;
    const Vec3 direction = normalizedOr(to - def_.center, Vec3::UnitY());
    Vec3 from = def_.center;
    for (int i = 0; i < kMostCrossed; ++i) {
      if ((to - from).dot(direction) <= 0.0f) return true;
      const RayResult ray = world_.castRay(from, to);
      if (!ray.hit) return true;
      const BodyHandle met = world_.bodyOf(ray.shape);
      if (met == target) return true;
      const std::uint32_t assembly = world_.body(met).assembly;
      if (assembly != own && std::find(bursting_.begin(), bursting_.end(), assembly) == bursting_.end()) return false;
      from = ray.point + direction * kSkin;
    }
    return false;
  }

  /// What the blast's sphere covers of it breaks out.
  void burst(const Target& target) {
    const Body& body = world_.body(target.body);
    BreakEvent event;
    event.body = target.body;
    event.assembly = body.assembly;
    event.userData = body.userData;
    event.point = target.point;
    event.normal = normalizedOr(target.point - def_.center, Vec3::UnitY());
    event.speed = def_.breakSpeed * (1.0f - 0.5f * target.distance / maxOf(def_.breakReach, 1e-6f));
    event.impulse = body.breaking.strength;
    const float covered = def_.breakReach * def_.breakReach - target.distance * target.distance;
    const std::uint32_t before = world_.counters().pieces;
    bursting_.push_back(event.assembly);
    world_.breakBody(target.body, event.point, event.normal, event.speed, std::sqrt(maxOf(covered, 0.0f)));
    event.pieces = world_.counters().pieces - before;
    result_.breaks.push_back(event);
  }

  /// All of them before the first is given: what moves is looked for in wider boxes.
  std::vector<Push> pushes() const {
    std::vector<Push> found;
    world_.overlapSphere(def_.center, def_.pushReach, ~0u, [&](ShapeHandle handle) {
      const Shape& shape = world_.shape(handle);
      const Body& body = world_.body(shape.body);
      if (!body.isDynamic()) return true;
      const Vec3 middle = body.pose.toWorld(shape.massProperties.center);
      const Vec3 direction = normalizedOr(middle - def_.center, Vec3::UnitY());
      const float mass = shape.massProperties.volume * shape.surface.density;
      const float area = shape.isSphere()
                             ? kPi * shape.radius * shape.radius
                             : outlineArea(world_.meshes().view(shape.mesh), body.pose.unrotate(direction));
      const float impulse = impulseAt(def_, (middle - def_.center).norm(), area, mass);
      if (impulse > kLeastPush && isInSight(middle, shape.body))
        found.push_back({shape.body, middle, direction * impulse});
      return true;
    });
    return found;
  }

  void give(const Push& push) {
    world_.applyImpulse(push.body, push.impulse, push.point);
    result_.momentum += push.impulse;
    result_.impulse += push.impulse.norm();
    ++result_.pushed;
  }

  World& world_;
  const ExplosionDef& def_;
  std::vector<std::uint32_t> bursting_;  // assemblies
  Explosion result_;
};

}  // namespace

float shareAt(float distance, float reach) {
  const float left = 1.0f - distance / reach;
  return left > 0.0f ? left * left : 0.0f;
}

float impulseAt(const ExplosionDef& def, float distance, float area, float mass) {
  const float share = shareAt(distance, def.pushReach);
  return minOf(def.pressure * share * area, def.mostSpeed * share * mass);
}

float outlineArea(const geometry::ConvexView& convex, const Vec3& direction) {
  std::vector<Vec3> corners;
  float sum = 0.0f;
  for (std::uint32_t face = 0; face < convex.faces.size(); ++face) {
    geometry::facePolygon(convex, face, Transform{}, corners);
    const float turned = convex.faces[face].plane.normal.dot(direction);
    sum += geometry::polygonArea(corners) * (turned < 0.0f ? -turned : turned);
  }
  return 0.5f * sum;
}

Explosion explode(World& world, const ExplosionDef& def) {
  BR_ZONE("explosion");
  BR_ASSERT(isFinite(def.center) && def.breakReach >= 0.0f && def.pushReach > 0.0f);
  return Blast(world, def).run();
}

}  // namespace brittle::physics
