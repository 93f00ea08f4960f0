// tools/bench/zones.h - what a tick consists of: the CPU time of each zone of engine/core/profile.h, without that of
// the zones inside it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/core/profile.h"
#include "tools/bench/cpu_time.h"

namespace brittle {

class ZoneTimes : public ZoneListener {
 public:
  ZoneTimes() : previous_(setZoneListener(this)) {}
  ~ZoneTimes() override { setZoneListener(previous_); }
  ZoneTimes(const ZoneTimes&) = delete;
  ZoneTimes& operator=(const ZoneTimes&) = delete;

  void zoneBegins(const char* name) override {
    charge();
    open_.push_back(name);
  }
  void zoneEnds(const char*) override {
    charge();
    open_.pop_back();
  }
  void clear() { milliseconds_.clear(); }
  /// By name, since the last clear.
  const std::map<std::string, double>& milliseconds() const { return milliseconds_; }

 private:
  /// What has gone by since the last change belongs to the innermost zone.
  void charge() {
    const double now = cpuMilliseconds();
    if (!open_.empty()) milliseconds_[open_.back()] += now - last_;
    last_ = now;
  }

  ZoneListener* previous_;
  std::vector<const char*> open_;
  std::map<std::string, double> milliseconds_;
  double last_ = 0.0;
};

}  // namespace brittle
