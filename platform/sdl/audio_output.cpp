#include "platform/sdl/audio_output.h"

#include <SDL.h>

#include <span>
#include <string>

namespace brittle::platform {

namespace {

constexpr Uint16 kFrames = 512;  // per callback: 11 ms; fewer crackle on slow machines

void fill(void* mixer, Uint8* bytes, int size) {
  static_cast<audio::Mixer*>(mixer)->render(
      {reinterpret_cast<float*>(bytes), static_cast<std::size_t>(size) / sizeof(float)});
}

class Device : public AudioOutput {
 public:
  Device() = default;
  ~Device() override {
    if (device_ != 0) SDL_CloseAudioDevice(device_);
    if (isOn_) SDL_QuitSubSystem(SDL_INIT_AUDIO);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  Status open(audio::Mixer& mixer) {
    isOn_ = SDL_InitSubSystem(SDL_INIT_AUDIO) == 0;
    if (!isOn_) return Error{std::string("no sound: ") + SDL_GetError()};
    SDL_AudioSpec wanted{};
    wanted.freq = audio::kSampleRate;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 2;
    wanted.samples = kFrames;
    wanted.callback = fill;
    wanted.userdata = &mixer;
    device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);  // SDL converts to what the device has
    if (device_ == 0) return Error{std::string("no sound: ") + SDL_GetError()};
    SDL_PauseAudioDevice(device_, 0);
    return Done{};
  }

 private:
  SDL_AudioDeviceID device_ = 0;
  bool isOn_ = false;
};

}  // namespace

Result<std::unique_ptr<AudioOutput>> openAudio(audio::Mixer& mixer) {
  std::unique_ptr<Device> device(new Device);
  const Status opened = device->open(mixer);
  if (!opened) return opened.error();
  return std::unique_ptr<AudioOutput>(std::move(device));
}

}  // namespace brittle::platform
