// render/passes.h - the back end: all programs, and one function per pass that sets the state it needs and issues its draws. The order
// of passes is the renderer's business.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "engine/render/batch.h"
#include "engine/render/draw_list.h"
#include "engine/render/instances.h"
#include "engine/render/mesh_store.h"
#include "engine/render/shader.h"
#include "engine/render/target.h"

namespace brittle::render {

class Passes {
 public:
  /// Fails with a shader's message.
  static Result<std::unique_ptr<Passes>> create(const Gl& gl);

  void setMaterials(const MaterialUniforms& materials);
  /// Makes the frame's uniforms current; counters start at zero.
  void begin(const FrameUniforms& uniforms);

  // Into the scene, in this order:
  void background();
  void beginRooms();
  void room(const StaticMesh& mesh, const Vec3& offset);
  void solid(const MeshStore& store, const std::vector<std::uint32_t>& indices);
  void spheres(const std::vector<SphereInstance>& instances);
  void crumbs(const std::vector<PlaceInstance>& instances);
  void shadows(const std::vector<ShadowInstance>& instances, Target& target);
  /// `refraction` [picture heights]: how far a fully tilted surface looks aside; 0: off, and then the colour copy is not read.
  void glass(const MeshStore& store, const std::vector<std::uint32_t>& indices, float refraction);
  void edges(const MeshStore& store, const std::vector<EdgeInstance>& instances);
  void glows(const std::vector<PlaceInstance>& instances);
  void beams(const std::vector<BeamInstance>& instances);

  // Into the picture:
  void composite(Target& target, const Vec4& tint, const Vec4& border);
  void hud(const std::vector<HudInstance>& instances);

  FrameCounters& counters() { return counters_; }

 private:
  enum Which {
    kBackgroundProgram,
    kRoomProgram,
    kSolidProgram,
    kSphereProgram,
    kCrumbProgram,
    kShadowProgram,
    kGlassProgram,
    kEdgeProgram,
    kGlowProgram,
    kBeamProgram,
    kCompositeProgram,
    kHudProgram,
    kPrograms
  };
  enum class Blend { Off, Over, Premultiplied, Add };
  enum class Depth { Off, Test, Write };
  enum class Faces { All, Front, Back };

  explicit Passes(const Gl& gl);
  void setState(Depth depth, Blend blend, Faces faces);
  void use(Which which) { programs_[which].use(); }
  void drawTriangles(GLuint indexBuffer, const std::vector<std::uint32_t>& indices);
  void count(std::size_t triangles);

  const Gl& gl_;
  std::array<Program, kPrograms> programs_;
  GlBuffer frameBlock_, materialBlock_;
  GlVertexArray empty_;  // passes without attributes still need one bound
  GlTexture strokes_, tiles_;
  SphereBatch sphereBatch_;
  InstanceBatch crumbBatch_, glowBatch_, beamBatch_, shadowBatch_, edgeBatch_, hudBatch_;
  GLint roomOffset_ = -1, glassBend_ = -1, compositeTint_ = -1, compositeBorder_ = -1;
  FrameCounters counters_;
};

}  // namespace brittle::render
