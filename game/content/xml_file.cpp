#include "game/content/xml_file.h"

#include "game/content/number.h"

#include <algorithm>
#include <cmath>

namespace brittle::content {
namespace {

constexpr int kMostRestarts = 50;
constexpr std::size_t kMostParsed = 64u << 20;  // [bytes], in all restarts: each keeps its copy of the rest of the file
constexpr std::size_t kLongestText = 1000;  // [bytes] of a name or a key=value: every placing of a segment copies them
constexpr std::size_t kMostProblems = 1000;

std::string countsText(std::initializer_list<std::size_t> counts) {
  std::string text;
  for (const std::size_t count : counts) text += (text.empty() ? "" : " or ") + std::to_string(count);
  return text + (text == "1" ? " number" : " numbers");
}

std::string rangeText(double low, double high) {
  const auto show = [](double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  };
  return show(low) + " to " + show(high);
}

/// Whether the tag that `offset` lies in closes `name`.
bool closesAt(const std::string& text, std::size_t offset, const std::string& name) {
  const std::size_t tag = text.rfind("</", offset);
  return tag != std::string::npos && text.compare(tag + 2, name.size(), name) == 0;
}

/// No XML has such a byte: Extensible Markup Language 1.0, section 2.2.
bool isNoText(char byte) {
  return static_cast<unsigned char>(byte) < 32 && byte != '\t' && byte != '\n' && byte != '\r';
}

bool isSane(double value) {
  return value <= kLargestNumber && value >= -kLargestNumber;
}

}  // namespace

bool isPlainName(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == ':' || c == '.';
  });
}

XmlFile::XmlFile(const std::string& text, const std::string& file, const char* root, Problems& problems)
    : file_(file), problems_(problems), lineStarts_{0} {
  const std::size_t before = problems.size();
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') lineStarts_.push_back(i + 1);
  std::size_t start = 0, parsed = 0;
  for (int restart = 0;; ++restart) {
    parsed += text.size() - start;
    if (restart > kMostRestarts || parsed > kMostParsed) {
      report({file_, lineAt(start), "XML: too many errors, the rest is not read", {}, {}});
      break;
    }
    const pugi::xml_parse_result result = parsePiece(text, start);
    collect(pieces_.back(), root);
    if (result || result.status == pugi::status_no_document_element) break;
    const std::size_t offset = std::min(start + static_cast<std::size_t>(result.offset), text.size());
    // what was read on its own ends with the root's closing tag, which it did not open
    if (start > 0 && result.status == pugi::status_end_element_mismatch && closesAt(text, offset, root)) break;
    report({file_, lineAt(offset), std::string("XML: ") + result.description(), {}, {}});
    const std::size_t next = text.find('<', std::max(offset, start + 1));
    if (next == std::string::npos) break;
    start = next;
  }
  if (!root_) sayWhatElse(text, root, before);
}

void XmlFile::sayWhatElse(const std::string& text, const char* root, std::size_t before) {
  const bool isEmpty = text.find_first_not_of(" \t\r\n") == std::string::npos;
  Problem problem = {file_, 1, isEmpty ? "an empty file" : "not XML", {}, std::string("<") + root + ">"};
  if (std::any_of(text.begin(), text.end(), isNoText)) {
    problem.what += ": bytes that are no text";
  } else if (const pugi::xml_node other = firstElement()) {
    problem = {file_, lineOf(other), "another kind of file", std::string("<") + other.name() + ">", problem.expected};
  } else if (problems_.size() > before) {
    problem.line = problems_[before].line;
    problem.what = "not " + problems_[before].what;
  }
  problems_.erase(problems_.begin() + static_cast<std::ptrdiff_t>(before), problems_.end());
  report(std::move(problem));
}

pugi::xml_node XmlFile::firstElement() const {
  for (const pugi::xml_node& node : pieces_.front().document.children())
    if (node.type() == pugi::node_element && isPlainName(node.name())) return node;
  return {};
}

pugi::xml_parse_result XmlFile::parsePiece(const std::string& text, std::size_t start) {
  pieces_.emplace_back();
  Piece& piece = pieces_.back();
  piece.start = start;
  piece.buffer = text.substr(start);
  // in place and in UTF-8: names and values then point into the buffer, which is what gives their lines
  const unsigned flags = pugi::parse_default | (start > 0 ? pugi::parse_fragment : 0u);
  return piece.document.load_buffer_inplace(piece.buffer.data(), piece.buffer.size(), flags, pugi::encoding_utf8);
}

void XmlFile::collect(const Piece& piece, const char* root) {
  pugi::xml_node parent = piece.document;
  if (!root_) {
    root_ = piece.document.child(root);
    parent = root_;
  }
  for (const pugi::xml_node& child : parent.children())
    if (child.type() == pugi::node_element) elements_.push_back(child);
}

void XmlFile::report(Problem problem) const {
  const auto same = [&](const Problem& other) {
    return other.file == problem.file && other.line == problem.line && other.what == problem.what;
  };
  if (problem.file != file_ && std::any_of(problems_.begin(), problems_.end(), same)) return;
  if (problems_.size() == kMostProblems)
    problem = {file_, problem.line, "and further problems, which are not listed", {}, {}};
  if (problems_.size() <= kMostProblems) problems_.push_back(std::move(problem));
}

int XmlFile::lineOf(const char* text) const {
  for (const Piece& piece : pieces_) {
    const char* begin = piece.buffer.data();
    if (std::less_equal<const char*>()(begin, text) &&
        std::less_equal<const char*>()(text, begin + piece.buffer.size()))
      return lineAt(piece.start + static_cast<std::size_t>(text - begin));
  }
  return 0;
}

int XmlFile::lineAt(std::size_t offset) const {
  const auto after = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
  return static_cast<int>(after - lineStarts_.begin());
}

Attributes::Attributes(const XmlFile& xml, const pugi::xml_node& node, const TemplateSet* templates,
                       std::set<std::string>& reported)
    : xml_(xml), node_(node), line_(xml.lineOf(node)) {
  std::set<std::string_view> seen;
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    if (!seen.insert(attribute.name()).second)
      xml_.report({xml_.file(),
                   xml_.lineOf(attribute.name()),
                   std::string("duplicate attribute ") + attribute.name() + ": the first counts",
                   attribute.value(),
                   {}});
  }
  const pugi::xml_attribute name = node.attribute("template");
  if (templates == nullptr || name.empty() || *name.value() == '\0') return;
  template_ = templates->find(name.value());
  templateFile_ = &templates->file;
  if (template_ == nullptr && reported.insert(name.value()).second)
    xml_.report({xml_.file(), xml_.lineOf(name.name()), kUnknownTemplate, name.value(), "one of templates.xml"});
}

std::optional<Attributes::Place> Attributes::find(const char* name) const {
  const pugi::xml_attribute own = node_.attribute(name);
  if (!own.empty()) return Place{own.value(), &xml_.file(), xml_.lineOf(own.name())};
  if (template_ == nullptr) return std::nullopt;
  for (const TemplateAttribute& attribute : template_->attributes)
    if (attribute.name == name) return Place{attribute.value, templateFile_, attribute.line};
  return std::nullopt;
}

Attributes::Found Attributes::refuse(const char* name, const Place& place, const std::string& expected) const {
  xml_.report(
      {*place.file, place.line, std::string("<") + node_.name() + "> " + name, std::string(place.value), expected});
  return Found::Bad;
}

Attributes::Found Attributes::numbers(const char* name, std::initializer_list<std::size_t> counts,
                                      std::vector<double>& values) const {
  const std::optional<Place> place = find(name);
  if (!place) return Found::Absent;
  const std::optional<std::vector<double>> parsed = parseNumbers(place->value);
  if (!parsed || std::find(counts.begin(), counts.end(), parsed->size()) == counts.end())
    return refuse(name, *place, countsText(counts));
  if (!std::all_of(parsed->begin(), parsed->end(), isSane)) return refuse(name, *place, "numbers up to 1000000");
  values = *parsed;
  return Found::Good;
}

Attributes::Found Attributes::number(const char* name, double low, double high, float& value) const {
  std::vector<double> values;
  const Found found = numbers(name, {1}, values);
  if (found != Found::Good) return found;
  if (!(values[0] >= low && values[0] <= high)) return refuse(name, *find(name), rangeText(low, high));
  value = static_cast<float>(values[0]);
  return Found::Good;
}

Attributes::Found Attributes::whole(const char* name, int low, int high, int& value) const {
  std::vector<double> values;
  const Found found = numbers(name, {1}, values);
  if (found != Found::Good) return found;
  if (!(values[0] >= low && values[0] <= high) || values[0] != std::floor(values[0]))
    return refuse(name, *find(name), "a whole number, " + rangeText(low, high));
  value = static_cast<int>(values[0]);
  return Found::Good;
}

Attributes::Found Attributes::truth(const char* name, bool& value) const {
  const std::optional<Place> place = find(name);
  if (!place) return Found::Absent;
  const std::optional<bool> parsed = parseTruth(place->value);
  if (!parsed) return refuse(name, *place, "0 or 1");
  value = *parsed;
  return Found::Good;
}

Attributes::Found Attributes::floats(const char* name, float* values, std::size_t count) const {
  std::vector<double> read;
  const Found found = numbers(name, {count}, read);
  if (found == Found::Good)
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(read[i]);
  return found;
}

Attributes::Found Attributes::text(const char* name, std::string& value) const {
  const std::optional<Place> place = find(name);
  if (!place) return Found::Absent;
  if (place->value.empty()) return refuse(name, *place, "a text that is not empty");
  if (place->value.size() > kLongestText)
    return refuse(name, *place, "at most " + std::to_string(kLongestText) + " bytes");
  value = place->value;
  return Found::Good;
}

void Attributes::report(std::string_view what, std::string_view value, std::string_view expected) const {
  std::string sentence = std::string("<").append(node_.name()).append("> ").append(what);
  xml_.report({xml_.file(), line_, std::move(sentence), std::string(value), std::string(expected)});
}

void Attributes::reportAt(const char* name, std::string_view what, std::string_view expected) const {
  const std::optional<Place> place = find(name);
  if (!place) return report(what, {}, expected);
  std::string sentence = std::string("<").append(node_.name()).append("> ").append(what);
  xml_.report({*place->file, place->line, std::move(sentence), std::string(place->value), std::string(expected)});
}

}  // namespace brittle::content
