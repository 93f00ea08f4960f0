#include "engine/render/passes.h"

namespace brittle::render {

void Passes::puffs(const std::vector<PuffInstance>& instances) {
  if (instances.empty()) return;
  // No depth test: a puff ends softly where the depth copy says that something stands.
  setState(Depth::Off, Blend::Premultiplied, Faces::All);
  if (!use(kPuffProgram)) return;
  puffBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

}  // namespace brittle::render
