// A device that swallows what it gets, at its pace: the callback runs as with a real one.
#include "platform/sdl/audio_output.h"

#include <SDL.h>

#include <cstdlib>

#include <gtest/gtest.h>

namespace brittle::platform {
namespace {

/// Sets SDL_AUDIODRIVER while it lives.
class Driver {
 public:
  explicit Driver(const char* name) {
    if (const char* old = std::getenv("SDL_AUDIODRIVER")) saved_ = old;
    setenv("SDL_AUDIODRIVER", name, 1);
  }
  ~Driver() {
    if (saved_.empty())
      unsetenv("SDL_AUDIODRIVER");
    else
      setenv("SDL_AUDIODRIVER", saved_.c_str(), 1);
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

 private:
  std::string saved_;
};

TEST(AudioOutput, TheDeviceTakesTheMix) {
  const Driver driver("dummy");
  const audio::Bank bank;
  audio::Mixer mixer(bank);
  const auto output = openAudio(mixer);
  ASSERT_TRUE(output) << output.error().message;
  // Only a callback empties the queue: three times its capacity goes through it.
  int sent = 0;
  for (int wait = 0; sent < 3000 && wait < 10000; ++wait) {
    const std::uint32_t refused = mixer.refused();
    mixer.setRate(1.0f);
    if (mixer.refused() == refused)
      ++sent;
    else
      SDL_Delay(1);
  }
  EXPECT_EQ(sent, 3000);
}

TEST(AudioOutput, SaysWhenThereIsNoDevice) {
  const Driver driver("nosuchdriver");
  const audio::Bank bank;
  audio::Mixer mixer(bank);
  const auto output = openAudio(mixer);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().message.find("no sound: "), 0u) << output.error().message;
}

}  // namespace
}  // namespace brittle::platform
