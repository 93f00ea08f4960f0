#include "engine/render/uniforms.h"

#include <cmath>

#include "engine/core/assert.h"

namespace brittle::render {

namespace {

std::array<float, 4> pack(const Vec3& v, float w) {
  return {v.x(), v.y(), v.z(), w};
}

Mat4 makeViewProjection(const View& view, float nearPlane, float farPlane) {
  Mat4 toCamera = Mat4::Identity();
  toCamera.block<1, 3>(0, 0) = view.right.transpose();
  toCamera.block<1, 3>(1, 0) = view.up.transpose();
  toCamera.block<1, 3>(2, 0) = -view.forward.transpose();
  toCamera(0, 3) = -view.right.dot(view.eye);
  toCamera(1, 3) = -view.up.dot(view.eye);
  toCamera(2, 3) = view.forward.dot(view.eye);
  Mat4 toClip = Mat4::Zero();
  toClip(0, 0) = 1.0f / view.tanHalfWidth;
  toClip(1, 1) = 1.0f / view.tanHalfHeight;
  toClip(2, 2) = (farPlane + nearPlane) / (nearPlane - farPlane);
  toClip(2, 3) = 2.0f * farPlane * nearPlane / (nearPlane - farPlane);
  toClip(3, 2) = -1.0f;
  return toClip * toCamera;
}

void setSurroundings(const Surroundings& from, FrameUniforms& block) {
  const std::size_t lamps = minOf(from.lamps.size(), kMostMirroredLamps);
  block.room = {from.low.x(), from.low.y(), from.high.x(), from.high.y()};
  block.lampColor = pack(decodeColor(from.lampColor), static_cast<float>(lamps));
  const Rgb* const sides[] = {&from.left, &from.right, &from.floor, &from.ceiling};
  for (std::size_t i = 0; i < 4; ++i) block.walls[i] = pack(decodeColor(sides[i]->cwiseMin(1.0f)), 0.0f);
  for (std::size_t i = 0; i < lamps; ++i) {
    block.lampPlace[i] = pack(from.lamps[i].center, from.lamps[i].light);
    block.lampForm[i] = pack(from.lamps[i].halfExtents, 0.0f);
  }
}

}  // namespace

bool View::sees(const Vec3& center, float radius, float farthest) const {
  const Vec3 d = center - eye;
  const float depth = forward.dot(d);
  if (depth < -radius || depth > farthest + radius) return false;
  // Distance to each side plane of the pyramid; the planes' normals have length sqrt(1 + tan^2).
  const float sideways = std::fabs(right.dot(d)) - depth * tanHalfWidth;
  const float upwards = std::fabs(up.dot(d)) - depth * tanHalfHeight;
  return sideways <= radius * std::sqrt(1.0f + tanHalfWidth * tanHalfWidth) &&
         upwards <= radius * std::sqrt(1.0f + tanHalfHeight * tanHalfHeight);
}

View makeView(const Camera& camera, int width, int height) {
  BR_ASSERT(width > 0 && height > 0);
  BR_ASSERT(camera.tanHalfWidth > 0.0f && camera.nearPlane > 0.0f && camera.farPlane > camera.nearPlane);
  View view;
  view.eye = camera.position;
  view.right = camera.rotation * Vec3::UnitX();
  view.up = camera.rotation * Vec3::UnitY();
  view.forward = camera.rotation * -Vec3::UnitZ();
  view.tanHalfWidth = camera.tanHalfWidth;
  view.tanHalfHeight = camera.tanHalfHeight > 0.0f
                           ? camera.tanHalfHeight
                           : camera.tanHalfWidth * static_cast<float>(height) / static_cast<float>(width);
  view.viewProjection = makeViewProjection(view, camera.nearPlane, camera.farPlane);
  return view;
}

FrameUniforms makeFrameUniforms(const Frame& frame, const View& view, int width, int height) {
  FrameUniforms block;
  for (int i = 0; i < 16; ++i) block.viewProjection[static_cast<std::size_t>(i)] = view.viewProjection(i % 4, i / 4);
  block.right = pack(view.right, view.tanHalfWidth);
  block.up = pack(view.up, view.tanHalfHeight);
  block.forward = pack(view.forward, frame.camera.nearPlane);
  block.eye = pack(view.eye, frame.camera.farPlane);
  block.fogBottom = pack(frame.fog.bottom, frame.fog.start);
  block.fogTop = pack(frame.fog.top, 1.0f / maxOf(frame.fog.end - frame.fog.start, 1e-3f));
  block.toLight = pack(-normalizedOr(frame.light.direction, -Vec3::UnitY()), frame.light.ambient);
  block.lightColor = pack(decodeColor(frame.light.color), frame.sphereShadow);
  const auto visible = [](const Rgb& c) { return decodeColor(c.cwiseMax(0.0f).cwiseMin(1.0f)); };
  block.low = pack(visible(frame.fog.bottom), 0.0f);
  block.high = pack(visible(frame.fog.top), 0.0f);
  setSurroundings(frame.surroundings, block);
  block.mirror = {frame.mirrorHeight.value_or(0.0f), frame.mirrorHeight ? 1.0f : 0.0f, 0.0f, 0.0f};
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  block.picture = {w, h, 1.0f / w, 1.0f / h};
  return block;
}

FrameUniforms mirrored(FrameUniforms uniforms, const View& view, float height) {
  Mat4 flip = Mat4::Identity();
  flip(1, 1) = -1.0f;
  flip(1, 3) = 2.0f * height;
  const Mat4 viewProjection = view.viewProjection * flip;
  for (int i = 0; i < 16; ++i) uniforms.viewProjection[static_cast<std::size_t>(i)] = viewProjection(i % 4, i / 4);
  for (std::array<float, 4>* axis : {&uniforms.right, &uniforms.up, &uniforms.forward}) (*axis)[1] = -(*axis)[1];
  uniforms.eye[1] = 2.0f * height - uniforms.eye[1];
  uniforms.mirror = {};
  return uniforms;
}

MaterialUniforms makeMaterialUniforms(std::span<const Material> materials) {
  BR_ASSERT(!materials.empty() && materials.size() <= kMaxMaterials);
  MaterialUniforms block;
  for (std::size_t i = 0; i < kMaxMaterials; ++i) {
    const Material& m = materials[minOf(i, materials.size() - 1)];
    block.surface[i] = pack(decodeColor(m.color), m.metalness);
    block.finish[i] = {m.gloss, m.clarity, m.edge, 0.0f};
  }
  return block;
}

Vec3 decodeColor(const Rgb& color) {
  Vec3 linear;
  for (int i = 0; i < 3; ++i) {
    const float c = color[i];
    linear[i] = c * (c * (c * 0.305306011f + 0.682171111f) + 0.012522878f);
  }
  return linear;
}

}  // namespace brittle::render
