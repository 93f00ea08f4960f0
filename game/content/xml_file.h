// content/xml_file.h - a level's XML as its authors left it: what can be read is read, with the line of every element
// and attribute. After a syntax error reading goes on at the next tag. Internal to game/content, the only place that
// sees pugixml.
#pragma once

#include "game/content/problem.h"
#include "game/content/template_set.h"

#include <deque>
#include <functional>
#include <initializer_list>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace brittle::content {

/// Whether it can be the name of an element: bytes that are no text look like one now and then.
bool isPlainName(std::string_view name);

class XmlFile {
 public:
  /// `root`: the element that the file should consist of.
  XmlFile(const std::string& text, const std::string& file, const char* root, Problems& problems);

  /// The root element; empty if there is none.
  pugi::xml_node root() const { return root_; }
  /// Its child elements in the order of the file.
  const std::vector<pugi::xml_node>& elements() const { return elements_; }
  /// The line of a name or value within this file's nodes.
  int lineOf(const char* text) const;
  int lineOf(const pugi::xml_node& node) const { return lineOf(node.name()); }

  const std::string& file() const { return file_; }
  /// Kept once if it is about a template, which many elements may use; no more than 1000 per file.
  void report(Problem problem) const;

 private:
  struct Piece {
    std::size_t start = 0;  // in the text
    std::string buffer;     // pugixml keeps its names and values in here
    pugi::xml_document document;
  };
  pugi::xml_parse_result parsePiece(const std::string& text, std::size_t start);
  void collect(const Piece& piece, const char* root);
  /// Without its root a file is none of its kind: one line says what it is, in place of the problems from `before` on,
  /// all that the parser stumbled over.
  void sayWhatElse(const std::string& text, const char* root, std::size_t before);
  pugi::xml_node firstElement() const;
  int lineAt(std::size_t offset) const;

  std::string file_;
  Problems& problems_;
  std::vector<std::size_t> lineStarts_;
  std::deque<Piece> pieces_;
  pugi::xml_node root_;
  std::vector<pugi::xml_node> elements_;
};

/// The attributes of one element over those of its template. Reading one that is there but wrong reports it.
class Attributes {
 public:
  enum class Found { Absent, Good, Bad };

  /// `reported`: names of unknown templates that were reported already.
  Attributes(const XmlFile& xml, const pugi::xml_node& node, const TemplateSet* templates,
             std::set<std::string>& reported);

  /// Numbers, as many as one of `counts`.
  Found numbers(const char* name, std::initializer_list<std::size_t> counts, std::vector<double>& values) const;
  Found number(const char* name, double low, double high, float& value) const;
  Found whole(const char* name, int low, int high, int& value) const;
  Found truth(const char* name, bool& value) const;
  /// Exactly `count` numbers.
  Found floats(const char* name, float* values, std::size_t count) const;
  /// Not empty, at most 1000 bytes.
  Found text(const char* name, std::string& value) const;

  /// Whether the element itself has it, not its template.
  bool isOwn(const char* name) const { return !node_.attribute(name).empty(); }
  int line() const { return line_; }
  void report(std::string_view what, std::string_view value = {}, std::string_view expected = {}) const;
  /// Reports at the attribute itself.
  void reportAt(const char* name, std::string_view what, std::string_view expected) const;

 private:
  struct Place {
    std::string_view value;
    const std::string* file;
    int line;
  };
  std::optional<Place> find(const char* name) const;
  Found refuse(const char* name, const Place& place, const std::string& expected) const;

  const XmlFile& xml_;
  pugi::xml_node node_;
  const Template* template_ = nullptr;
  const std::string* templateFile_ = nullptr;
  int line_;
};

}  // namespace brittle::content
