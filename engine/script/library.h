// script/library.h - the functions that C++ offers to scripts: built once, shared by every sandbox made with it.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine/script/call.h"

namespace brittle::script {

using Native = std::function<void(Call&)>;

class Library {
 public:
  struct Entry {
    std::string name;
    Native native;
  };

  /// `native` becomes the global function `name`; it may not call into the sandbox that called it, nor throw.
  void add(std::string name, Native native) { entries_.push_back({std::move(name), std::move(native)}); }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

}  // namespace brittle::script
