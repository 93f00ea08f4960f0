#include "game/sim/omission.h"

#include <iterator>

namespace brittle::sim {

const char* nameOf(Omission omission) {
  constexpr const char* names[] = {
      "bodies passed",       "bodies fallen out", "pieces out of sight", "obstacles put off", "scripts put off",
      "obstacles taken out", "content refused",   "throws refused",      "splashes refused",  "reports not told"};
  static_assert(std::size(names) == static_cast<std::size_t>(Omission::Count));
  return names[static_cast<int>(omission)];
}

}  // namespace brittle::sim
