// render/frame.h - one picture as plain data: what the renderer needs to know and all it knows. Whoever owns the scene
// fills a Frame (a copy, so that the simulation may go on); the renderer reads it and never asks back. No physics, no
// game rules, no GL here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/mesh_pool.h"
#include "engine/math/transform.h"

namespace brittle::render {

/// Red, green, blue as authors and displays write them: sRGB-encoded, 1 is full. The renderer decodes and lights
/// linearly.
using Rgb = Vec3;

/// An sRGB-encoded RGBA8 colour, R in the lowest byte, as geometry::Vertex stores it. Arguments in [0, 1], clamped.
std::uint32_t packRgba(const Rgb& color, float alpha = 1.0f);
inline constexpr std::uint32_t kWhite = 0xffffffff;

/// Where it is seen from. Looks along its local -Z, X right, Y up.
struct Camera {
  Vec3 position = Vec3::Zero();      // [m]
  Quat rotation = Quat::Identity();  // unit
  float tanHalfWidth = 0.57735f;     // tangent of half the horizontal field of view (60 degrees)
  float tanHalfHeight = 0.0f;        // 0: from the picture's aspect, pixels square
  float nearPlane = 0.1f;            // [m] > 0
  float farPlane = 100.0f;           // [m]
};

/// Fog by depth; its colour goes from `bottom` to `top` up the picture. Values outside [0, 1] are legal and clamp after
/// blending.
struct Fog {
  Rgb bottom = Rgb(0.45f, 0.60f, 0.72f);
  Rgb top = Rgb(0.80f, 0.88f, 0.94f);
  float start = 5.0f;  // [m] of depth where it begins
  float end = 25.0f;   // [m] where only fog is left; beyond it nothing needs to be submitted
};

struct Light {
  Vec3 direction =
      Vec3(-0.35f, -0.85f, -0.4f);  // where it shines to; normalised by the renderer, zero is straight down
  Rgb color = Rgb(1.0f, 0.97f, 0.92f);
  float ambient = 0.55f;  // share of light that comes from everywhere [0, 1]
};

/// What mirrors and glass show: the room as a long box of one colour a side along Z, with the nearest lamps.
struct Surroundings {
  struct Lamp {
    Vec3 center = Vec3::Zero();       // [m]
    Vec3 halfExtents = Vec3::Ones();  // [m]
    float light = 1.0f;               // [-] 0 is dark
  };
  Vec2 low = Vec2(-4.0f, -1.0f), high = Vec2(4.0f, 4.0f);  // its sides in X and Y [m]
  Rgb left = Rgb::Constant(0.62f), right = Rgb::Constant(0.62f);
  Rgb floor = Rgb::Constant(0.42f), ceiling = Rgb::Constant(0.72f);
  Rgb lampColor = Rgb(1.0f, 0.97f, 0.92f);
  std::vector<Lamp> lamps;  // the first kMostMirroredLamps are shown
};
inline constexpr std::size_t kMostMirroredLamps = 8;

/// Indices of the built-in draw materials (MeshInfo::material). The table may be replaced, see Renderer::setMaterials.
enum BuiltInMaterial : std::uint16_t { kGlass, kMetal, kMatte, kCrystal, kBall, kBuiltInMaterials };

/// A convex of a mesh pool that is to be seen.
struct VisibleMesh {
  geometry::MeshSlot slot = 0;
  std::uint32_t body = 0;           // index into MeshGroup::bodies
  std::uint16_t material = kGlass;  // index into the material table
  std::uint32_t tint = kWhite;      // multiplies the vertex colours
};

/// The convexes of one mesh pool. The pool is read, and its dirty ranges are cleared, while the frame is drawn.
struct MeshGroup {
  geometry::MeshPool* pool = nullptr;  // null: the group is empty
  std::uint64_t poolId = 0;            // another id means another pool: everything is uploaded
  std::vector<Transform> bodies;       // by body slot
  std::vector<VisibleMesh> meshes;     // any order; the renderer sorts. Slots that are not alive are skipped
};

/// Pools alive at once: the room the camera is in and the next one.
inline constexpr std::size_t kMaxGroups = 2;

/// A sphere drawn from one built-in mesh; its surface pattern shows its rotation.
struct Sphere {
  Vec3 position = Vec3::Zero();  // [m]
  float radius = 0.1f;           // [m]
  Quat rotation = Quat::Identity();
  std::uint16_t material = kBall;
  std::uint32_t color = kWhite;
};

/// Light debris: a small tumbling tetrahedron.
struct Crumb {
  Vec3 position = Vec3::Zero();  // [m]
  float radius = 0.01f;          // [m]
  std::uint32_t color = kWhite;
};

/// A soft disc facing the camera (sparkle, lamp, puff of dust).
struct Glow {
  Vec3 position = Vec3::Zero();  // [m]
  float radius = 0.1f;           // [m]
  std::uint32_t color = kWhite;  // alpha scales it
  float cover = 0.0f;            // 0: adds to what is behind it, 1: hides it
  float star = 0.0f;             // 0: round, 1: four rays
};

/// An additive beam facing the camera (laser, streak).
struct Beam {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // [m]
  float radius = 0.02f;                         // [m]
  std::uint32_t color = kWhite;
};

/// A soft shadow on what looks up below a caster; spheres cast theirs by themselves (Frame::sphereShadow).
struct Shadow {
  Vec3 position = Vec3::Zero();      // the middle of the caster's underside [m]
  Vec2 halfSize = Vec2(0.2f, 0.2f);  // of its outline from above [m]
  float turn = 0.0f;                 // of that outline about Y [rad]
  float opacity = 0.4f;              // [0, 1] where it touches the surface
};

/// A picture on a surface, facing its local +Z. Lies flat on whatever is there; seen from both sides.
struct Decal {
  Vec3 position = Vec3::Zero();  // [m]
  Quat rotation = Quat::Identity();
  Vec2 halfSize = Vec2(0.5f, 0.5f);  // [m]
  int tile = 0;                      // 0 to 63 of the sprites, -1 to -4 the emblems of doors
  std::uint32_t color = kWhite;      // alpha scales its coverage
  float cover = 1.0f;                // 1: hides what is behind it, 0: adds to it
};

/// A puff of smoke: a soft ball that lets through what is behind it, and ends softly where it meets anything.
struct Puff {
  Vec3 position = Vec3::Zero();  // [m]
  float radius = 0.3f;           // [m]
  std::uint32_t color = kWhite;  // alpha scales how much it hides
  float turn = 0.0f;             // of its pattern [rad]
  float pattern = 0.0f;          // which: any number
};

/// Blur of what is far away, translucent things too: those are blurred as what is behind them is.
struct Focus {
  float distance = 10.0f;  // sharp up to here [m]
  float range = 10.0f;     // wholly blurred after so much more [m] > 0
  float strength = 0.0f;   // [0, 1]; 0: no such stage
};

/// A level surface of water with waves on it: a grid of cells, rows from low z to high z, corners from low x to high x.
struct Water {
  Vec3 center = Vec3::Zero();    // [m]
  Vec2 halfSize = Vec2::Ones();  // in x and z [m]
  int columns = 1, rows = 1;     // cells along x and z
  std::vector<float> heights;    // of the (columns + 1) (rows + 1) corners above the surface [m]
  std::vector<float> foam;       // of each, 0 clear to 1 white
  float along = 0.0f;            // added to z gives a place that stays where it is: of its finest waves [m]
  float seconds = 0.0f;          // by which those move
};

/// Baked room geometry, made by Renderer::createStatic. 0 is null.
using StaticId = std::uint32_t;

struct VisibleStatic {
  StaticId id = 0;
  Vec3 offset = Vec3::Zero();  // where its origin is now [m]
};

inline constexpr float kHudWidth = 1.2f;  // of the widest sign; a narrower picture shrinks the HUD [HUD heights]

/// A place on the picture: a fraction of it (0 left and top, 1 right and bottom) plus a distance in HUD heights. A HUD
/// height is the picture's, or less where the picture is narrower than kHudWidth of them.
struct HudPoint {
  Vec2 anchor = Vec2::Zero();  // [fraction of width, fraction of height]
  Vec2 offset = Vec2::Zero();  // [HUD heights], x right, y down
};

/// A filled rectangle centred on `at`.
struct HudQuad {
  HudPoint at;
  Vec2 size = Vec2(0.1f, 0.1f);  // [HUD heights]
  std::uint32_t color = kWhite;
  float radius = 0.0f;  // of its corners [HUD heights]
};

/// A ring or pie about `at`: clockwise from the top.
struct HudArc {
  HudPoint at;
  float inner = 0.0f, outer = 0.05f;  // radii [HUD heights]
  float from = 0.0f, to = 1.0f;       // [turns]
  std::uint32_t color = kWhite;
};

enum class HudAlign : std::uint8_t { Left, Center, Right };

/// One line of printable ASCII, vertically centred on `at`; other bytes show as a box.
struct HudText {
  HudPoint at;
  float height = 0.05f;  // of a capital letter [HUD heights]
  HudAlign align = HudAlign::Left;
  std::uint32_t color = kWhite;
  std::string text;
  float stroke = 0.12f;  // width of its lines [height]
  float spacing = 0.0f;  // more room between the letters [height]
};

struct Frame {
  Camera camera;
  Fog fog;
  Light light;
  Surroundings surroundings;

  std::array<MeshGroup, kMaxGroups> groups;  // each is drawn as a whole, so glass of two must not interleave in depth
  std::vector<VisibleStatic> statics;
  std::vector<Sphere> spheres;
  std::vector<Crumb> crumbs;
  std::vector<Glow> glows;
  std::vector<Beam> beams;
  std::vector<Shadow> shadows;
  std::vector<Beam> lasers;           // with a halo; seen in the mirror too
  std::vector<Puff> puffs;            // drawn in this order: farthest first
  std::vector<Water> waters;          // drawn in this order: farthest first
  std::vector<Decal> decals;          // drawn in this order
  std::optional<float> mirrorHeight;  // of a polished floor that shows the room upside down [m]; none: no such stage
  float sphereShadow = 0.6f;          // opacity of the shadows of spheres; 0: none

  std::vector<HudQuad> quads;  // drawn in this order: quads, arcs, texts
  std::vector<HudArc> arcs;
  std::vector<HudText> texts;
  Focus focus;
  float bloom = 0.0f;          // how far bright things shine beyond their outline; 0: no such stage [0, 1]
  Vec4 tint = Vec4::Zero();    // colour over the whole picture below the HUD: rgb, alpha
  Vec4 border = Vec4::Zero();  // the same, strongest at the picture's border (a crash)

  /// Empties the lists, keeping their memory; camera, fog, light and surroundings stay.
  void clear();
};

}  // namespace brittle::render
