// One hash a second of the scene, so that a difference says when it began.
#include "tools/state_hash/scene.h"

#include "tools/state_hash/sections.h"

namespace brittle {

void addPhysics(std::vector<Line>& lines) {
  physics::Scene scene;
  for (int tick = 1; tick <= physics::kSceneTicks; ++tick) {
    scene.step(tick);
    if (tick % 60 == 0) lines.push_back({"world at tick " + std::to_string(tick), scene.hash()});
  }
}

}  // namespace brittle
