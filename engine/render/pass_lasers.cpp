#include "engine/render/passes.h"

namespace brittle::render {

void Passes::lasers(const std::vector<BeamInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Test, Blend::Add, Faces::All);
  if (!use(kLaserProgram)) return;
  laserBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

}  // namespace brittle::render
