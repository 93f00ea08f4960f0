// platform/headless/library.h - a shared library opened at run time and its functions by name.
#pragma once

#include <string>

#include "engine/core/result.h"

namespace brittle::platform {

class Library {
 public:
  /// Fails with the file's name and the Debian package that brings it. Never closed: drivers keep threads and static
  /// memory.
  static Result<Library> open(const std::string& file, const std::string& package);

  /// Null if it has no such function.
  template <class Function>
  Function find(const char* name) const {
    return reinterpret_cast<Function>(findAddress(name));
  }

 private:
  explicit Library(void* handle) : handle_(handle) {}
  void* findAddress(const char* name) const;

  void* handle_;
};

}  // namespace brittle::platform
