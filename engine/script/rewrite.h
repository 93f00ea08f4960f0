// script/rewrite.h - makes a source say `("^")(a, b)` where it said `a ^ b`, and likewise `a % b` and `#a`. Lua's
// virtual machine (and its constant folding) computes a power with the C library, whose last bit differs between
// machines; a modulo with a product and a difference that some compilers fuse; and a length that depends on how a table
// was filled. The string that is called finds our own arithmetic through the metatable of strings, which no script can
// reach or hide.
#pragma once

#include "engine/core/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace brittle::script {

enum class TokenKind { Name, Keyword, Number, Text, Symbol };

struct Token {
  TokenKind kind;
  std::string_view text;
  int line;
};

/// Splits a source into tokens without comments. The error says "LINE: what", or nothing is wrong.
struct Tokens {
  std::vector<Token> all;
  std::string wrong;  // empty: nothing
  int wrongLine = 0;
};
Tokens tokenize(std::string_view source);

/// The rewritten source, line for line as before. `wrong` is set where brackets do not match or a function is an
/// operand.
struct Rewritten {
  std::string source;
  std::string wrong;
  int wrongLine = 0;
};
Rewritten rewriteOperators(std::string_view source);

}  // namespace brittle::script
