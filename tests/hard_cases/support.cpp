#include "tests/hard_cases/support.h"

#include <deque>

#include "engine/physics/contact_graph.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

bool isDriven(const State& state, const Body& body) {
  bool driven = false;
  state.drives.forEach([&](DriveHandle, const Drive& drive) {
    driven = driven || (drive.def.drivePosition && drive.def.assembly == body.assembly);
  });
  return driven;
}

bool staysUp(const State& state, const Body& body) {
  return !body.isDynamic() || body.gravityScale == 0.0f || state.gravity.isZero() || isDriven(state, body);
}

/// Goes from body to body as far as one holds the next.
class Search {
 public:
  explicit Search(const World& world) : world_(world), state_(world.state()), stands_(state_.bodies.capacity(), false) {
    state_.bodies.forEach([&](BodyHandle handle, const Body& body) {
      forEachShape(state_, body, [&](ShapeHandle, const Shape& shape) {
        shapes_.push_back(
            {handle, &shape, geometry::boundsOf(proxyOf(shape, state_.meshes), body.pose).grownBy(kHolds)});
      });
    });
    state_.bodies.forEach([&](BodyHandle handle, const Body& body) {
      if (staysUp(state_, body)) reach(handle);
    });
    state_.joints.forEach([&](JointHandle, const Joint& joint) {
      if (!joint.b && state_.shapes.contains(joint.a)) reach(state_.shapes[joint.a].body);
    });
    while (!pending_.empty()) {
      const BodyHandle next = pending_.front();
      pending_.pop_front();
      reachFrom(next);
    }
  }
  std::vector<bool> take() { return std::move(stands_); }

 private:
  struct Placed {
    BodyHandle body;
    const Shape* shape;
    Aabb bounds;
  };

  void reach(BodyHandle handle) {
    if (stands_[handle.index]) return;
    stands_[handle.index] = true;
    pending_.push_back(handle);
  }

  void reachFrom(BodyHandle from) {
    for (const Placed& holder : shapes_) {
      if (holder.body != from) continue;
      for (const Placed& held : shapes_)
        if (!stands_[held.body.index] && holder.bounds.overlaps(held.bounds) &&
            areNear(world_, *holder.shape, *held.shape, kHolds))
          reach(held.body);
    }
    state_.joints.forEach([&](JointHandle, const Joint& joint) {
      const Shape* a = state_.shapes.find(joint.a);
      const Shape* b = state_.shapes.find(joint.b);
      if (a == nullptr || b == nullptr) return;
      if (a->body == from) reach(b->body);
      if (b->body == from) reach(a->body);
    });
  }

  const World& world_;
  const State& state_;
  std::vector<Placed> shapes_;
  std::vector<bool> stands_;  // by body slot
  std::deque<BodyHandle> pending_;
};

}  // namespace

bool areNear(const World& world, const Shape& a, const Shape& b, float gap) {
  const State& state = world.state();
  return geometry::overlaps(proxyOf(a, state.meshes), state.bodyOf(a).pose, proxyOf(b, state.meshes),
                            state.bodyOf(b).pose, gap);
}

std::vector<bool> standing(const World& world) {
  return Search(world).take();
}

int floatingSleepers(const World& world) {
  const std::vector<bool> stands = standing(world);
  int count = 0;
  world.forEachBody([&](BodyHandle handle, const Body& body) {
    count += body.isDynamic() && !body.awake && !stands[handle.index] ? 1 : 0;
  });
  return count;
}

}  // namespace brittle::physics
