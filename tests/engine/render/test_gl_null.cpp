#include "engine/render/gl_null.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/render/gl_object.h"
#include "engine/render/shader.h"

namespace brittle::render {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(NullGl, AnswersEveryFunctionOfTheTable) {
  NullGl null;
#define BR_GL_CHECK(name, type) EXPECT_NE(null.table().name, nullptr) << #name;
  BR_GL_FUNCTIONS(BR_GL_CHECK)
#undef BR_GL_CHECK
  null.table().Finish();
  null.table().Finish();
  EXPECT_EQ(null.calls("Finish"), 2u);
  EXPECT_EQ(null.calls("Clear"), 0u);
}

TEST(NullGl, ComplainsAboutADrawWithNothingSet) {
  NullGl null;
  null.table().DrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_THAT(null.complaints(), ElementsAre("a draw without a program",
                                             "a draw without a vertex array: GLES allows it, core profiles do not",
                                             "a draw into an empty viewport"));
}

TEST(NullGl, ComplainsAboutWritesBeyondABuffer) {
  NullGl null;
  const Gl& gl = null.table();
  GlBuffer buffer(gl);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
  gl.BufferData(GL_ARRAY_BUFFER, 100, nullptr, GL_DYNAMIC_DRAW);
  gl.BufferSubData(GL_ARRAY_BUFFER, 60, 40, nullptr);
  EXPECT_THAT(null.complaints(), IsEmpty());
  gl.BufferSubData(GL_ARRAY_BUFFER, 60, 41, nullptr);
  EXPECT_THAT(null.complaints(), ElementsAre("BufferSubData up to byte 101 of a buffer of 100"));
}

TEST(NullGl, ComplainsAboutIndicesBeyondTheirBuffer) {
  NullGl null;
  const Gl& gl = null.table();
  GlBuffer buffer(gl);
  GlVertexArray array(gl);
  gl.BindVertexArray(array.name());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.name());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 12, nullptr, GL_STREAM_DRAW);
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
  EXPECT_EQ(null.complaints().at(0), "a draw reads indices up to byte 24 of 12");
}

TEST(NullGl, ComplainsAboutReadingWhatIsDrawnInto) {
  NullGl null;
  const Gl& gl = null.table();
  GlTexture texture(gl);
  GlFramebuffer framebuffer(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
  gl.Viewport(0, 0, 4, 4);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_THAT(null.complaints().back(), HasSubstr("is bound for reading while it is drawn into"));
}

TEST(NullGl, ComplainsAboutUniformsOfAnotherProgram) {
  NullGl null;
  const Gl& gl = null.table();
  const GLuint a = gl.CreateProgram(), b = gl.CreateProgram();
  gl.UseProgram(a);
  gl.Uniform1i(gl.GetUniformLocation(a, "x"), 1);
  EXPECT_THAT(null.complaints(), IsEmpty());
  gl.Uniform1i(gl.GetUniformLocation(b, "x"), 1);
  EXPECT_EQ(null.complaints().size(), 1u);
}

TEST(NullGl, CountsObjectsThatLive) {
  NullGl null;
  {
    GlBuffer buffer(null.table());
    GlTexture moved;
    moved = GlTexture(null.table());
    EXPECT_EQ(null.liveObjects(), 2u);
  }
  EXPECT_EQ(null.liveObjects(), 0u);
  const GLuint unknown = 99;
  null.table().DeleteBuffers(1, &unknown);
  EXPECT_THAT(null.complaints(), ElementsAre("deleted buffer 99 that does not exist"));
}

TEST(Shader, TellsProgramStageAndTheCompilersWords) {
  NullGl null;
  null.failNextShader("0:7(3): syntax error");
  const Result<Program> program = Program::build(null.table(), {"test", "", ""});
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().message, "shader test (vertex): 0:7(3): syntax error");
  EXPECT_EQ(null.liveObjects(), 0u);
}

TEST(LoadGl, NamesTheFirstMissingFunction) {
  const Result<Gl> gl = loadGl([](const char*) -> void* { return nullptr; });
  ASSERT_FALSE(gl);
  EXPECT_EQ(gl.error().message, "the GL context lacks glActiveTexture: GLES 3.0 is needed");
}

}  // namespace
}  // namespace brittle::render
