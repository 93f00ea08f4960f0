#include "game/content/segment.h"

#include "game/content/xml_file.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>

namespace brittle::content {
namespace {

using Found = Attributes::Found;

constexpr int kMostParams = 64;
constexpr float kFarthest = 10'000.0f;       // [m]: beyond, floats lose their millimetres
constexpr std::size_t kMostElements = 5000;  // of a segment; the largest known has some 500

/// The position; an element whose position cannot be read is left out, one without stands at the origin.
bool readPosition(const Attributes& attributes, Vec3& position) {
  const Found found = attributes.floats("pos", position.data(), 3);
  if (found == Found::Absent) attributes.report("pos is missing: 0 0 0 is used");
  const bool isNear = position.cwiseAbs().maxCoeff() <= kFarthest;
  if (!isNear) attributes.reportAt("pos", "pos: the element is left out", "numbers up to 10000");
  return found != Found::Bad && isNear;
}

void readColors(const Attributes& attributes, std::array<Vec3, 3>& color) {
  std::vector<double> values;
  if (attributes.numbers("color", {3, 9}, values) == Found::Good) {
    for (std::size_t face = 0; face < 3; ++face) {
      const std::size_t first = values.size() == 9 ? face * 3 : 0;
      color[face] = Vec3(static_cast<float>(values[first]), static_cast<float>(values[first + 1]),
                         static_cast<float>(values[first + 2]));
    }
  }
  attributes.floats("colorX", color[0].data(), 3);  // how old files write one pair of faces
  attributes.floats("colorY", color[1].data(), 3);
  attributes.floats("colorZ", color[2].data(), 3);
}

/// One number for all pairs of faces or one each, within [low, high]; whole numbers if `whole`.
template <class T>
void readPerFace(const Attributes& attributes, const char* name, double low, double high, bool whole,
                 const char* expected, std::array<T, 3>& out) {
  std::vector<double> values;
  if (attributes.numbers(name, {1, 3}, values) != Found::Good) return;
  for (const double value : values)
    if (!(value >= low && value <= high) || (whole && value != std::floor(value)))
      return attributes.reportAt(name, name, expected);
  for (std::size_t face = 0; face < 3; ++face) out[face] = static_cast<T>(values[values.size() == 3 ? face : 0]);
}

void readTiles(const Attributes& attributes, Box& box) {
  readPerFace(attributes, "tile", 0, 63, true, "whole numbers, 0 to 63", box.tile);
  const char* names[] = {"tileX", "tileY", "tileZ"};
  for (std::size_t face = 0; face < 3; ++face) attributes.whole(names[face], 0, 63, box.tile[face]);
  readPerFace(attributes, "tileSize", 0.01, 1000.0, false, "0.01 to 1000", box.tileSize);
  readPerFace(attributes, "tileRot", -1000, 1000, true, "whole numbers", box.tileRotation);
  for (int& turns : box.tileRotation) turns = (turns % 4 + 4) % 4;
}

bool readBox(const Attributes& attributes, Box& box) {
  box.line = attributes.line();
  const bool hasPosition = readPosition(attributes, box.position);
  const Found size = attributes.floats("size", box.halfExtents.data(), 3);
  if (size == Found::Absent) attributes.report("size is missing: half extents of 0.5 are used");
  attributes.truth("hidden", box.hidden);
  attributes.truth("visible", box.visible);
  attributes.truth("reflection", box.reflection);
  if (attributes.number("glow", -1000.0, 1000.0, box.glow) == Found::Absent)
    attributes.number("mb-glow", -1000.0, 1000.0, box.glow);
  readColors(attributes, box.color);
  readTiles(attributes, box);
  if (!hasPosition || size == Found::Bad) return false;
  if (box.halfExtents.minCoeff() < 0.0f) {
    attributes.reportAt("size", "size is negative: its sign is dropped", "half extents");
    box.halfExtents = box.halfExtents.cwiseAbs();
  }
  if (box.halfExtents.minCoeff() > 0.0f) return true;
  attributes.reportAt("size", "a box without volume is left out", "half extents above 0");
  return false;
}

void readParams(const Attributes& attributes, std::vector<Param>& params) {
  for (int i = 0; i < kMostParams; ++i) {
    const std::string name = "param" + std::to_string(i);
    std::string text;
    if (attributes.text(name.c_str(), text) != Found::Good) continue;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      attributes.reportAt(name.c_str(), name, "key=value");
      continue;
    }
    params.push_back({text.substr(0, equals), text.substr(equals + 1), !attributes.isOwn(name.c_str())});
  }
}

bool readType(const Attributes& attributes, std::string& type) {
  const Found found = attributes.text("type", type);
  if (found == Found::Absent) attributes.report("type is missing: the element is left out");
  return found == Found::Good;
}

bool readObstacle(const Attributes& attributes, Obstacle& obstacle) {
  obstacle.line = attributes.line();
  const bool hasType = readType(attributes, obstacle.type);
  const bool hasPosition = readPosition(attributes, obstacle.position);
  attributes.floats("rot", obstacle.rotation.data(), 3);
  attributes.truth("hidden", obstacle.hidden);
  readParams(attributes, obstacle.params);
  int modes = kAllModes;
  attributes.whole("mode", 0, 255, modes);
  obstacle.modes = static_cast<std::uint32_t>(modes);
  attributes.whole("group", -1000000, 1000000, obstacle.group);
  float range[2] = {0.0f, 1.0f};
  if (attributes.floats("difficulty", range, 2) == Found::Good) {
    obstacle.difficultyMin = range[0];
    obstacle.difficultyMax = range[1];
  }
  return hasType && hasPosition;
}

bool readDecal(const Attributes& attributes, Decal& decal) {
  decal.line = attributes.line();
  const bool hasPosition = readPosition(attributes, decal.position);
  attributes.floats("rot", decal.rotation.data(), 3);
  std::vector<double> values;
  if (attributes.numbers("size", {2, 3}, values) == Found::Good)
    decal.size = Vec2(static_cast<float>(values[0]), static_cast<float>(values[1]));
  attributes.whole("tile", -4, 63, decal.tile);
  if (attributes.numbers("color", {3, 4}, values) == Found::Good)
    for (std::size_t i = 0; i < values.size(); ++i)
      decal.color[static_cast<Eigen::Index>(i)] = static_cast<float>(values[i]);
  attributes.number("blend", -10.0, 10.0, decal.blend);
  attributes.truth("hidden", decal.hidden);
  return hasPosition;
}

bool readPowerUp(const Attributes& attributes, PowerUp& powerUp) {
  powerUp.line = attributes.line();
  const bool hasType = readType(attributes, powerUp.type);
  const bool hasPosition = readPosition(attributes, powerUp.position);
  attributes.truth("hidden", powerUp.hidden);
  return hasType && hasPosition;
}

bool readWater(const Attributes& attributes, Water& water) {
  water.line = attributes.line();
  const bool hasPosition = readPosition(attributes, water.position);
  const Found size = attributes.floats("size", water.halfExtents.data(), 2);
  std::vector<double> cells;
  if (attributes.numbers("resolution", {1, 2}, cells) == Found::Good) {
    for (std::size_t i = 0; i < 2; ++i) {
      const double wanted = cells[cells.size() == 2 ? i : 0];
      water.resolution[i] = static_cast<int>(clampTo(wanted, 2.0, 256.0));
      if (wanted != water.resolution[i]) attributes.reportAt("resolution", "resolution", "whole numbers, 2 to 256");
    }
  }
  attributes.truth("hidden", water.hidden);
  if (!hasPosition || size == Found::Bad) return false;
  if (water.halfExtents.minCoeff() > 0.0f) return true;
  attributes.reportAt("size", "water without area is left out", "half extents above 0");
  return false;
}

void readSettings(const Attributes& attributes, Segment& segment) {
  Vec3 size = segment.size;
  const Found found = attributes.floats("size", size.data(), 3);
  if (found == Found::Absent) attributes.report("size is missing: 12 10 16 is used");
  if (found == Found::Good && size.minCoeff() <= 0.0f)
    attributes.reportAt("size", "size: 12 10 16 is used", "positive extents");
  if (size.minCoeff() > 0.0f) segment.size = size;
  const char* lights[] = {"lightLeft", "lightRight", "lightTop", "lightBottom", "lightFront", "lightBack"};
  for (std::size_t i = 0; i < 6; ++i) attributes.number(lights[i], -100.0, 100.0, segment.light[i]);
  attributes.number("softshadow", 0.0, 1.0, segment.softShadow);
  float ambient = 0.0f;
  if (attributes.number("ambient", -100.0, 100.0, ambient) == Found::Good) segment.ambient = ambient;
  std::array<float, 6> fog{};
  if (attributes.floats("fogcolor", fog.data(), 6) == Found::Good) segment.fogColor = fog;
}

template <class T>
void readInto(std::vector<T>& list, bool (*read)(const Attributes&, T&), const Attributes& attributes) {
  T element;
  if (read(attributes, element)) list.push_back(std::move(element));
}

}  // namespace

const std::string* Obstacle::find(std::string_view key) const {
  for (std::size_t i = params.size(); i-- > 0;)
    if (params[i].key == key) return &params[i].value;
  return nullptr;
}

Segment readSegment(const std::string& text, const std::string& file, const TemplateSet& templates) {
  Segment segment;
  segment.file = file;
  const XmlFile xml(text, file, "segment", segment.problems);
  std::set<std::string> reported;
  if (xml.root()) {
    segment.line = xml.lineOf(xml.root());
    readSettings(Attributes(xml, xml.root(), &templates, reported), segment);
  }
  std::size_t elements = 0;
  for (const pugi::xml_node& node : xml.elements()) {
    const std::string_view kind = node.name();
    if (kind != "box" && kind != "obstacle" && kind != "decal" && kind != "powerup" && kind != "water") continue;
    if (++elements > kMostElements) {
      xml.report({file,
                  xml.lineOf(node),
                  "too many elements: the rest is left out",
                  {},
                  "at most " + std::to_string(kMostElements)});
      break;
    }
    const Attributes attributes(xml, node, &templates, reported);
    if (kind == "box") readInto(segment.boxes, readBox, attributes);
    if (kind == "obstacle") readInto(segment.obstacles, readObstacle, attributes);
    if (kind == "decal") readInto(segment.decals, readDecal, attributes);
    if (kind == "powerup") readInto(segment.powerUps, readPowerUp, attributes);
    if (kind == "water") readInto(segment.waters, readWater, attributes);
  }
  return segment;
}

}  // namespace brittle::content
