#include "engine/render/material.h"

namespace brittle::render {

std::vector<Material> builtInMaterials() {
  std::vector<Material> table(kBuiltInMaterials);
  table[kGlass] = {
      .look = Look::Glass, .color = Rgb(0.94f, 0.985f, 0.99f), .gloss = 0.9f, .clarity = 0.85f, .edge = 0.8f};
  table[kMetal] = {.color = Rgb(0.66f, 0.68f, 0.72f), .metalness = 1.0f, .gloss = 0.55f};
  table[kMatte] = {.color = Rgb(0.80f, 0.78f, 0.75f), .gloss = 0.15f};
  table[kCrystal] = {.look = Look::Glass, .gloss = 1.0f, .clarity = 0.55f, .edge = 1.0f};
  table[kBall] = {.color = Rgb(0.86f, 0.87f, 0.90f), .metalness = 1.0f, .gloss = 0.9f};
  return table;
}

}  // namespace brittle::render
