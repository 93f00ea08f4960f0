#include "tools/brittle/faults.h"

#include <cstdio>

namespace brittle::program {

void Faults::show(const sim::Game& game) {
  for (const sim::Problem& problem : game.problems())
    if (shown_.insert(problem.text).second) std::fprintf(stderr, "content: %s\n", problem.text.c_str());
}

}  // namespace brittle::program
