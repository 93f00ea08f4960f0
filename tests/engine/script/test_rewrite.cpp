#include "engine/script/rewrite.h"

#include "engine/core/random.h"
#include "engine/math/trig.h"
#include "script_helpers.h"

#include <cmath>
#include <lua.hpp>

namespace brittle::script {
namespace {

std::string rewritten(const std::string& source) {
  const Rewritten result = rewriteOperators(source);
  return result.wrong.empty() ? result.source : "wrong: " + result.wrong;
}

TEST(Rewrite, PowersBecomeCalls) {
  EXPECT_EQ(rewritten("x=a^b"), R"(x=("^")(a,b))");
  EXPECT_EQ(rewritten("x=a^b^c"), R"(x=("^")(a,("^")(b,c)))");
  EXPECT_EQ(rewritten("x=-a^-b^c*d"), R"(x=-("^")(a,-("^")(b,c))*d)");
  EXPECT_EQ(rewritten("x=t.a[i]:f(1)'s'^2 y=3"), R"(x=("^")(t.a[i]:f(1)'s',2) y=3)");
  EXPECT_EQ(rewritten("f{a^2}[1]=(b)^2"), R"(f{("^")(a,2)}[1]=("^")((b),2))");
}

TEST(Rewrite, ModuloTakesTheChainBeforeIt) {
  EXPECT_EQ(rewritten("x=a*b%c+d"), R"(x=("%")(a*b,c)+d)");
  EXPECT_EQ(rewritten("x=a+b%c%d"), R"(x=a+("%")(("%")(b,c),d))");
  EXPECT_EQ(rewritten("x=-a%b"), R"(x=("%")(-a,b))");
  EXPECT_EQ(rewritten("x=2^-a%b"), R"(x=("%")(("^")(2,-a),b))");
  EXPECT_EQ(rewritten("x=a%b^c"), R"(x=("%")(a,("^")(b,c)))");
  EXPECT_EQ(rewritten("a=b%c d=e%f"), R"(a=("%")(b,c) d=("%")(e,f))");
  EXPECT_EQ(rewritten("f(x)\ng(y)\nz=a%b"), "f(x)\ng(y)\nz=(\"%\")(a,b)");
}

TEST(Rewrite, LengthTakesWhatFollows) {
  EXPECT_EQ(rewritten("t[#t+1]=#t.x^2"), R"(t[("#")(t)+1]=("#")(("^")(t.x,2)))");
  EXPECT_EQ(rewritten("x=#t%2"), R"(x=("%")(("#")(t),2))");
  EXPECT_EQ(rewritten("x=not #-#t"), R"(x=not ("#")(-("#")(t)))");
}

TEST(Rewrite, TextsAndCommentsAreLeftAlone) {
  const std::string source = "x = 'a^b' --[==[ ^ % ]] # ]==] .. [[2^3]] -- 1^2\ny = \"\\\"^\\z\n  #\"";
  EXPECT_EQ(rewritten(source), source);
}

TEST(Rewrite, FunctionsInsideOperandsAreWalked) {
  EXPECT_EQ(rewritten("table.sort(t,function(a,b) return a^2<b^2 end)"),
            R"(table.sort(t,function(a,b) return ("^")(a,2)<("^")(b,2) end))");
  EXPECT_EQ(rewritten("x=2^function() end"), "wrong: a function or a keyword stands where an operand was expected");
}

// An oracle: the same random expression, rewritten and not, must agree where only exact operations occur.
std::string randomExpression(Random& random, int depth) {
  const std::uint32_t kind = random.nextBelow(depth > 0 ? 12 : 3);
  const auto sub = [&] { return randomExpression(random, depth - 1); };
  switch (kind) {
    case 0:
      return std::to_string(1 + random.nextBelow(5));
    case 1:
      return "a";
    case 2:
      return "t.b";
    case 3:
      return "f(" + sub() + ")";
    case 4:
      return "(" + sub() + ")";
    case 5:
      return "- " + sub();
    case 6:
      return "#t[" + std::to_string(1 + random.nextBelow(2)) + "]";
    case 7: {
      const std::string left = sub();
      return left + " % " + sub();
    }
    case 8: {
      const std::string left = sub();
      return left + " ^ " + std::to_string(random.nextBelow(3));
    }
    case 9: {
      const std::string left = sub();
      return left + " * " + sub();
    }
    case 10:
      return "2 ^ -" + std::to_string(random.nextBelow(3)) + " ^ " + std::to_string(random.nextBelow(3));
    default: {
      const std::string left = sub();
      return left + " - " + sub();
    }
  }
}

TEST(Rewrite, KeepsTheMeaningOfRandomExpressions) {
  Random random(5);
  // f adds parentheses of its own, so that a wrong binding shows; numbers stay small and exact.
  for (int i = 0; i < 400; ++i) {
    const std::string expression = randomExpression(random, 4);
    const std::string prefix =
        "local a, t = 3, {'xx', {1, 2, 3}, b = 2} local function f(x) return x + 1 end result = ";
    lua_State* plain = luaL_newstate();
    luaL_openlibs(plain);
    ASSERT_EQ(luaL_loadstring(plain, (prefix + expression).c_str()), 0) << expression << lua_tostring(plain, -1);
    const bool fails = lua_pcall(plain, 0, 0, 0) != 0;  // a length of a number, say
    lua_getglobal(plain, "result");
    const double expected = lua_tonumber(plain, -1);
    lua_close(plain);
    if (fails) {
      EXPECT_NE(errorOf(prefix + expression), "no error") << expression;
      continue;
    }
    const double got = resultOf(prefix + expression).number;
    if (std::isfinite(expected) && std::fabs(expected) < 1e12) {
      EXPECT_EQ(got, expected) << expression;
    }
  }
}

TEST(Rewrite, PowersHaveTheBitsOfOurOwn) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const double x = random.nextFloat(0.01f, 50.0f);
    const double y = random.nextFloat(-6.0f, 6.0f);
    char expression[128];
    std::snprintf(expression, sizeof(expression), "%a ^ %a", x, y);
    EXPECT_EQ(numberOf(expression), power(x, y)) << expression;  // constants: folded by Lua, were they left to it
    std::snprintf(expression, sizeof(expression), "math.pow(%a, %a)", x, y);
    EXPECT_EQ(numberOf(expression), power(x, y));
  }
  EXPECT_EQ(numberOf("2^10"), 1024.0);
  EXPECT_EQ(numberOf("2^0.5"), std::sqrt(2.0));
  EXPECT_EQ(numberOf("'2'^'3'"), 8.0);
}

TEST(Rewrite, AStringCannotBeCalledOtherwise) {
  EXPECT_EQ(errorOf("('abc')()"), "t.lua:1: attempt to call a string value");
  EXPECT_EQ(errorOf("x = #nil"), "t.lua:1: attempt to get length of a nil value");
}

TEST(Rewrite, LinesStayWhereTheyWere) {
  EXPECT_EQ(errorOf("local a = 2\n  ^ 3 --[[\n]] % 4\nerror('here')"), "t.lua:4: here");
}

}  // namespace
}  // namespace brittle::script
