#include "script_helpers.h"

#include <gmock/gmock.h>

namespace brittle::script {
namespace {

using testing::HasSubstr;

TEST(Sandbox, ReachesNothingOutsideOfItself) {
  for (const char* name : {"io", "os", "package", "require", "dofile", "loadfile", "load", "loadstring", "debug",
                           "collectgarbage", "getmetatable", "setmetatable", "coroutine", "pcall", "module"})
    EXPECT_EQ(resultOf(std::string("result = type(") + name + ")"), Value("nil")) << name;
  EXPECT_EQ(resultOf("result = type(string.dump)"), Value("nil"));
}

TEST(Sandbox, SpeaksLua52) {
  EXPECT_EQ(textOf("10/2 .. ''"), "5");  // 5.4 says 5.0
  EXPECT_EQ(textOf("_VERSION"), "Lua 5.2");
}

TEST(Sandbox, CallsFunctionsByNameWithArguments) {
  Sandbox sandbox(noLibrary());
  ASSERT_TRUE(sandbox.load("function add(a, b) return a + b end", "a.lua"));
  EXPECT_TRUE(sandbox.has("add"));
  EXPECT_FALSE(sandbox.has("print"));
  EXPECT_FALSE(sandbox.has("tick"));
  const std::vector<Value> arguments = {2.0, 40.0};
  const Result<Value> sum = sandbox.call("add", arguments);
  ASSERT_TRUE(sum) << sum.error().message;
  EXPECT_EQ(*sum, Value(42.0));
  EXPECT_FALSE(sandbox.call("tick"));
}

TEST(Sandbox, ErrorsNameFileAndLine) {
  EXPECT_EQ(errorOf("x = 1\ny = x + nil_thing"),
            "t.lua:2: attempt to perform arithmetic on global 'nil_thing' (a nil value)");
  EXPECT_EQ(errorOf("error('mine')"), "t.lua:1: mine");
  EXPECT_EQ(errorOf("error('mine', 0)"), "t.lua:1: mine");
  EXPECT_EQ(errorOf("error({})"), "t.lua:1: the error is a table");
  EXPECT_THAT(errorOf("x = = 2"), HasSubstr("t.lua:1: unexpected symbol near '='"));
  EXPECT_EQ(errorOf("\n\nx = 2 ^ nil"), "t.lua:3: attempt to perform arithmetic on a nil value");
}

TEST(Sandbox, AnUnknownFunctionIsNamed) {
  EXPECT_EQ(errorOf("a = 1\nmgObstace('bar', 0, 0, 0)"), "t.lua:2: unknown function mgObstace");
}

TEST(Sandbox, LongFileNamesAreNotCutShort) {
  Sandbox sandbox(noLibrary());
  const std::string name = "a/" + std::string(200, 'x') + ".lua";
  EXPECT_EQ(sandbox.load("error('e')", name).error().message, name + ":1: e");
}

TEST(Sandbox, WhatAScriptDidBeforeItsErrorStays) {
  Sandbox sandbox(noLibrary());
  EXPECT_FALSE(sandbox.load("n = 7 function f() return n end unknown()", "t.lua"));
  EXPECT_EQ(*sandbox.call("f"), Value(7.0));
}

TEST(Sandbox, ALoopForEverEnds) {
  EXPECT_THAT(errorOf("while true do end"), HasSubstr("t.lua:1: the budget of 1000000 instructions is used up"));
  EXPECT_THAT(errorOf("local t = {} for i = 1, 1e18 do t.x = i end"), HasSubstr("budget"));
  EXPECT_THAT(errorOf("x = 1\n::again::\ngoto again"), HasSubstr("t.lua:2: the budget"));
}

TEST(Sandbox, LongStringsMakeInstructionsDearer) {
  const auto errorWith = [](int length, const std::string& work) {
    const std::string n = std::to_string(length);
    return errorOf("local s = string.rep('\\0', " + n + ") .. '1' local d = string.rep('1', " + n +
                   ") for i = 1, 20000 do " + work + " end");
  };
  for (const std::string work :
       {"local x = s < s .. '2'", "local x = d + 1", "local x = tonumber(d, 36)", "local x = d:byte(1, 9)"}) {
    EXPECT_EQ(errorWith(200, work), "no error") << work;
    EXPECT_THAT(errorWith(50000, work), HasSubstr("t.lua:1: the budget")) << work;
  }
}

TEST(Sandbox, AnErrorIsOneLine) {
  EXPECT_EQ(errorOf("error('a\\nb\\0c')"), "t.lua:1: a b c");
  EXPECT_LT(errorOf("error(string.rep('x', 60000))").size(), 400u);
}

TEST(Sandbox, TheFileThatDoesNotFitIntoMemoryIsNamed) {
  Sandbox sandbox(noLibrary());
  ASSERT_TRUE(sandbox.load("x = 1", "small.lua"));
  const Status status = sandbox.load("x = '" + std::string(200000, 'a') + "'", "large.lua");
  EXPECT_THAT(status.error().message, HasSubstr("large.lua: the memory budget"));
}

TEST(Sandbox, TheBudgetOfACallIsItsOwn) {
  Sandbox sandbox(noLibrary());
  ASSERT_TRUE(sandbox.load("function work(n) for i = 1, n do end end", "t.lua"));
  const std::vector<Value> much = {1e4};
  EXPECT_FALSE(sandbox.call("work", much, 1000));
  EXPECT_TRUE(sandbox.call("work", much, 100000));
  EXPECT_GT(sandbox.instructionsUsed(), 9000);
  EXPECT_TRUE(sandbox.call("work", much));
}

TEST(Sandbox, MemoryWithoutEndEnds) {
  EXPECT_THAT(errorOf("local s = 'x'\nwhile true do s = s .. s end"),
              HasSubstr("t.lua:2: the memory budget is used up"));
  EXPECT_THAT(errorOf("local t = {} while true do t[#t + 1] = {} end"), HasSubstr("budget"));
  EXPECT_THAT(errorOf("local t = {} for i = 1, 1e9 do t[i] = i end"), HasSubstr("memory budget"));
  EXPECT_THAT(errorOf("local s = string.rep('x', 1e9)"), HasSubstr("string.rep"));
  EXPECT_THAT(errorOf("local s = string.rep('', 1e15)"), HasSubstr("no error"));
  EXPECT_THAT(errorOf("local s = string.rep('x', 60000) for i = 1, 1e6 do local t = s .. i end"), HasSubstr("budget"));
  EXPECT_THAT(errorOf("local s, t = string.rep('x', 60000), {} for i = 1, 200 do t[i] = s .. i end"),
              HasSubstr("memory budget"));
}

TEST(Sandbox, RecursionWithoutEndEnds) {
  EXPECT_THAT(errorOf("function f() return 1 + f() end f()"), HasSubstr("budget"));
  EXPECT_THAT(errorOf("function f() return f() end f()"), HasSubstr("budget"));
  EXPECT_THAT(errorOf("function f(s) return string.gsub(s, '.', f) end f('x')"), HasSubstr("t.lua:1:"));
  EXPECT_THAT(errorOf("function f(a, b) table.sort({1, 2}, f) end f()"), HasSubstr("t.lua:1:"));
  EXPECT_THAT(errorOf("x = " + std::string(100000, '(') + "1" + std::string(100000, ')')), HasSubstr("t.lua"));
  EXPECT_THAT(errorOf(std::string(5000, '{')), HasSubstr("t.lua"));
}

TEST(Sandbox, ASandboxGoesOnAfterItsMemoryRanOut) {
  Sandbox sandbox(noLibrary());
  ASSERT_TRUE(sandbox.load(
      "function fill() local t = {} while true do t[#t + 1] = 'a' .. #t end end function one() return 1 end", "t"));
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(sandbox.call("fill"));
    EXPECT_EQ(*sandbox.call("one"), Value(1.0));
  }
  EXPECT_LT(sandbox.memoryUsed(), 9u << 20);
}

TEST(Sandbox, BytecodeIsRefused) {
  EXPECT_THAT(errorOf("\x1bLua\x52"), HasSubstr("t.lua"));
}

TEST(Sandbox, ShowsNoAddress) {
  EXPECT_EQ(textOf("tostring({})"), "table");
  EXPECT_EQ(textOf("tostring(print)"), "function");
  EXPECT_EQ(textOf("string.format('%s|%s|%5.2f|%d', {}, print, 1.005, 3)"), "table|function| 1.00|3");
  EXPECT_EQ(textOf("tostring(0/0) .. string.format('%s %f', 0/0, -(0/0))"), "nannan nan");
}

TEST(Sandbox, SyntaxIsCheckedWithoutRunning) {
  EXPECT_TRUE(checkSyntax("while true do end mgWhatever()", "a.lua"));
  EXPECT_EQ(checkSyntax("x = 1\nif x then", "a.lua").error().message, "a.lua:2: 'end' expected near <eof>");
  EXPECT_FALSE(checkSyntax("x = 'abc", "a.lua"));
  EXPECT_FALSE(checkSyntax("--[[ open", "a.lua"));
}

TEST(Sandbox, SourcesCutOrChangedAnywhereNeverCrash) {
  const std::string source =
      "local t = {a = 2 ^ 3, [1] = #'x' % 4; f = function(...) return ... end}\n--[[c]] x = t.f(1)[ [=[k]=] ] or -2 ^ "
      "-3 .. 'q\\z  w'\n";
  for (std::size_t cut = 0; cut <= source.size(); ++cut)
    errorOf(source.substr(0, cut), {20000, 256u << 10, 64u << 10, 4096});
  for (std::size_t at = 0; at < source.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = source;
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << bit));
      errorOf(flipped, {20000, 256u << 10, 64u << 10, 4096});
    }
  }
}

}  // namespace
}  // namespace brittle::script
