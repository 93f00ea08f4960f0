#include <filesystem>

#include "tools/accuracy/outcome.h"
#include "tools/brittle/child.h"

namespace brittle::accuracy {
namespace {

constexpr const char* kPackage = "gnuplot-nox";
constexpr const char* kScripts = BRITTLE_SOURCE_DIR "/tools/accuracy/plots";

/// As gnuplot wants a text: in single quotes, where only they are special.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

Status draw(const std::string& script, const std::string& name, const std::string& kind, const std::string& folder) {
  const std::string settings = "folder=" + quoted(folder) + "; scripts=" + quoted(kScripts) + "; kind=" + quoted(kind) +
                               "; name=" + quoted(name);
  auto child = program::Child::start({"gnuplot", "-e", settings, script}, kPackage);
  if (!child) return child.error();
  return (*child)->end();
}

}  // namespace

Status checkPlotting() {
  auto child = program::Child::start({"gnuplot", "--version"}, kPackage);
  if (!child) return child.error();
  return (*child)->end();
}

Status drawPlots(const std::string& folder) {
  std::vector<std::filesystem::path> scripts;
  for (const auto& entry : std::filesystem::directory_iterator(kScripts))
    if (entry.path().filename().string().starts_with("plot_")) scripts.push_back(entry.path());
  for (const std::filesystem::path& script : scripts)
    for (const char* kind : {"svg", "png"}) {
      const std::string name = script.stem().string().substr(5);
      const Status drawn = draw(script.string(), name, kind, folder);
      if (!drawn) return drawn;
    }
  return Done{};
}

}  // namespace brittle::accuracy
