#include "engine/render/overlay.h"

namespace brittle::render {

void Overlay::clear() {
  points.clear();
  indices.clear();
  parts.clear();
}

}  // namespace brittle::render
