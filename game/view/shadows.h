// view/shadows.h - soft shadows under things made of convexes: one a body, of the rectangle that holds the body as seen
// from above. Pure.
#pragma once

#include <span>
#include <vector>

#include "engine/render/material.h"

namespace brittle::view {

/// Appends a shadow for every body of the group with an outline worth one, glass lighter than the rest. `strength`
/// scales them all. [0, 1]
void addShadows(const render::MeshGroup& group, std::span<const render::Material> materials, float strength,
                std::vector<render::Shadow>& shadows);

}  // namespace brittle::view
