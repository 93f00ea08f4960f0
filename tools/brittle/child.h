// brittle/child.h - another program, fed through its standard input. Knows nothing of what it is fed.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace brittle::program {

class Child {
 public:
  /// Runs `words[0]`, looked up in PATH, with the rest as its arguments. Its output is dropped, its complaints are
  /// kept. One that is missing is a line that names `package`.
  static Result<std::unique_ptr<Child>> start(const std::vector<std::string>& words, const std::string& package);
  /// Without end() it is killed.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Waits until all of it is taken; false if the child takes no more.
  bool write(std::span<const std::uint8_t> bytes);
  /// Ends its input and waits for it. What it complained of first, or how it ended, if it did not end well.
  Status end();

 private:
  Child() = default;
  Status launch(const std::vector<std::string>& words, const std::string& package);
  int wait();
  std::string firstComplaint();

  std::string name_;
  pid_t process_ = -1;
  int input_ = -1;
  std::FILE* complaints_ = nullptr;  // a file without a name: a pipe that nobody reads would fill and stop the child
};

}  // namespace brittle::program
