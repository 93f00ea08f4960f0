#include "script_helpers.h"

#include <gmock/gmock.h>

namespace brittle::script {
namespace {

struct World {
  std::vector<std::string> seen;
};

Library makeLibrary() {
  Library library;
  library.add("mgBox", [](Call& call) {
    const double x = call.number(1);
    const double y = call.number(2, 5.0);
    if (call.failed()) return;
    call.user<World>().seen.push_back(call.where());
    call.result(x + y);
    call.result(std::string(1000, 'x'));
  });
  library.add("mgName", [](Call& call) { call.result(call.string(1)); });
  library.add("mgTruth", [](Call& call) { call.result(call.boolean(1, true)); });
  library.add("mgWhole", [](Call& call) { call.result(call.integer(1)); });
  library.add("mgBusy", [](Call& call) { call.charge(1'000'000'000); });
  return library;
}

class Calls : public testing::Test {
 protected:
  std::string errorOfLoad(const std::string& source) {
    const Status status = sandbox_.load(source, "room.lua");
    return status ? "no error" : status.error().message;
  }
  Value load(const std::string& source) {
    const Status status = sandbox_.load(source, "room.lua");
    EXPECT_TRUE(status) << status.error().message;
    return sandbox_.get("result");
  }
  World world_;
  Library library_ = makeLibrary();
  Sandbox sandbox_{library_, 1, Limits{}, &world_};
};

TEST_F(Calls, HandArgumentsInAndResultsOut) {
  EXPECT_EQ(load("\nlocal a, b = mgBox(1, 2) result = a + #b"), Value(1003.0));
  EXPECT_EQ(load("result = mgBox('3') + 0"), Value(8.0));
  EXPECT_THAT(world_.seen, testing::ElementsAre("room.lua:2", "room.lua:1"));
}

TEST_F(Calls, AWrongArgumentIsNamed) {
  EXPECT_EQ(errorOfLoad("\nmgBox({})"), "room.lua:2: mgBox: argument 1: expected a number, got table");
  EXPECT_EQ(errorOfLoad("mgBox(1, 'wide')"), "room.lua:1: mgBox: argument 2: expected a number, got \"wide\"");
  EXPECT_EQ(errorOfLoad("mgBox()"), "room.lua:1: mgBox: argument 1: expected a number, got nothing");
  EXPECT_EQ(errorOfLoad("mgBox(nil)"), "room.lua:1: mgBox: argument 1: expected a number, got nil");
  EXPECT_EQ(errorOfLoad("mgBox(1/0)"), "room.lua:1: mgBox: argument 1: expected a finite number up to 1e15, got inf");
  EXPECT_EQ(errorOfLoad("mgWhole(1e12)"),
            "room.lua:1: mgWhole: argument 1: expected a whole number up to 2147483647, got 1000000000000");
  EXPECT_EQ(errorOfLoad("mgTruth('yes')"), "room.lua:1: mgTruth: argument 1: expected true or false, got \"yes\"");
  EXPECT_EQ(
      errorOfLoad("mgName(string.rep('x', 1001))"),
      "room.lua:1: mgName: argument 1: expected a string of at most 1000 bytes, got \"" + std::string(60, 'x') + "\"");
  EXPECT_EQ(errorOfLoad("mgName(string.rep('x', 1000))"), "no error");
  EXPECT_TRUE(world_.seen.empty());
}

TEST_F(Calls, KindsAreReadAsTheCommunityWritesThem) {
  EXPECT_EQ(load("result = mgName(12)"), Value("12"));
  EXPECT_EQ(load("result = mgTruth(0)"), Value(false));
  EXPECT_EQ(load("result = mgTruth()"), Value(true));
  EXPECT_EQ(load("result = mgWhole(-2.7)"), Value(-2.0));
}

TEST_F(Calls, ASourceWithoutANameIsNotToBlame) {
  ASSERT_TRUE(sandbox_.load("local name = mgName function mgName(t)\n\nname(t.text) end", ""));
  EXPECT_EQ(errorOfLoad("\nmgName{text = nil}"), "room.lua:2: mgName: argument 1: expected a string, got nil");
  EXPECT_EQ(errorOfLoad("\nmgName{text = 'a'}"), "no error");
}

TEST_F(Calls, ANativeMayUseUpTheBudget) {
  EXPECT_THAT(errorOfLoad("mgBusy()"), testing::HasSubstr("room.lua:1: the budget"));
}

TEST_F(Calls, AnErrorWithinSortOrGsubStillNamesTheLine) {
  EXPECT_EQ(errorOfLoad("\nstring.gsub('a', '.', mgWhole)"),
            "room.lua:2: mgWhole: argument 1: expected a number, got \"a\"");
}

}  // namespace
}  // namespace brittle::script
