#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <map>
#include <vector>

#include "tests/hard_cases/case.h"

namespace brittle::hard {
namespace {

struct Figure {
  std::string label, unit;
  double value = 0.0;
  bool isSum = false;
};

bool full = false;

std::map<std::string, std::vector<Figure>, std::less<>>& figures() {
  static std::map<std::string, std::vector<Figure>, std::less<>> all;
  return all;
}

/// The figure of this label of the running test's case; made if it is new.
Figure& figureFor(std::string_view label, std::string_view unit, double start, bool isSum) {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  std::vector<Figure>& list = figures()[idOf(test->test_suite_name())];
  for (Figure& figure : list)
    if (figure.label == label) return figure;
  return list.emplace_back(Figure{std::string(label), std::string(unit), start, isSum});
}

std::string written(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value == static_cast<double>(static_cast<long long>(value)) ? "%.0f" : "%.3g",
                value);
  return text;
}

}  // namespace

std::string idOf(std::string_view suite) {
  suite = suite.substr(suite.find('/') == std::string_view::npos ? 0 : suite.find('/') + 1);
  std::size_t end = 1;
  while (end < suite.size() && std::isdigit(static_cast<unsigned char>(suite[end])) != 0) ++end;
  if (suite.empty() || suite[0] != 'B' || end == 1) return {};
  return std::string(suite.substr(0, end));
}

bool isFull() {
  return full;
}

void setFull(bool isFull) {
  full = isFull;
}

void reportWorst(std::string_view label, double value, std::string_view unit) {
  Figure& figure = figureFor(label, unit, value, false);
  figure.value = value > figure.value || value != value ? value : figure.value;
}

void reportSum(std::string_view label, double value) {
  figureFor(label, "", 0.0, true).value += value;
}

// Worst values read "label value unit"; sums "value label".
std::string figureOf(std::string_view id) {
  std::string line;
  const auto found = figures().find(id);
  if (found == figures().end()) return line;
  for (const Figure& figure : found->second) {
    if (!line.empty()) line += "; ";
    line += figure.isSum ? written(figure.value) + " " + figure.label : figure.label + " " + written(figure.value);
    if (!figure.unit.empty()) line += " " + figure.unit;
  }
  return line;
}

}  // namespace brittle::hard
