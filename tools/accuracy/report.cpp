#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <thread>

#include "engine/core/file.h"
#include "tools/accuracy/csv.h"
#include "tools/accuracy/instructions.h"
#include "tools/accuracy/outcome.h"

namespace brittle::accuracy {
namespace {

/// "Intel(R) Xeon(R) Processor", or what else the machine calls itself.
std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string picture(const std::string& name, const std::string& what) {
  return "![" + what + "](" + name + ".svg)\n\n";
}

/// A Markdown table, row by row.
class Table {
 public:
  explicit Table(const std::vector<std::string>& heads) {
    line(heads);
    text_ += "|";
    for (std::size_t i = 0; i < heads.size(); ++i) text_ += " --- |";
    text_ += "\n";
  }
  void line(const std::vector<std::string>& cells) {
    text_ += "|";
    for (const std::string& cell : cells) text_ += " " + cell + " |";
    text_ += "\n";
  }
  std::string text() const { return text_ + "\n"; }

 private:
  std::string text_;
};

std::string withBounds(const Deviation& error) {
  if (std::isnan(error.value)) return "-";
  const std::string value = shortly(error.value);
  if (error.low == error.value && error.high == error.value) return value;
  return value + " (" + shortly(error.low) + " to " + shortly(error.high) + ")";
}

std::string machine(const Outcome& outcome) {
  return "Measured on: " + processorName() + ", " + std::to_string(std::thread::hardware_concurrency()) +
         " cores; compiler " + __VERSION__ + ", " + BRITTLE_FLAGS + "; " + (outcome.quick ? "quick" : "full") +
         " run, " + shortly(outcome.minutes) + " minutes of processor time, " +
         std::to_string(Effort{outcome.quick}.rounds()) + " interleaved rounds. " +
         (outcome.countsInstructions ? "Instructions are those of World::step in the scene " +
                                           std::string(kCountedScene) + ", counted by callgrind.\n\n"
                                     : "Instructions were not counted (--instructions does).\n\n");
}

/// The worst of the rows that pass a test, of a figure.
template <class Of>
double worstOf(const std::vector<PanesRow>& rows, Of&& of) {
  double worst = 0.0;
  for (const PanesRow& row : rows) worst = std::max<double>(worst, of(row));
  return worst;
}

std::string claim(const Outcome& outcome) {
  const auto& rows = outcome.claim;
  const double error = worstOf(rows, [](const PanesRow& row) { return row.exitSpeedError; });
  const double late = worstOf(rows, [](const PanesRow& row) { return row.late; });
  std::string text =
      "## The default answers within 2 %\n\nA ball of 1 kg through 1 to 16 panes 5 cm apart, at 5 to 200 m/s, in the "
      "worst of " +
      std::to_string(rows.empty() ? 0 : rows[0].phases) +
      " phases of the gap within a tick: its exit speed is at most **" + shortly(error) +
      " %** from v0 - N J/M, and it comes at most " + shortly(late) +
      " ms late. What too few rounds cost is time, not speed.\n\n";
  Table table({"panes", "speed [m/s]", "exit speed off by [%]", "late [ms]", "behind [cm]", "ms per simulated s"});
  for (const PanesRow& row : rows)
    table.line({std::to_string(row.panes), shortly(static_cast<double>(row.speed)), shortly(row.exitSpeedError),
                shortly(row.late), shortly(row.behind), shortly(row.perSecond)});
  return text + table.text();
}

const PanesRow* rowOf(const Outcome& outcome, const std::string& how, int panes, float speed) {
  const auto found = std::find_if(outcome.modes.begin(), outcome.modes.end(), [&](const PanesRow& row) {
    return row.how == how && row.panes == panes && row.speed == speed;
  });
  return found == outcome.modes.end() ? nullptr : &*found;
}

std::string mended(const Outcome& outcome) {
  std::string text =
      "## More rounds only for what is fast\n\nWith three rounds a ball at 100 m/s hangs at every fourth pane until "
      "the "
      "next tick. `fastRounds` lets a tick go on to eight while what strikes goes farther than its own size in it; "
      "whatever is slower keeps to three. Each cell: 3 rounds, 3 but 8 for what is fast, unbounded.\n\n";
  Table table({"panes", "speed [m/s]", "late, worst phase [ms]", "shard push, least phase [mN s]", "p99 tick [ms]"});
  for (const int panes : {6, 16})
    for (const float speed : kSpeeds) {
      std::string late, push, tick;
      for (const char* how : {"3", "3 to 8", "unbounded"})
        if (const PanesRow* row = rowOf(outcome, how, panes, speed)) {
          const char* comma = late.empty() ? "" : ", ";
          late += comma + shortly(row->late);
          push += comma + shortly(1000.0 * row->push);
          tick += comma + shortly(row->p99Tick);
        }
      if (!late.empty()) table.line({std::to_string(panes), shortly(static_cast<double>(speed)), late, push, tick});
    }
  return text + table.text();
}

/// Rows: how; columns: how far beside the edge.
std::string threshold(const Outcome& outcome) {
  std::string text =
      "## The threshold is an edge\n\nOf 10,000 balls whose momentum is J / (1 + x) - the pane must hold - and of as "
      "many "
      "with J (1 + x) - it must break: those that got the wrong answer, false breaks and missed ones. Balls of 0.2 to "
      "2 "
      "kg, anywhere on the pane and within the tick, that bounce or do not; " +
      std::to_string(outcome.thresholds.empty() ? 0 : outcome.thresholds[0].throws) + " throws for each number.\n\n";
  std::vector<std::string> heads = {"how"};
  for (const ThresholdRow& row : outcome.thresholds)
    if (row.how == outcome.thresholds[0].how) heads.push_back("x = " + shortly(row.beside));
  Table table(heads);
  std::vector<std::string> cells;
  for (const ThresholdRow& row : outcome.thresholds) {
    if (cells.empty()) cells.push_back(row.how);
    cells.push_back(shortly(row.falseBreaks) + ", " + shortly(row.missedBreaks));
    if (cells.size() < heads.size()) continue;
    table.line(cells);
    cells.clear();
  }
  return text + table.text() + picture("threshold", "Wrong answers against the distance from the edge");
}

std::string convergence(const Outcome& outcome) {
  if (outcome.convergence.empty())
    return "The reference of a quick run has 4 sub-steps; a full run shows that it converges.\n\n";
  std::string text =
      "## The reference has converged\n\nThe reference has 16 sub-steps, 32 iterations, no bound of rounds, nothing "
      "recycled, nothing put to rest. With sub-steps four times and twice as long its errors are (against an exact "
      "result, or against itself where there is none):\n\n";
  Table table({"scene", "figure", "4 sub-steps", "8 sub-steps", "counts as 1"});
  for (std::size_t i = 0; i < allFigures().size(); ++i) {
    const Figure& figure = allFigures()[i];
    table.line({std::string(figure.scene), std::string(figure.name) + " [" + std::string(figure.unit) + "]",
                withBounds(outcome.convergence[0].errors[i]), withBounds(outcome.convergence[1].errors[i]),
                figure.tolerance == 0.0 ? "-" : shortly(figure.tolerance)});
  }
  return text + table.text() +
         "Where everything bursts (`shatter`, `flood`) single trajectories part ways at the first difference in the "
         "last "
         "bit. There the distributions of all shards' speeds are compared: the figure is the area between them "
         "(Wasserstein-1), in percent of the mean speed, with 95 % bounds from resampling the seeds. What the two "
         "columns "
         "show for those is the noise that no accuracy goes below.\n\n";
}

std::string scoredTable(const std::vector<Scored>& scored, bool (*isWanted)(const Scored&)) {
  Table table({"knob", "value", "score", "ms per simulated s", "least to most", "p99 tick [ms]",
               "room: median, p99 [ms]", "million instructions per s", "front"});
  for (const Scored& one : scored)
    if (isWanted(one))
      table.line(
          {one.setting.knob, one.setting.value + (one.setting.isDefault ? " (default)" : ""), shortly(one.score.value),
           shortly(one.cost.perSecond), shortly(one.cost.low) + " to " + shortly(one.cost.high),
           shortly(one.cost.p99Tick), shortly(one.cost.roomMedian) + ", " + shortly(one.cost.roomP99),
           one.cost.instructions == 0.0 ? "-" : shortly(1e-6 * one.cost.instructions, 4), one.isFront ? "yes" : ""});
  return table.text();
}

const char* reasonFor(const std::string& preset) {
  if (preset == "phone") return "small pieces become debris: less time, and no other error grows";
  if (preset == "balanced")
    return "the default: exit speeds exact, stacks stand, a room's ticks well within a frame; more iterations change "
           "no error by more than the seeds do";
  if (preset == "accurate")
    return "two sub-steps make pendulums keep time and shards overlap less; 8 iterations in each are enough";
  return "eight sub-steps and 32 iterations: for recordings and to compare with";
}

std::string presets(const Outcome& outcome) {
  std::string text =
      "## Presets\n\n`brittle play --accuracy PRESET` takes them; a replay records what it was played with.\n\n";
  Table table({"preset", "score", "ms per simulated s", "room: p99 tick [ms]", "beaten", "why"});
  for (const Scored& one : outcome.scored)
    if (one.setting.knob == "preset")
      table.line({one.setting.value, withBounds(one.score), shortly(one.cost.perSecond), shortly(one.cost.roomP99),
                  one.isBeaten ? "yes" : "no", reasonFor(one.setting.value)});
  return text + table.text() +
         "Beaten is what another setting is better than by more than the seeds explain, and cheaper than in every "
         "round.\n\n";
}

std::string budgets(const Outcome& outcome) {
  std::string text =
      "## What a budget buys\n\nThe best settings with which 99 of 100 ticks of the whole game keep a budget, in a "
      "room "
      "that a scripted player throws through.\n\n";
  Table table({"ms a tick", "settings", "score", "room: p99 tick [ms]"});
  for (const BudgetRow& row : outcome.budgets)
    table.line(
        {shortly(row.budget),
         row.best == nullptr ? "nothing is that cheap here" : row.best->setting.knob + " " + row.best->setting.value,
         row.best == nullptr ? "-" : shortly(row.best->score.value),
         row.best == nullptr ? "-" : shortly(row.best->cost.roomP99)});
  return text + table.text() + picture("budget", "The best error for 0.5 to 8 ms a tick");
}

std::string splitters(const Outcome& outcome) {
  std::string text =
      "## Splitters\n\nA cube cut to 512 pieces again and again (64 for exact numbers, which grow with every cut). A "
      "cut "
      "fails if it leaves no two closed pieces with a volume that add up within 1e-6 m3. The engine is built on floats "
      "throughout; the "
      "splitter alone is a template of its scalar, so it is where float and double can be compared.\n\n";
  Table table(
      {"splitter", "planes", "attempts", "failures per million", "splits per second", "worst volume error [m3]"});
  for (const SplitterRow& row : outcome.splitters)
    table.line({row.splitter, row.cuts, shortly(row.attempts, 7), shortly(row.failuresPerMillion),
                shortly(row.splitsPerSecond), shortly(row.volumeError)});
  return text + table.text() + picture("splitters", "Failures per million against splits per second");
}

std::string floats(const Outcome& outcome) {
  std::string text =
      "## What float costs\n\nThe engine is built on floats throughout and cannot be built on doubles: its numbers, "
      "its "
      "SIMD lanes and the vertices it shares with the renderer are floats by name. What that costs in error can be had "
      "where the exact result is known in double precision and nothing but rounding is left: worst relative error, and "
      "the same in units of float's epsilon, 1.19e-07.\n\n";
  Table table({"what", "variants", "worst relative error", "in epsilons"});
  for (const FloatRow& row : outcome.floats)
    table.line({row.what, std::to_string(row.variants), shortly(row.worst),
                shortly(row.worst / static_cast<double>(std::numeric_limits<float>::epsilon()))});
  return text + table.text();
}

std::string knobs(const Outcome& outcome) {
  return "## Knob by knob\n\nThe score is the root mean square of all errors, each in units of what counts as 1 (the "
         "table "
         "below) and at most 10: at 1 everything is off by as much as one would just notice. Time is the mean over the "
         "scenes of processor time per simulated second.\n\n" +
         picture("knobs", "Deviation against time, knob by knob") +
         picture("front", "The front of error against time") +
         scoredTable(outcome.scored, [](const Scored& one) { return one.setting.knob != "preset"; }) +
         "Pattern density, smallest body, debris and bodies kept change what breaks into what: their error is the "
         "distance from the default's content, not a mistake.\n\n";
}

std::string defaultErrors(const Outcome& outcome) {
  const auto found = std::find_if(outcome.scored.begin(), outcome.scored.end(),
                                  [](const Scored& one) { return one.setting.isDefault; });
  if (found == outcome.scored.end()) return "";
  Table table({"scene", "figure", "default's error", "counts as 1"});
  for (std::size_t i = 0; i < found->errors.size(); ++i) {
    const Figure& figure = allFigures()[i];
    table.line({std::string(figure.scene), std::string(figure.name) + " [" + std::string(figure.unit) + "]",
                withBounds(found->errors[i]), figure.tolerance == 0.0 ? "-" : shortly(figure.tolerance)});
  }
  return "## The default, figure by figure\n\n" + table.text();
}

std::string scenes() {
  Table table({"scene", "what happens", "variants"});
  for (const Scene& scene : allScenes())
    table.line({std::string(scene.name), std::string(scene.what), std::to_string(scene.variants)});
  return "## Scenes\n\n" + table.text();
}

}  // namespace

Status writeReport(const Outcome& outcome, const std::string& folder) {
  const std::string text =
      "# What accuracy costs\n\n`build/tools/accuracy" + std::string(outcome.quick ? " --quick" : "") +
      "` wrote this. Figures of time are of one machine; errors are the same bits on every one.\n\n" +
      machine(outcome) + picture("headline", "Where glass breaks decides the exit speed") + claim(outcome) +
      picture("rounds", "Exit-speed error against rounds") +
      picture("lag", "What few rounds cost: lag and shard push") + mended(outcome) +
      picture("map", "Rounds by sub-steps") + threshold(outcome) +
      picture("phases", "What a breaking step consists of") + presets(outcome) + budgets(outcome) + knobs(outcome) +
      defaultErrors(outcome) + floats(outcome) + splitters(outcome) + convergence(outcome) + scenes();
  return writeFile(folder + "/report.md", {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

}  // namespace brittle::accuracy
