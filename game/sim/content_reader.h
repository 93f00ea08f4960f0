// game/sim/content_reader.h - the files a game reads, each once: templates, materials, segments, scripts. Keeps a hash
// over all of them, so that a replay can tell whether it is played on the same content. Problems of files go to a list
// that the session takes over.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/content/asset_source.h"
#include "game/content/level.h"
#include "game/content/material.h"
#include "game/content/parameter_names.h"
#include "game/content/segment.h"

namespace brittle::sim {

class ContentReader {
 public:
  explicit ContentReader(const content::AssetSource& assets);

  /// A text file.
  Result<std::string> text(const std::string& name);
  /// segments/NAME.xml.
  Result<std::shared_ptr<const content::Segment>> segment(const std::string& name);
  const content::MaterialTable& materials() const { return materials_; }
  /// What the script asks for; of one that cannot be read, anything.
  const content::ParameterNames& parameterNames(const std::string& script);

  /// Over the names and bytes of every file read so far, whatever the order. Files that only the picture reads (baked
  /// meshes) are none of them: without them a replay plays the same.
  std::uint64_t hash() const { return hash_; }
  /// What was wrong with files read since the last call.
  std::vector<std::string> takeProblems();
  /// An unknown template counts once, however many files ask for it.
  void addProblems(const content::Problems& problems);

 private:
  const content::AssetSource& assets_;
  content::TemplateSet templates_;
  content::MaterialTable materials_;
  std::map<std::string, Result<std::string>> texts_;
  std::map<std::string, std::shared_ptr<const content::Segment>> segments_;
  std::map<std::string, content::ParameterNames> parameterNames_;
  std::vector<std::string> problems_;
  std::set<std::string> unknownTemplates_;
  std::uint64_t hash_ = 0;
  std::size_t held_ = 0;  // names and texts [bytes]
  bool isFull_ = false;
};

}  // namespace brittle::sim
