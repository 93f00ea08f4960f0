// view/shadows.h - soft shadows under things made of convexes: one blob a body, as wide as the body is seen from above.
// Pure.
#pragma once

#include <vector>

#include "engine/render/frame.h"

namespace brittle::view {

/// Appends a shadow for every body of the group with a footprint worth one.
void addShadows(const render::MeshGroup& group, std::vector<render::Shadow>& shadows);

}  // namespace brittle::view
