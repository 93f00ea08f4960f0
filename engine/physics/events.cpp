#include "engine/physics/events.h"

#include <iterator>

namespace brittle::physics {

const char* nameOf(Omission omission) {
  constexpr const char* names[] = {"breakings put off", "strikers stopped", "bodies made crumbs", "crumbs recycled",
                                   "crumbs removed",    "contacts refused", "cuts refused",       "bodies quarantined"};
  static_assert(std::size(names) == static_cast<std::size_t>(Omission::Count));
  return names[static_cast<int>(omission)];
}

}  // namespace brittle::physics
