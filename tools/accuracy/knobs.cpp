#include "tools/accuracy/knobs.h"

#include <algorithm>
#include <initializer_list>

#include "tools/accuracy/csv.h"

namespace brittle::accuracy {
namespace {

using physics::Accuracy;
using physics::FractureMode;
using physics::ManifoldKind;

class List {
 public:
  void add(const std::string& knob, const std::string& value, const Accuracy& accuracy) {
    const bool isFirst = settings_.empty() || settings_.back().knob != knob;
    settings_.push_back(
        {knob, value, isFirst ? 0 : settings_.back().order + 1, isSame(accuracy, Accuracy{}), accuracy});
  }
  template <class T>
  void sweep(const std::string& knob, T Accuracy::*field, std::initializer_list<double> values) {
    for (const double value : values) {
      Accuracy accuracy;
      accuracy.*field = static_cast<T>(value);
      add(knob, shortly(value, 6), accuracy);
    }
  }
  std::vector<Setting> take() { return std::move(settings_); }

 private:
  std::vector<Setting> settings_;
};

void addModes(List& list) {
  const auto mode = [&](const std::string& value, FractureMode how, bool isCapped, float blend) {
    Accuracy accuracy;
    accuracy.fractureMode = how;
    accuracy.impulseCap = isCapped;
    accuracy.blend = blend;
    list.add("fracture", value, accuracy);
  };
  mode("after", FractureMode::AfterStep, false, 0.5f);
  mode("after capped", FractureMode::AfterStep, true, 0.5f);
  mode("blended", FractureMode::AfterStepBlended, false, 0.5f);
  mode("restored", FractureMode::AfterStepBlended, false, 1.0f);
  for (const int rounds : {1, 2, 3, 5, 0}) {
    Accuracy accuracy;
    accuracy.fractureRounds = rounds;
    accuracy.fastRounds = 0;
    list.add("fracture", rounds == 0 ? "unbounded" : std::to_string(rounds), accuracy);
  }
  list.add("fracture", "3 to 8", {});
}

void addManifolds(List& list) {
  for (const ManifoldKind kind : {ManifoldKind::Incremental, ManifoldKind::Clipped}) {
    Accuracy accuracy;
    accuracy.manifold.kind = kind;
    list.add("manifold", kind == ManifoldKind::Clipped ? "clipped" : "incremental", accuracy);
  }
  for (const float distance : {0.1f, 0.03f, 0.01f, 0.0f}) {
    Accuracy accuracy;
    accuracy.manifold.recycleDistance = distance;
    list.add("recycle distance", shortly(static_cast<double>(distance), 6), accuracy);
  }
}

void addSwitch(List& list, const std::string& knob, bool Accuracy::*field) {
  for (const bool on : {false, true}) {
    Accuracy accuracy;
    accuracy.*field = on;
    list.add(knob, on ? "on" : "off", accuracy);
  }
}

}  // namespace

bool isSame(const Accuracy& a, const Accuracy& b) {
  struct Writer {
    std::vector<double> numbers;
    void operator()(FractureMode value) { numbers.push_back(static_cast<double>(value)); }
    void operator()(ManifoldKind value) { numbers.push_back(static_cast<double>(value)); }
    void operator()(double value) { numbers.push_back(value); }
  };
  Writer first, second;
  Accuracy copyA = a, copyB = b;
  copyA.serialize(first);
  copyB.serialize(second);
  return first.numbers == second.numbers;
}

std::vector<Setting> knobSettings(bool quick) {
  List list;
  addModes(list);
  if (quick) {
    list.sweep("iterations", &Accuracy::iterations, {2, 10, 32});
    list.sweep("substeps", &Accuracy::substeps, {1, 2, 4});
    return list.take();
  }
  list.sweep("fast rounds", &Accuracy::fastRounds, {0, 4, 8, 16, 64});
  list.sweep("iterations", &Accuracy::iterations, {2, 4, 6, 8, 10, 16, 32, 64, 128, 256});
  list.sweep("substeps", &Accuracy::substeps, {1, 2, 3, 4, 8, 16});
  list.sweep("position iterations", &Accuracy::positionIterations, {0, 1, 3, 8, 16});
  addManifolds(list);
  list.sweep("speculative margin", &Accuracy::speculativeMargin, {0.05, 0.02, 0.01, 0.005, 0.0});
  addSwitch(list, "warm start", &Accuracy::warmStart);
  addSwitch(list, "deactivation", &Accuracy::deactivation);
  addSwitch(list, "stacks", &Accuracy::stacks);
  list.sweep("direct solve mass ratio", &Accuracy::directSolveMassRatio, {0, 1000, 200, 20});
  list.sweep("pattern density", &Accuracy::patternDensity, {0.25, 0.5, 1, 2, 4});
  list.sweep("smallest body", &Accuracy::minVolumeScale, {1000, 100, 10, 1, 0});
  list.sweep("debris kept", &Accuracy::maxDebris, {32, 128, 512, 2048});
  list.sweep("bodies kept", &Accuracy::maxBodies, {64, 256, 2048, 8192});
  return list.take();
}

std::vector<Setting> fractureModes() {
  List list;
  addModes(list);
  return list.take();
}

std::vector<Setting> gridSettings(bool quick) {
  List list;
  if (quick) return list.take();
  for (const int substeps : {1, 2, 4, 8})
    for (const int iterations : {1, 2, 4, 8, 16, 32}) {
      Accuracy accuracy;
      accuracy.substeps = substeps;
      accuracy.iterations = iterations;
      list.add("grid", std::to_string(iterations) + " x " + std::to_string(substeps), accuracy);
    }
  return list.take();
}

std::vector<Setting> presetSettings() {
  List list;
  for (const std::string_view name : physics::presetNames())
    list.add("preset", std::string(name), *physics::preset(name));
  return list.take();
}

physics::Accuracy referenceAccuracy(int fineness) {
  Accuracy accuracy;
  accuracy.fractureRounds = 0;
  accuracy.substeps = 16 / fineness;
  accuracy.iterations = 32;
  accuracy.manifold.recycleDistance = 0.0f;
  accuracy.deactivation = false;
  return accuracy;
}

}  // namespace brittle::accuracy
