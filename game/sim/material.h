// game/sim/material.h - the level format's materials and what they are in kilograms and newton seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/fracture/material.h"
#include "engine/math/types.h"
#include "engine/physics/body.h"
#include "engine/physics/shape.h"
#include "game/content/material.h"
#include "game/sim/event.h"

namespace brittle::sim {

/// In the units of the format; scripts override single values.
struct Material {
  Look look = Look::Glass;
  float density = 1.0f;
  float friction = 0.7f;
  float restitution = 0.0f;
  float forceLimit = 0.0f;  // 0: unbreakable
  std::uint32_t category = 1;
  std::uint32_t mask = 255;
  std::int32_t staticMode = 0;  // 0 dynamic, 1 static, 2 animated

  template <class Archive>
  void serialize(Archive& a) {
    a(look);
    a(density);
    a(friction);
    a(restitution);
    a(forceLimit);
    a(category);
    a(mask);
    a(staticMode);
  }
};

/// A material of the table ("steel", "wood", "glass", "door" ...); nothing for a name that is not in it.
std::optional<Material> findMaterial(const content::MaterialTable& table, const std::string& name);

physics::Surface surfaceOf(const Material& material);

/// How a shape of this bounding box breaks: sheets crack radially, blocks by random planes.
physics::Breakable breakableOf(const Material& material, const Vec3& extent);

/// RGBA8 with R in the lowest byte; values are clamped to [0, 1].
std::uint32_t packColor(float r, float g, float b, float a);

}  // namespace brittle::sim
