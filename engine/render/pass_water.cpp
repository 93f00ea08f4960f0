#include "engine/render/passes.h"

namespace brittle::render {

void Passes::water(const Water& water, float refraction) {
  packWater(water, waterVertices_, waterIndices_);
  setState(Depth::Test, Blend::Premultiplied, Faces::All);
  if (!use(kWaterProgram)) return;
  set(kOffset, Vec4(0.0f, 0.0f, water.along, water.seconds));
  set(kBend, Vec4(refraction, 0.0f, 0.0f, 0.0f));
  waterBatch_.draw(gl_, waterVertices_, waterIndices_);
  counters_.indicesUploaded += static_cast<std::uint32_t>(waterIndices_.size());
  count(waterIndices_.size() / 3);
}

}  // namespace brittle::render
