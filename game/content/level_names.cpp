#include "game/content/level_names.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

#include "game/content/nearest.h"
#include "game/content/xml_file.h"

namespace brittle::content {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::string_view kSegmentElements[] = {"box", "obstacle", "decal", "powerup", "water", "model"};
constexpr std::string_view kRoom[] = {"room"}, kTemplate[] = {"template"}, kProperties[] = {"properties"},
                           kLevels[] = {"levels"}, kLevel[] = {"level"}, kMaterialElement[] = {"material"},
                           kName[] = {"name"};

constexpr std::string_view kSegment[] = {"size",       "template",    "lightLeft",  "lightRight",
                                         "lightTop",   "lightBottom", "lightFront", "lightBack",
                                         "softshadow", "fogcolor",    "ambient"};
constexpr std::string_view kBox[] = {"pos",   "size",     "hidden",  "visible",    "template", "color",
                                     "tile",  "tileSize", "tileRot", "reflection", "glow",     "tileX",
                                     "tileY", "tileZ",    "colorX",  "colorY",     "colorZ"};
constexpr std::string_view kObstacle[] = {"pos",    "type",   "rot",    "template", "mode",   "difficulty",
                                          "group",  "hidden", "param0", "param1",   "param2", "param3",
                                          "param4", "param5", "param6", "param7",   "param8", "param9"};
constexpr std::string_view kDecal[] = {"pos", "rot", "size", "tile", "color", "blend", "template", "hidden"};
constexpr std::string_view kPowerUp[] = {"pos", "type", "template", "hidden"};
constexpr std::string_view kWater[] = {"pos", "size", "resolution", "template", "hidden"};
constexpr std::string_view kMaterial[] = {"name", "density", "friction", "restitution", "forceLimit",
                                          "type", "static",  "category", "mask"};

struct Element {
  std::string_view name;
  Names attributes;
};
constexpr Element kElements[] = {{"segment", kSegment},   {"box", kBox},         {"obstacle", kObstacle},
                                 {"decal", kDecal},       {"powerup", kPowerUp}, {"water", kWater},
                                 {"material", kMaterial}, {"template", kName},   {"level", kName}};

/// What stands in a file: its root, and the elements in it.
struct Kind {
  const char* root;
  Names children;
};
constexpr Kind kKinds[] = {{"segment", kSegmentElements},
                           {"level", kRoom},
                           {"templates", kTemplate},
                           {"game", kLevels},
                           {"materials", kMaterialElement}};

constexpr std::string_view kRoots[] = {"segment", "level", "templates", "game", "materials"};

constexpr std::string_view kObstacles[] = {
    "scoretop", "scorediamond", "scorestar", "scoremulti",
    // doors
    "doors/basic", "doors/double", "doors/45", "vs_door", "vs_sweeper", "vs_wall",
    // panes
    "bar", "framedwindow", "suspendwindow", "foldwindow", "beatwindow", "sweeper", "beatsweeper", "sidesweeper",
    "revolver", "ngon", "creditssign", "credits1", "credits2", "box",
    // what hangs
    "suspendcube", "suspendbox", "suspendcylinder", "suspendside", "suspendhollow", "bigpendulum", "babytoy", "3dcross",
    "cubeframe", "gyro",
    // what turns
    "rotor", "bigcrank", "beatmill", "gear", "dna", "tree", "cactus",
    // what falls, flies and jumps
    "dropblock", "hitblock", "flycube", "levicube",
    // others
    "laser", "pyramid", "bowling", "elevator", "elevatorgrid", "grid", "test", "stone", "boss/single", "boss/cube",
    "boss/triple", "boss/matryoshka", "boss/telecube", "fence/carousel", "fence/slider", "fence/dna",
    // ours
    "vent"};

bool holds(Names names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// param10 and on.
bool isParameter(std::string_view name) {
  return name.size() > 5 && name.substr(0, 5) == "param" &&
         std::all_of(name.begin() + 5, name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Templates may be of any kind of element.
const std::vector<std::string_view>& allAttributes() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> names;
    for (const Element& element : kElements)
      names.insert(names.end(), element.attributes.begin(), element.attributes.end());
    return names;
  }();
  return all;
}

class Search {
 public:
  Search(const std::string& text, const std::string& file, const Kind& kind) : xml_(text, file, kind.root, found_) {
    found_.clear();  // what is wrong with its syntax says who reads it
    if (kind.children.data() == kSegmentElements && xml_.root()) checkAttributes(xml_.root());
    for (const pugi::xml_node& node : xml_.elements()) {
      checkElement(node, kind.children);
      checkAttributes(node);
      if (kind.children.data() == kTemplate) checkChildren(node, kProperties);
      if (kind.children.data() == kLevels) checkChildren(node, kLevel);
    }
  }
  Problems take() { return std::move(found_); }

 private:
  void checkChildren(const pugi::xml_node& parent, Names known) {
    for (const pugi::xml_node& node : parent.children()) {
      if (node.type() != pugi::node_element) continue;
      checkElement(node, known);
      checkAttributes(node);
    }
  }

  void checkElement(const pugi::xml_node& node, Names known) {
    const std::string_view name = node.name();
    if (!holds(known, name) && !isEditorsName(name)) report("unknown element", node.name(), known);
  }

  void checkAttributes(const pugi::xml_node& node) {
    const std::string_view element = node.name();
    const auto found = std::find_if(std::begin(kElements), std::end(kElements),
                                    [&](const Element& one) { return one.name == element; });
    const bool isTemplate = element == "properties";
    if (found == std::end(kElements) && !isTemplate) return;
    const Names known = isTemplate ? Names(allAttributes()) : found->attributes;
    const bool hasParameters = isTemplate || element == "obstacle";
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const std::string_view name = attribute.name();
      if (holds(known, name) || isEditorsName(name) || (hasParameters && isParameter(name))) continue;
      report("<" + std::string(element) + "> unknown attribute", attribute.name(), known);
    }
  }

  void report(std::string what, const char* name, Names known) {
    const std::string nearest = nearestOf(name, known);
    xml_.report({xml_.file(), xml_.lineOf(name), std::move(what), name, nearest.empty() ? listOf(known) : nearest});
  }

  Problems found_;
  XmlFile xml_;
};

}  // namespace

Problems unknownNames(const std::string& text, const std::string& file, std::string_view root) {
  const auto kind =
      std::find_if(std::begin(kKinds), std::end(kKinds), [&](const Kind& one) { return one.root == root; });
  if (kind != std::end(kKinds)) return Search(text, file, *kind).take();
  const std::string nearest = nearestOf(root, kRoots);
  if (nearest.empty()) return {};
  return {{file, 0, "unknown element", std::string(root), nearest}};
}

bool isEditorsName(std::string_view name) {
  return name.find('-') != std::string_view::npos || name.substr(0, 1) == "_" || name == "IMPORT_IGNORE" ||
         name == "drm";
}

bool isKnownObstacle(std::string_view type) {
  return holds(kObstacles, type);
}

std::string nearestObstacle(std::string_view type, const std::set<std::string>& own) {
  std::vector<std::string_view> known(std::begin(kObstacles), std::end(kObstacles));
  known.insert(known.end(), own.begin(), own.end());
  return nearestOf(type, known);
}

}  // namespace brittle::content
