#include "engine/render/shader.h"

#include <utility>

#include "engine/render/glsl.h"

namespace brittle::render {

namespace {

std::string infoLog(const Gl& gl, GLuint object, bool isProgram) {
  char text[2048] = "";
  GLsizei length = 0;
  if (isProgram) {
    gl.GetProgramInfoLog(object, sizeof(text), &length, text);
  } else {
    gl.GetShaderInfoLog(object, sizeof(text), &length, text);
  }
  return std::string(text, static_cast<std::size_t>(length));
}

Result<GLuint> compile(const Gl& gl, GLenum stage, const ProgramSource& source) {
  const bool isVertex = stage == GL_VERTEX_SHADER;
  const char* parts[] = {glsl::kHeader, isVertex ? glsl::kVertexCommon : glsl::kFragmentCommon,
                         isVertex ? source.vertex : source.fragment};
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 3, parts, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != 0) return shader;
  const Error error{std::string("shader ") + source.name + (isVertex ? " (vertex): " : " (fragment): ") +
                    infoLog(gl, shader, false)};
  gl.DeleteShader(shader);
  return error;
}

}  // namespace

Program::~Program() {
  if (name_ != 0) gl_->DeleteProgram(name_);
}

Program::Program(Program&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(name_, other.name_);
  return *this;
}

Result<Program> Program::build(const Gl& gl, const ProgramSource& source) {
  const Result<GLuint> vertex = compile(gl, GL_VERTEX_SHADER, source);
  if (!vertex) return vertex.error();
  const Result<GLuint> fragment = compile(gl, GL_FRAGMENT_SHADER, source);
  if (!fragment) {
    gl.DeleteShader(*vertex);
    return fragment.error();
  }
  Program program(gl, gl.CreateProgram());
  gl.AttachShader(program.name_, *vertex);
  gl.AttachShader(program.name_, *fragment);
  gl.LinkProgram(program.name_);
  gl.DeleteShader(*vertex);  // the program keeps them until it goes
  gl.DeleteShader(*fragment);
  GLint linked = 0;
  gl.GetProgramiv(program.name_, GL_LINK_STATUS, &linked);
  if (linked == 0) return Error{std::string("shader ") + source.name + " (link): " + infoLog(gl, program.name_, true)};
  program.bindPlaces();
  return program;
}

void Program::bindPlaces() const {
  const std::pair<const char*, GLuint> blocks[] = {{"FrameBlock", kFrameBlock}, {"MaterialBlock", kMaterialBlock}};
  for (const auto& [name, place] : blocks) {
    const GLuint index = gl_->GetUniformBlockIndex(name_, name);
    if (index != GL_INVALID_INDEX) gl_->UniformBlockBinding(name_, index, place);
  }
  use();
  const std::pair<const char*, GLint> units[] = {
      {"bodyTexture", kUnitBodies},  {"shapeTexture", kUnitShapes}, {"colorTexture", kUnitColor},
      {"depthTexture", kUnitDepth},  {"tileTexture", kUnitTiles},   {"glyphTexture", kUnitGlyphs},
      {"decalTexture", kUnitDecals}, {"bloomTexture", kUnitBloom},  {"coverageTexture", kUnitOverlay}};
  for (const auto& [name, unit] : units) gl_->Uniform1i(location(name), unit);
}

}  // namespace brittle::render
