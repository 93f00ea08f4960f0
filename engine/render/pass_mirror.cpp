// A polished floor shows the room: what is drawn between begin and end is seen upside down in it.
#include "engine/render/passes.h"

namespace brittle::render {

void Passes::beginMirror(const FrameUniforms& uniforms) {
  inMirror_ = true;
  if (!mirrorBlock_) mirrorBlock_ = GlBuffer(gl_);
  gl_.BindBuffer(GL_UNIFORM_BUFFER, mirrorBlock_.name());
  gl_.BufferData(GL_UNIFORM_BUFFER, sizeof(uniforms), &uniforms, GL_STREAM_DRAW);
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, mirrorBlock_.name());
}

void Passes::endMirror() {
  inMirror_ = false;
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, frameBlock_.name());
  setState(Depth::Write, Blend::Off, Faces::All);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace brittle::render
