// tools/bench/cpu_time.h - the clock of everything that is measured: processor time of this thread, which other
// programs on the machine disturb least.
#pragma once

#include <ctime>

namespace brittle {

inline double cpuMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

}  // namespace brittle
