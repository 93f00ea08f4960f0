// content/material.h - the named materials of obstacle scripts, from materials.xml or the table built in.
#pragma once

#include "game/content/problem.h"

#include <string>
#include <string_view>
#include <vector>

namespace brittle::content {

enum class SoundKind { Glass, Metal, Marble };

struct MaterialEntry {
  std::string name;
  float density = 1.0f;      // in the level format's unit: glass is 1
  float friction = 0.7f;     // 0 to 2
  float restitution = 0.3f;  // 0 to 1
  float forceLimit = 0.1f;   // in the level format's unit; infinity: does not break
  SoundKind kind = SoundKind::Glass;
  int motion = 0;         // 0 dynamic, 1 static, 2 kinematic
  unsigned category = 1;  // collision bits
  unsigned mask = 255;
};

struct MaterialTable {
  std::vector<MaterialEntry> materials;
  Problems problems;

  const MaterialEntry* find(std::string_view name) const;
};

/// steel, wood, glass, door.
MaterialTable builtInMaterials();
/// The built-in table with what a materials.xml changes or adds: <materials><material name density friction restitution
/// forceLimit type static category mask/>.
MaterialTable readMaterials(const std::string& text, const std::string& file);

}  // namespace brittle::content
