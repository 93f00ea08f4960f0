#include "script_helpers.h"

#include <gmock/gmock.h>

namespace brittle::script {
namespace {

constexpr const char* kSource = R"(
  local count, list = 0, {}
  local shared = {n = 1}
  a, b = shared, shared
  ring = {} ring.self = ring
  function tick()
    count = count + 1
    list[#list + 1] = math.random(100)
    shared.n = shared.n * 1.5
    names = names or {}
    names['k' .. count % 3] = {count, count % 2 == 0, tick}
    return count .. ':' .. table.concat(list, ',') .. ':' .. a.n .. ':' .. b.n .. ':' .. tostring(ring.self == ring) .. #names
  end
)";

Sandbox loaded() {
  Sandbox sandbox(noLibrary(), 9);
  EXPECT_TRUE(sandbox.load(kSource, "t.lua"));
  return sandbox;
}

TEST(Snapshot, ARestoredScriptGoesOnAsTheOriginal) {
  Sandbox original = loaded();
  for (int i = 0; i < 7; ++i) ASSERT_TRUE(original.call("tick"));
  ByteWriter saved;
  ASSERT_TRUE(original.save(saved));
  Sandbox restored = loaded();
  ByteReader reader(saved.bytes());
  const Status status = restored.restore(reader);
  ASSERT_TRUE(status) << status.error().message;
  EXPECT_EQ(reader.remaining(), 0u);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(*original.call("tick"), *restored.call("tick"));
  ByteWriter first, second;
  ASSERT_TRUE(original.save(first));
  ASSERT_TRUE(restored.save(second));
  EXPECT_EQ(first.bytes(), second.bytes());
}

TEST(Snapshot, WhatLongStringsMadeDearStaysDear) {
  const auto made = [] {
    Sandbox sandbox(noLibrary());
    EXPECT_TRUE(sandbox.load(
        "function grow() local s = string.rep('x', 60000) end function work() for i = 1, 20000 do end end", "t.lua"));
    return sandbox;
  };
  Sandbox original = made();
  EXPECT_TRUE(original.call("work"));
  ASSERT_TRUE(original.call("grow"));
  EXPECT_FALSE(original.call("work"));
  ByteWriter saved;
  ASSERT_TRUE(original.save(saved));
  Sandbox restored = made();
  ByteReader reader(saved.bytes());
  ASSERT_TRUE(restored.restore(reader));
  EXPECT_FALSE(restored.call("work"));
}

TEST(Snapshot, BytesDependOnContentsAlone) {
  const auto bytesAfter = [](const std::string& source) {
    Sandbox sandbox(noLibrary());
    EXPECT_TRUE(sandbox.load("function f() " + source + " end", "t.lua"));
    EXPECT_TRUE(sandbox.call("f"));
    ByteWriter out;
    EXPECT_TRUE(sandbox.save(out));
    return out.bytes();
  };
  EXPECT_EQ(bytesAfter("t = {} t.x = 1 t.y = 2 t[1] = 3"), bytesAfter("t = {3, y = 2, z = 1} t.z = nil t.x = 1"));
  EXPECT_NE(bytesAfter("t = {1}"), bytesAfter("t = {2}"));
}

TEST(Snapshot, RemovedAndReplacedGlobalsAreKept) {
  const char* source = "function change() next = nil change = nil print = tostring extra = 4 end";
  Sandbox original(noLibrary());
  ASSERT_TRUE(original.load(source, "t.lua"));
  ASSERT_TRUE(original.call("change"));
  ByteWriter saved;
  ASSERT_TRUE(original.save(saved));
  Sandbox restored(noLibrary());
  ASSERT_TRUE(restored.load(source, "t.lua"));
  ByteReader reader(saved.bytes());
  ASSERT_TRUE(restored.restore(reader));
  EXPECT_FALSE(restored.has("change"));
  EXPECT_EQ(restored.get("extra"), Value(4.0));
  ASSERT_TRUE(restored.load("result = type(next) .. print(5)", "u.lua"));
  EXPECT_EQ(restored.get("result"), Value("nil5"));
}

TEST(Snapshot, AFunctionMadeWhileRunningIsRefused) {
  Sandbox sandbox(noLibrary());
  ASSERT_TRUE(sandbox.load("function f() later = function() end end", "t.lua"));
  ASSERT_TRUE(sandbox.call("f"));
  ByteWriter out;
  EXPECT_THAT(sandbox.save(out).error().message,
              testing::HasSubstr("'later': a function made while running cannot be saved"));
  EXPECT_TRUE(out.bytes().empty());
}

TEST(Snapshot, DeepListsDoNotOverflow) {
  Sandbox sandbox(noLibrary());
  ASSERT_TRUE(sandbox.load("function f() for i = 1, 20000 do head = {head} end end", "t.lua"));
  ASSERT_TRUE(sandbox.call("f"));
  ByteWriter out;
  EXPECT_TRUE(sandbox.save(out));
  Sandbox other(noLibrary());
  ASSERT_TRUE(other.load("function f() for i = 1, 20000 do head = {head} end end", "t.lua"));
  ByteReader reader(out.bytes());
  EXPECT_TRUE(other.restore(reader));
}

TEST(Snapshot, OtherScriptsAreRefused) {
  Sandbox original = loaded();
  ByteWriter saved;
  ASSERT_TRUE(original.save(saved));
  Sandbox other(noLibrary());
  ASSERT_TRUE(other.load("x = 1", "t.lua"));
  ByteReader reader(saved.bytes());
  EXPECT_THAT(other.restore(reader).error().message, testing::HasSubstr("saved with other scripts"));
}

TEST(Snapshot, DamagedBytesNeverCrash) {
  Sandbox original = loaded();
  ASSERT_TRUE(original.call("tick"));
  ByteWriter saved;
  ASSERT_TRUE(original.save(saved));
  std::vector<unsigned char> bytes = saved.bytes();
  for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
    Sandbox sandbox = loaded();
    ByteReader reader(std::span<const unsigned char>(bytes.data(), cut));
    EXPECT_FALSE(sandbox.restore(reader)) << cut;
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int bit : {0, 1, 4, 7}) {
      bytes[at] = static_cast<unsigned char>(bytes[at] ^ (1 << bit));
      Sandbox sandbox = loaded();
      ByteReader reader(bytes);
      if (sandbox.restore(reader)) (void)sandbox.call("tick", {}, 10000);
      bytes[at] = static_cast<unsigned char>(bytes[at] ^ (1 << bit));
    }
  }
}

/// The saved state of an empty script, whose globals are now `tables` empty tables.
std::vector<unsigned char> forgedTables(const Sandbox& empty, std::uint32_t tables) {
  constexpr std::size_t untilGlobals =
      4 + 8 + 8 + 4 + 4 + 5;  // format, random stream, price, functions, the globals' name
  constexpr std::uint8_t nil = 0, number = 3, table = 5;
  ByteWriter saved, out;
  EXPECT_TRUE(empty.save(saved));
  out.writeBytes(saved.bytes().data(), untilGlobals);
  for (std::uint32_t i = 0; i < tables; ++i) {
    out.write(number);
    out.write(static_cast<double>(i + 1));
    out.write(table);
    out.write(i + 2);
  }
  for (std::uint32_t i = 0; i <= tables; ++i) out.write(nil);
  return out.bytes();
}

// A table of six bytes takes a hundred in memory: a script that had so many could not have made them.
TEST(Snapshot, AStateThatNoScriptCouldHoldIsRefused) {
  Limits limits;
  limits.memoryBytes = 256u << 10;
  for (const std::uint32_t tables : {100u, 20'000u}) {
    Sandbox sandbox(noLibrary(), 0, limits);
    ASSERT_TRUE(sandbox.load("", "t.lua"));
    const std::vector<unsigned char> bytes = forgedTables(sandbox, tables);
    ByteReader reader(bytes);
    EXPECT_EQ(static_cast<bool>(sandbox.restore(reader)), tables == 100u);
    EXPECT_LT(sandbox.memoryUsed(), 4 * limits.memoryBytes + 1);
  }
}

}  // namespace
}  // namespace brittle::script
