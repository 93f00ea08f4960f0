#include "engine/core/profile.h"

#include <utility>

namespace brittle {
namespace {
ZoneListener* installed = nullptr;
}

ZoneListener* setZoneListener(ZoneListener* listener) {
  return std::exchange(installed, listener);
}
ZoneListener* zoneListener() {
  return installed;
}

}  // namespace brittle
