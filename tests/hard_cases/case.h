// hard_cases/case.h - what a hard case is: an id, what happens in it, what must come of it, and the figures its tests
// measure. The tests of case B17 are those of the suite B17, and of suites whose names go on with a capital letter.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace brittle::hard {

struct Case {
  std::string_view id;
  std::string_view name;       // what happens
  std::string_view criterion;  // what must come of it
};

/// All cases that have tests, in order of their ids.
std::span<const Case> allCases();
/// The id of the case that a test suite belongs to: B21 of "Panes/B21.Exits/0". Empty: of none.
std::string idOf(std::string_view suite);

/// Whether the full counts were asked for, which take hours; else smaller ones that show the same in seconds.
bool isFull();
void setFull(bool full);
inline int counted(int quick, int full) {
  return isFull() ? full : quick;
}

/// Figures of the running test's case, kept under their labels: the largest value reported, or the sum.
void reportWorst(std::string_view label, double value, std::string_view unit = "");
void reportSum(std::string_view label, double value);
/// Everything that was reported for a case, as one line: "exit speed off by 0.4 %; 1920 shots".
std::string figureOf(std::string_view id);

}  // namespace brittle::hard
