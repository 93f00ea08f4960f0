#include "engine/script/rewrite.h"

#include <array>

namespace brittle::script {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isHexDigit(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
bool isNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isNamePart(char c) {
  return isNameStart(c) || isDigit(c);
}
bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

constexpr std::array<std::string_view, 22> kKeywords = {
    "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
    "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};

bool isKeyword(std::string_view word) {
  for (const std::string_view keyword : kKeywords)
    if (word == keyword) return true;
  return false;
}

class Lexer {
 public:
  explicit Lexer(std::string_view source) : source_(source) {}

  Tokens run() {
    while (result_.wrong.empty()) {
      skipBlanksAndComments();
      if (at_ >= source_.size() || !result_.wrong.empty()) break;
      readToken();
    }
    return std::move(result_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0'; }

  void fail(const char* what) {
    if (!result_.wrong.empty()) return;
    result_.wrong = what;
    result_.wrongLine = line_;
  }

  void skipBlanksAndComments() {
    while (at_ < source_.size()) {
      if (isBlank(peek())) {
        line_ += peek() == '\n' ? 1 : 0;
        ++at_;
      } else if (peek() == '-' && peek(1) == '-') {
        at_ += 2;
        if (longBracketLevel() >= 0) {
          readLongBracket(longBracketLevel());
        } else {
          while (at_ < source_.size() && peek() != '\n' && peek() != '\r') ++at_;
        }
      } else {
        return;
      }
    }
  }

  /// The number of equal signs if a long bracket opens here, else -1.
  int longBracketLevel() const {
    if (peek() != '[') return -1;
    std::size_t equals = 0;
    while (peek(1 + equals) == '=') ++equals;
    return peek(1 + equals) == '[' ? static_cast<int>(equals) : -1;
  }

  void readLongBracket(int level) {
    const std::string close = "]" + std::string(static_cast<std::size_t>(level), '=') + "]";
    const std::size_t end = source_.find(close, at_ + static_cast<std::size_t>(level) + 2);
    if (end == std::string_view::npos) return fail("a long bracket is not closed");
    for (; at_ < end + close.size(); ++at_) line_ += peek() == '\n' ? 1 : 0;
  }

  void readToken() {
    const std::size_t start = at_;
    const int line = line_;
    const char c = peek();
    TokenKind kind = TokenKind::Symbol;
    if (isNameStart(c)) {
      while (isNamePart(peek())) ++at_;
      kind = isKeyword(source_.substr(start, at_ - start)) ? TokenKind::Keyword : TokenKind::Name;
    } else if (isDigit(c) || (c == '.' && isDigit(peek(1)))) {
      readNumber();
      kind = TokenKind::Number;
    } else if (c == '"' || c == '\'') {
      readQuoted(c);
      kind = TokenKind::Text;
    } else if (longBracketLevel() >= 0) {
      readLongBracket(longBracketLevel());
      kind = TokenKind::Text;
    } else {
      at_ += symbolLength();
    }
    if (result_.wrong.empty()) result_.all.push_back({kind, source_.substr(start, at_ - start), line});
  }

  void readNumber() {  // as wide as Lua's own: what is no number is then refused by Lua
    const bool hex = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
    if (hex) at_ += 2;
    for (;;) {
      const char c = peek();
      if (hex ? (c == 'p' || c == 'P') : (c == 'e' || c == 'E')) {
        ++at_;
        if (peek() == '+' || peek() == '-') ++at_;
      }
      if (!isHexDigit(peek()) && peek() != '.') break;
      ++at_;
    }
  }

  void readQuoted(char quote) {
    for (++at_; peek() != quote; ++at_) {
      if (at_ >= source_.size() || peek() == '\n' || peek() == '\r') return fail("a string is not closed");
      if (peek() == '\\') readEscape();
    }
    ++at_;
  }

  void readEscape() {  // leaves at_ on the last character that belongs to the escape
    ++at_;
    if (peek() == 'z') {
      while (isBlank(peek(1))) {
        line_ += peek(1) == '\n' ? 1 : 0;
        ++at_;
      }
      return;
    }
    line_ += peek() == '\n' ? 1 : 0;
    if (peek() == '\r' && peek(1) == '\n') {
      ++at_;
      ++line_;
    }
  }

  std::size_t symbolLength() const {
    if (peek() == '.' && peek(1) == '.') return peek(2) == '.' ? 3 : 2;
    if (peek() == ':' && peek(1) == ':') return 2;
    const bool compares = peek() == '=' || peek() == '~' || peek() == '<' || peek() == '>';
    return compares && peek(1) == '=' ? 2 : 1;
  }

  std::string_view source_;
  std::size_t at_ = 0;
  int line_ = 1;
  Tokens result_;
};

}  // namespace

Tokens tokenize(std::string_view source) {
  return Lexer(source).run();
}

}  // namespace brittle::script
