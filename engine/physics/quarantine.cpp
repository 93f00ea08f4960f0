#include "engine/physics/quarantine.h"

#include <string>

#include "engine/core/log.h"
#include "engine/physics/edit.h"

namespace brittle::physics {
namespace {

/// Faster than this, positions overflow within seconds; nothing in a game gets there by itself. [m/s]
constexpr float kAbsurdSpeed = 1e6f;

const char* whatIsWrong(const Body& body) {
  if (!isFinite(body.center) || !isFinite(body.pose.position) || !isFinite(body.pose.rotation)) return "pose";
  if (!isFinite(body.velocity) || body.velocity.norm() > kAbsurdSpeed) return "velocity";
  if (!isFinite(body.angularVelocity) || body.angularVelocity.norm() > kAbsurdSpeed) return "angular velocity";
  return nullptr;
}

}  // namespace

void quarantine(State& state) {
  for (std::uint32_t slot = 0; slot < state.bodies.capacity(); ++slot) {
    if (!state.bodies.isAlive(slot)) continue;
    const Body& body = state.bodies.at(slot);
    const char* wrong = whatIsWrong(body);
    if (wrong == nullptr) continue;
    const BodyHandle handle = state.bodies.handleAt(slot);
    logWarning("physics: body " + std::to_string(slot) + " of assembly " + std::to_string(body.assembly) +
               " removed: its " + wrong + " is not a usable number (tick " + std::to_string(state.tick) + ")");
    state.events.quarantined.push_back(handle);
    state.counters.omissions.add(Omission::QuarantinedBody);
    dropBody(state, handle);
  }
}

}  // namespace brittle::physics
