#include "game/content/material.h"

#include "game/content/xml_file.h"

#include <limits>
#include <set>

namespace brittle::content {
namespace {

using Found = Attributes::Found;

constexpr float kUnbreakable = std::numeric_limits<float>::infinity();
constexpr double kMost = 1e6;

void readKind(const Attributes& attributes, SoundKind& kind) {
  std::string name;
  if (attributes.text("type", name) != Found::Good) return;
  if (name == "glass") {
    kind = SoundKind::Glass;
  } else if (name == "metal") {
    kind = SoundKind::Metal;
  } else if (name == "marble") {
    kind = SoundKind::Marble;
  } else {
    attributes.reportAt("type", "type", "glass, metal or marble");
  }
}

void readEntry(const Attributes& attributes, MaterialEntry& entry) {
  attributes.number("density", 0.001, kMost, entry.density);
  attributes.number("friction", 0.0, 10.0, entry.friction);
  attributes.number("restitution", 0.0, 1.0, entry.restitution);
  attributes.number("forceLimit", 0.0, kMost, entry.forceLimit);
  readKind(attributes, entry.kind);
  attributes.whole("static", 0, 2, entry.motion);
  int bits = static_cast<int>(entry.category);
  if (attributes.whole("category", 0, 255, bits) == Found::Good) entry.category = static_cast<unsigned>(bits);
  bits = static_cast<int>(entry.mask);
  if (attributes.whole("mask", 0, 255, bits) == Found::Good) entry.mask = static_cast<unsigned>(bits);
}

}  // namespace

const MaterialEntry* MaterialTable::find(std::string_view name) const {
  for (const MaterialEntry& entry : materials)
    if (entry.name == name) return &entry;
  return nullptr;
}

MaterialTable builtInMaterials() {
  MaterialTable table;
  table.materials = {{"steel", 1.0f, 0.9f, 0.3f, kUnbreakable, SoundKind::Metal, 0, 1, 255},
                     {"wood", 1.0f, 0.9f, 0.3f, 0.05f, SoundKind::Marble, 0, 1, 255},
                     {"glass", 1.0f, 0.7f, 0.3f, 0.1f, SoundKind::Glass, 0, 1, 255},
                     {"door", 100.0f, 0.7f, 0.3f, kUnbreakable, SoundKind::Metal, 2, 2, 125}};
  return table;
}

MaterialTable readMaterials(const std::string& text, const std::string& file) {
  MaterialTable table = builtInMaterials();
  const XmlFile xml(text, file, "materials", table.problems);
  std::set<std::string> reported;
  for (const pugi::xml_node& node : xml.elements()) {
    if (std::string_view(node.name()) != "material") continue;
    const Attributes attributes(xml, node, nullptr, reported);
    MaterialEntry entry;
    const Found found = attributes.text("name", entry.name);
    if (found == Found::Absent) attributes.report("name is missing: the material is left out");
    if (found != Found::Good) continue;
    const MaterialEntry* known = table.find(entry.name);
    const std::size_t place =
        known != nullptr ? static_cast<std::size_t>(known - table.materials.data()) : table.materials.size();
    if (known == nullptr) table.materials.push_back(entry);
    readEntry(attributes, table.materials[place]);
  }
  return table;
}

}  // namespace brittle::content
