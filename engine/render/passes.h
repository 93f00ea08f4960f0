// render/passes.h - the back end: all programs, and one function per pass that sets the state it needs and issues its
// draws. The order of passes is the renderer's business. A pass compiles its shader and takes its buffers with its
// first draw: what no scene asks for costs nothing.
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
#include "engine/render/water.h"

namespace brittle::render {

class Passes {
 public:
  /// Fails with a shader's message.
  static Result<std::unique_ptr<Passes>> create(const Gl& gl);

  void setMaterials(const MaterialUniforms& materials);
  /// Makes the frame's uniforms current; counters start at zero.
  void begin(const FrameUniforms& uniforms);
  /// Rooms, solids and spheres until endMirror are seen in the mirror floor.
  void beginMirror(const FrameUniforms& uniforms);
  void endMirror();

  // Into the scene, in this order:
  void background();
  /// Its dull faces, or the polished ones: those let the mirrored picture below them through.
  void room(const StaticMesh& mesh, const Vec3& offset, bool polished);
  void solid(const MeshStore& store, const std::vector<std::uint32_t>& indices);
  void spheres(const std::vector<SphereInstance>& instances);
  void crumbs(const std::vector<CrumbInstance>& instances);
  void decals(const std::vector<DecalInstance>& instances);
  /// Reads the depth copy, as refraction and depth of field do.
  void shadows(const std::vector<ShadowInstance>& instances);
  /// Reads the depth and the colour copy, unless `refraction` is 0 (see glass).
  void water(const Water& water, float refraction);
  /// `refraction` [picture heights]: how far a fully tilted surface looks aside; 0: off, and then the colour copy is
  /// not read. `cut`: the faces are where it broke.
  void glass(const MeshStore& store, const std::vector<std::uint32_t>& indices, float refraction, bool cut);
  void edges(const MeshStore& store, const std::vector<EdgeInstance>& instances);
  void glows(const std::vector<GlowInstance>& instances);
  void beams(const std::vector<BeamInstance>& instances);
  void lasers(const std::vector<BeamInstance>& instances);
  /// Reads the depth copy.
  void puffs(const std::vector<PuffInstance>& instances);
  /// Which of what is translucent is drawn from here on; `focus` is drawn between Far and Near.
  enum class Part { Whole, Far, Near };
  void choose(Part part, const Focus& focus);
  /// Blurs what the scene shows so far where it is far away by the depth copy.
  void focus(Target& target, const Focus& focus);

  // Into the picture:
  /// `bloom`: how strongly bright places shine beyond their outline; 0 skips the stage.
  void composite(Target& target, float bloom, const Vec4& tint, const Vec4& border);
  void hud(const std::vector<HudInstance>& instances);
  void overlay(const Overlay& overlay, int width, int height);

  FrameCounters& counters() { return counters_; }

 private:
  static constexpr GLsizei kQuadVertices = 4, kBoxVertices = 14, kTetrahedronVertices = 12;
  enum Which {
    kBackgroundProgram,
    kRoomProgram,
    kSolidProgram,
    kSphereProgram,
    kCrumbProgram,
    kDecalProgram,
    kShadowProgram,
    kGlassProgram,
    kEdgeProgram,
    kGlowProgram,
    kBeamProgram,
    kBrightProgram,
    kBlurProgram,
    kCompositeProgram,
    kHudProgram,
    kOverlayProgram,
    kWaterProgram,
    kLaserProgram,
    kPuffProgram,
    kFarProgram,
    kDiscProgram,
    kFocusProgram,
    kPrograms
  };
  /// The vec4s a program may have of its own.
  enum Uniform { kOffset, kBend, kTint, kBorder, kTap, kFocusPart, kUniforms };
  enum class Blend { Off, Over, Premultiplied, Add };
  enum class Depth { Off, Test, Write };
  enum class Faces { All, Front, Back };

  explicit Passes(const Gl& gl);
  void setState(Depth depth, Blend blend, Faces faces);
  Status build(Which which);
  /// False, with a line in the log, if its shader does not compile.
  bool use(Which which);
  void set(Uniform uniform, const Vec4& value) const;
  void bindTexture(GLint unit, GLuint texture) const;
  void drawScreen();
  void bloom(Target& target);
  void drawTriangles(GLuint indexBuffer, const std::vector<std::uint32_t>& indices);
  void count(std::size_t triangles);

  const Gl& gl_;
  std::array<Program, kPrograms> programs_;
  std::array<bool, kPrograms> failed_{};
  std::array<std::array<GLint, kUniforms>, kPrograms> locations_{};
  Which current_ = kBackgroundProgram;
  GlBuffer frameBlock_, mirrorBlock_, materialBlock_;
  bool inMirror_ = false;
  Vec4 part_ = Vec4::Zero();  // as clearAt in glsl_common.cpp reads it
  GlVertexArray empty_;       // passes without attributes still need one bound
  GlTexture glyphs_, tiles_, decals_;
  SphereBatch sphereBatch_;
  InstanceBatch crumbBatch_, glowBatch_, beamBatch_, decalBatch_, shadowBatch_, edgeBatch_, hudBatch_, laserBatch_,
      puffBatch_;
  OverlayBatch overlayBatch_;
  StreamBatch waterBatch_;
  std::vector<WaterVertex> waterVertices_;  // kept to avoid allocating every frame
  std::vector<std::uint32_t> waterIndices_;
  FrameCounters counters_;
};

}  // namespace brittle::render
