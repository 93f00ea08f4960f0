// content/parameter_names.h - the names under which a script of an obstacle or a room asks for its parameters: to find
// misspelled ones, which nobody reads. Found in the source, as scripts may ask at any time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brittle::content {

struct ParameterNames {
  std::vector<std::string> names;  // in the order of the source
  bool isOpen = false;             // some name is put together while the script runs: it may be any

  void add(const ParameterNames& more);
};

/// Those that `source` asks for with mgGetFloat, mgGetInt, mgGetBool, mgGetString and mgGetColor.
ParameterNames parameterNames(std::string_view source);

/// What is wrong with a parameter that `key` names: nothing if it is asked for, or may be; else what is expected: the
/// nearest name that is asked for, or all of them. With `onlyNear` nothing either if no name is near.
std::string expectedFor(std::string_view key, const ParameterNames& asked, bool onlyNear);

}  // namespace brittle::content
