// effects_probe/scenes.h - one small room in as many versions as there are effects: as it is it calls for none of them,
// each version adds what calls for one.
#pragma once

#include "engine/effects/effect.h"
#include "game/content/asset_source.h"

namespace brittle::probe {

/// Level "probe": steel crates that are pushed about on a floor, in a room that demands nothing but fog.
/// With six crates, or with six in each of `rows` rows.
content::MemorySource plainRoom(int rows = 1);
/// The same, and what demands `effect`.
content::MemorySource roomWith(effects::Effect effect);

}  // namespace brittle::probe
