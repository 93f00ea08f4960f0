// build/tools/sounds DIR: every sound of the bank as a WAV file, to listen to and to look at (sox FILE -n spectrogram
// -o FILE.png).
#include <cstdio>
#include <string>

#include "engine/audio/bank.h"
#include "engine/audio/wav.h"

namespace brittle {
namespace {

Status write(const audio::Clip& clip, const std::string& path) {
  Result<audio::WavWriter> file = audio::WavWriter::open(path);
  if (!file) return file.error();
  std::vector<float> stereo;
  for (std::size_t i = 0; i < clip.size(); ++i) stereo.insert(stereo.end(), 2, *clip.at(i));
  file->write(stereo);
  return file->close();
}

int run(const std::string& folder) {
  const audio::Bank bank;
  for (int i = 0; i < static_cast<int>(audio::Sound::Count); ++i) {
    const auto sound = static_cast<audio::Sound>(i);
    for (std::uint32_t variation = 0; variation < bank.variations(sound); ++variation) {
      const Status written =
          write(bank.clip(sound, variation), folder + "/" + nameOf(sound) + "_" + std::to_string(variation) + ".wav");
      if (written) continue;
      std::fprintf(stderr, "sounds: %s\n", written.error().message.c_str());
      return 2;
    }
  }
  std::printf("%s: %zu kB of sounds\n", folder.c_str(), bank.bytes() / 1024);
  return 0;
}

}  // namespace
}  // namespace brittle

int main(int argc, char** argv) {
  if (argc == 2) return brittle::run(argv[1]);
  std::fprintf(stderr, "usage: sounds DIR\n");
  return 2;
}
