#include "engine/render/frame.h"

namespace brittle::render {

namespace {

std::uint32_t toByte(float value) {
  return static_cast<std::uint32_t>(clampTo(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

}  // namespace

std::uint32_t packRgba(const Rgb& color, float alpha) {
  return toByte(color.x()) | toByte(color.y()) << 8 | toByte(color.z()) << 16 | toByte(alpha) << 24;
}

void Frame::clear() {
  for (MeshGroup& group : groups) {
    group.pool = nullptr;
    group.bodies.clear();
    group.meshes.clear();
  }
  statics.clear();
  spheres.clear();
  crumbs.clear();
  glows.clear();
  beams.clear();
  shadows.clear();
  waters.clear();
  lasers.clear();
  puffs.clear();
  decals.clear();
  quads.clear();
  arcs.clear();
  texts.clear();
  mirrorHeight.reset();
  focus = {};
  bloom = 0.0f;
  tint = border = Vec4::Zero();
}

}  // namespace brittle::render
