#include "tools/brittle/saved.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "engine/core/file.h"

namespace brittle::program {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestProgress = 1u << 20;  // [bytes]
constexpr std::size_t kMostShown = 10;              // lines of a damaged file
constexpr int kMostDamaged = 20;                    // damaged files kept side by side

const char* setVariable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != 0 ? value : nullptr;
}

/// Whole, or not at all.
Status copyFile(const std::string& from, const std::string& to) {
  std::error_code failed;
  fs::copy_file(from, to, failed);
  if (!failed) return Done{};
  std::error_code ignored;
  fs::remove(to, ignored);
  return errorAt(to, 0, failed.message());
}

bool holdTheSame(const std::string& a, const std::string& b) {
  const Result<std::string> first = readFile(a, kLongestProgress, ""), second = readFile(b, kLongestProgress, "");
  return first && second && *first == *second;
}

/// Copies the file beside itself under a name that is not taken, since an older one may hold more; the name.
Result<std::string> keepDamaged(const std::string& path) {
  for (int number = 1; number <= kMostDamaged; ++number) {
    const std::string name = path + ".damaged" + (number == 1 ? "" : "." + std::to_string(number));
    std::error_code failed;
    if (holdTheSame(path, name)) return name;
    if (fs::exists(fs::symlink_status(name, failed))) continue;
    const Status copied = copyFile(path, name);
    return copied ? Result<std::string>(name) : Result<std::string>(copied.error());
  }
  return errorAt(path + ".damaged", 0, std::to_string(kMostDamaged) + " older ones are there");
}

void print(const std::vector<std::string>& problems) {
  for (std::size_t i = 0; i < problems.size() && i < kMostShown; ++i) {
    std::string line = problems[i];
    for (char& c : line)
      if (static_cast<unsigned char>(c) < 32) c = ' ';
    std::fprintf(stderr, "%s\n", line.c_str());
  }
  if (problems.size() > kMostShown)
    std::fprintf(stderr, "and %zu more lines like these\n", problems.size() - kMostShown);
}

}  // namespace

std::string progressPath() {
  const char* data = setVariable("XDG_DATA_HOME");
  const char* home = setVariable("HOME");
  if (data == nullptr && home == nullptr) return {};
  const fs::path folder = data != nullptr ? fs::path(data) : fs::path(home) / ".local" / "share";
  return (folder / "brittle" / "progress.txt").string();
}

Saved loadProgress(const std::string& path) {
  Saved saved{{}, path};
  std::error_code failed;
  if (path.empty() || !fs::exists(path, failed)) return saved;
  const Result<std::string> text = readFile(path, kLongestProgress, "the progress of earlier games");
  std::vector<std::string> problems;
  if (text)
    saved.progress = sim::Progress::parse(*text, path, problems);
  else
    problems.push_back(text.error().message);
  if (problems.empty()) return saved;
  print(problems);
  const Result<std::string> kept = keepDamaged(path);
  if (!kept) saved.path.clear();
  std::fprintf(stderr, "%s: %s\n", path.c_str(),
               kept ? ("damaged, kept as it was in " + *kept).c_str()
                    : ("damaged, and stays as it is, since it cannot be kept elsewhere (" + kept.error().message +
                       "): what is reached now is not stored")
                          .c_str());
  return saved;
}

Status saveProgress(const Saved& saved) {
  if (saved.path.empty()) return Done{};
  std::error_code failed;
  fs::create_directories(fs::path(saved.path).parent_path(), failed);
  const std::string text = saved.progress.text();
  return writeFile(saved.path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

}  // namespace brittle::program
