// A power binds tighter than a sign on its left and is right-associative; its right operand is signs and one simple
// expression. So while walking over the tokens it is enough to know, per bracket level, where the last simple
// expression began (the left operand of ^), where the chain of * / % began (that of %), and how many calls are to be
// closed after the next operand.
#include "engine/script/rewrite.h"

#include <algorithm>

namespace brittle::script {
namespace {

struct Level {
  char opener = 0;
  bool afterOperand = false;     // the last token ended a simple expression
  bool takesSuffix = false;      // which may go on with . [ ( : { or a string
  std::size_t operandStart = 0;  // token index
  bool hasChain = false;
  std::size_t chainStart = 0;  // token index
  int open = 0;                // calls to close when the operand ends
};

class Rewriter {
 public:
  Rewriter(std::string_view source, const std::vector<Token>& tokens)
      : source_(source),
        tokens_(tokens),
        before_(tokens.size()),
        after_(tokens.size()),
        instead_(tokens.size(), nullptr) {
    levels_.emplace_back();
  }

  Rewritten run() {
    for (at_ = 0; at_ < tokens_.size() && result_.wrong.empty(); ++at_) step(tokens_[at_]);
    if (result_.wrong.empty() && !tokens_.empty()) endOperand();
    if (result_.wrong.empty() && levels_.size() > 1) fail("a bracket is not closed");
    if (result_.wrong.empty()) assemble();
    return std::move(result_);
  }

 private:
  Level& level() { return levels_.back(); }

  void fail(const char* what) {
    result_.wrong = what;
    result_.wrongLine = at_ < tokens_.size() ? tokens_[at_].line : (tokens_.empty() ? 0 : tokens_.back().line);
  }

  void step(const Token& token) {
    const std::string_view text = token.text;
    if (level().afterOperand && level().takesSuffix && goOnWithSuffix(token)) return;
    if (text == "^" && token.kind == TokenKind::Symbol && level().afterOperand) return startPower();
    if (level().afterOperand) endOperand();
    switch (token.kind) {
      case TokenKind::Name:
        return startOperand(true);
      case TokenKind::Number:
      case TokenKind::Text:
        return startOperand(false);
      case TokenKind::Keyword:
        return keyword(text);
      case TokenKind::Symbol:
        return symbol(text);
    }
  }

  /// Whether the token belongs to the simple expression before it.
  bool goOnWithSuffix(const Token& token) {
    if (token.kind == TokenKind::Text) {
      level().takesSuffix = true;
      return true;
    }
    if (token.kind != TokenKind::Symbol) return false;
    if (token.text == "." || token.text == ":") {
      if (at_ + 1 < tokens_.size() && tokens_[at_ + 1].kind == TokenKind::Name) ++at_;
      return true;
    }
    if (token.text == "(" || token.text == "[" || token.text == "{") {
      open(token.text[0]);
      return true;
    }
    return false;
  }

  void startOperand(bool takesSuffix) {
    Level& here = level();
    if (here.afterOperand) here.hasChain = false;  // two in a row: a new statement
    here.afterOperand = true;
    here.takesSuffix = takesSuffix;
    here.operandStart = at_;
    startChain();
  }

  void startChain() {
    if (level().hasChain) return;
    level().hasChain = true;
    level().chainStart = at_;
  }

  /// The operand ended with the token before this one: every call that waited for it is closed.
  void endOperand() {
    after_[at_ - 1] += level().open;
    level().open = 0;
  }

  void startPower() {
    before_[level().operandStart].push_back('^');
    instead_[at_] = ",";
    ++level().open;
    level().afterOperand = false;
  }

  void keyword(std::string_view text) {
    if (text == "nil" || text == "true" || text == "false") return startOperand(false);
    if (text == "not") {
      startChain();
      level().afterOperand = false;
      return;
    }
    if (level().open > 0) return fail("a function or a keyword stands where an operand was expected");
    level().afterOperand = false;
    level().hasChain = false;
  }

  void symbol(std::string_view text) {
    Level& here = level();
    if (text == "...") return startOperand(false);
    if (text == "(" || text == "{") {
      startOperand(text == "(");
      return open(text[0]);
    }
    if (text == "[") return open('[');  // a key in a table constructor
    if (text == ")" || text == "]" || text == "}") return close(text[0]);
    const bool isOperand = here.afterOperand;
    here.afterOperand = false;
    if (!isOperand && text == "-") return startChain();
    if (!isOperand && text == "#") {
      startChain();
      before_[at_].push_back('#');
      instead_[at_] = "";
      ++here.open;
      return;
    }
    if (isOperand && text == "%") {
      before_[here.chainStart].push_back('%');
      instead_[at_] = ",";
      ++here.open;
      return;
    }
    if (isOperand && (text == "*" || text == "/")) return;
    if (here.open > 0) return fail("an operator stands where an operand was expected");
    here.hasChain = false;
  }

  void open(char opener) {
    levels_.emplace_back();
    level().opener = opener;
  }

  void close(char closer) {
    const char opener = closer == ')' ? '(' : (closer == ']' ? '[' : '{');
    if (level().opener != opener) return fail("a bracket closes that is not open");
    if (level().open > 0) return fail("a bracket stands where an operand was expected");
    levels_.pop_back();
  }

  void assemble() {
    std::size_t copied = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const auto start = static_cast<std::size_t>(tokens_[i].text.data() - source_.data());
      result_.source.append(source_, copied, start - copied);
      for (std::size_t k = before_[i].size(); k-- > 0;) {  // what was found later encloses what was found before
        result_.source += "(\"";
        result_.source += before_[i][k];
        result_.source += "\")(";
      }
      result_.source += instead_[i] != nullptr ? std::string_view(instead_[i]) : tokens_[i].text;
      result_.source.append(static_cast<std::size_t>(after_[i]), ')');
      copied = start + tokens_[i].text.size();
    }
    result_.source.append(source_, copied, source_.size() - copied);
  }

  std::string_view source_;
  const std::vector<Token>& tokens_;
  std::vector<std::string> before_;   // per token: the operators whose call opens before it, innermost first
  std::vector<int> after_;            // per token: the calls that close after it
  std::vector<const char*> instead_;  // per token: what stands in its place, or null
  std::vector<Level> levels_;
  std::size_t at_ = 0;
  Rewritten result_;
};

}  // namespace

Rewritten rewriteOperators(std::string_view source) {
  const Tokens tokens = tokenize(source);
  if (!tokens.wrong.empty()) return {{}, tokens.wrong, tokens.wrongLine};
  return Rewriter(source, tokens.all).run();
}

}  // namespace brittle::script
