#include "engine/render/passes.h"

#include "engine/core/profile.h"
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
constexpr std::array<Attribute, 2> kPlaceLayout = {{{1, 4, GL_FLOAT, As::Float, 0},
                                                    {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 16}}};
constexpr std::array<Attribute, 3> kBeamLayout = {{{0, 4, GL_FLOAT, As::Float, 0},
                                                   {1, 3, GL_FLOAT, As::Float, 16},
                                                   {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 28}}};
constexpr std::array<Attribute, 2> kShadowLayout = {{{1, 4, GL_FLOAT, As::Float, 0}, {2, 2, GL_FLOAT, As::Float, 16}}};
constexpr std::array<Attribute, 4> kEdgeLayout = {{{0, 3, GL_FLOAT, As::Float, 0},
                                                   {1, 3, GL_FLOAT, As::Float, 12},
                                                   {2, 1, GL_UNSIGNED_INT, As::Whole, 24},
                                                   {3, 1, GL_FLOAT, As::Float, 28}}};
constexpr std::array<Attribute, 3> kHudLayout = {{{0, 4, GL_FLOAT, As::Float, 0},
                                                  {1, 4, GL_FLOAT, As::Float, 16},
                                                  {2, 4, GL_UNSIGNED_BYTE, As::Normalized, 32}}};
constexpr GLsizei kQuadVertices = 4, kBoxVertices = 14, kTetrahedronVertices = 12;

void bindTexture(const Gl& gl, GLint unit, GLuint texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, texture);
}

void set(const Gl& gl, GLint location, const Vec4& v) { gl.Uniform4f(location, v.x(), v.y(), v.z(), v.w()); }

}  // namespace

Passes::Passes(const Gl& gl)
    : gl_(gl),
      frameBlock_(gl),
      materialBlock_(gl),
      empty_(gl),
      strokes_(makeStrokeTexture(gl)),
      tiles_(makeTileTexture(gl)),
      sphereBatch_(gl, sizeof(SphereInstance), kSphereLayout),
      crumbBatch_(gl, sizeof(PlaceInstance), kPlaceLayout),
      glowBatch_(gl, sizeof(PlaceInstance), kPlaceLayout),
      beamBatch_(gl, sizeof(BeamInstance), kBeamLayout),
      shadowBatch_(gl, sizeof(ShadowInstance), kShadowLayout),
      edgeBatch_(gl, sizeof(EdgeInstance), kEdgeLayout),
      hudBatch_(gl, sizeof(HudInstance), kHudLayout) {}

Result<std::unique_ptr<Passes>> Passes::create(const Gl& gl) {
  const ProgramSource* sources[kPrograms] = {&glsl::kBackground, &glsl::kRoom, &glsl::kSolid, &glsl::kSphere,
                                          &glsl::kCrumb,      &glsl::kShadow, &glsl::kGlass, &glsl::kEdge,
                                          &glsl::kGlow,       &glsl::kBeam, &glsl::kComposite, &glsl::kHud};
  std::unique_ptr<Passes> passes(new Passes(gl));
  for (int i = 0; i < kPrograms; ++i) {
    Result<Program> program = Program::build(gl, *sources[i]);
    if (!program) return program.error();
    passes->programs_[static_cast<std::size_t>(i)] = std::move(*program);
  }
  passes->roomOffset_ = passes->programs_[kRoomProgram].location("offset");
  passes->glassBend_ = passes->programs_[kGlassProgram].location("bend");
  passes->compositeTint_ = passes->programs_[kCompositeProgram].location("tint");
  passes->compositeBorder_ = passes->programs_[kCompositeProgram].location("border");
  return passes;
}

void Passes::setMaterials(const MaterialUniforms& materials) {
  gl_.BindBuffer(GL_UNIFORM_BUFFER, materialBlock_.name());
  gl_.BufferData(GL_UNIFORM_BUFFER, sizeof(materials), &materials, GL_DYNAMIC_DRAW);
}

void Passes::begin(const FrameUniforms& uniforms) {
  counters_ = {};
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
  gl_.CullFace(faces == Faces::Back ? GL_FRONT : GL_BACK);
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
  gl_.BindVertexArray(empty_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  count(1);
}

void Passes::beginRooms() {
  setState(Depth::Write, Blend::Off, Faces::Front);
  use(kRoomProgram);
  bindTexture(gl_, kUnitTiles, tiles_.name());
}

void Passes::room(const StaticMesh& mesh, const Vec3& offset) {
  gl_.Uniform4f(roomOffset_, offset.x(), offset.y(), offset.z(), 0.0f);
  mesh.draw(gl_);
  count(mesh.triangles());
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
  use(kSolidProgram);
  store.bind();
  drawTriangles(store.indexBuffer(), indices);
}

void Passes::spheres(const std::vector<SphereInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Write, Blend::Off, Faces::Front);
  use(kSphereProgram);
  sphereBatch_.draw(gl_, instances);
  count(instances.size() * sphereBatch_.triangles());
}

void Passes::crumbs(const std::vector<PlaceInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Write, Blend::Off, Faces::All);
  use(kCrumbProgram);
  crumbBatch_.draw(gl_, GL_TRIANGLES, kTetrahedronVertices, instances);
  count(instances.size() * 4);
}

void Passes::shadows(const std::vector<ShadowInstance>& instances, Target& target) {
  if (instances.empty()) return;
  target.copyDepth(kUnitDepth);
  // Back faces without a depth test: seen from inside the box, too.
  setState(Depth::Off, Blend::Over, Faces::Back);
  use(kShadowProgram);
  shadowBatch_.draw(gl_, GL_TRIANGLE_STRIP, kBoxVertices, instances);
  count(instances.size() * 12);
}

void Passes::glass(const MeshStore& store, const std::vector<std::uint32_t>& indices, float refraction) {
  if (indices.empty()) return;
  setState(Depth::Test, Blend::Premultiplied, Faces::All);
  use(kGlassProgram);
  gl_.Uniform4f(glassBend_, refraction, 0.0f, 0.0f, 0.0f);
  store.bind();
  drawTriangles(store.indexBuffer(), indices);
}

void Passes::edges(const MeshStore& store, const std::vector<EdgeInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Test, Blend::Premultiplied, Faces::All);
  use(kEdgeProgram);
  store.bindTables();
  edgeBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
  counters_.lines += static_cast<std::uint32_t>(instances.size());
}

void Passes::glows(const std::vector<PlaceInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Test, Blend::Add, Faces::All);
  use(kGlowProgram);
  glowBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

void Passes::beams(const std::vector<BeamInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Test, Blend::Add, Faces::All);
  use(kBeamProgram);
  beamBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

void Passes::composite(Target& target, const Vec4& tint, const Vec4& border) {
  target.resolve(kUnitColor);
  target.bindPicture();
  setState(Depth::Off, Blend::Off, Faces::All);
  use(kCompositeProgram);
  set(gl_, compositeTint_, tint);
  set(gl_, compositeBorder_, border);
  gl_.BindVertexArray(empty_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  bindTexture(gl_, kUnitColor, 0);  // the next frame draws into it, and WebGL refuses that while a program could read it
  count(1);
}

void Passes::hud(const std::vector<HudInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Off, Blend::Over, Faces::All);
  use(kHudProgram);
  bindTexture(gl_, kUnitStrokes, strokes_.name());
  hudBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

}  // namespace brittle::render
