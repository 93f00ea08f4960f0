#include "game/sim/progress.h"

#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

TEST(Progress, ACheckpointKeepsTheMostBallsItWasPassedWith) {
  Progress progress;
  EXPECT_EQ(progress.ballsAt("first", 3), rules::kStartBalls);
  EXPECT_TRUE(progress.pass("first", 3, 31));
  EXPECT_FALSE(progress.pass("first", 3, 12));
  EXPECT_FALSE(progress.pass("first", 3, 31));
  EXPECT_TRUE(progress.pass("first", 3, 40));
  EXPECT_TRUE(progress.pass("first", 5, 7));  // fewer than a game begins with, but it was passed
  EXPECT_EQ(progress.ballsAt("first", 3), 40);
  EXPECT_EQ(progress.ballsAt("first", 5), 7);
  EXPECT_EQ(progress.ballsAt("second", 3), rules::kStartBalls);
}

TEST(Progress, ComesBackFromItsTextAndNamesLinesThatAreNone) {
  Progress progress;
  progress.pass("a pack/one", 3, 31);
  progress.pass("two", 0, 999);
  std::vector<std::string> problems;
  EXPECT_EQ(Progress::parse(progress.text(), "progress", problems).text(), progress.text());
  EXPECT_TRUE(problems.empty());
  const std::string bad = "31 3 first\nhello\n-4 1 first\n12 1\n99999999999 1 x\n0 0 first\n";
  EXPECT_EQ(Progress::parse(bad, "progress", problems).text(), "31 3 first\n");
  ASSERT_EQ(problems.size(), 5u);
  EXPECT_EQ(problems[0], "progress:2: hello: expected BALLS ROOM LEVEL");
}

/// Four empty rooms of 32 m with a checkpoint after the second, and a level after it.
content::MemorySource fourRooms() {
  content::MemorySource source = oneRoom("", 32.0f);
  const std::string room = "<room type=\"test/room\" length=\"100\"";
  source.add("levels/test.xml", "<level>" + room + "/>" + room + " end=\"true\"/>" + room + "/>" + room + "/></level>");
  source.add("levels/more.xml", "<level>" + room + "/></level>");
  return source;
}

TEST(Progress, ARestartBeginsAtTheLastCheckpointWithTheStoredBalls) {
  const content::MemorySource source = fourRooms();
  const auto game = newTestGame(source);
  Progress progress;
  game->tick(throwAt(0.0f, 0.3f));
  play(*game, rules::kRoomTicks - 1);
  EXPECT_EQ(nextGame(*game, progress, {}).firstRoom, 0u);  // a door is no checkpoint
  const auto events = play(*game, rules::kRoomTicks);
  EXPECT_EQ(events.at(EventType::Checkpoint), 1);
  EXPECT_EQ(game->checkpoint().room, 2u);
  EXPECT_EQ(game->checkpoint().balls, rules::kStartBalls - 1);
  EXPECT_FLOAT_EQ(game->checkpoint().distance, 200.0f);
  EXPECT_EQ(game->hud().checkpointBalls, rules::kStartBalls - 1);
  EXPECT_EQ(game->hud().phase, Phase::Playing);  // the level goes on
  EXPECT_TRUE(progress.pass("test", game->checkpoint().room, game->checkpoint().balls));
  const GameDef def = nextGame(*game, progress, {"test", "more"});
  EXPECT_EQ(def.level, "test");
  EXPECT_EQ(def.firstRoom, 2u);
  EXPECT_EQ(def.balls, rules::kStartBalls - 1);
  const auto again = newGame(source, def);
  EXPECT_EQ(again->hud().balls, rules::kStartBalls - 1);
  EXPECT_FLOAT_EQ(again->hud().distance, 200.0f);
  EXPECT_EQ(again->hud().room, 2);
  EXPECT_EQ(again->hud().rooms, 4);
}

TEST(Progress, ALevelsEndIsACheckpointAndTheNextLevelFollows) {
  const content::MemorySource source = fourRooms();
  GameDef def;
  def.level = "test";
  def.firstRoom = 3;
  def.balls = 60;
  def.streak = 12;
  const auto game = newGame(source, def);
  EXPECT_EQ(game->hud().ballsPerThrow, 2);
  const auto events = play(*game, rules::kRoomTicks);
  EXPECT_EQ(events.at(EventType::Checkpoint), 1);
  EXPECT_EQ(events.at(EventType::LevelDone), 1);
  EXPECT_EQ(game->hud().phase, Phase::Checkpoint);
  EXPECT_EQ(game->hud().phaseTicks, 0u);
  EXPECT_EQ(game->checkpoint().room, 4u);
  EXPECT_TRUE(game->isOver());
  Progress progress;
  progress.pass("test", 4, game->checkpoint().balls);
  const GameDef next = nextGame(*game, progress, {"test", "more"});
  EXPECT_EQ(next.level, "more");
  EXPECT_EQ(next.firstRoom, 0u);
  EXPECT_EQ(next.balls, 60);
  EXPECT_EQ(next.streak, 12);
  EXPECT_FLOAT_EQ(newGame(source, next)->hud().distance, 400.0f);
  EXPECT_EQ(nextGame(*game, progress, {"more", "test"}).level, "test");  // the last repeats
  play(*game, 100);
  EXPECT_EQ(game->camera().velocity, Vec3(0.0f, 0.0f, 0.0f));
  EXPECT_FLOAT_EQ(game->roomDistance(), 32.0f);
  game->tick(throwAt(0.0f, 0.0f));
  EXPECT_EQ(game->hud().balls, 60);
}

TEST(Progress, ARoomCountsAsReachedThreeTicksAfterItsDoor) {
  const content::MemorySource source = fourRooms();
  const auto game = newTestGame(source);
  play(*game, 10);
  game->tick(throwAt(0.0f, 0.3f));
  play(*game, rules::kRoomTicks - 11 + 2);
  EXPECT_EQ(game->hud().room, 1);
  EXPECT_EQ(game->reached().room, 0u);
  EXPECT_EQ(game->reached().balls, rules::kStartBalls);
  play(*game, 1);
  EXPECT_EQ(game->reached().room, 1u);
  EXPECT_EQ(game->reached().balls, rules::kStartBalls - 1);
  EXPECT_EQ(game->reached().streak, 0);
}

TEST(Progress, InZenNoRoomIsRemembered) {
  GameDef def;
  def.level = "test";
  def.mode = Mode::Zen;
  const content::MemorySource source = fourRooms();
  const auto game = newGame(source, def);
  EXPECT_FALSE(game->hud().countsBalls);
  play(*game, rules::kRoomTicks + 20);
  EXPECT_EQ(game->reached().room, 0u);
}

TEST(Progress, TheTitleWaitsForATouchThatThrowsNothing) {
  GameDef def;
  def.level = "test";
  def.title = true;
  const content::MemorySource source = fourRooms();
  const auto game = newGame(source, def);
  auto events = play(*game, 100);
  EXPECT_EQ(game->hud().phase, Phase::Title);
  EXPECT_EQ(game->hud().phaseTicks, 100u);
  EXPECT_EQ(game->roomDistance(), 0.0f);
  EXPECT_EQ(game->camera().velocity.norm(), 0.0f);
  game->tick(throwAt(0.0f, 0.0f));
  EXPECT_EQ(game->events().size(), 1u);
  EXPECT_EQ(game->events().front().type, EventType::Begin);
  EXPECT_EQ(game->hud().phase, Phase::Playing);
  EXPECT_EQ(game->hud().balls, rules::kStartBalls);
  ByteWriter out;
  game->save(out);
  const auto other = newGame(source, def);
  ByteReader in(out.bytes());
  ASSERT_TRUE(other->restore(in));
  EXPECT_EQ(other->stateHash(), game->stateHash());
  EXPECT_EQ(other->hud().phase, Phase::Playing);
  play(*game, 60);
  EXPECT_FLOAT_EQ(game->roomDistance(), 1.0f);
}

TEST(Progress, ACrashWithTheLastBallsEndsTheGameAtOnce) {
  GameDef def;
  def.level = "test";
  def.balls = 8;
  const content::MemorySource source =
      oneRoom("<obstacle pos=\"0 1 -10\" type=\"framedwindow\" param0=\"width=3\" param1=\"height=2\"/>");
  const auto game = newGame(source, def);
  const auto events = play(*game, 130);
  EXPECT_EQ(events.at(EventType::Crash), 1);
  EXPECT_EQ(events.at(EventType::GameOver), 1);
  EXPECT_EQ(game->hud().phase, Phase::GameOver);
  EXPECT_EQ(game->hud().balls, 0);
  EXPECT_EQ(nextGame(*game, {}, {}).balls, 8);  // as it began
}

}  // namespace
}  // namespace brittle::sim
