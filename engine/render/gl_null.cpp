#include "engine/render/gl_null.h"

#include <cstring>

#include "engine/core/assert.h"

namespace brittle::render {

namespace {

NullGl* current = nullptr;

/// What stands in the table, for every entry.
template <class Function, int index>
struct Counter;

const char* const kNames[] = {
#define BR_GL_NAME(name, type) #name,
    BR_GL_FUNCTIONS(BR_GL_NAME)
#undef BR_GL_NAME
};

}  // namespace

/// The functions that do more than count. Names as in the table.
struct NullFunctions {
  static NullGl& self() {
    BR_ASSERT(current != nullptr);
    return *current;
  }
  static void count(int index) { ++self().calls_[kNames[index]]; }

  template <class Map>
  static void generate(Map& map, GLsizei n, GLuint* names) {
    for (GLsizei i = 0; i < n; ++i) {
      names[i] = self().nextName_++;
      map[names[i]] = {};
    }
  }
  template <class Map>
  static void remove(Map& map, const char* what, GLsizei n, const GLuint* names) {
    for (GLsizei i = 0; i < n; ++i) {
      if (names[i] != 0 && map.erase(names[i]) == 0) {
        self().complain(std::string("deleted ") + what + " " + std::to_string(names[i]) + " that does not exist");
      }
    }
  }
  template <class Map>
  static bool exists(const Map& map, const char* what, GLuint name) {
    if (name == 0 || map.count(name) != 0) return true;
    self().complain(std::string("bound ") + what + " " + std::to_string(name) + " that does not exist");
    return false;
  }

  static void GenBuffers(GLsizei n, GLuint* names) { generate(self().buffers_, n, names); }
  static void GenTextures(GLsizei n, GLuint* names) { generate(self().textures_, n, names); }
  static void GenFramebuffers(GLsizei n, GLuint* names) { generate(self().framebuffers_, n, names); }
  static void GenRenderbuffers(GLsizei n, GLuint* names) { generate(self().renderbuffers_, n, names); }
  static void GenVertexArrays(GLsizei n, GLuint* names) { generate(self().arrays_, n, names); }
  static void DeleteBuffers(GLsizei n, const GLuint* names) { remove(self().buffers_, "buffer", n, names); }
  static void DeleteTextures(GLsizei n, const GLuint* names) {
    remove(self().textures_, "texture", n, names);
    for (auto& [unit, texture] : self().boundTextures_) {
      if (self().textures_.count(texture) == 0) texture = 0;
    }
  }
  static void DeleteFramebuffers(GLsizei n, const GLuint* names) {
    remove(self().framebuffers_, "framebuffer", n, names);
  }
  static void DeleteRenderbuffers(GLsizei n, const GLuint* names) {
    remove(self().renderbuffers_, "renderbuffer", n, names);
  }
  static void DeleteVertexArrays(GLsizei n, const GLuint* names) { remove(self().arrays_, "vertex array", n, names); }

  static GLuint CreateShader(GLenum) {
    const GLuint name = self().nextName_++;
    self().shaders_[name] = true;
    return name;
  }
  static void CompileShader(GLuint shader) { self().shaders_[shader] = self().shaderError_.empty(); }
  static void GetShaderiv(GLuint shader, GLenum, GLint* value) { *value = self().shaders_[shader] ? 1 : 0; }
  static void GetShaderInfoLog(GLuint, GLsizei room, GLsizei* length, GLchar* text) {
    std::string& message = self().shaderError_;
    *length = static_cast<GLsizei>(message.copy(text, static_cast<std::size_t>(room) - 1));
    text[*length] = 0;
    message.clear();
  }
  static void DeleteShader(GLuint shader) { remove(self().shaders_, "shader", 1, &shader); }
  static GLuint CreateProgram() {
    const GLuint name = self().nextName_++;
    self().programs_[name] = true;
    return name;
  }
  static void GetProgramiv(GLuint, GLenum, GLint* value) { *value = 1; }
  static void DeleteProgram(GLuint program) { remove(self().programs_, "program", 1, &program); }
  static void UseProgram(GLuint program) {
    if (exists(self().programs_, "program", program)) self().program_ = program;
  }
  /// Every uniform exists, and its location tells which program it belongs to.
  static GLint GetUniformLocation(GLuint program, const GLchar* name) {
    return static_cast<GLint>(program * 100 + std::strlen(name));
  }
  static void checkUniform(GLint location) {
    if (location >= 0 && static_cast<GLuint>(location) / 100 != self().program_) {
      self().complain("a uniform of program " + std::to_string(location / 100) + " is set while program " +
                      std::to_string(self().program_) + " is in use");
    }
  }
  static void Uniform1i(GLint location, GLint) { checkUniform(location); }
  static void Uniform4f(GLint location, GLfloat, GLfloat, GLfloat, GLfloat) { checkUniform(location); }

  static void BindBuffer(GLenum target, GLuint name) {
    if (exists(self().buffers_, "buffer", name)) self().bufferAt(target) = name;
  }
  static void BindVertexArray(GLuint name) {
    if (exists(self().arrays_, "vertex array", name)) self().array_ = name;
  }
  static void ActiveTexture(GLenum unit) { self().activeUnit_ = unit; }
  static void BindTexture(GLenum, GLuint name) {
    if (exists(self().textures_, "texture", name)) self().boundTextures_[self().activeUnit_] = name;
  }
  static void BindRenderbuffer(GLenum, GLuint name) {
    if (exists(self().renderbuffers_, "renderbuffer", name)) self().boundRenderbuffer_ = name;
  }
  static void BindFramebuffer(GLenum target, GLuint name) {
    if (!exists(self().framebuffers_, "framebuffer", name)) return;
    if (target != GL_READ_FRAMEBUFFER) self().drawFramebuffer_ = name;
    if (target != GL_DRAW_FRAMEBUFFER) self().readFramebuffer_ = name;
  }

  static void BufferData(GLenum target, GLsizeiptr size, const void* data, GLenum) {
    const GLuint name = self().bufferAt(target);
    if (name == 0) return self().complain("BufferData without a buffer bound");
    self().buffers_[name].size = size;
    if (data != nullptr) self().bytes_[target] += static_cast<std::uint64_t>(size);
  }
  static void BufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void*) {
    const GLuint name = self().bufferAt(target);
    if (name == 0) return self().complain("BufferSubData without a buffer bound");
    if (offset + size > self().buffers_[name].size) {
      self().complain("BufferSubData up to byte " + std::to_string(offset + size) + " of a buffer of " +
                      std::to_string(self().buffers_[name].size));
    }
    self().bytes_[target] += static_cast<std::uint64_t>(size);
  }
  static NullGl::Texture* boundTexture(const char* call) {
    const GLuint name = self().boundTextures_[self().activeUnit_];
    if (name != 0) return &self().textures_[name];
    self().complain(std::string(call) + " without a texture bound");
    return nullptr;
  }
  static void TexStorage2D(GLenum, GLsizei, GLenum, GLsizei width, GLsizei height) {
    NullGl::Texture* texture = boundTexture("TexStorage2D");
    if (texture == nullptr) return;
    if (texture->width != 0) self().complain("TexStorage2D on a texture that has storage already: it cannot change");
    *texture = {width, height};
  }
  static void TexSubImage2D(GLenum, GLint, GLint x, GLint y, GLsizei width, GLsizei height, GLenum, GLenum,
                            const void*) {
    const NullGl::Texture* texture = boundTexture("TexSubImage2D");
    if (texture != nullptr && (x + width > texture->width || y + height > texture->height)) {
      self().complain("TexSubImage2D beyond the texture's " + std::to_string(texture->width) + " x " +
                      std::to_string(texture->height));
    }
  }

  static void attach(GLenum attachment, GLuint texture) {
    if (self().drawFramebuffer_ == 0) return self().complain("an attachment to framebuffer 0, which has none");
    NullGl::Framebuffer& framebuffer = self().framebuffers_[self().drawFramebuffer_];
    const bool isDepth = attachment == GL_DEPTH_ATTACHMENT;
    (isDepth ? framebuffer.hasDepth : framebuffer.hasColor) = true;
    (isDepth ? framebuffer.depthTexture : framebuffer.colorTexture) = texture;
  }
  static void FramebufferTexture2D(GLenum, GLenum attachment, GLenum, GLuint texture, GLint) {
    attach(attachment, texture);
  }
  static void FramebufferRenderbuffer(GLenum, GLenum attachment, GLenum, GLuint) { attach(attachment, 0); }
  static GLenum CheckFramebufferStatus(GLenum) { return GL_FRAMEBUFFER_COMPLETE; }
  static void BlitFramebuffer(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum) {
    if (self().readFramebuffer_ == self().drawFramebuffer_) self().complain("a framebuffer is copied onto itself");
  }
  static void Viewport(GLint, GLint, GLsizei width, GLsizei height) {
    self().viewportWidth_ = width;
    self().viewportHeight_ = height;
  }
  static void ReadPixels(GLint, GLint, GLsizei width, GLsizei height, GLenum, GLenum, void* pixels) {
    std::memset(pixels, 0, 4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }
  static const GLubyte* GetString(GLenum) { return reinterpret_cast<const GLubyte*>("OpenGL ES 3.0 null"); }
  static GLuint GetUniformBlockIndex(GLuint, const GLchar*) { return 0; }

  static void DrawArrays(GLenum, GLint, GLsizei count) { self().checkDraw(count, 1); }
  static void DrawArraysInstanced(GLenum, GLint, GLsizei count, GLsizei instances) {
    self().checkDraw(count, instances);
  }
  static void DrawElements(GLenum, GLsizei count, GLenum type, const void* offset) {
    self().checkIndices(count, type, reinterpret_cast<std::uintptr_t>(offset));
    self().checkDraw(count, 1);
  }
  static void DrawElementsInstanced(GLenum, GLsizei count, GLenum type, const void* offset, GLsizei instances) {
    self().checkIndices(count, type, reinterpret_cast<std::uintptr_t>(offset));
    self().checkDraw(count, instances);
  }
};

namespace {

/// Calls are counted first, then passed on to the function above, or answered with zero.
template <class R, class... A, int index>
struct Counter<R(GL_APIENTRYP)(A...), index> {
  static inline R (*next)(A...) = nullptr;
  static R GL_APIENTRY call(A... arguments) {
    NullFunctions::count(index);
    if (next != nullptr) return next(arguments...);
    return R();
  }
};

enum Index : int {
#define BR_GL_INDEX(name, type) k##name,
  BR_GL_FUNCTIONS(BR_GL_INDEX)
#undef BR_GL_INDEX
};

}  // namespace

NullGl::NullGl() {
  BR_ASSERT(current == nullptr);
  current = this;
#define BR_GL_COUNT(name, type) table_.name = Counter<type, k##name>::call;
  BR_GL_FUNCTIONS(BR_GL_COUNT)
#undef BR_GL_COUNT
#define BR_GL_ANSWER(name) Counter<decltype(table_.name), k##name>::next = NullFunctions::name;
#define BR_GL_ANSWERED(X)                                                                                             \
  X(GenBuffers)                                                                                                       \
  X(GenTextures) X(GenFramebuffers) X(GenRenderbuffers) X(GenVertexArrays) X(DeleteBuffers) X(DeleteTextures)         \
      X(DeleteFramebuffers) X(DeleteRenderbuffers) X(DeleteVertexArrays) X(CreateShader) X(CompileShader)             \
          X(GetShaderiv) X(GetShaderInfoLog) X(DeleteShader) X(CreateProgram) X(GetProgramiv) X(DeleteProgram)        \
              X(UseProgram) X(GetUniformLocation) X(Uniform1i) X(Uniform4f) X(BindBuffer) X(BindVertexArray)          \
                  X(ActiveTexture) X(BindTexture) X(BindRenderbuffer) X(BindFramebuffer) X(BufferData)                \
                      X(BufferSubData) X(TexStorage2D) X(TexSubImage2D) X(FramebufferTexture2D)                       \
                          X(FramebufferRenderbuffer) X(CheckFramebufferStatus) X(BlitFramebuffer) X(Viewport)         \
                              X(ReadPixels) X(GetString) X(GetUniformBlockIndex) X(DrawArrays) X(DrawArraysInstanced) \
                                  X(DrawElements) X(DrawElementsInstanced)
  BR_GL_ANSWERED(BR_GL_ANSWER)
#undef BR_GL_ANSWERED
#undef BR_GL_ANSWER
  table_.description = "null";
}

NullGl::~NullGl() {
  current = nullptr;
}

void* NullGl::find(const char* name) {
  BR_ASSERT(current != nullptr);
#define BR_GL_FIND(function, type) \
  if (std::strcmp(name, "gl" #function) == 0) return reinterpret_cast<void*>(current->table_.function);
  BR_GL_FUNCTIONS(BR_GL_FIND)
#undef BR_GL_FIND
  return nullptr;
}

GLuint& NullGl::bufferAt(GLenum target) {
  // The index buffer belongs to the vertex array, as in GL.
  return target == GL_ELEMENT_ARRAY_BUFFER ? arrays_[array_].indexBuffer : boundBuffers_[target];
}

void NullGl::checkIndices(GLsizei count, GLenum type, std::uintptr_t offset) {
  const GLuint buffer = arrays_[array_].indexBuffer;
  if (buffer == 0) return complain("an indexed draw without an index buffer");
  const std::uintptr_t end = offset + static_cast<std::uintptr_t>(count) * (type == GL_UNSIGNED_INT ? 4u : 2u);
  if (end > static_cast<std::uintptr_t>(buffers_[buffer].size)) {
    complain("a draw reads indices up to byte " + std::to_string(end) + " of " + std::to_string(buffers_[buffer].size));
  }
}

void NullGl::checkDraw(GLsizei vertices, GLsizei instances) {
  if (program_ == 0) complain("a draw without a program");
  if (array_ == 0) complain("a draw without a vertex array: GLES allows it, core profiles do not");
  if (vertices <= 0 || instances <= 0) complain("a draw of nothing");
  if (viewportWidth_ <= 0 || viewportHeight_ <= 0) complain("a draw into an empty viewport");
  const Framebuffer target = drawFramebuffer_ != 0 ? framebuffers_[drawFramebuffer_] : Framebuffer{};
  if (drawFramebuffer_ != 0 && !target.hasColor) complain("a draw into a framebuffer without colour");
  for (const auto& [unit, texture] : boundTextures_) {
    if (texture != 0 && (texture == target.colorTexture || texture == target.depthTexture)) {
      complain("texture " + std::to_string(texture) + " is bound for reading while it is drawn into");
    }
  }
  draws_.push_back({program_, vertices, instances, drawFramebuffer_});
}

std::uint32_t NullGl::calls(const std::string& function) const {
  const auto found = calls_.find(function);
  return found != calls_.end() ? found->second : 0;
}

std::uint64_t NullGl::bytesTo(GLenum target) const {
  const auto found = bytes_.find(target);
  return found != bytes_.end() ? found->second : 0;
}

std::size_t NullGl::liveObjects() const {
  // arrays_[0] may exist: it stands for "no vertex array".
  return buffers_.size() + textures_.size() + framebuffers_.size() + renderbuffers_.size() + arrays_.size() -
         arrays_.count(0) + shaders_.size() + programs_.size();
}

void NullGl::clearRecord() {
  draws_.clear();
  calls_.clear();
  bytes_.clear();
}

}  // namespace brittle::render
