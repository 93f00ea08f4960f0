#include "tools/accuracy/study.h"

#include <algorithm>

namespace brittle::accuracy {
namespace {

double sumOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

double meanOf(const std::vector<double>& values) {
  return values.empty() ? 0.0 : sumOf(values) / static_cast<double>(values.size());
}

/// What one setting showed and took in all rounds.
struct Taken {
  std::vector<std::vector<Observation>> seen;  // by scene, of each variant
  std::vector<double> perSecond;               // of each round, mean of the scenes [ms/s]
  std::vector<std::vector<double>> scenes;     // by scene, of each round [ms/s]
  std::vector<double> ticks;                   // all [ms]
  std::vector<double> roomTicks;               // all [ms]
  double roomBreaks = 0.0;
};

/// The variants of a scene that are played in one of the rounds.
std::vector<int> variantsOf(int all, int round, int rounds) {
  if (all > 0 && all < rounds) return {round % all};
  std::vector<int> variants;
  for (int i = all * round / rounds; i < all * (round + 1) / rounds; ++i) variants.push_back(i);
  return variants;
}

void playRound(const Setting& setting, const Effort& effort, int round, Taken& taken, const Advance& advance) {
  const auto scenes = allScenes();
  taken.seen.resize(scenes.size());
  taken.scenes.resize(scenes.size());
  std::vector<double> rates;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    double spent = 0.0, seconds = 0.0;
    for (const int variant : variantsOf(effort.variants(scenes[s]), round, effort.rounds())) {
      Observation seen = observe(scenes[s], setting.accuracy, variant);
      spent += sumOf(seen.tickMs);
      seconds += static_cast<double>(kTick) * static_cast<double>(seen.tickMs.size());
      taken.ticks.insert(taken.ticks.end(), seen.tickMs.begin(), seen.tickMs.end());
      if (taken.seen[s].size() == static_cast<std::size_t>(variant)) taken.seen[s].push_back(std::move(seen));
    }
    advance();
    if (seconds == 0.0) continue;
    rates.push_back(spent / seconds);
    taken.scenes[s].push_back(rates.back());
  }
  taken.perSecond.push_back(meanOf(rates));
}

Status playRoom(const Setting& setting, const Room& room, Taken& taken) {
  const Result<RoomPlay> play = room.play(setting.accuracy);
  if (!play) return play.error();
  taken.roomTicks.insert(taken.roomTicks.end(), play->tickMs.begin(), play->tickMs.end());
  taken.roomBreaks = play->breaks;
  return Done{};
}

Cost costOf(const Taken& taken) {
  Cost cost;
  cost.rounds = taken.perSecond;
  cost.perSecond = meanOf(taken.perSecond);
  cost.low = quantileOf(taken.perSecond, 0.0);
  cost.high = quantileOf(taken.perSecond, 1.0);
  cost.medianTick = quantileOf(taken.ticks, 0.5);
  cost.p99Tick = quantileOf(taken.ticks, 0.99);
  cost.roomMedian = quantileOf(taken.roomTicks, 0.5);
  cost.roomP99 = quantileOf(taken.roomTicks, 0.99);
  cost.roomBreaks = taken.roomBreaks;
  for (const std::vector<double>& scene : taken.scenes) cost.scenes.push_back(meanOf(scene));
  return cost;
}

/// Indices of the first setting of each kind: the default is among the values of every knob.
std::vector<std::size_t> differentOf(const std::vector<Setting>& settings) {
  std::vector<std::size_t> different;
  for (std::size_t i = 0; i < settings.size(); ++i)
    if (std::none_of(different.begin(), different.end(),
                     [&](std::size_t k) { return isSame(settings[k].accuracy, settings[i].accuracy); }))
      different.push_back(i);
  return different;
}

bool isAlwaysCheaper(const Cost& a, const Cost& b) {
  return std::equal(a.rounds.begin(), a.rounds.end(), b.rounds.begin(), [](double x, double y) { return x < y; });
}

}  // namespace

int Effort::variants(const Scene& scene) const {
  if (scene.name == "panes") return quick ? 4 : 8;
  if (scene.name == "grazes") return quick ? 16 : scene.variants;
  if (scene.name == "flood") return quick ? 0 : 4;
  return quick ? 1 : scene.variants;
}

Reference playAll(const physics::Accuracy& accuracy, const Effort& effort, const Advance& advance) {
  Reference all;
  for (const Scene& scene : allScenes()) {
    std::vector<Observation>& seen = all.emplace_back();
    for (int variant = 0; variant < effort.variants(scene); ++variant)
      seen.push_back(observe(scene, accuracy, variant));
    advance();
  }
  return all;
}

int stepsOf(const std::vector<Setting>& settings, const Effort& effort) {
  return static_cast<int>(differentOf(settings).size() * allScenes().size()) * effort.rounds();
}

Result<std::vector<Scored>> study(const std::vector<Setting>& settings, const Reference& reference, const Room& room,
                                  const Effort& effort, const Advance& advance) {
  const std::vector<std::size_t> different = differentOf(settings);
  std::vector<Taken> taken(different.size());
  for (int round = 0; round < effort.rounds(); ++round)
    for (std::size_t i = 0; i < different.size(); ++i) {
      const Setting& setting = settings[different[i]];
      playRound(setting, effort, round, taken[i], advance);
      if (const Status played = round == 0 ? playRoom(setting, room, taken[i]) : Done{}; !played) return played.error();
    }
  std::vector<Scored> measured(different.size());
  for (std::size_t i = 0; i < different.size(); ++i) {
    measured[i].errors = errorsOf(taken[i].seen, reference);
    measured[i].score = {scoreOf(measured[i].errors), scoreOf(measured[i].errors, &Deviation::low),
                         scoreOf(measured[i].errors, &Deviation::high)};
    measured[i].cost = costOf(taken[i]);
  }
  markFront(measured);
  std::vector<Scored> scored;
  for (const Setting& setting : settings) {
    const auto same = std::find_if(different.begin(), different.end(),
                                   [&](std::size_t i) { return isSame(settings[i].accuracy, setting.accuracy); });
    scored.push_back(measured[static_cast<std::size_t>(same - different.begin())]);
    scored.back().setting = setting;
  }
  return scored;
}

void markFront(std::vector<Scored>& scored) {
  const auto isAny = [&](auto&& test) { return std::any_of(scored.begin(), scored.end(), test); };
  for (Scored& one : scored) {
    one.isFront = !isAny([&](const Scored& other) {
      return other.score.value < one.score.value && other.cost.perSecond < one.cost.perSecond;
    });
    one.isBeaten = isAny(
        [&](const Scored& other) { return other.score.high < one.score.low && isAlwaysCheaper(other.cost, one.cost); });
  }
}

double quantileOf(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(part * last + 0.5)];
}

}  // namespace brittle::accuracy
