#include "tools/brittle/faults.h"

#include <cstdio>

namespace brittle::program {

void Faults::show(const sim::Game& game) {
  for (; next_ < game.problems().size(); ++next_) {
    const std::string& text = game.problems()[next_].text;
    if (shown_.insert(text).second) std::fprintf(stderr, "content: %s\n", text.c_str());
  }
}

}  // namespace brittle::program
