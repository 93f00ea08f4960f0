#include "tools/brittle/saved.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace brittle::program {
namespace {

namespace fs = std::filesystem;

const char* setVariable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != 0 ? value : nullptr;
}

}  // namespace

std::string progressPath() {
  const char* data = setVariable("XDG_DATA_HOME");
  const char* home = setVariable("HOME");
  if (data == nullptr && home == nullptr) return {};
  const fs::path folder = data != nullptr ? fs::path(data) : fs::path(home) / ".local" / "share";
  return (folder / "brittle" / "progress.txt").string();
}

sim::Progress loadProgress(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::vector<std::string> problems;
  sim::Progress progress = sim::Progress::parse(text, path, problems);
  for (const std::string& problem : problems) std::fprintf(stderr, "%s\n", problem.c_str());
  return progress;
}

Status saveProgress(const sim::Progress& progress, const std::string& path) {
  if (path.empty()) return Done{};
  std::error_code failed;
  fs::create_directories(fs::path(path).parent_path(), failed);
  const std::string part = path + ".part";
  {
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    out << progress.text();
    if (!out.flush()) return errorAt(part, 0, "cannot be written");
  }
  fs::rename(part, path, failed);
  return failed ? Status(errorAt(path, 0, "cannot be written")) : Status(Done{});
}

}  // namespace brittle::program
