// The scene the picture tests look at: a fogged corridor with whole and broken panes, glass blocks, metal and balls.
// Fixed seeds.
#pragma once

#include "engine/render/bake.h"
#include "engine/render/frame.h"
#include "engine/render/renderer.h"

namespace brittle::render {

struct Gallery {
  geometry::MeshPool pool;
  Frame frame;
  BakedMesh room;
};

/// Everything in view of a camera at (0, 1, 0) that looks along -Z.
void fillGallery(Gallery& gallery);

}  // namespace brittle::render
