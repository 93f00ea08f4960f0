// content/check.h - reads every piece of level content in a file or a folder and lists what is wrong with it, as
// `brittle check` shows.
#pragma once

#include "game/content/problem.h"

#include <string>
#include <vector>

namespace brittle::content {

struct CheckReport {
  int segments = 0, levels = 0, templates = 0, gameLists = 0, materials = 0, scripts = 0, meshes = 0;
  int boxes = 0, obstacles = 0, rooms = 0;
  int skipped = 0;                    // files that are no level content, or unknown kinds of it
  Problems problems;                  // by file in the order of their names, then by line
  std::string root;                   // the asset folder, as named in messages; empty: there is none
  std::vector<std::string> playable;  // levels of a folder's that lie in it and have rooms, as play names them
};

/// `path`: a file or a folder (read with all that is in it, links not followed). Templates and the scripts that levels
/// name are looked for in the asset folder around the path: the nearest one that holds templates.xml, levels/ or
/// segments/. What lies in its levels/ must be a level, in its segments/ a segment.
CheckReport checkPath(const std::string& path);

}  // namespace brittle::content
