// A renderer on a software GL and what tests ask of its pictures.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "engine/geometry/make.h"
#include "engine/render/gl.h"
#include "gallery.h"
#include "platform/headless/headless.h"

namespace brittle::render {

inline constexpr RendererDef kSmall = {.width = 320, .height = 180};

/// A context and a renderer on it; a scene is drawn by draw().
class Studio {
 public:
  explicit Studio(const RendererDef& def, platform::HeadlessBackend backend = platform::HeadlessBackend::Egl) {
    const Status opened = open(def, backend);
    if (!opened) ADD_FAILURE() << opened.error().message;
  }

  Image draw(const Frame& frame, const Overlay* overlay = nullptr) {
    if (renderer_ == nullptr) return {};
    renderer_->draw(frame, overlay);
    EXPECT_EQ(glErrorName(gl_.GetError()), "no error");
    return renderer_->readBack();
  }
  Image drawGallery() {
    Gallery gallery;
    fillGallery(gallery);
    gallery.frame.statics.push_back({addStatic(gallery.room), Vec3::Zero()});
    return draw(gallery.frame);
  }
  StaticId addStatic(const BakedMesh& mesh) {
    return renderer_ != nullptr ? renderer_->createStatic(mesh.vertices, mesh.indices, mesh.polished) : 0;
  }

 private:
  Status open(const RendererDef& def, platform::HeadlessBackend backend) {
    auto device = platform::createHeadless(backend, {def.width, def.height});
    if (!device) return device.error();
    device_ = std::move(*device);
    Result<Gl> gl = loadGl(device_->glLoader());
    if (!gl) return gl.error();
    gl_ = *gl;
    auto renderer = Renderer::create(gl_, def);
    if (!renderer) return renderer.error();
    renderer_ = std::move(*renderer);
    return Done{};
  }

  std::unique_ptr<platform::Headless> device_;
  Gl gl_;
  std::unique_ptr<Renderer> renderer_;
};

inline Vec3 pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = image.at(x, y);
  return Vec3(p[0], p[1], p[2]);
}

inline float brightness(const Image& image, int x, int y) {
  return pixel(image, x, y).mean();
}

/// Fog so thin and grey that what is tested stands alone.
inline Frame clearAir() {
  Frame frame;
  frame.fog.bottom = frame.fog.top = Rgb::Constant(0.5f);
  frame.fog.start = 90.0f;
  frame.fog.end = 100.0f;
  return frame;
}

/// Two metres square and 4 cm thick, and looking at the camera.
inline void addPane(Frame& frame, geometry::MeshPool& pool, const Vec3& place, const Rgb& color,
                    std::uint16_t material = kGlass) {
  geometry::Convex pane = geometry::makeBox<float>(Vec3(1.0f, 1.0f, 0.02f));
  for (geometry::Vertex& vertex : pane.vertices) vertex.color = packRgba(color);
  MeshGroup& group = frame.groups[0];
  group.pool = &pool;
  const auto body = static_cast<std::uint32_t>(group.bodies.size());
  group.bodies.push_back({place, Quat::Identity()});
  group.meshes.push_back({pool.add(pane, body, material), body, material, kWhite});
}

}  // namespace brittle::render
