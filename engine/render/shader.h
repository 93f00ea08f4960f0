// render/shader.h - programs compiled from the sources in glsl_*.cpp, with every uniform block and texture unit bound
// by name.
#pragma once

#include <string>

#include "engine/core/result.h"
#include "engine/render/gl.h"

namespace brittle::render {

/// Uniform blocks and texture units have one fixed place for all programs; a program uses those its source names. No
/// program reads the scratch unit: textures made in the middle of a frame are bound there.
enum BlockBinding : GLuint { kFrameBlock, kMaterialBlock };
enum TextureUnit : GLint {
  kUnitBodies,
  kUnitShapes,
  kUnitColor,
  kUnitDepth,
  kUnitTiles,
  kUnitGlyphs,
  kUnitDecals,
  kUnitBloom,
  kUnitOverlay,
  kUnitScratch
};

struct ProgramSource {
  const char* name;    // for messages
  const char* vertex;  // without the version line and the common part
  const char* fragment;
};

class Program {
 public:
  Program() = default;
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;

  /// Fails with the program's name, the stage and the compiler's words.
  static Result<Program> build(const Gl& gl, const ProgramSource& source);

  explicit operator bool() const { return name_ != 0; }
  void use() const { gl_->UseProgram(name_); }
  /// -1 if the program has no such uniform; setting -1 is legal and does nothing.
  GLint location(const char* uniform) const { return gl_->GetUniformLocation(name_, uniform); }

 private:
  Program(const Gl& gl, GLuint name) : gl_(&gl), name_(name) {}
  void bindPlaces() const;

  const Gl* gl_ = nullptr;
  GLuint name_ = 0;
};

}  // namespace brittle::render
