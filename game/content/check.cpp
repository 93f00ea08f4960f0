#include "game/content/check.h"

#include "engine/core/file.h"
#include "engine/script/rewrite.h"
#include "engine/script/sandbox.h"
#include "game/content/asset_source.h"
#include "game/content/baked_mesh.h"
#include "game/content/level.h"
#include "game/content/level_names.h"
#include "game/content/material.h"
#include "game/content/script_names.h"
#include "game/content/segment.h"
#include "game/content/xml_file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>

namespace brittle::content {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFiles = 100000;
constexpr int kMostParents = 20;

bool isContent(const std::string& path) {
  const std::string name = bareName(path);
  return name.ends_with(".xml") || name.ends_with(".lua") || name.ends_with(".mesh");
}

/// The name of the first element of an XML text; empty if there is none.
std::string firstElement(const std::string& text) {
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string::npos) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
      if (at == std::string::npos) break;
      continue;
    }
    const std::size_t end = text.find_first_of(" \t\r\n/>", ++at);
    if (text[at] != '?' && text[at] != '!') return text.substr(at, end == std::string::npos ? end : end - at);
  }
  return {};
}

class Checker {
 public:
  /// `path` as it will be named.
  CheckReport run(const std::string& path) {
    std::error_code failed;
    findRoot(path);
    if (fs::is_directory(path, failed)) {
      isFolder_ = true;
      for (const std::string& file : filesIn(path)) checkFile(file);
    } else if (isContent(path)) {
      checkFile(path);
    } else {
      problem(path, 0, "not level content", {}, "a .xml, .lua or .mesh file, or a folder of them");
    }
    return std::move(report_);
  }

 private:
  void problem(const std::string& file, int line, std::string what, std::string value = {}, std::string expected = {}) {
    report_.problems.push_back({file, line, std::move(what), std::move(value), std::move(expected)});
  }

  /// From a reader's "path:line: what".
  void problem(const std::string& path, const Error& error) {
    const std::string& message = error.message;
    const bool isHere = message.compare(0, path.size() + 1, path + ":") == 0;
    const int line = isHere ? std::atoi(message.c_str() + path.size() + 1) : 0;
    const std::size_t what = message.find(": ", isHere ? path.size() : 0);
    problem(path, line, isHere && what != std::string::npos ? message.substr(what + 2) : message);
  }

  void take(Problems& problems) {
    std::stable_sort(problems.begin(), problems.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    for (Problem& one : problems)
      if (listed_.insert(one.text()).second)
        report_.problems.push_back(std::move(one));  // one of a template may come up in many files
  }

  std::vector<std::string> filesIn(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code failed;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, failed);
    for (; !failed && at != fs::recursive_directory_iterator(); at.increment(failed)) {
      std::error_code none;
      if (at->is_regular_file(none) && !at->is_symlink(none)) files.push_back(at->path().string());
      if (static_cast<int>(files.size()) < kMostFiles) continue;
      problem(folder, 0, "too many files: the rest is not read", {}, "up to " + std::to_string(kMostFiles));
      break;
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  /// The asset folder around the path, or directly in it, and its templates.
  void findRoot(const std::string& path) {
    std::error_code failed;
    const fs::path here = fs::current_path(failed);
    const auto isFound = [&](const fs::path& folder) {
      if (!isRoot(folder)) return false;
      useRoot(folder, fs::path(path).is_absolute() ? folder : folder.lexically_relative(here));
      return true;
    };
    fs::path folder = (here / path).lexically_normal();
    if (isFound(folder) || isFound(folder / "assets")) return;
    for (int i = 0; i < kMostParents && folder.has_relative_path(); ++i) {
      folder = folder.parent_path();
      if (isFound(folder)) return;
    }
  }

  static bool isRoot(const fs::path& folder) {
    std::error_code failed;
    return FolderSource({folder.string()}).has("templates.xml") || fs::is_directory(folder / "levels", failed) ||
           fs::is_directory(folder / "segments", failed);
  }

  /// `shown`: the folder as its files are named in messages.
  void useRoot(const fs::path& folder, const fs::path& shown) {
    root_.emplace(std::vector<std::string>{folder.string()});
    report_.root = shown.string();
    const Result<std::string> text = root_->read("templates.xml");
    if (text)
      templates_ = readTemplates(*text, (shown / root_->storedName("templates.xml")).lexically_normal().string());
    for (const std::string& file : filesIn((folder / "obstacles").string())) {
      const fs::path name = fs::path(bareName(file)).lexically_relative(folder / "obstacles");
      if (name.extension() == ".lua") obstacles_.insert(fs::path(name).replace_extension().generic_string());
    }
  }

  void checkFile(const std::string& path) {
    if (!isContent(path)) {
      ++report_.skipped;
      return;
    }
    const Result<std::string> raw = readFile(path, kLongestFile, "content");
    if (!raw) return problem(path, raw.error());
    if (bareName(path).ends_with(".mesh")) return checkMesh(path, *raw);
    const Result<std::string> text = unpacked(*raw);
    if (!text) return problem(path, 0, text.error().message);
    if (bareName(path).ends_with(".lua")) {
      checkScript(path, *text);
    } else {
      checkXml(path, *text);
    }
  }

  void checkMesh(const std::string& path, const std::string& bytes) {
    ++report_.meshes;
    BakedMesh mesh = readBakedMesh(bytes, path);
    take(mesh.problems);
  }

  void checkXml(const std::string& path, const std::string& text) {
    const std::string must = kindAt(path);
    const std::string kind = must.empty() ? firstElement(text) : must;
    if (!isPlainName(kind)) return problem(path, 1, text.empty() ? "an empty file" : "not XML", {}, "an element");
    Problems problems = unknownNames(text, path, kind);
    if (!read(kind, path, text, problems) && problems.empty()) ++report_.skipped;
    take(problems);
  }

  /// The first element that a file must have where it lies in the asset folder; empty where it may have any.
  std::string kindAt(const std::string& path) const {
    const fs::path name = nameInRoot(path);
    if (name.empty()) return {};
    const std::string first = name.begin()->string();
    if (std::next(name.begin()) == name.end()) {
      if (first == "templates.xml" || first == "materials.xml" || first == "game.xml") return name.stem().string();
      return {};
    }
    return first == "levels" ? "level" : first == "segments" ? "segment" : "";
  }

  /// As the game names it; empty outside of the asset folder.
  fs::path nameInRoot(const std::string& path) const {
    if (!root_) return {};
    const fs::path name = fs::path(bareName(path)).lexically_relative(report_.root);
    return name.empty() || *name.begin() == ".." ? fs::path() : name;
  }

  /// Adds what the reader of this kind of file says; false if there is none.
  bool read(const std::string& kind, const std::string& path, const std::string& text, Problems& problems) {
    if (kind == "segment") {
      readSegment(path, text, problems);
    } else if (kind == "level") {
      readLevel(path, text, problems);
    } else if (kind == "templates") {
      ++report_.templates;
      add(readTemplates(text, path).problems, problems);
    } else if (kind == "game") {
      readGameList(path, text, problems);
    } else if (kind == "materials") {
      ++report_.materials;
      add(readMaterials(text, path).problems, problems);
    } else {
      return false;
    }
    return true;
  }

  static void add(const Problems& more, Problems& problems) {
    problems.insert(problems.end(), more.begin(), more.end());
  }

  void readSegment(const std::string& path, const std::string& text, Problems& problems) {
    ++report_.segments;
    const Segment segment = content::readSegment(text, path, templates_);
    report_.boxes += static_cast<int>(segment.boxes.size());
    report_.obstacles += static_cast<int>(segment.obstacles.size());
    add(segment.problems, problems);
    for (const Obstacle& obstacle : segment.obstacles) checkType(obstacle, path, problems);
  }

  void checkType(const Obstacle& obstacle, const std::string& path, Problems& problems) const {
    if (isKnownObstacle(obstacle.type) || obstacles_.contains(obstacle.type)) return;
    const std::string nearest = nearestObstacle(obstacle.type, obstacles_);
    problems.push_back({path, obstacle.line, "unknown obstacle type", obstacle.type,
                        nearest.empty() ? "a file obstacles/" + obstacle.type + ".lua" : nearest});
  }

  void readLevel(const std::string& path, const std::string& text, Problems& problems) {
    ++report_.levels;
    const Level level = content::readLevel(text, path);
    report_.rooms += static_cast<int>(level.rooms.size());
    add(level.problems, problems);
    const fs::path name = nameInRoot(path);
    if (isFolder_ && !level.rooms.empty() && !name.empty() && *name.begin() == "levels")
      report_.playable.push_back(fs::path(name).replace_extension().lexically_relative("levels").generic_string());
    for (const Room& room : level.rooms)
      if (root_ && !root_->has("rooms/" + room.type + ".lua"))
        problems.push_back(
            {path, room.line, "the room has no script", room.type, "a file rooms/" + room.type + ".lua"});
  }

  void readGameList(const std::string& path, const std::string& text, Problems& problems) {
    ++report_.gameLists;
    const GameList list = content::readGameList(text, path);
    add(list.problems, problems);
    for (const LevelEntry& entry : list.levels)
      if (root_ && !root_->has("levels/" + entry.name + ".xml"))
        problems.push_back(
            {path, entry.line, "there is no such level", entry.name, "a file levels/" + entry.name + ".xml"});
  }

  void checkScript(const std::string& path, const std::string& text) {
    ++report_.scripts;
    const Status status = script::checkSyntax(text, path);
    if (!status) return problem(path, status.error());
    checkCalls(path, text);
  }

  /// Calls of mg... functions that nobody defines: neither the game nor this script.
  void checkCalls(const std::string& path, const std::string& text) {
    const script::Tokens tokens = script::tokenize(text);
    std::set<std::string_view> defined;
    for (std::size_t i = 0; i + 1 < tokens.all.size(); ++i) {
      const bool isFunction = tokens.all[i].text == "function" && tokens.all[i + 1].kind == script::TokenKind::Name;
      if (isFunction) defined.insert(tokens.all[i + 1].text);
      if (tokens.all[i].kind == script::TokenKind::Name && tokens.all[i + 1].text == "=")
        defined.insert(tokens.all[i].text);
    }
    for (std::size_t i = 0; i + 1 < tokens.all.size(); ++i) {
      const script::Token& token = tokens.all[i];
      const bool isField = i > 0 && (tokens.all[i - 1].text == "." || tokens.all[i - 1].text == ":" ||
                                     tokens.all[i - 1].text == "function");
      if (token.kind != script::TokenKind::Name || token.text.substr(0, 2) != "mg" || tokens.all[i + 1].text != "(" ||
          isField)
        continue;
      if (isScriptCall(token.text) || defined.count(token.text) != 0) continue;
      problem(path, token.line, "unknown function", std::string(token.text), nearestScriptCall(token.text));
    }
  }

  CheckReport report_;
  bool isFolder_ = false;             // what is checked
  std::optional<FolderSource> root_;  // report_.root
  TemplateSet templates_;
  std::set<std::string> obstacles_;  // that have a script in the asset folder
  std::set<std::string> listed_;
};

}  // namespace

CheckReport checkPath(const std::string& path) {
  std::error_code failed;
  if (fs::exists(path, failed)) return Checker().run(fs::path(path).lexically_normal().string());
  CheckReport report;
  report.problems.push_back({path, 0, "there is no such file or folder", {}, {}});
  return report;
}

}  // namespace brittle::content
