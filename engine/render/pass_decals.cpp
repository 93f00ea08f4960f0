#include "engine/render/decal_atlas.h"
#include "engine/render/passes.h"

namespace brittle::render {

void Passes::decals(const std::vector<DecalInstance>& instances) {
  if (instances.empty()) return;
  setState(Depth::Test, Blend::Premultiplied, Faces::All);
  if (!use(kDecalProgram)) return;
  if (!decals_) decals_ = makeDecalTexture(gl_);
  bindTexture(kUnitDecals, decals_.name());
  decalBatch_.draw(gl_, GL_TRIANGLE_STRIP, kQuadVertices, instances);
  count(instances.size() * 2);
}

}  // namespace brittle::render
