#include "engine/render/passes.h"

namespace brittle::render {

void Passes::bloom(Target& target) {
  setState(Depth::Off, Blend::Off, Faces::All);
  target.bindSmall(0);
  if (!use(kBrightProgram)) return;
  drawScreen();
  if (!use(kBlurProgram)) return;
  const float right = 1.0f / static_cast<float>(target.smallWidth()),
              up = 1.0f / static_cast<float>(target.smallHeight());
  for (const std::size_t to : {1u, 0u}) {
    target.bindSmall(to);
    target.useSmall(1 - to, kUnitBloom);
    set(kTap, to == 1 ? Vec4(right, 0.0f, 0.0f, 0.0f) : Vec4(0.0f, up, 0.0f, 0.0f));
    drawScreen();
  }
  target.useSmall(0, kUnitBloom);
}

}  // namespace brittle::render
