#include "game/sim/material.h"

#include "game/sim/constants.h"

namespace brittle::sim {

namespace {

Look lookOf(const content::MaterialEntry& entry) {
  if (entry.name == "door") return Look::Door;
  if (entry.name == "wood") return Look::Wood;
  if (entry.kind == content::SoundKind::Glass) return Look::Glass;
  return entry.kind == content::SoundKind::Metal ? Look::Metal : Look::Stone;
}

}  // namespace

std::optional<Material> findMaterial(const content::MaterialTable& table, const std::string& name) {
  const content::MaterialEntry* entry = table.find(name);
  if (entry == nullptr) return std::nullopt;
  Material material;
  material.look = lookOf(*entry);
  material.density = entry->density;
  material.friction = entry->friction;
  material.restitution = entry->restitution;
  material.forceLimit = isFinite(entry->forceLimit) ? entry->forceLimit : 0.0f;
  material.category = entry->category;
  material.mask = entry->mask;
  material.staticMode = entry->motion;
  return material;
}

physics::Surface surfaceOf(const Material& material) {
  physics::Surface surface;
  surface.density = maxOf(material.density, 0.001f) * rules::kDensityUnit;
  surface.friction = clampTo(material.friction, 0.0f, 4.0f);
  surface.restitution = clampTo(material.restitution, 0.0f, 1.0f);
  surface.category = material.category;
  // Levels count categories up to 128: bits above, and the balls' own, are not theirs to switch off.
  surface.mask = material.mask == 0 ? 0 : material.mask | rules::kCategoryBall | 0xffffff00u;
  return surface;
}

physics::Breakable breakableOf(const Material& material, const Vec3& extent) {
  physics::Breakable breakable;
  if (material.forceLimit <= 0.0f) return breakable;
  breakable.strength = material.forceLimit * rules::kForceUnit;
  float sorted[3] = {extent.x(), extent.y(), extent.z()};
  for (int pass = 0; pass < 2; ++pass)
    for (int i = 0; i < 2; ++i)
      if (sorted[i + 1] < sorted[i]) std::swap(sorted[i], sorted[i + 1]);
  const bool isSheet = sorted[0] < 0.3f * sorted[1];
  breakable.material.pattern = isSheet ? fracture::Pattern::Pane : fracture::Pattern::Block;
  breakable.material.carveRadius = rules::kCarveRadius;
  breakable.material.density = isSheet ? 1.0f : rules::kBlockCracks;
  breakable.material.minVolume = maxOf(rules::kSmallestPiece, rules::kSmallestShare * extent.prod());
  return breakable;
}

std::uint32_t packColor(float r, float g, float b, float a) {
  const float values[4] = {r, g, b, a};
  std::uint32_t packed = 0;
  for (int i = 0; i < 4; ++i)
    packed |= static_cast<std::uint32_t>(clampTo(values[i], 0.0f, 1.0f) * 255.0f + 0.5f) << (8 * i);
  return packed;
}

}  // namespace brittle::sim
