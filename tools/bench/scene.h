// tools/bench/scene.h - what the benches of physics share: a world in few lines, and the hash that says it was the same
// work everywhere.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdio>

#include "engine/geometry/make.h"
#include "engine/physics/world.h"
#include "tools/bench/cpu_time.h"

namespace brittle::physics {

inline constexpr float kTick = 1.0f / 60.0f;

inline BodyHandle addBox(World& world, const BodyDef& def, const Vec3& halfExtents, bool anchored = false) {
  const BodyHandle body = world.createBody(def);
  ShapeDef shape;
  shape.surface.density = 2500.0f;
  shape.anchored = anchored;
  world.addConvex(body, shape, geometry::makeBox<float>(halfExtents).view());
  return body;
}

/// A static box whose top is at y = 0.
inline void addFloor(World& world) {
  BodyDef floor;
  floor.type = BodyType::Static;
  floor.pose.position = Vec3(0.0f, -0.5f, 0.0f);
  addBox(world, floor, Vec3(20.0f, 0.5f, 20.0f));
}

inline void label(benchmark::State& state, std::uint64_t hash) {
  char text[32];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  state.SetLabel(text);
}

}  // namespace brittle::physics
