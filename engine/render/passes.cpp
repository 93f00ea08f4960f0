#include "engine/render/passes.h"

#include "engine/core/log.h"
#include "engine/core/profile.h"
#include "engine/effects/has/bloom.h"
#include "engine/effects/has/decals.h"
#include "engine/effects/has/depth_of_field.h"
#include "engine/effects/has/lasers.h"
#include "engine/effects/has/shadows.h"
#include "engine/effects/has/smoke.h"
#include "engine/effects/has/water.h"
#include "engine/render/glsl.h"
#include "engine/render/text.h"
#include "engine/render/tiles.h"

namespace brittle::render {

namespace {

using As = Attribute::As;

constexpr std::array<Attribute, 4> kSphereLayout = {{{1, 4, GL_FLOAT, As::Float, 0},
                                                     {2, 4, GL_FLOAT, As::Float, 16},
                                                     {3, 4, GL_UNSIGNED_BYTE, As::Normalized, 32},
                                                     {4, 1, GL_UNSIGNED_INT, As::Whole, 36}}};
constexpr std::array<Attribute, 2> kCrumbLayout = {
    {{1, 4, GL_FLOAT, As::Float, 0}, {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 16}}};
constexpr std::array<Attribute, 3> kGlowLayout = {
    {{1, 4, GL_FLOAT, As::Float, 0}, {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 16}, {3, 2, GL_FLOAT, As::Float, 20}}};
static_assert(sizeof(PuffInstance) == sizeof(GlowInstance), "they share the layout above");
constexpr std::array<Attribute, 3> kBeamLayout = {
    {{0, 4, GL_FLOAT, As::Float, 0}, {1, 3, GL_FLOAT, As::Float, 16}, {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 28}}};
constexpr std::array<Attribute, 4> kDecalLayout = {{{0, 4, GL_FLOAT, As::Float, 0},
                                                    {1, 4, GL_FLOAT, As::Float, 16},
                                                    {2, 3, GL_FLOAT, As::Float, 32},
                                                    {3, 4, GL_UNSIGNED_BYTE, As::Normalized, 44}}};
constexpr std::array<Attribute, 3> kShadowLayout = {
    {{1, 4, GL_FLOAT, As::Float, 0}, {2, 4, GL_FLOAT, As::Float, 16}, {3, 2, GL_FLOAT, As::Float, 32}}};
constexpr std::array<Attribute, 4> kEdgeLayout = {{{0, 3, GL_FLOAT, As::Float, 0},
                                                   {1, 3, GL_FLOAT, As::Float, 12},
                                                   {2, 1, GL_UNSIGNED_INT, As::Whole, 24},
                                                   {3, 1, GL_FLOAT, As::Float, 28}}};
constexpr std::array<Attribute, 3> kHudLayout = {
    {{0, 4, GL_FLOAT, As::Float, 0}, {1, 4, GL_FLOAT, As::Float, 16}, {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 32}}};
constexpr std::array<Attribute, 2> kWaterLayout = {{{0, 3, GL_FLOAT, As::Float, 0}, {1, 3, GL_FLOAT, As::Float, 12}}};

}  // namespace

Passes::Passes(const Gl& gl)
    : gl_(gl),
      frameBlock_(gl),
      materialBlock_(gl),
      empty_(gl),
      sphereBatch_(sizeof(SphereInstance), kSphereLayout),
      crumbBatch_(sizeof(CrumbInstance), kCrumbLayout),
      glowBatch_(sizeof(GlowInstance), kGlowLayout),
      beamBatch_(sizeof(BeamInstance), kBeamLayout),
      decalBatch_(sizeof(DecalInstance), kDecalLayout),
      shadowBatch_(sizeof(ShadowInstance), kShadowLayout),
      edgeBatch_(sizeof(EdgeInstance), kEdgeLayout),
      hudBatch_(sizeof(HudInstance), kHudLayout),
      laserBatch_(sizeof(BeamInstance), kBeamLayout),
      puffBatch_(sizeof(PuffInstance), kGlowLayout),
      waterBatch_(sizeof(WaterVertex), kWaterLayout) {}

Result<std::unique_ptr<Passes>> Passes::create(const Gl& gl) {
  std::unique_ptr<Passes> passes(new Passes(gl));
  for (const Which which : {kBackgroundProgram, kCompositeProgram}) {  // of every picture
    const Status built = passes->build(which);
    if (!built) return built.error();
  }
  return passes;
}

Status Passes::build(Which which) {
  static const ProgramSource* const sources[kPrograms] = {&glsl::kBackground,
                                                          &glsl::kRoom,
                                                          &glsl::kSolid,
                                                          &glsl::kSphere,
                                                          &glsl::kCrumb,
                                                          effects::kHasDecals ? &glsl::kDecal : nullptr,
                                                          effects::kHasShadows ? &glsl::kShadow : nullptr,
                                                          &glsl::kGlass,
                                                          &glsl::kEdge,
                                                          &glsl::kGlow,
                                                          &glsl::kBeam,
                                                          effects::kHasBloom ? &glsl::kBright : nullptr,
                                                          effects::kHasBloom ? &glsl::kBlur : nullptr,
                                                          &glsl::kComposite,
                                                          &glsl::kHud,
                                                          &glsl::kOverlay,
                                                          effects::kHasWater ? &glsl::kWater : nullptr,
                                                          effects::kHasLasers ? &glsl::kLaser : nullptr,
                                                          effects::kHasSmoke ? &glsl::kPuff : nullptr,
                                                          effects::kHasDepthOfField ? &glsl::kFar : nullptr,
                                                          effects::kHasDepthOfField ? &glsl::kDisc : nullptr,
                                                          effects::kHasDepthOfField ? &glsl::kFocus : nullptr};
  static const char* const uniforms[kUniforms] = {"offset", "bend", "tint", "border", "tap", "focusPart"};
  Result<Program> program = Program::build(gl_, *sources[which]);
  if (!program) return program.error();
  programs_[which] = std::move(*program);
  for (std::size_t i = 0; i < kUniforms; ++i) locations_[which][i] = programs_[which].location(uniforms[i]);
  return Done{};
}

bool Passes::use(Which which) {
  if (failed_[which]) return false;
  if (!programs_[which]) {
    const Status built = build(which);
    failed_[which] = !built;
    if (!built) {
      logError(built.error().message);
      return false;
    }
  }
  programs_[which].use();
  current_ = which;
  if (locations_[which][kFocusPart] >= 0) set(kFocusPart, part_);
  return true;
}

void Passes::set(Uniform uniform, const Vec4& v) const {
  gl_.Uniform4f(locations_[current_][uniform], v.x(), v.y(), v.z(), v.w());
}

void Passes::bindTexture(GLint unit, GLuint texture) const {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, texture);
}

void Passes::choose(Part part, const Focus& focus) {
  part_ = Vec4(focus.distance, 1.0f / maxOf(focus.range, 1e-3f), part == Part::Far ? 0.0f : 1.0f,
               part == Part::Near ? 0.0f : 1.0f);
}

void Passes::setMaterials(const MaterialUniforms& materials) {
  gl_.BindBuffer(GL_UNIFORM_BUFFER, materialBlock_.name());
  gl_.BufferData(GL_UNIFORM_BUFFER, sizeof(materials), &materials, GL_DYNAMIC_DRAW);
}

void Passes::begin(const FrameUniforms& uniforms) {
  counters_ = {};
  choose(Part::Whole, {});
  gl_.BindBuffer(GL_UNIFORM_BUFFER, frameBlock_.name());
  gl_.BufferData(GL_UNIFORM_BUFFER, sizeof(uniforms), &uniforms, GL_STREAM_DRAW);
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, frameBlock_.name());
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, kMaterialBlock, materialBlock_.name());
}

void Passes::setState(Depth depth, Blend blend, Faces faces) {
  const auto turn = [this](GLenum what, bool on) { on ? gl_.Enable(what) : gl_.Disable(what); };
  turn(GL_DEPTH_TEST, depth != Depth::Off);
  gl_.DepthMask(depth == Depth::Write ? GL_TRUE : GL_FALSE);
  gl_.DepthFunc(GL_LEQUAL);
  turn(GL_BLEND, blend != Blend::Off);
  if (blend == Blend::Over) gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  if (blend == Blend::Premultiplied) gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (blend == Blend::Add) gl_.BlendFunc(GL_ONE, GL_ONE);
  turn(GL_CULL_FACE, faces != Faces::All);
  gl_.CullFace((faces == Faces::Back) != inMirror_ ? GL_FRONT : GL_BACK);
}

void Passes::count(std::size_t triangles) {
  ++counters_.draws;
  counters_.triangles += static_cast<std::uint32_t>(triangles);
}

void Passes::background() {
  setState(Depth::Write, Blend::Off, Faces::All);  // the depth mask also lets the clear through
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  setState(Depth::Off, Blend::Off, Faces::All);
  use(kBackgroundProgram);
  drawScreen();
}

void Passes::drawScreen() {
  gl_.BindVertexArray(empty_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  count(1);
}

void Passes::room(const StaticMesh& mesh, const Vec3& offset, bool polished) {
  if (mesh.triangles(polished) == 0) return;
  setState(Depth::Write, polished ? Blend::Premultiplied : Blend::Off, Faces::Front);
  if (!use(kRoomProgram)) return;
  if (!tiles_) tiles_ = makeTileTexture(gl_);
  bindTexture(kUnitTiles, tiles_.name());
  set(kOffset, Vec4(offset.x(), offset.y(), offset.z(), polished ? 1.0f : 0.0f));
  mesh.draw(gl_, polished);
  count(mesh.triangles(polished));
}

void Passes::drawTriangles(GLuint indexBuffer, const std::vector<std::uint32_t>& indices) {
  stream(gl_, GL_ELEMENT_ARRAY_BUFFER, indexBuffer, indices);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
  counters_.indicesUploaded += static_cast<std::uint32_t>(indices.size());
  count(indices.size() / 3);
}

void Passes::solid(const MeshStore& store, const std::vector<std::uint32_t>& indices) {
  if (indices.empty()) return;
  setState(Depth::Write, Blend::Off, Faces::All);
  if (!use(kSolidProgram)) return;
  store.bind();
  drawTriangles(store.indexBuffer(), indices);
}

void Passes::spheres(const std::vector<SphereInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Write, Blend::Off, Faces::Front);
  if (!use(kSphereProgram)) return;
  sphereBatch_.draw(gl_, instances);
  count(instances.size() * sphereBatch_.triangles());
}

void Passes::crumbs(const std::vector<CrumbInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Write, Blend::Off, Faces::All);
  if (!use(kCrumbProgram)) return;
  crumbBatch_.draw(gl_, GL_TRIANGLES, kTetrahedronVertices, instances);
  count(instances.size() * 4);
}

void Passes::glass(const MeshStore& store, const std::vector<std::uint32_t>& indices, float refraction, bool cut) {
  if (indices.empty()) return;
  setState(Depth::Test, Blend::Premultiplied, Faces::All);
  if (!use(kGlassProgram)) return;
  set(kBend, Vec4(refraction, cut ? 1.0f : 0.0f, 0.0f, 0.0f));
  store.bind();
  drawTriangles(store.indexBuffer(), indices);
}

void Passes::edges(const MeshStore& store, const std::vector<EdgeInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Test, Blend::Premultiplied, Faces::All);
  if (!use(kEdgeProgram)) return;
  store.bindTables();
  edgeBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
  counters_.lines += static_cast<std::uint32_t>(instances.size());
}

void Passes::glows(const std::vector<GlowInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Test, Blend::Premultiplied, Faces::All);
  if (!use(kGlowProgram)) return;
  glowBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

void Passes::beams(const std::vector<BeamInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Test, Blend::Add, Faces::All);
  if (!use(kBeamProgram)) return;
  beamBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

void Passes::composite(Target& target, float strength, const Vec4& tint, const Vec4& border) {
  target.resolve(kUnitColor);
  if constexpr (effects::kHasBloom)
    if (strength > 0.0f) bloom(target);
  target.bindPicture();
  setState(Depth::Off, Blend::Off, Faces::All);
  use(kCompositeProgram);
  set(kTint, tint);
  set(kBorder, border);
  set(kTap, Vec4(strength, 0.0f, 0.0f, 0.0f));
  drawScreen();
  // The next frame draws into them, and WebGL refuses that while a program could read them.
  bindTexture(kUnitColor, 0);
  if (strength > 0.0f) bindTexture(kUnitBloom, 0);
}

void Passes::hud(const std::vector<HudInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Off, Blend::Over, Faces::All);
  if (!use(kHudProgram)) return;
  if (!glyphs_) glyphs_ = makeGlyphTexture(gl_);
  bindTexture(kUnitGlyphs, glyphs_.name());
  hudBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

void Passes::overlay(const Overlay& overlay, int width, int height) {
  if (overlay.parts.empty()) return;
  setState(Depth::Off, Blend::Over, Faces::All);
  if (!use(kOverlayProgram)) return;
  count(overlayBatch_.draw(gl_, overlay, width, height));
}

}  // namespace brittle::render
