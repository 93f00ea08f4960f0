#include "game/content/parameter_names.h"

#include <algorithm>
#include <span>

#include "engine/script/rewrite.h"
#include "game/content/nearest.h"

namespace brittle::content {
namespace {

using script::Token;
using script::TokenKind;

constexpr std::string_view kAsks[] = {"mgGetFloat", "mgGetInt", "mgGetBool", "mgGetString", "mgGetColor"};

/// The text of a short string without escapes; empty for others.
std::string_view textOf(const Token& token) {
  const std::string_view text = token.text;
  const bool isShort = token.kind == TokenKind::Text && text.size() > 2 && text.front() != '[';
  return isShort && text.find('\\') == std::string_view::npos ? text.substr(1, text.size() - 2) : std::string_view();
}

/// The name that the call after `tokens[0]` asks for, if it says it: f("name" followed by , or ), or f"name".
std::string_view askedFor(std::span<const Token> tokens) {
  if (tokens.size() > 1 && tokens[1].kind == TokenKind::Text) return textOf(tokens[1]);
  if (tokens.size() < 4 || tokens[1].text != "(") return {};
  return tokens[3].text == "," || tokens[3].text == ")" ? textOf(tokens[2]) : std::string_view();
}

}  // namespace

void ParameterNames::add(const ParameterNames& more) {
  isOpen = isOpen || more.isOpen;
  for (const std::string& name : more.names)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

ParameterNames parameterNames(std::string_view source) {
  const script::Tokens tokens = script::tokenize(source);
  ParameterNames found;
  found.isOpen = !tokens.wrong.empty();
  const std::span<const Token> all(tokens.all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::find(std::begin(kAsks), std::end(kAsks), all[i].text) == std::end(kAsks)) continue;
    const std::string name(askedFor(all.subspan(i)));
    found.add(name.empty() ? ParameterNames{{}, true} : ParameterNames{{name}, false});
  }
  return found;
}

std::string expectedFor(std::string_view key, const ParameterNames& asked, bool onlyNear) {
  const std::vector<std::string_view> known(asked.names.begin(), asked.names.end());
  if (asked.isOpen || std::find(known.begin(), known.end(), key) != known.end()) return {};
  const std::string nearest = nearestOf(key, known);
  if (!nearest.empty() || onlyNear) return nearest;
  return known.empty() ? "none" : listOf(known);
}

}  // namespace brittle::content
