// brittle/progress.h - how far a long command is: one bar that redraws itself on a terminal, a plain line per tenth
// elsewhere.
#pragma once

#include <cstdint>
#include <string>

namespace brittle::program {

class Progress {
 public:
  /// `what` is shown before the bar; it goes to standard error, so that results can be piped.
  Progress(std::string what, std::uint32_t of);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void reached(std::uint32_t done);

 private:
  void print(int percent) const;

  std::string what_;
  std::uint32_t of_;
  bool onTerminal_;
  int shown_ = -1;  // what was printed last [percent]
};

}  // namespace brittle::program
