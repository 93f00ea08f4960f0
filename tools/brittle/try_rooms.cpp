#include "tools/brittle/try_rooms.h"

#include <algorithm>
#include <filesystem>

#include "tools/brittle/game.h"
#include "tools/brittle/interrupt.h"
#include "tools/brittle/progress.h"

namespace brittle::program {
namespace {

namespace fs = std::filesystem;

/// The begin of a message, "NAME:", as the report names files: with its folder and as it is stored.
std::string shown(const std::string& text, const std::string& root) {
  const std::size_t end = std::min(text.find(':'), text.size());
  const std::string stored = content::FolderSource({root}).storedName(text.substr(0, end));
  return stored.empty() ? text : (fs::path(root) / stored).lexically_normal().string() + text.substr(end);
}

/// Whether a message of the game is about what reading found: the same value or call, or the same fault of the syntax.
bool isAbout(const std::string& text, const content::Problem& known) {
  if (known.value.empty()) return text.find(known.what) != std::string::npos;
  for (const std::string& part : {"'" + known.value + "'", " " + known.value + ": ", "function " + known.value})
    if (text.find(part) != std::string::npos) return true;
  return false;
}

/// Whether reading has found this already, at a place that it names.
bool isSaid(const std::string& text, const content::CheckReport& report) {
  return std::any_of(report.problems.begin(), report.problems.end(), [&](const content::Problem& known) {
    const std::string file = content::bareName(fs::path(known.file).lexically_relative(report.root).generic_string());
    return text.find(errorAt(file, known.line, "").message) != std::string::npos && isAbout(text, known);
  });
}

}  // namespace

Result<sim::DryRun> tryRooms(const content::CheckReport& report) {
  sim::DryRun all;
  if (report.playable.empty()) return all;
  const auto assets = openAssets(report.root);
  if (!assets) return assets.error();
  constexpr std::uint32_t steps = 1000;  // of a level
  Progress progress("trying rooms", steps * static_cast<std::uint32_t>(report.playable.size()));
  std::uint32_t before = 0;
  for (const std::string& level : report.playable) {
    const sim::DryRun run = sim::dryRun(**assets, level, [&](std::uint32_t done, std::uint32_t of) {
      progress.reached(before + steps * done / of);
      return !isInterrupted();
    });
    if (isInterrupted()) return interruption();
    all.rooms += run.rooms;
    for (const std::string& text : run.problems) {
      const std::string line = shown(text, report.root);
      if (!isSaid(text, report) && std::find(all.problems.begin(), all.problems.end(), line) == all.problems.end())
        all.problems.push_back(line);
    }
    progress.reached(before += steps);
  }
  return all;
}

}  // namespace brittle::program
