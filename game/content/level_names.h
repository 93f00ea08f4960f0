// content/level_names.h - the names of elements, attributes and obstacles in the community's level files: to find
// misspelled ones, which readers pass over as they pass over whatever editors write for themselves.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "game/content/problem.h"

namespace brittle::content {

/// Each element and attribute of a level file that is none of the format's, with the nearest one that is. `root`: its
/// first element, which says what kind of file it is; of other kinds nothing is known. Left alone is what editors mark
/// as their own, and rooms' attributes, which are their scripts' to ask for (parameter_names.h).
Problems unknownNames(const std::string& text, const std::string& file, std::string_view root);

/// Whether editors mark what is theirs so: names with - in them, with _ in front, IMPORT_IGNORE, drm.
bool isEditorsName(std::string_view name);

/// Whether obstacles of this type belong to the format, with a script here or not.
bool isKnownObstacle(std::string_view type);
/// The one nearest to `type` of these and of `own`, the scripts of a level pack; empty if none is near.
std::string nearestObstacle(std::string_view type, const std::set<std::string>& own);

}  // namespace brittle::content
