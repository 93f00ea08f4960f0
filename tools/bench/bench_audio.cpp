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
void count(benchmark::State& state, const Made& made) {
  state.counters["kB"] = static_cast<double>(made.bytes()) / 1024.0;
}

void makeBank(benchmark::State& state) {
  for (auto iteration : state) count(state, audio::Bank());
}
BENCHMARK(makeBank)->Name("audio/make_bank")->Unit(benchmark::kMillisecond);

/// What a tick with a note never played before waits for.
void makeTone(benchmark::State& state, audio::Instrument instrument) {
  for (auto iteration : state) {
    audio::Instruments made;
    benchmark::DoNotOptimize(made.tone(instrument, 60.0f));
    count(state, made);
  }
}
BENCHMARK_CAPTURE(makeTone, pad, audio::Instrument::Pad)->Name("audio/make_tone/pad")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(makeTone, bass, audio::Instrument::Bass)->Name("audio/make_tone/bass")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(makeTone, mallet, audio::Instrument::Mallet)
    ->Name("audio/make_tone/mallet")
    ->Unit(benchmark::kMillisecond);

}  // namespace
