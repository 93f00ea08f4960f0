// physics/pair_velocity.h - the velocities of the bodies of one contact, or of four independent ones, out of the
// solver's bodies and back. Private to the contact solver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "engine/physics/contact_rows.h"
#include "engine/physics/solver_body.h"

namespace brittle::physics {

inline Wide3<float> wide(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
inline Vec3 narrow(const Wide3<float>& v) {
  return Vec3(v.x, v.y, v.z);
}

inline PairVelocity<float> loadPair(const std::vector<SolverBody>& bodies, std::uint32_t a, std::uint32_t b) {
  return {wide(bodies[a].velocity), wide(bodies[a].angularVelocity), wide(bodies[b].velocity),
          wide(bodies[b].angularVelocity)};
}

inline void storePair(std::vector<SolverBody>& bodies, std::uint32_t a, std::uint32_t b, const PairVelocity<float>& v) {
  bodies[a].velocity = narrow(v.linearA);
  bodies[a].angularVelocity = narrow(v.angularA);
  bodies[b].velocity = narrow(v.linearB);
  bodies[b].angularVelocity = narrow(v.angularB);
}

/// The velocities of a body, each with its pad as four lanes.
struct Lanes {
  Float4 linear, angular;
};
static_assert(offsetof(SolverBody, angularVelocity) == sizeof(Float4) &&
              offsetof(SolverBody, invMass) == sizeof(Lanes));

inline Lanes lanesOf(const SolverBody& body) {
  Lanes lanes;
  std::memcpy(&lanes, &body, sizeof(lanes));
  return lanes;
}

/// What `load` and `store` do with one body of each of four pairs.
[[gnu::always_inline]] inline void gather(const SolverBody* bodies, const std::uint32_t (&index)[kLanes],
                                          Wide3<Float4>& linear, Wide3<Float4>& angular) {
  Lanes p = lanesOf(bodies[index[0]]), q = lanesOf(bodies[index[1]]);
  Lanes r = lanesOf(bodies[index[2]]), s = lanesOf(bodies[index[3]]);
  transpose(p.linear, q.linear, r.linear, s.linear);
  transpose(p.angular, q.angular, r.angular, s.angular);
  linear = {p.linear, q.linear, r.linear};
  angular = {p.angular, q.angular, r.angular};
}

[[gnu::always_inline]] inline void scatter(const Wide3<Float4>& linear, const Wide3<Float4>& angular,
                                           const std::uint32_t (&index)[kLanes], SolverBody* bodies) {
  Lanes p{linear.x, angular.x}, q{linear.y, angular.y}, r{linear.z, angular.z}, s{};
  transpose(p.linear, q.linear, r.linear, s.linear);
  transpose(p.angular, q.angular, r.angular, s.angular);
  std::memcpy(static_cast<void*>(&bodies[index[0]]), &p, sizeof(p));
  std::memcpy(static_cast<void*>(&bodies[index[1]]), &q, sizeof(q));
  std::memcpy(static_cast<void*>(&bodies[index[2]]), &r, sizeof(r));
  std::memcpy(static_cast<void*>(&bodies[index[3]]), &s, sizeof(s));
}

inline PairVelocity<Float4> loadPair(const std::vector<SolverBody>& bodies, const std::uint32_t (&a)[kLanes],
                                     const std::uint32_t (&b)[kLanes]) {
  PairVelocity<Float4> v;
  gather(bodies.data(), a, v.linearA, v.angularA);
  gather(bodies.data(), b, v.linearB, v.angularB);
  return v;
}

inline void storePair(std::vector<SolverBody>& bodies, const std::uint32_t (&a)[kLanes],
                      const std::uint32_t (&b)[kLanes], const PairVelocity<Float4>& v) {
  scatter(v.linearA, v.angularA, a, bodies.data());
  scatter(v.linearB, v.angularB, b, bodies.data());
}

}  // namespace brittle::physics
