// fracture/material.h - how a breakable thing breaks. Numbers are ours, chosen by eye against footage of breaking glass
// unless said.
#pragma once

#include <cstdint>

namespace brittle::fracture {

/// Which pattern the carved volume is cut by.
enum class Pattern : std::uint8_t {
  Pane,       // annealed sheet: radial and concentric cracks about the impact, in the plane of the sheet
  Block,      // random planes
  Tempered,   // dice over the whole body
  Laminated,  // cracks like a pane but holds together: pieces keep their bonds, only what the striker carves out leaves
};

struct FractureMaterial {
  Pattern pattern = Pattern::Pane;
  float carveRadius = 0.3f;  // radius of the hole at 10 m/s [m]; grows with the square root of impact speed
  float density = 1.0f;      // number of cracks relative to the default [-], > 0
  float dieSize = 0.02f;     // Tempered: edge of a die [m]
  float minVolume = 2e-6f;   // pieces below become debris [m3]
};

}  // namespace brittle::fracture
