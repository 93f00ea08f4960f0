#include "engine/render/passes.h"

namespace brittle::render {

void Passes::focus(Target& target, const Focus& focus) {
  constexpr float widest = 0.011f;  // radius of the disc that a point far away becomes [picture heights]
  const Vec4 where(focus.distance, 1.0f / maxOf(focus.range, 1e-3f), focus.strength, 0.0f);
  const float aspect = static_cast<float>(target.height()) / static_cast<float>(target.width());
  target.resolve(kUnitColor);
  setState(Depth::Off, Blend::Off, Faces::All);
  target.bindHalf(0);
  if (use(kFarProgram)) {
    set(kTap, where);
    drawScreen();
  }
  target.bindHalf(1);
  target.useHalf(0, kUnitColor);
  if (use(kDiscProgram)) {
    set(kTap, Vec4(widest * aspect, widest, 0.0f, 0.0f));
    drawScreen();
  }
  target.bindScene();
  target.useHalf(1, kUnitColor);
  setState(Depth::Off, Blend::Over, Faces::All);
  if (use(kFocusProgram)) {
    set(kTap, where);
    drawScreen();
  }
  bindTexture(kUnitColor, 0);  // the next frame draws into it
}

}  // namespace brittle::render
