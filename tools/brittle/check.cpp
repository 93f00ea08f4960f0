#include "game/content/check.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "tools/brittle/options.h"

namespace brittle::program {
namespace {

void add(const content::CheckReport& report, content::CheckReport& sum) {
  sum.segments += report.segments;
  sum.levels += report.levels;
  sum.templates += report.templates;
  sum.gameLists += report.gameLists;
  sum.materials += report.materials;
  sum.scripts += report.scripts;
  sum.meshes += report.meshes;
  sum.boxes += report.boxes;
  sum.obstacles += report.obstacles;
  sum.rooms += report.rooms;
  sum.skipped += report.skipped;
  sum.problems.insert(sum.problems.end(), report.problems.begin(), report.problems.end());
}

}  // namespace

int check(const CheckOptions& options) {
  content::CheckReport sum;
  for (const std::string& path : options.paths) {
    std::error_code problem;
    if (!std::filesystem::exists(path, problem)) return refuse(errorAt(path, 0, "no such file or folder"));
  }
  for (const std::string& path : options.paths) add(content::checkPath(path), sum);
  for (const content::Problem& problem : sum.problems) std::printf("%s\n", problem.text().c_str());
  std::printf(
      "%d levels, %d rooms, %d segments (%d boxes, %d obstacles), %d scripts, %d other files skipped: %zu problems\n",
      sum.levels, sum.rooms, sum.segments, sum.boxes, sum.obstacles, sum.scripts, sum.skipped, sum.problems.size());
  return sum.problems.empty() ? kDone : kFailed;
}

}  // namespace brittle::program
