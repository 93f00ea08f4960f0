// core/profile.h - where the time goes: named zones that cost nothing unless a profiler is installed.
// The simulation never reads a clock: a zone only tells the installed listener that it begins and ends.
#pragma once

namespace brittle {

class ZoneListener {
 public:
  virtual ~ZoneListener() = default;
  virtual void zoneBegins(const char* name) = 0;
  virtual void zoneEnds(const char* name) = 0;
};

/// Installs a listener (null: none). Returns the one it replaced.
ZoneListener* setZoneListener(ZoneListener* listener);
ZoneListener* zoneListener();

class Zone {
 public:
  explicit Zone(const char* name) : name_(name), listener_(zoneListener()) {
    if (listener_ != nullptr) listener_->zoneBegins(name_);
  }
  ~Zone() {
    if (listener_ != nullptr) listener_->zoneEnds(name_);
  }
  Zone(const Zone&) = delete;
  Zone& operator=(const Zone&) = delete;

 private:
  const char* name_;
  ZoneListener* listener_;
};

}  // namespace brittle

#define BR_ZONE_JOIN(a, b) a##b
#define BR_ZONE_NAME(line) BR_ZONE_JOIN(zone, line)
#define BR_ZONE(name) const ::brittle::Zone BR_ZONE_NAME(__LINE__)(name)
