#include "tools/brittle/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace brittle::program {

Progress::Progress(std::string what, std::uint32_t of)
    : what_(std::move(what)), of_(of), onTerminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (onTerminal_ && shown_ >= 0) std::fputc('\n', stderr);
}

void Progress::reached(std::uint32_t done) {
  const int percent = of_ == 0 ? 100 : static_cast<int>(100ull * done / of_);
  const int step = onTerminal_ ? percent : percent / 10 * 10;
  if (step == shown_) return;
  shown_ = step;
  print(percent);
}

void Progress::print(int percent) const {
  if (!onTerminal_) {
    std::fprintf(stderr, "%s: %d %%\n", what_.c_str(), percent);
    return;
  }
  constexpr int width = 40;
  const std::string bar(static_cast<std::size_t>(percent * width / 100), '#');
  std::fprintf(stderr, "\r%s [%-*s] %3d %%", what_.c_str(), width, bar.c_str(), percent);
  std::fflush(stderr);
}

}  // namespace brittle::program
