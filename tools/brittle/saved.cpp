#include "tools/brittle/saved.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "engine/core/file.h"

namespace brittle::program {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestProgress = 1u << 20;  // [bytes]

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
  std::error_code failed;
  if (path.empty() || !fs::exists(path, failed)) return {};
  const Result<std::string> text = readFile(path, kLongestProgress, "the progress of earlier games");
  std::vector<std::string> problems;
  sim::Progress progress;
  if (text)
    progress = sim::Progress::parse(*text, path, problems);
  else
    problems.push_back(text.error().message);
  for (const std::string& problem : problems) std::fprintf(stderr, "%s\n", problem.c_str());
  return progress;
}

Status saveProgress(const sim::Progress& progress, const std::string& path) {
  if (path.empty()) return Done{};
  std::error_code failed;
  fs::create_directories(fs::path(path).parent_path(), failed);
  const std::string text = progress.text();
  return writeFile(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

}  // namespace brittle::program
