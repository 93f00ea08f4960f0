// tests/game/sim/layered_source.h - files held in memory before the shipped assets: levels and rooms of a test's own,
// made of shipped segments and obstacles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "game/content/asset_source.h"

namespace brittle::sim {

class LayeredSource : public content::FolderSource {
 public:
  explicit LayeredSource(std::map<std::string, std::string> files)
      : content::FolderSource({BRITTLE_SOURCE_DIR "/assets"}), files_(std::move(files)) {}

 protected:
  std::optional<std::string> bytes(const std::string& stored) const override {
    const auto found = files_.find(stored);
    return found != files_.end() ? found->second : content::FolderSource::bytes(stored);
  }
  std::string find(const std::string& name) const override {
    return files_.contains(name) ? name : content::FolderSource::find(name);
  }

 private:
  std::map<std::string, std::string> files_;
};

/// A level file of so many rooms of one script, each with these attributes.
inline std::string levelOf(int rooms, const std::string& type, const std::string& attributes = "") {
  std::string level = "<level>";
  for (int i = 0; i < rooms; ++i) level += "<room type=\"" + type + "\" length=\"100\" " + attributes + "/>";
  return level + "</level>";
}

}  // namespace brittle::sim
