// render/uniforms.h - the uniform blocks of the shaders as plain memory, and how a frame and a material table fill
// them.
#pragma once

#include <array>
#include <span>

#include "engine/render/material.h"

namespace brittle::render {

/// Mirrors FrameBlock in glsl_common.cpp (std140: vec4 and mat4 only, so there is no padding to get wrong).
struct FrameUniforms {
  std::array<float, 16> viewProjection{};  // by columns
  std::array<float, 4> right{}, up{}, forward{}, eye{};
  std::array<float, 4> fogBottom{}, fogTop{};
  std::array<float, 4> toLight{}, lightColor{};
  std::array<float, 4> picture{};
  std::array<float, 4> low{}, high{};
  std::array<float, 4> room{}, lampColor{};
  std::array<std::array<float, 4>, 4> walls{};  // left, right, floor, ceiling
  std::array<std::array<float, 4>, kMostMirroredLamps> lampPlace{}, lampForm{};
  std::array<float, 4> mirror{};  // height of the mirror floor, 1 if there is one
};

/// Mirrors MaterialBlock.
struct MaterialUniforms {
  std::array<std::array<float, 4>, kMaxMaterials> surface{};
  std::array<std::array<float, 4>, kMaxMaterials> finish{};
};

/// The camera ready for use: its axes, tangents filled in, and world to clip space.
struct View {
  Vec3 eye, right, up, forward;
  float tanHalfWidth, tanHalfHeight;
  Mat4 viewProjection;

  /// Distance along the view direction. [m]
  float depthOf(const Vec3& point) const { return forward.dot(point - eye); }
  /// Whether a sphere can be seen between the camera and `farthest`. [m]
  bool sees(const Vec3& center, float radius, float farthest) const;
};

/// Picture size in pixels, both at least 1.
View makeView(const Camera& camera, int width, int height);
FrameUniforms makeFrameUniforms(const Frame& frame, const View& view, int width, int height);
/// The same scene as seen in a level mirror at `height` [m]: the eye below it, everything upside down on the picture.
/// Front faces turn the other way round.
FrameUniforms mirrored(FrameUniforms uniforms, const View& view, float height);
MaterialUniforms makeMaterialUniforms(std::span<const Material> materials);

/// sRGB-encoded to linear, the same polynomial as in the shaders.
Vec3 decodeColor(const Rgb& color);

}  // namespace brittle::render
