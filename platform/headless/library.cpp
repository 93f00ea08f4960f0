#include "platform/headless/library.h"

#include <dlfcn.h>

namespace brittle::platform {

Result<Library> Library::open(const std::string& file, const std::string& package) {
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return Error{file + " is missing: apt-get install " + package};
  return Library(handle);
}

void* Library::findAddress(const char* name) const {
  return dlsym(handle_, name);
}

}  // namespace brittle::platform
