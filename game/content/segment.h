// content/segment.h - a segment file as data: boxes, obstacles, decals, power-ups, water, with templates merged under
// them and every value checked. All positions are in the segment's frame: right-handed, -Z forward, the segment lies in
// z of [-size.z, 0] [m]. Knows nothing of bodies, meshes or scripts; who builds them finds the line of each element
// here.
#pragma once

#include "engine/math/types.h"
#include "game/content/problem.h"
#include "game/content/template_set.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brittle::content {

/// One "key=value" of an obstacle.
struct Param {
  std::string key;
  std::string value;
  bool isShared = false;  // of its template, which may serve obstacles of other types too
};

/// A static box. `hidden` elements are left out by the editor: they neither collide nor show.
struct Box {
  Vec3 position = Vec3::Zero();
  Vec3 halfExtents = Vec3(0.5f, 0.5f, 0.5f);  // all positive
  bool hidden = false;
  bool visible = true;  // drawn; it collides either way
  bool reflection = false;
  float glow = 0.0f;
  std::array<Vec3, 3> color = {Vec3::Ones(), Vec3::Ones(), Vec3::Ones()};  // of the x, y and z faces, linear
  std::array<int, 3> tile = {0, 0, 0};                                     // 0 to 63 of the atlas, per pair of faces
  std::array<float, 3> tileSize = {1.0f, 1.0f, 1.0f};                      // [m], positive
  std::array<int, 3> tileRotation = {0, 0, 0};                             // [quarter turns], 0 to 3
  int line = 0;
};

/// Which modes an obstacle appears in: bits of Obstacle::modes.
enum ModeBit : std::uint32_t {
  kTraining = 1,
  kClassicAndZen = 2,
  kMayhem = 4,
  kVersus = 16,
  kCoop = 32,
  kAllModes = 55
};

struct Obstacle {
  Vec3 position = Vec3::Zero();
  Vec3 rotation = Vec3::Zero();  // about X, Y, Z [rad]
  std::string type;              // a path under obstacles/, never empty
  std::vector<Param> params;     // param0 first; a later one of the same key wins
  std::uint32_t modes = kAllModes;
  float difficultyMin = 0.0f;
  float difficultyMax = 1.0f;
  int group = 0;
  bool hidden = false;
  int line = 0;

  const std::string* find(std::string_view key) const;
};

struct Decal {
  Vec3 position = Vec3::Zero();
  Vec3 rotation = Vec3::Zero();  // [rad]
  Vec2 size = Vec2(1.0f, 1.0f);  // [m]
  int tile = 0;                  // 0 to 63 of the sprite atlas, -1 to -4 of the door emblems
  Vec4 color = Vec4(1.0f, 1.0f, 1.0f, 1.0f);
  float blend = 1.0f;  // 1 covers, 0 adds
  bool hidden = false;
  int line = 0;
};

struct PowerUp {
  Vec3 position = Vec3::Zero();
  std::string type;  // never empty
  bool hidden = false;
  int line = 0;
};

struct Water {
  Vec3 position = Vec3::Zero();
  Vec2 halfExtents = Vec2(1.0f, 1.0f);       // in x and z [m], positive
  std::array<int, 2> resolution = {32, 32};  // cells, 2 to 256
  bool hidden = false;
  int line = 0;
};

struct Segment {
  std::string file;
  Vec3 size = Vec3(12.0f, 10.0f, 16.0f);  // full extents [m], positive
  std::array<float, 6> light = {1, 1, 1,
                                1, 1, 1};  // on -X, +X, +Y, -Y, +Z, -Z faces: left, right, top, bottom, front, back
  float softShadow = 0.6f;                 // opacity, 0 to 1
  std::optional<float> ambient;
  std::optional<std::array<float, 6>> fogColor;  // bottom, then top: a hint for previews
  std::vector<Box> boxes;
  std::vector<Obstacle> obstacles;
  std::vector<Decal> decals;
  std::vector<PowerUp> powerUps;
  std::vector<Water> waters;
  int line = 0;
  Problems problems;
};

/// Reads a segment. Never fails: an element that cannot be used is left out, a bad attribute has its default, and
/// `problems` says so.
Segment readSegment(const std::string& text, const std::string& file, const TemplateSet& templates);

}  // namespace brittle::content
