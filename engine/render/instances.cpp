#include "engine/render/instances.h"

#include <cmath>

#include "engine/math/trig.h"
#include "engine/render/decal_atlas.h"
#include "engine/render/text.h"

namespace brittle::render {

namespace {

constexpr float kRectangle = 0.0f, kArc = 1.0f, kGlyph = 2.0f;  // kinds of the hud shader
constexpr float kShadeWidth = 0.20f;      // of the soft shade about a letter [cap height]. Chosen by eye
constexpr float kBallShadowReach = 4.0f;  // how far below its ball a shadow can fall [radii]

/// How far below its caster a shadow can be told: a small one is soon too soft. [m]
float reachOf(const Shadow& s) {
  return clampTo(0.25f + 3.0f * std::sqrt(s.halfSize.x() * s.halfSize.y()), 0.3f, 1.8f);
}

std::array<float, 4> placeOf(const Vec3& center, float radius) {
  return {center.x(), center.y(), center.z(), radius};
}

void packBeams(const std::vector<Beam>& from, std::vector<BeamInstance>& packed) {
  for (const Beam& b : from) packed.push_back({placeOf(b.from, b.radius), {b.to.x(), b.to.y(), b.to.z()}, b.color});
}

/// The picture's size and its HUD height. [px]
struct Sheet {
  float width, height;
  float unit = minOf(height, width / kHudWidth);
};

Vec2 pixelsOf(const HudPoint& point, const Sheet& sheet) {
  return point.anchor.cwiseProduct(Vec2(sheet.width, sheet.height)) + sheet.unit * point.offset;
}

void addText(const HudText& text, const Sheet& sheet, std::vector<HudInstance>& out) {
  const float cap = text.height * sheet.unit;
  const float unit = cap / kGlyphHeight;
  Vec2 at = pixelsOf(text.at, sheet);
  const float spread = text.spacing * cap;
  const float wide = textWidth(text.text) * cap + spread * static_cast<float>(text.text.size() - 1);
  if (text.align == HudAlign::Center) at.x() -= 0.5f * wide;
  if (text.align == HudAlign::Right) at.x() -= wide;
  at.y() += 0.5f * cap;
  for (const char c : text.text) {
    const std::array<float, 4> form = {0.5f * text.stroke * cap, kShadeWidth * cap, kGlyph, 0.0f};
    if (c != ' ') out.push_back({{at.x(), at.y(), unit, static_cast<float>(glyphRow(c))}, form, text.color});
    at.x() += glyphAdvance(c) * unit + spread;
  }
}

}  // namespace

void Instances::packBodies(const Frame& frame, const View& view) {
  const float farthest = minOf(frame.camera.farPlane, frame.fog.end);
  for (const Sphere& s : frame.spheres) {
    if (!view.sees(s.position, s.radius, farthest)) continue;
    const Quat& q = s.rotation;
    spheres.push_back({placeOf(s.position, s.radius),
                       {q.x(), q.y(), q.z(), q.w()},
                       s.color,
                       minOf<std::uint32_t>(s.material, kMaxMaterials - 1)});
  }
  const float reach = 1.4f;  // the tetrahedron's corners, in radii
  for (const Crumb& c : frame.crumbs) {
    if (view.sees(c.position, c.radius * reach, farthest)) crumbs.push_back({placeOf(c.position, c.radius), c.color});
  }
  for (const Glow& g : frame.glows) {
    if (view.sees(g.position, g.radius * reach, farthest))
      glows.push_back({placeOf(g.position, g.radius), g.color, g.cover, g.star});
  }
  packBeams(frame.beams, beams);
  packBeams(frame.lasers, lasers);
  for (const Puff& p : frame.puffs)
    if (view.sees(p.position, p.radius * reach, farthest))
      puffs.push_back({placeOf(p.position, p.radius), p.color, p.turn, p.pattern});
}

void Instances::packShadows(const Frame& frame, const View& view) {
  const float farthest = minOf(frame.camera.farPlane, frame.fog.end);
  const auto add = [&](const ShadowInstance& shadow, const Vec3& center, float size) {
    if (shadow.opacity > 0.0f && view.sees(center, size + shadow.place[3], farthest)) shadows.push_back(shadow);
  };
  for (const Sphere& s : frame.spheres)
    add({placeOf(s.position, kBallShadowReach * s.radius), {s.radius, s.radius, 1.0f, 0.0f}, frame.sphereShadow, 1.0f},
        s.position, s.radius);
  for (const Shadow& s : frame.shadows)
    add({placeOf(s.position, reachOf(s)),
         {s.halfSize.x(), s.halfSize.y(), cosine(s.turn), sine(s.turn)},
         s.opacity,
         0.0f},
        s.position, s.halfSize.norm());
}

void Instances::packDecals(const Frame& frame, const View& view) {
  const float farthest = minOf(frame.camera.farPlane, frame.fog.end);
  for (const Decal& d : frame.decals) {
    if (!view.sees(d.position, d.halfSize.norm(), farthest)) continue;
    const Vec3 right = d.rotation * Vec3(d.halfSize.x(), 0.0f, 0.0f),
               up = d.rotation * Vec3(0.0f, d.halfSize.y(), 0.0f);
    decals.push_back({placeOf(d.position, static_cast<float>(decalCell(d.tile))),
                      placeOf(right, d.cover),
                      {up.x(), up.y(), up.z()},
                      d.color});
  }
}

void Instances::packHud(const Frame& frame, float width, float height) {
  const Sheet sheet{width, height};
  for (const HudQuad& q : frame.quads) {
    const Vec2 at = pixelsOf(q.at, sheet), half = 0.5f * sheet.unit * q.size;
    hud.push_back({{at.x(), at.y(), half.x(), half.y()}, {q.radius * sheet.unit, 0.0f, kRectangle, 0.0f}, q.color});
  }
  for (const HudArc& a : frame.arcs) {
    if (a.to <= a.from) continue;
    const Vec2 at = pixelsOf(a.at, sheet);
    hud.push_back({{at.x(), at.y(), a.from, a.to}, {a.outer * sheet.unit, a.inner * sheet.unit, kArc, 0.0f}, a.color});
  }
  for (const HudText& text : frame.texts)
    if (!text.text.empty()) addText(text, sheet, hud);
}

void Instances::pack(const Frame& frame, const View& view, int width, int height, bool withShadows) {
  spheres.clear();
  crumbs.clear();
  glows.clear();
  beams.clear();
  lasers.clear();
  puffs.clear();
  shadows.clear();
  decals.clear();
  hud.clear();
  packBodies(frame, view);
  packDecals(frame, view);
  if (withShadows) packShadows(frame, view);
  packHud(frame, static_cast<float>(width), static_cast<float>(height));
}

}  // namespace brittle::render
