#include "engine/physics/events.h"

namespace brittle::physics {

const char* nameOf(Omission omission) {
  constexpr const char* names[] = {"breakings put off", "strikers stopped", "bodies made crumbs", "crumbs recycled",
                                   "crumbs removed",    "contacts refused", "cuts refused",       "bodies quarantined"};
  return names[static_cast<int>(omission)];
}

}  // namespace brittle::physics
