// hard_cases/work.h - what work costs, as little disturbed by what else runs on the machine as can be: processor time
// of the thread, the least of several runs that take turns. Used where a case bounds how cost grows; instructions are
// counted by hand and stand in the case's text.
#pragma once

#include <algorithm>
#include <ctime>
#include <limits>
#include <vector>

namespace brittle::hard {

/// Processor time of this thread. [s]
inline double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

struct Spread {
  double least = 0.0, most = 0.0;  // [s]
  double ratio() const { return most / least; }
};

/// What one thing costs at each of several sizes: the least of `repeats` rounds over all sizes in turn, so that
/// whatever disturbs the machine disturbs all of them; and of up to eight times as many while the most is above `bound`
/// times the least, as noise goes away and growth does not.
template <class Cost>
Spread spreadOf(const std::vector<int>& sizes, int repeats, double bound, Cost&& costOf) {
  std::vector<double> costs(sizes.size(), std::numeric_limits<double>::infinity());
  Spread spread;
  for (int round = 0; round < repeats || (round < 8 * repeats && spread.ratio() > bound); ++round) {
    auto cost = costs.begin();
    for (const int size : sizes) {
      *cost = std::min(*cost, costOf(size));
      ++cost;
    }
    const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
    spread = {*least, *most};
  }
  return spread;
}

}  // namespace brittle::hard
