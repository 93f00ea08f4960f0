// effects_cost [--json|--markdown] [--used] [EFFECT...]: what each effect costs where it is used and where it is not.
#include <cstdio>
#include <string>
#include <thread>

#include "tools/brittle/arguments.h"
#include "tools/brittle/progress.h"
#include "tools/effects_cost/measure.h"

namespace {

using namespace brittle;
using namespace brittle::effects_cost;

std::string textOf(const std::optional<double>& number, const char* format, const char* none) {
  if (!number) return none;
  char text[32];
  std::snprintf(text, sizeof text, format, *number == 0.0 ? 0.0 : *number);
  return text;
}

std::string kilobytesOf(const Cost& cost) {
  std::optional<double> kilobytes = cost.codeBytes;
  if (kilobytes) *kilobytes /= 1024.0;
  return textOf(kilobytes, "%.1f kB", "-");
}

void printJson(const std::vector<Cost>& costs) {
  std::printf("[");
  for (const Cost& cost : costs)
    std::printf(
        "%s\n  {\"effect\": \"%s\", \"unused_overhead_percent\": %s, \"bytes_per_body\": %s, \"code_bytes\": %s, "
        "\"used_ms\": %.4f}",
        &cost == costs.data() ? "" : ",", effects::nameOf(cost.effect),
        textOf(cost.unusedOverhead, "%.4f", "null").c_str(), textOf(cost.bytesPerBody, "%.1f", "null").c_str(),
        textOf(cost.codeBytes, "%.0f", "null").c_str(), cost.usedMilliseconds);
  std::printf("\n]\n");
}

void printTable(const std::vector<Cost>& costs) {
  std::printf("%-16s %20s %14s %12s %16s\n", "effect", "unused: instructions", "bytes a body", "program",
              "used: ms a tick");
  for (const Cost& cost : costs)
    std::printf("%-16s %20s %14s %12s %16.3f\n", effects::nameOf(cost.effect),
                textOf(cost.unusedOverhead, "%+.3f %%", "-").c_str(), textOf(cost.bytesPerBody, "%.0f", "-").c_str(),
                kilobytesOf(cost).c_str(), cost.usedMilliseconds);
}

/// Three effects to a line, so that README stays short.
void printMarkdown(const std::vector<Cost>& costs) {
  constexpr std::size_t kAside = 3;
  const std::size_t lines = (costs.size() + kAside - 1) / kAside;
  for (const char* cells : {" effect | unused | program | ms |", " --- | ---: | ---: | ---: |"}) {
    std::printf("|");
    for (std::size_t i = 0; i < kAside; ++i) std::printf("%s", cells);
    std::printf("\n");
  }
  for (std::size_t line = 0; line < lines; ++line) {
    std::printf("|");
    for (std::size_t i = line; i < kAside * lines; i += lines) {
      if (i >= costs.size()) {
        std::printf(" | | | |");
        continue;
      }
      std::printf(" %s | %s | %s | %.2f |", effects::nameOf(costs[i].effect),
                  textOf(costs[i].unusedOverhead, "%+.2f %%", "-").c_str(), kilobytesOf(costs[i]).c_str(),
                  costs[i].usedMilliseconds);
    }
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "What each effect costs: in a room that does not use it, against a build without its module; and in one "
      "that does, drawn at 320x180 by the processor.",
      "effects_cost");
  std::vector<std::string> names;
  bool json = false, markdown = false, used = false;
  Effort effort;
  effort.jobs = std::to_string(std::max(1u, std::thread::hardware_concurrency()));
  app.add_option("EFFECT", names, "names of effects (default: all that have a module)");
  app.add_flag("--json", json, "a list of objects");
  app.add_flag("--markdown", markdown, "a table for README, three effects to a line")->excludes("--json");
  app.add_flag("--used", used, "only what it costs where it is used: builds nothing");
  app.add_option("--rounds", effort.rounds, "of timing")->capture_default_str()->check(CLI::Range(1, 100));
  app.footer(
      "Builds a program without each effect in turn (build/without): some minutes for the first, less than one for the "
      "others.\n\n"
      "Examples:\n  effects_cost\n  effects_cost --json joints reverb\n  effects_cost --used mirror");
  if (const auto ended = program::readArguments(app, argc, argv)) return *ended;
  effort.compares = !used;
  std::vector<effects::Effect> wanted;
  for (const std::string& name : names) {
    const auto effect = effects::effectNamed(name);
    if (!effect || !hasModule(*effect))
      return program::refuse(app.get_name(),
                             {name + ": expected an effect with a module (brittle play --help lists them)"});
    wanted.push_back(*effect);
  }
  for (std::size_t i = 0; names.empty() && i < effects::kEffects; ++i)
    if (hasModule(static_cast<effects::Effect>(i))) wanted.push_back(static_cast<effects::Effect>(i));
  program::Progress progress("measuring", static_cast<std::uint32_t>(stepsOf(wanted, effort)));
  std::uint32_t step = 0;
  const auto costs = measure(wanted, effort, [&](const std::string&) { progress.reached(step++); });
  if (!costs) return program::refuse(app.get_name(), costs.error());
  if (json)
    printJson(*costs);
  else if (markdown)
    printMarkdown(*costs);
  else
    printTable(*costs);
  return 0;
}
