// physics/heap.h - what lies on, leans on or hangs together with a body: what would move if it went.
#pragma once

#include <vector>

#include "engine/physics/ids.h"

namespace brittle::physics {

struct State;

struct Heap {
  std::vector<BodyHandle> bodies;  // dynamic ones; the one that was asked for first
  std::vector<bool> isIn;          // by body slot: whether it is one of them
  bool isCarried = false;          // one of them hangs by a joint, is driven or touches something animated
};

/// From `body`, which is dynamic, over all that touched at the end of the last tick; static bodies are the ends.
void gatherHeap(const State& state, BodyHandle body, Heap& heap);

}  // namespace brittle::physics
