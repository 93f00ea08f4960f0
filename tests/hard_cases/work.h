// hard_cases/work.h - what work costs, as little disturbed by what else runs on the machine as can be: processor time
// of the thread, the least of several runs. Used where a case bounds how cost grows; instructions are counted by hand
// and stand in the case's text.
#pragma once

#include <algorithm>
#include <ctime>

namespace brittle::hard {

/// Processor time of this thread. [s]
inline double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// The least of what `run` says it took. [s]
template <class Run>
double leastOf(int repeats, Run&& run) {
  double least = run();
  for (int i = 1; i < repeats; ++i) least = std::min(least, run());
  return least;
}

}  // namespace brittle::hard
