// Going back and forth in a simulation whose every state depends on all that was put in.
#include "tools/sandbox/timeline.h"

#include <gtest/gtest.h>

namespace brittle::sandbox {
namespace {

struct Mixer {
  using Input = std::uint32_t;
  std::uint64_t state = 1;
  std::uint32_t factor = 3;            // a setting, part of the state
  std::vector<unsigned char> ballast;  // makes its snapshots large

  void tick(const Input& input) { state = (state + input) * 6364136223846793005u + factor; }
  void save(ByteWriter& out) const {
    out.write(state);
    out.write(factor);
    out.writeBytes(ballast.data(), ballast.size());
  }
  bool restore(ByteReader& in) {
    state = in.read<std::uint64_t>();
    factor = in.read<std::uint32_t>();
    in.readBytes(ballast.data(), ballast.size());
    return in.ok();
  }
};

struct Course {
  explicit Course(std::size_t ballast = 0) : mixer{.ballast = std::vector<unsigned char>(ballast)} {}

  Mixer mixer;
  Timeline<Mixer> timeline{mixer};
  std::vector<std::uint64_t> states{mixer.state};

  void step(std::uint32_t input = 0) {
    timeline.step(input);
    states.resize(timeline.tick());
    states.push_back(mixer.state);
  }
  void expectAllStates() {
    for (const std::uint32_t tick : {100u, 3u, 4u, 99u, 0u, 64u, 63u, 65u, 100u, 8u, 7u}) {
      timeline.seek(tick);
      EXPECT_EQ(timeline.tick(), tick);
      EXPECT_EQ(mixer.state, states[tick]) << tick;
    }
  }
};

TEST(Timeline, ReachesEveryTickAgain) {
  Course course;
  for (std::uint32_t i = 0; i < 100; ++i) course.step(i % 7);
  course.expectAllStates();
}

TEST(Timeline, RepeatsWhatWasPutInWhenItGoesOnFromThePast) {
  Course course;
  for (std::uint32_t i = 0; i < 20; ++i) course.step(i);
  course.timeline.seek(5);
  for (int i = 0; i < 15; ++i) course.timeline.step();
  EXPECT_EQ(course.mixer.state, course.states[20]);
}

TEST(Timeline, ForgetsTheFutureWhenSomethingElseIsPutIn) {
  Course course;
  for (std::uint32_t i = 0; i < 20; ++i) course.step(i);
  course.timeline.seek(5);
  course.step(77);
  EXPECT_EQ(course.timeline.end(), 6u);
  for (int i = 0; i < 94; ++i) course.step();
  course.expectAllStates();
}

TEST(Timeline, KeepsAChangedSettingWhereItWasChanged) {
  Course course;
  for (int i = 0; i < 20; ++i) course.step(1);
  course.timeline.seek(11);  // between two states that are kept anyway
  course.mixer.factor = 5;
  course.timeline.changed();
  EXPECT_EQ(course.timeline.end(), 20u);  // what is put in stays known
  for (int i = 11; i < 100; ++i) course.step();
  course.expectAllStates();
  course.timeline.seek(3);
  EXPECT_EQ(course.mixer.factor, 3u);
  while (course.timeline.tick() < 12) course.timeline.step();  // across the change without seeking
  EXPECT_EQ(course.mixer.factor, 5u);
  EXPECT_EQ(course.mixer.state, course.states[12]);
}

TEST(Timeline, KeepsFewerStatesWhereTheyAreLarge) {
  Course course(std::size_t{8} << 20);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    course.timeline.step(i);
    if (course.states.size() <= 100) course.states.push_back(course.mixer.state);
    ASSERT_LE(course.timeline.bytes(), (std::size_t{256} << 20) + course.mixer.ballast.size() + 64);
  }
  course.expectAllStates();
}

TEST(Timeline, PlaysWhatIsKnownInAdvance) {
  Mixer ahead;
  for (const std::uint32_t input : {4u, 0u, 9u}) ahead.tick(input);
  Mixer mixer;
  Timeline<Mixer> timeline(mixer, {4, 0, 9});
  timeline.seek(3);
  EXPECT_EQ(mixer.state, ahead.state);
}

}  // namespace
}  // namespace brittle::sandbox
