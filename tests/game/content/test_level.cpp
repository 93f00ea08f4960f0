#include "game/content/level.h"

#include "content_helpers.h"
#include "engine/core/random.h"

#include <gmock/gmock.h>

namespace brittle::content {
namespace {

using testing::HasSubstr;

TEST(Level, RoomsAreReadWithAllTheirAttributes) {
  const Level level = readLevel(dataFile("levels/yard.xml"), "l.xml");
  ASSERT_EQ(level.rooms.size(), 4u);
  EXPECT_EQ(level.rooms[0].type, "yard/first");
  EXPECT_FLOAT_EQ(level.rooms[0].length, 300.0f);
  EXPECT_TRUE(level.rooms[0].start);
  EXPECT_FALSE(level.rooms[0].end);
  EXPECT_EQ(level.rooms[0].attributes.at("rot"), "0.5");
  EXPECT_FLOAT_EQ(level.rooms[1].length, 200.0f);  // called distance
  EXPECT_TRUE(level.rooms[1].end);
  EXPECT_EQ(level.rooms[1].line, 3);
  EXPECT_FLOAT_EQ(level.rooms[2].length, 100.0f);
  const std::string problems = listed(level.problems);
  EXPECT_THAT(problems, HasSubstr("l.xml:4: <room> type is missing"));
  EXPECT_THAT(problems, HasSubstr("l.xml:5: <room> length, got '-5', expected 0.001 to 1000000"));
  EXPECT_THAT(problems, HasSubstr("l.xml:6: <room> length is missing: 100 is used"));
  EXPECT_EQ(level.problems.size(), 3u);
}

TEST(Level, OnOneLineIsReadToo) {
  const Level level =
      readLevel("<level>\t<room type=\"a\" length=\"1\"/>\t<room type=\"b\" length=\"2\"/></level>", "l.xml");
  EXPECT_EQ(level.rooms.size(), 2u);
  EXPECT_TRUE(level.problems.empty());
}

TEST(Level, AnEndlessListOfRoomsEnds) {
  std::string text = "<level>\n";
  for (int i = 0; i < 501; ++i) text += "<room type=\"a\" length=\"1\"/>\n";
  const Level level = readLevel(text + "</level>", "l.xml");
  EXPECT_EQ(level.rooms.size(), 500u);
  EXPECT_EQ(listed(level.problems), "l.xml:502: too many rooms: the rest is left out, expected at most 500\n");
}

TEST(Level, WithoutRoomsIsAProblem) {
  EXPECT_EQ(listed(readLevel("<level/>", "l.xml").problems), "l.xml:1: the level has no rooms\n");
}

TEST(Level, WhatIsNoneIsSaidToBeSomethingElseInOneLine) {
  const auto said = [](const std::string& text) { return listed(readLevel(text, "l.xml").problems); };
  EXPECT_EQ(said(""), "l.xml:1: an empty file, expected <level>\n");
  EXPECT_EQ(said(" \n"), "l.xml:1: an empty file, expected <level>\n");
  EXPECT_EQ(said("no\ntags"), "l.xml:1: not XML, expected <level>\n");
  EXPECT_EQ(said("\n<segment size=\"1 1 1\"/>"), "l.xml:2: another kind of file, got '<segment>', expected <level>\n");
  std::string bytes;
  Random random(3);
  for (int i = 0; i < 5000; ++i) bytes += static_cast<char>(random.nextBelow(256));
  const std::string noise = said(bytes);
  EXPECT_EQ(noise, "l.xml:1: not XML: bytes that are no text, expected <level>\n");
  EXPECT_EQ(said("\n<!-- <level/>"), "l.xml:2: not XML: Error parsing comment, expected <level>\n");
}

TEST(Level, CutOrChangedAnywhereItIsStillSound) {
  forEachDamage(dataFile("levels/yard.xml"), [](const std::string& text) {
    for (const Room& room : readLevel(text, "f.xml").rooms) ASSERT_TRUE(!room.type.empty() && room.length > 0.0f);
  });
}

TEST(GameList, ListsLevels) {
  const GameList list = readGameList(dataFile("game.xml"), "g.xml");
  ASSERT_EQ(list.levels.size(), 2u);
  EXPECT_EQ(list.levels[1].name, "nowhere");
  EXPECT_EQ(list.levels[1].line, 3);
  EXPECT_EQ(listed(list.problems), "g.xml:4: <level> name is missing: the level is left out\n");
}

}  // namespace
}  // namespace brittle::content
