// What sound costs: `bench --benchmark_filter=audio`. A second of mix per iteration: items per second are seconds of
// sound per second.
#include <benchmark/benchmark.h>

#include <vector>

#include "engine/audio/instruments.h"
#include "engine/audio/mixer.h"

namespace {

using namespace brittle;

void mix(benchmark::State& state, std::uint32_t voices, const audio::Acoustics& acoustics) {
  static const audio::Bank bank;
  std::vector<float> second(2 * audio::kSampleRate);
  for (auto iteration : state) {
    audio::Mixer mixer(bank);
    mixer.setAcoustics(acoustics);
    for (std::uint32_t i = 0; i < voices; ++i) {
      audio::VoiceDef voice;
      voice.clip = &bank.clip(audio::Sound::Note, i);  // the longest sound, at a pitch of its own
      voice.pitch = 0.7f + 0.005f * static_cast<float>(i);
      voice.cutoff = 8000.0f;
      mixer.play(voice);
    }
    mixer.render(second);
    benchmark::DoNotOptimize(second.data());
  }
  state.SetItemsProcessed(state.iterations());
}

audio::Acoustics hall() {
  audio::Acoustics acoustics;
  acoustics.reverb = {0.5f, 1.0f, 0.2f};
  acoustics.echo = {0.4f, 0.3f, 0.4f, 0.2f};
  return acoustics;
}

BENCHMARK_CAPTURE(mix, silence, 0u, audio::Acoustics{})->Name("audio/silence")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mix, voices, 64u, audio::Acoustics{})->Name("audio/64_voices")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mix, hall, 64u, hall())->Name("audio/64_voices_in_a_hall")->Unit(benchmark::kMillisecond);

template <class Made>
void load(benchmark::State& state) {
  for (auto iteration : state) {
    const Made made;
    state.counters["kB"] = static_cast<double>(made.bytes()) / 1024.0;
  }
}
BENCHMARK(load<audio::Bank>)->Name("audio/make_bank")->Unit(benchmark::kMillisecond);
BENCHMARK(load<audio::Instruments>)->Name("audio/make_instruments")->Unit(benchmark::kMillisecond);

}  // namespace
