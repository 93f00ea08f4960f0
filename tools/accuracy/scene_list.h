// accuracy/scene_list.h - how each scene of scenes.h begins. Only scenes.cpp uses it.
#pragma once

#include "tools/accuracy/scenes.h"

namespace brittle::accuracy {

Stage buildSixPanes(physics::World& world, int variant);
Stage buildGraze(physics::World& world, int variant);
Stage buildStack(physics::World& world, int variant);
Stage buildShatter(physics::World& world, int variant);
Stage buildSwing(physics::World& world, int variant);
Stage buildPacked(physics::World& world, int variant);
Stage buildFlood(physics::World& world, int variant);

}  // namespace brittle::accuracy
