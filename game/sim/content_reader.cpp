#include "game/sim/content_reader.h"

#include "engine/core/hash.h"
#include "game/sim/constants.h"

namespace brittle::sim {

ContentReader::ContentReader(const content::AssetSource& assets)
    : assets_(assets), materials_(content::builtInMaterials()) {
  if (const Result<std::string> found = text("templates.xml"))
    templates_ = content::readTemplates(*found, "templates.xml");
  if (const Result<std::string> found = text("materials.xml"))
    materials_ = content::readMaterials(*found, "materials.xml");
  addProblems(templates_.problems);
  addProblems(materials_.problems);
}

Result<std::string> ContentReader::text(const std::string& name) {
  const auto known = texts_.find(name);
  if (known != texts_.end()) return known->second;
  Result<std::string> found = isFull_ ? Result<std::string>(Error{}) : assets_.read(name);
  const std::size_t size = name.size() + (found ? found->size() : 0);
  isFull_ = isFull_ || size > rules::kMaxContent - held_;
  if (isFull_)  // and nothing is read any more: it would have to be read again each time it is asked for
    return errorAt(name, 0,
                   "not read: a game holds at most " + std::to_string(rules::kMaxContent) + " bytes of content");
  held_ += size;
  // A sum of the files' hashes does not depend on the order in which a game happens to need them.
  if (found) hash_ += hashBytes(found->data(), found->size(), hashBytes(name.data(), name.size()));
  texts_.emplace(name, found);
  return found;
}

Result<std::shared_ptr<const content::Segment>> ContentReader::segment(const std::string& name) {
  const auto known = segments_.find(name);
  if (known != segments_.end()) return known->second;
  const std::string file = "segments/" + name + ".xml";
  const Result<std::string> source = text(file);
  if (!source) return source.error();
  const auto made = std::make_shared<const content::Segment>(content::readSegment(*source, file, templates_));
  addProblems(made->problems);
  segments_[name] = made;
  return made;
}

const content::ParameterNames& ContentReader::parameterNames(const std::string& script) {
  const auto known = parameterNames_.find(script);
  if (known != parameterNames_.end()) return known->second;
  const Result<std::string> source = text(script);
  return parameterNames_[script] = source ? content::parameterNames(*source) : content::ParameterNames{{}, true};
}

std::vector<std::string> ContentReader::takeProblems() {
  std::vector<std::string> taken;
  taken.swap(problems_);
  return taken;
}

void ContentReader::addProblems(const content::Problems& problems) {
  for (const content::Problem& problem : problems) {
    const bool isKnown = problem.what == content::kUnknownTemplate && !unknownTemplates_.insert(problem.value).second;
    if (!isKnown) problems_.push_back(problem.text());
  }
}

}  // namespace brittle::sim
