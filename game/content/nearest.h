// content/nearest.h - the known name that a misspelled one is most likely meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace brittle::content {

/// The one of `known` that the fewest letters changed, added or left out lead to, at most two; empty if none is so
/// near. Ties: the first.
std::string nearestOf(std::string_view name, std::span<const std::string_view> known);

/// "a", or "one of a, b, c".
std::string listOf(std::span<const std::string_view> names);

}  // namespace brittle::content
