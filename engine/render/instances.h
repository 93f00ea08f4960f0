// render/instances.h - the small things of a frame as the records their shaders read, one per instance. Pure packing;
// no GL.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/render/uniforms.h"

namespace brittle::render {

struct SphereInstance {
  std::array<float, 4> place;     // centre, radius [m]
  std::array<float, 4> rotation;  // x, y, z, w
  std::uint32_t color;
  std::uint32_t material;
};

struct CrumbInstance {
  std::array<float, 4> place;  // centre, radius [m]
  std::uint32_t color;
};

struct GlowInstance {
  std::array<float, 4> place;  // centre, radius [m]
  std::uint32_t color;
  float cover, star;
};

struct BeamInstance {
  std::array<float, 4> from;  // point, radius [m]
  std::array<float, 3> to;
  std::uint32_t color;
};

struct PuffInstance {
  std::array<float, 4> place;  // centre, radius [m]
  std::uint32_t color;
  float turn, pattern;
};

struct DecalInstance {
  std::array<float, 4> place;  // centre, cell of the atlas
  std::array<float, 4> right;  // half its width, coverage
  std::array<float, 3> up;     // half its height
  std::uint32_t color;
};

struct ShadowInstance {
  std::array<float, 4> place;  // middle of the underside, or a ball's centre; how far down it reaches [m]
  std::array<float, 4> form;   // half its width and depth [m]; cosine and sine of its turn
  float opacity;
  float isSphere;  // 1: a round outline, and its own lower half is left out
};

/// HUD shapes and letters; see the hud shader for the meaning by kind.
struct HudInstance {
  std::array<float, 4> ends;
  std::array<float, 4> form;
  std::uint32_t color;
};

/// A frame's instances; the vectors keep their memory from frame to frame.
struct Instances {
  std::vector<SphereInstance> spheres;
  std::vector<CrumbInstance> crumbs;
  std::vector<GlowInstance> glows;
  std::vector<BeamInstance> beams, lasers;
  std::vector<PuffInstance> puffs;
  std::vector<ShadowInstance> shadows;
  std::vector<DecalInstance> decals;
  std::vector<HudInstance> hud;

  /// Refills everything from `frame`, leaving out what the view cannot see. Picture size in pixels. Shadows are packed
  /// only if `withShadows`.
  void pack(const Frame& frame, const View& view, int width, int height, bool withShadows);

 private:
  void packBodies(const Frame& frame, const View& view);
  void packShadows(const Frame& frame, const View& view);
  void packDecals(const Frame& frame, const View& view);
  void packHud(const Frame& frame, float width, float height);
};

}  // namespace brittle::render
