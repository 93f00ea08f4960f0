// view/water_drops.h - what a splash throws up: a crown of drops, then a few straight up from its middle. Pure.
#pragma once

#include <cstdint>

#include "engine/render/frame.h"
#include "game/sim/event.h"
#include "game/view/water.h"

namespace brittle::view {

/// As many drops as what fell in is heavy and fast; `key` makes them its own. Adds glows and beams.
void addDrops(const Splash& splash, const sim::Event& event, const Vec3& point, std::uint64_t key,
              render::Frame& frame);

}  // namespace brittle::view
