// render/renderer.h - the whole renderer behind one class: it owns the GL objects, mirrors the mesh pool and draws
// frames. Works on GLES 3.0 (the subset WebGL 2 has too), on a desktop core profile with ES3 compatibility, and on the
// null table.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/capture.h"
#include "engine/render/frame.h"
#include "engine/render/material.h"
#include "engine/render/overlay.h"

namespace brittle::render {

class Gl;

struct RendererDef {
  int width = 640, height = 360;  // [pixels], in [1, 16384]
  int samples = 0;                // multisampling: 0 (off) or 4
  bool offscreen = true;          // draw into a picture of its own; false: into framebuffer 0
  bool shadows = true;            // soft shadows under spheres and Frame::shadows
  bool refraction = true;         // glass bends what is behind it
};

/// A vertex of baked room geometry; the layout of the level format's .mesh files.
struct StaticVertex {
  Vec3 point = Vec3::Zero();  // [m]
  float u = 0.0f, v = 0.0f;   // in the tile atlas
  std::uint32_t color =
      0x80808080;  // rgb: half the colour times light; alpha: openness, 255 is open and 0 a deep corner
};

/// What the last frame cost.
struct FrameCounters {
  std::uint32_t draws = 0;
  std::uint32_t triangles = 0, lines = 0;
  std::uint32_t verticesUploaded = 0;  // of the mesh pool
  std::uint32_t indicesUploaded = 0;
};

class Renderer {
 public:
  /// Fails with one line if the context is too old, a shader does not compile or the picture is too large. `gl` must
  /// outlive the renderer.
  static Result<std::unique_ptr<Renderer>> create(Gl& gl, const RendererDef& def);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Replaces the material table (at most kMaxMaterials); meshes and spheres with an index beyond it use the last
  /// entry.
  void setMaterials(std::span<const Material> materials);
  void resize(int width, int height);

  /// Uploads baked geometry: indices are triangles, counter-clockwise seen from the front; the last `polished` of them
  /// mirror the room.
  StaticId createStatic(std::span<const StaticVertex> vertices, std::span<const std::uint32_t> indices,
                        std::uint32_t polished = 0);
  void destroyStatic(StaticId id);

  /// Draws one picture, and the overlay on top of it unless it is null or empty. Uploads the dirty ranges of the
  /// frame's pools first and clears them.
  void draw(const Frame& frame, const Overlay* overlay = nullptr);
  /// The picture drawn last.
  Image readBack();
  const FrameCounters& counters() const;

 private:
  struct Parts;
  explicit Renderer(std::unique_ptr<Parts> parts);
  bool makeTarget(int width, int height);
  std::unique_ptr<Parts> parts_;
};

}  // namespace brittle::render
