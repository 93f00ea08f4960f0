// brittle/omissions.h - what a game, its pictures and its sound put off, refused or took away, as text.
#pragma once

#include <string>
#include <vector>

#include "engine/core/tally.h"

namespace brittle::program {

/// "3 breakings put off, 120 crumbs recycled"
inline std::string inWords(const std::vector<NamedCount>& counts) {
  std::string words;
  for (const NamedCount& one : counts)
    words += (words.empty() ? "" : ", ") + std::to_string(one.count) + " " + one.name;
  return words;
}

/// {"breakings put off": 3, "crumbs recycled": 120}
inline std::string inJson(const std::vector<NamedCount>& counts) {
  std::string json;
  for (const NamedCount& one : counts)
    json += (json.empty() ? "\"" : ", \"") + std::string(one.name) + "\": " + std::to_string(one.count);
  return "{" + json + "}";
}

}  // namespace brittle::program
