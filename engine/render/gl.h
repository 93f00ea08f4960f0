// render/gl.h - the GL functions we use, as a table filled through a callback: nothing links against a GL library, and
// a null table can stand in for a driver. Only this folder calls GL.
#pragma once

#ifndef GL_GLES_PROTOTYPES
#define GL_GLES_PROTOTYPES 0
#endif
#include <GLES3/gl3.h>

#include <string>

#include "engine/core/result.h"

// name, type: every function of the table.
#define BR_GL_FUNCTIONS(X)                                                   \
  X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                                   \
  X(AttachShader, PFNGLATTACHSHADERPROC)                                     \
  X(BindBuffer, PFNGLBINDBUFFERPROC)                                         \
  X(BindBufferBase, PFNGLBINDBUFFERBASEPROC)                                 \
  X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                               \
  X(BindRenderbuffer, PFNGLBINDRENDERBUFFERPROC)                             \
  X(BindTexture, PFNGLBINDTEXTUREPROC)                                       \
  X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                               \
  X(BlendFunc, PFNGLBLENDFUNCPROC)                                           \
  X(BlitFramebuffer, PFNGLBLITFRAMEBUFFERPROC)                               \
  X(BufferData, PFNGLBUFFERDATAPROC)                                         \
  X(BufferSubData, PFNGLBUFFERSUBDATAPROC)                                   \
  X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC)                 \
  X(Clear, PFNGLCLEARPROC)                                                   \
  X(CompileShader, PFNGLCOMPILESHADERPROC)                                   \
  X(CreateProgram, PFNGLCREATEPROGRAMPROC)                                   \
  X(CreateShader, PFNGLCREATESHADERPROC)                                     \
  X(CullFace, PFNGLCULLFACEPROC)                                             \
  X(DeleteBuffers, PFNGLDELETEBUFFERSPROC)                                   \
  X(DeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC)                         \
  X(DeleteProgram, PFNGLDELETEPROGRAMPROC)                                   \
  X(DeleteRenderbuffers, PFNGLDELETERENDERBUFFERSPROC)                       \
  X(DeleteShader, PFNGLDELETESHADERPROC)                                     \
  X(DeleteTextures, PFNGLDELETETEXTURESPROC)                                 \
  X(DeleteVertexArrays, PFNGLDELETEVERTEXARRAYSPROC)                         \
  X(DepthFunc, PFNGLDEPTHFUNCPROC)                                           \
  X(DepthMask, PFNGLDEPTHMASKPROC)                                           \
  X(Disable, PFNGLDISABLEPROC)                                               \
  X(DrawArrays, PFNGLDRAWARRAYSPROC)                                         \
  X(DrawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC)                       \
  X(DrawElements, PFNGLDRAWELEMENTSPROC)                                     \
  X(DrawElementsInstanced, PFNGLDRAWELEMENTSINSTANCEDPROC)                   \
  X(Enable, PFNGLENABLEPROC)                                                 \
  X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC)               \
  X(Finish, PFNGLFINISHPROC)                                                 \
  X(FramebufferRenderbuffer, PFNGLFRAMEBUFFERRENDERBUFFERPROC)               \
  X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)                     \
  X(GenBuffers, PFNGLGENBUFFERSPROC)                                         \
  X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)                               \
  X(GenRenderbuffers, PFNGLGENRENDERBUFFERSPROC)                             \
  X(GenTextures, PFNGLGENTEXTURESPROC)                                       \
  X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)                               \
  X(GenerateMipmap, PFNGLGENERATEMIPMAPPROC)                                 \
  X(GetError, PFNGLGETERRORPROC)                                             \
  X(GetIntegerv, PFNGLGETINTEGERVPROC)                                       \
  X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)                           \
  X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                                     \
  X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)                             \
  X(GetShaderiv, PFNGLGETSHADERIVPROC)                                       \
  X(GetString, PFNGLGETSTRINGPROC)                                           \
  X(GetUniformBlockIndex, PFNGLGETUNIFORMBLOCKINDEXPROC)                     \
  X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)                         \
  X(LinkProgram, PFNGLLINKPROGRAMPROC)                                       \
  X(PixelStorei, PFNGLPIXELSTOREIPROC)                                       \
  X(ReadPixels, PFNGLREADPIXELSPROC)                                         \
  X(RenderbufferStorageMultisample, PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC) \
  X(Scissor, PFNGLSCISSORPROC)                                               \
  X(ShaderSource, PFNGLSHADERSOURCEPROC)                                     \
  X(TexParameteri, PFNGLTEXPARAMETERIPROC)                                   \
  X(TexStorage2D, PFNGLTEXSTORAGE2DPROC)                                     \
  X(TexSubImage2D, PFNGLTEXSUBIMAGE2DPROC)                                   \
  X(Uniform1i, PFNGLUNIFORM1IPROC)                                           \
  X(Uniform4f, PFNGLUNIFORM4FPROC)                                           \
  X(UniformBlockBinding, PFNGLUNIFORMBLOCKBINDINGPROC)                       \
  X(UseProgram, PFNGLUSEPROGRAMPROC)                                         \
  X(VertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC)                       \
  X(VertexAttribIPointer, PFNGLVERTEXATTRIBIPOINTERPROC)                     \
  X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)                       \
  X(Viewport, PFNGLVIEWPORTPROC)

namespace brittle::render {

/// Finds a GL function by its full name ("glClear"); null if there is none.
using GlLoader = void* (*)(const char* name);

/// The table. Members are called like functions: gl.Clear(bits).
class Gl {
 public:
#define BR_GL_MEMBER(name, type) type name = nullptr;
  BR_GL_FUNCTIONS(BR_GL_MEMBER)
#undef BR_GL_MEMBER

  /// "3.2 Mesa 22.3.6, llvmpipe ...", for the log.
  std::string description;
};

/// Fills the table from the context that is current. Fails naming the first missing function, or the version when it is
/// below GLES 3.0 (a desktop core context must offer GLES 3 shaders). Desktop contexts are set to behave like GLES:
/// sRGB framebuffers are written encoded.
Result<Gl> loadGl(GlLoader loader);

/// The name of a glGetError value.
std::string glErrorName(GLenum error);

}  // namespace brittle::render
