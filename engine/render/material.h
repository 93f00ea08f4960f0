// render/material.h - how surfaces look: one entry per draw material. The game picks entries by index; only the shaders
// read them.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/frame.h"

namespace brittle::render {

inline constexpr std::size_t kMaxMaterials = 32;

enum class Look : std::uint8_t { Opaque, Glass };

struct Material {
  Look look = Look::Opaque;
  Rgb color = Rgb(1.0f, 1.0f, 1.0f);  // multiplies vertex colours
  float metalness = 0.0f;             // 0: plastic or stone, 1: metal [0, 1]
  float gloss = 0.5f;                 // sharpness of highlight and reflection [0, 1]
  float clarity = 0.8f;               // glass: light that passes straight through [0, 1]
  float edge = 0.0f;                  // brightness of fracture edges [0, 1]; 0: none drawn
};

/// The table a renderer starts with, in the order of BuiltInMaterial.
std::vector<Material> builtInMaterials();

}  // namespace brittle::render
