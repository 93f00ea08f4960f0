#include "tools/accuracy/study.h"

#include <algorithm>

namespace brittle::accuracy {
namespace {

double sumOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

/// What one setting took in all repeats.
struct Taken {
  std::vector<double> perSecond;            // of each repeat [ms/s]
  std::vector<std::vector<double>> scenes;  // by scene, of each repeat
  std::vector<double> ticks;                // all [ms]
  std::vector<double> roomTicks;            // all [ms]
  double roomBreaks = 0.0;
};

void timeOnce(const Setting& setting, const Effort& effort, Taken& taken) {
  const auto scenes = allScenes();
  taken.scenes.resize(scenes.size());
  double rates = 0.0;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    double spent = 0.0, seconds = 0.0;
    for (int variant = 0; variant < effort.timed(scenes[s]); ++variant) {
      const Observation seen = timeOf(scenes[s], setting.accuracy, variant);
      spent += sumOf(seen.tickMs);
      seconds += static_cast<double>(kTick) * static_cast<double>(seen.tickMs.size());
      taken.ticks.insert(taken.ticks.end(), seen.tickMs.begin(), seen.tickMs.end());
    }
    if (seconds == 0.0) continue;
    taken.scenes[s].push_back(spent / seconds);
    rates += spent / seconds;
  }
  taken.perSecond.push_back(rates / static_cast<double>(scenes.size()));
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
  cost.perSecond = quantileOf(taken.perSecond, 0.5);
  cost.low = quantileOf(taken.perSecond, 0.0);
  cost.high = quantileOf(taken.perSecond, 1.0);
  cost.medianTick = quantileOf(taken.ticks, 0.5);
  cost.p99Tick = quantileOf(taken.ticks, 0.99);
  cost.roomMedian = quantileOf(taken.roomTicks, 0.5);
  cost.roomP99 = quantileOf(taken.roomTicks, 0.99);
  cost.roomBreaks = taken.roomBreaks;
  for (const std::vector<double>& scene : taken.scenes) cost.scenes.push_back(quantileOf(scene, 0.5));
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

}  // namespace

int Effort::observed(const Scene& scene) const {
  if (scene.name == "panes") return quick ? 4 : 8;
  if (scene.name == "grazes") return quick ? 16 : scene.variants;
  if (scene.name == "flood") return quick ? 0 : 2;
  return quick ? 1 : scene.variants;
}

int Effort::timed(const Scene& scene) const {
  if (scene.name == "grazes") return quick ? 4 : 16;
  if (scene.name == "flood") return quick ? 0 : 1;
  return quick ? 1 : 2;
}

Reference playAll(const physics::Accuracy& accuracy, const Effort& effort, const Advance& advance) {
  Reference all;
  for (const Scene& scene : allScenes()) {
    std::vector<Observation>& seen = all.emplace_back();
    for (int variant = 0; variant < effort.observed(scene); ++variant)
      seen.push_back(observe(scene, accuracy, variant));
    advance();
  }
  return all;
}

int stepsOf(const std::vector<Setting>& settings, const Effort& effort) {
  return static_cast<int>(differentOf(settings).size()) * (static_cast<int>(allScenes().size()) + effort.repeats());
}

Result<std::vector<Scored>> study(const std::vector<Setting>& settings, const Reference& reference, const Room& room,
                                  const Effort& effort, const Advance& advance) {
  const std::vector<std::size_t> different = differentOf(settings);
  std::vector<Scored> measured(different.size());
  for (std::size_t i = 0; i < different.size(); ++i) {
    measured[i].errors = errorsOf(playAll(settings[different[i]].accuracy, effort, advance), reference);
    measured[i].score = scoreOf(measured[i].errors);
  }
  std::vector<Taken> taken(different.size());
  for (int repeat = 0; repeat < effort.repeats(); ++repeat)
    for (std::size_t i = 0; i < different.size(); ++i) {
      const Setting& setting = settings[different[i]];
      timeOnce(setting, effort, taken[i]);
      if (const Status played = repeat == 0 ? playRoom(setting, room, taken[i]) : Done{}; !played)
        return played.error();
      advance();
    }
  for (std::size_t i = 0; i < different.size(); ++i) measured[i].cost = costOf(taken[i]);
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
  for (Scored& one : scored)
    one.isFront = std::none_of(scored.begin(), scored.end(), [&](const Scored& other) {
      return other.score < one.score && other.cost.perSecond < one.cost.perSecond;
    });
}

double quantileOf(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(part * last + 0.5)];
}

}  // namespace brittle::accuracy
