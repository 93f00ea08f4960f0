// Our replacements of the standard library: order, math, patterns, sort.
#include "engine/core/random.h"
#include "engine/math/trig.h"
#include "script_helpers.h"

#include <gmock/gmock.h>
#include <lua.hpp>

namespace brittle::script {
namespace {

using testing::HasSubstr;

TEST(Pairs, GoThroughKeysInOrder) {
  const std::string walk =
      "local s = '' for k, v in pairs(t) do s = s .. tostring(k) .. '=' .. v .. ' ' end result = s";
  EXPECT_EQ(resultOf("t = {z=1, a=2, [3]=3, [1]=4, [-2.5]=5, [true]=6, [false]=7, ['10']=8, B=9} " + walk),
            Value("-2.5=5 1=4 3=3 10=8 B=9 a=2 z=1 false=7 true=6 "));
  EXPECT_EQ(resultOf("t = {} for i = 50, 1, -7 do t[i] = i end t[8] = nil " + walk),
            Value("1=1 15=15 22=22 29=29 36=36 43=43 50=50 "));
  EXPECT_EQ(resultOf("t = {} " + walk), Value(""));
}

TEST(Pairs, NextGivesTheSameOrder) {
  EXPECT_EQ(
      resultOf(
          "t = {b=1, a=1, 1, 2} local s = '' local k = next(t) while k do s = s .. k k = next(t, k) end result = s"),
      Value("12ab"));
  EXPECT_EQ(resultOf("local s = '' for k in next, {b=1, a=2} do s = s .. k end result = s"), Value("ab"));
}

TEST(Pairs, EntriesMayBeRemovedOnTheWay) {
  EXPECT_EQ(
      resultOf("t = {a=1, b=2, c=3} local s = '' for k in pairs(t) do s = s .. k t.b = nil t[k] = nil end result = s"),
      Value("ac"));
}

TEST(Pairs, KeysWithoutOrderAreRefused) {
  EXPECT_THAT(errorOf("for k in pairs({[{}] = 1}) do end"),
              HasSubstr("t.lua:1: pairs: a table or function used as a key"));
  EXPECT_THAT(errorOf("next({[print] = 1})"), HasSubstr("t.lua:1: next:"));
}

TEST(Math, HasTheBitsOfTheEngine) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double x = random.nextFloat(-20.0f, 20.0f);
    char text[64];
    std::snprintf(text, sizeof(text), "%a", x);
    EXPECT_EQ(numberOf("math.sin(" + std::string(text) + ")"), sineOf(x));
    EXPECT_EQ(numberOf("math.cos(" + std::string(text) + ")"), cosineOf(x));
    EXPECT_EQ(numberOf("math.exp(" + std::string(text) + ")"), exponentialOf(x));
    EXPECT_EQ(numberOf("math.atan2(" + std::string(text) + ", 2)"), arcTangentOf(x, 2.0));
  }
  EXPECT_EQ(numberOf("math.log(8, 2)"), 3.0);
  EXPECT_EQ(numberOf("math.log10(1000)"), 3.0);
  EXPECT_NEAR(numberOf("math.tanh(0.5)"), 0.46211715726000975, 1e-15);
  EXPECT_NEAR(numberOf("math.asin(0.5)"), 0.52359877559829887, 1e-15);
  EXPECT_EQ(numberOf("math.fmod(-7, 3)"), -1.0);
  EXPECT_EQ(numberOf("-7 % 3"), 2.0);
  EXPECT_EQ(numberOf("math.max(1, 3, 2) - math.min(4, 2)"), 1.0);
  EXPECT_EQ(numberOf("math.floor(-1.5) + math.ceil(1.2)"), 0.0);
}

TEST(Math, RandomFollowsTheSeed) {
  const auto draw = [](std::uint64_t seed) {
    Sandbox sandbox(noLibrary(), seed);
    EXPECT_TRUE(sandbox.load(
        "s = '' for i = 1, 20 do s = s .. math.random(6) .. math.random(-2, 2) .. math.random() end", "t"));
    return sandbox.get("s").text;
  };
  EXPECT_EQ(draw(1), draw(1));
  EXPECT_NE(draw(1), draw(2));
  EXPECT_EQ(resultOf("math.randomseed(7) a = math.random() math.randomseed(7) result = a == math.random()"),
            Value(true));
  EXPECT_EQ(
      resultOf("result = true for i = 1, 1000 do local r = math.random(3) result = result and r >= 1 and r <= 3 end"),
      Value(true));
  EXPECT_EQ(errorOf("math.random(0)"), "t.lua:1: math.random: the interval 1 to 0 is empty");
}

TEST(Patterns, AgreeWithTheLibrary) {
  const char* expressions[] = {"string.find('hello world', 'o w')",
                               "string.find('a.b', '.', 2, true)",
                               "string.find('abc', 'b', -1)",
                               "string.match('key = value', '^(%w+)%s*=%s*(%w+)$')",
                               "string.match('  trim  ', '^%s*(.-)%s*$')",
                               "string.match('2024-05', '%d+', 5)",
                               "string.gsub('hello', 'l+', '<%0>')",
                               "string.gsub('abc', '', '-')",
                               "string.gsub('abc', '%w', '%0%0', 2)",
                               "string.gsub('$x and $y', '%$(%w+)', {x = '1'})",
                               "string.gsub('abc', 'b', function(c) return nil end)",
                               "string.match('f(a(b)c)d', '%b()')",
                               "string.gsub('THE (quick) fox', '%f[%a]%a+', 'X')",
                               "string.find('', '')",
                               "string.match('aaa', 'a-b')",
                               "string.match('x[]]', '[]]+')",
                               "string.match('a-z', '[a%-z]+')",
                               "string.match('abab', '(ab)%1')",
                               "string.find('abc', '()b()')",
                               "string.rep('ab', 3, ',')",
                               "string.match('path/to/x.lua', '([^/]+)%.lua$')",
                               "string.gsub('a,b,,c', ',', ';')",
                               "string.match('0x1F', '%x+$')",
                               "string.find('a\\0b', '%z')",
                               "string.find('abc', 'c', 10)",
                               "string.match('foo.bar', '%.(.*)')",
                               "string.gsub('hello world', '(o)( ?)', '%2%1')",
                               "('x'):rep(0)",
                               "string.find('ab', '[b-]')"};
  for (const char* expression : expressions) {
    const std::string source = std::string("local r = {") + expression +
                               "} local s = '' for i = 1, #r do s = s .. '|' .. tostring(r[i]) end result = s";
    lua_State* plain = luaL_newstate();
    luaL_openlibs(plain);
    ASSERT_EQ(luaL_dostring(plain, source.c_str()), 0) << expression << ": " << lua_tostring(plain, -1);
    lua_getglobal(plain, "result");
    const std::string expected = lua_tostring(plain, -1);
    lua_close(plain);
    EXPECT_EQ(resultOf(source), Value(expected)) << expression;
  }
  EXPECT_EQ(
      resultOf("local s = '' for k, v in string.gmatch('a=1, b=2', '(%w+)=(%w+)') do s = s .. k .. v end result = s"),
      Value("a1b2"));
  EXPECT_EQ(resultOf("local n = 0 for w in ('one two'):gmatch('%a*') do n = n + 1 end result = n"), Value(4.0));
}

TEST(Patterns, GoingBackForEverEnds) {
  const std::string subject = "local s = string.rep('a', 200) ";
  EXPECT_THAT(errorOf(subject + "string.find(s, string.rep('a-', 20) .. 'b')"),
              HasSubstr("t.lua:1: the instruction budget is used up"));
  EXPECT_THAT(errorOf(subject + "string.find(s, string.rep('.*', 20) .. 'b')"), HasSubstr("budget"));
  EXPECT_THAT(errorOf(subject + "string.gsub(s, string.rep('a?', 150) .. 'b', '')"), HasSubstr("t.lua:1:"));
  EXPECT_THAT(errorOf("string.find(string.rep('a', 6e4), string.rep('a', 3e4) .. 'b', 1, true)"), HasSubstr("budget"));
  EXPECT_THAT(errorOf("string.find(string.rep('a', 500), string.rep('a?', 500))"), HasSubstr("pattern too complex"));
}

TEST(Patterns, MalformedOnesAreRefused) {
  for (const char* pattern :
       {"[a", "%", "(a", "a)", "%1", "%f", "%b", "%bx", "[%", "[^", "[]", "[a-", "(()", "%f[", "[%a"})
    EXPECT_THAT(errorOf(std::string("string.find('aaa', '") + pattern + "')"), HasSubstr("t.lua:1: ")) << pattern;
}

TEST(Tables, LengthDependsOnContentsAlone) {
  const std::string holes = "for i = 1, 20 do t[i] = i end for i = 5, 19 do t[i] = nil end ";
  const double built = numberOf("(function() local t = {} " + holes + " return #t end)()");
  EXPECT_EQ(numberOf("(function() local t = {} t[20] = 20 t[4] = 4 t[3] = 3 t[2] = 2 t[1] = 1 return #t end)()"),
            built);
  EXPECT_EQ(numberOf("(function() local t = {1, 2, 3, 4} t[20] = 20 return #t end)()"), built);
  // Lua itself says 5 for the first and 3 for the second
  EXPECT_EQ(numberOf("#{1, 2, 3, nil, 5}"),
            numberOf("(function() local t = {} t[1] = 1 t[2] = 2 t[3] = 3 t[5] = 5 return #t end)()"));
}

TEST(Tables, InsertRemoveConcatUnpackSort) {
  EXPECT_EQ(
      textOf(
          "(function() local t = {1, 2} table.insert(t, 3) table.insert(t, 1, 0) return table.concat(t, ',') end)()"),
      "0,1,2,3");
  EXPECT_EQ(
      textOf("(function() local t = {1, 2, 3} local a = table.remove(t, 1) return a .. table.remove(t) .. #t end)()"),
      "131");
  EXPECT_EQ(numberOf("select('#', table.unpack({1, 2, 3}, 2))"), 2.0);
  EXPECT_EQ(numberOf("table.pack(1, nil, 3).n"), 3.0);
  EXPECT_EQ(textOf("(function() local t = {5, 3, 9, 1, 1, 7} table.sort(t) return table.concat(t, ' ') end)()"),
            "1 1 3 5 7 9");
  EXPECT_EQ(
      textOf("(function() local t = {'b1', 'a2', 'b3', 'a4', 'a5'} "
             "table.sort(t, function(x, y) return x:sub(1, 1) < y:sub(1, 1) end) return table.concat(t, ' ') end)()"),
      "a2 a4 a5 b1 b3");
  EXPECT_EQ(textOf("(function() local t = {3, 1, 2} table.sort(t, function() return true end) return #t .. '' end)()"),
            "3");
  EXPECT_THAT(errorOf("table.sort({1, 'x'})"), HasSubstr("t.lua:1: attempt to compare"));
  EXPECT_THAT(errorOf("table.insert({}, 5, 1)"), HasSubstr("position 5 is not in 1 to 1"));
  EXPECT_THAT(errorOf("table.concat({}, '', 1, 2^31 - 2)"), HasSubstr("t.lua:1:"));
}

}  // namespace
}  // namespace brittle::script
