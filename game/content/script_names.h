// content/script_names.h - the names that room and obstacle scripts of the community may call: to find misspelled calls
// without running anything. The calls themselves belong to game/sim.
#pragma once

#include <string>
#include <string_view>

namespace brittle::content {

/// Whether `name` is a call of room or obstacle scripts.
bool isScriptCall(std::string_view name);
/// The known call nearest to `name` (nearest.h); empty if none is near.
std::string nearestScriptCall(std::string_view name);

}  // namespace brittle::content
