// render/lamp.h - boxes that glow, as the few points they shine from. Pure; used by the baker and for halos.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/render/occlusion.h"

namespace brittle::render {

struct BakeBox;

inline constexpr std::size_t kLampPoints = 3;

struct Lamp {
  std::array<Vec3, kLampPoints> points;  // along its longest side [m]
  Vec3 color = Vec3::Ones();
  float strength = 1.0f;  // light of one point on a face one metre before it [-]
};

/// Appends the boxes that glow.
void addLamps(std::span<const BakeBox> boxes, std::vector<Lamp>& lamps);

/// What the lamps add to the light on a face, where nothing stands between.
Vec3 lightAt(const Vec3& point, const Vec3& normal, std::span<const Lamp> lamps, const Occlusion& occlusion);

}  // namespace brittle::render
