#include "game/content/check.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "tools/brittle/interrupt.h"
#include "tools/brittle/options.h"
#include "tools/brittle/try_rooms.h"

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

void add(const sim::DryRun& run, sim::DryRun& sum) {
  sum.rooms += run.rooms;
  sum.problems.insert(sum.problems.end(), run.problems.begin(), run.problems.end());
}

std::string counted(int count, const std::string& one, const std::string& many = "") {
  return std::to_string(count) + " " + (count == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace

int check(const CheckOptions& options) {
  content::CheckReport sum;
  sim::DryRun tried;
  for (const std::string& path : options.paths) {
    std::error_code problem;
    if (!std::filesystem::exists(path, problem)) return refuse(errorAt(path, 0, "no such file or folder"));
  }
  catchInterrupts();
  for (const std::string& path : options.paths) {
    const content::CheckReport report = content::checkPath(path);
    const Result<sim::DryRun> run = tryRooms(report);
    if (!run) return refuse(run.error());
    add(report, sum);
    add(*run, tried);
  }
  for (const content::Problem& problem : sum.problems) std::printf("%s\n", problem.text().c_str());
  for (const std::string& problem : tried.problems) std::printf("%s\n", problem.c_str());
  const std::string howMany = tried.rooms > 0 ? " (" + std::to_string(tried.rooms) + " tried)" : "";
  std::printf("%s, %s%s, %s (%s, %s), %s, %s, %s skipped: %s\n", counted(sum.levels, "level").c_str(),
              counted(sum.rooms, "room").c_str(), howMany.c_str(), counted(sum.segments, "segment").c_str(),
              counted(sum.boxes, "box", "boxes").c_str(), counted(sum.obstacles, "obstacle").c_str(),
              counted(sum.meshes, "mesh", "meshes").c_str(), counted(sum.scripts, "script").c_str(),
              counted(sum.skipped, "other file").c_str(),
              counted(static_cast<int>(sum.problems.size() + tried.problems.size()), "problem").c_str());
  return sum.problems.empty() && tried.problems.empty() ? kDone : kFailed;
}

}  // namespace brittle::program
