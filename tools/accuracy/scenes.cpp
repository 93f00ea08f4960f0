#include "tools/accuracy/scenes.h"

#include <algorithm>

#include "tools/accuracy/scene_list.h"

namespace brittle::accuracy {

std::span<const Scene> allScenes() {
  static const Scene scenes[] = {
      {"panes", "a ball of 1 kg at 20 m/s through six anchored panes 5 cm apart, by its phase within a tick", 64, false,
       buildSixPanes},
      {"grazes", "a fast ball that passes a pane within 15 mm, or cuts 10 to 30 mm into it", 256, false, buildGraze},
      {"stack", "a ball of half a ton rests on six blocks of glass that can bear three times as much", 4, true,
       buildStack},
      {"shatter", "a ball shatters a block of glass that flies and spins, far from everything", 32, false,
       buildShatter},
      {"swing", "a pane hung from a hinge swings through 120 degrees", 4, true, buildSwing},
      {"packed", "a block is cut to pieces where it stands, in a box that it fills", 2, true, buildPacked},
      {"flood", "six balls through panes and blocks of glass in a walled yard", 8, true, buildFlood},
  };
  return scenes;
}

const Scene* findScene(std::string_view name) {
  const auto scenes = allScenes();
  const auto found = std::find_if(scenes.begin(), scenes.end(), [&](const Scene& one) { return one.name == name; });
  return found == scenes.end() ? nullptr : &*found;
}

std::unique_ptr<physics::World> makeWorld(const Scene& scene, const physics::Accuracy& accuracy, int variant) {
  physics::WorldDef def;
  def.accuracy = accuracy;
  def.seed = static_cast<std::uint64_t>(variant) + 1;
  if (!scene.gravity) def.gravity = Vec3::Zero();
  return std::make_unique<physics::World>(def);
}

}  // namespace brittle::accuracy
