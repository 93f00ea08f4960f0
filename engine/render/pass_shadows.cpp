#include "engine/render/passes.h"

namespace brittle::render {

void Passes::shadows(const std::vector<ShadowInstance>& instances) {
  if (instances.empty()) return;
  // Back faces without a depth test: seen from inside the box, too.
  setState(Depth::Off, Blend::Over, Faces::Back);
  if (!use(kShadowProgram)) return;
  shadowBatch_.draw(gl_, GL_TRIANGLE_STRIP, kBoxVertices, instances);
  count(instances.size() * 12);
}

}  // namespace brittle::render
