// hard_cases [--full] [--json | --markdown] [IDS]: runs the hard cases and prints the table: what happens, what must
// come of it, the measured figures, pass or fail, seconds. The tests themselves stand in tests/hard_cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/hard_cases/case.h"
#include "tools/brittle/arguments.h"
#include "tools/hard_cases/table.h"

namespace {

using namespace brittle::hard;

constexpr const char* kNoTest = "no test";

int numberOf(std::string_view id) {
  return id.size() > 1 && id[0] == 'B' ? std::atoi(id.data() + 1) : 0;
}

/// Whether `wanted`, as B21 or B17..B39, names this case.
bool names(const std::string& wanted, std::string_view id) {
  const std::size_t dots = wanted.find("..");
  if (dots == std::string::npos) return wanted == id;
  const int number = numberOf(id);
  return numberOf(wanted) <= number && number <= numberOf(wanted.substr(dots + 2));
}

bool isWanted(const std::vector<std::string>& ids, std::string_view id) {
  return ids.empty() ||
         std::any_of(ids.begin(), ids.end(), [&](const std::string& wanted) { return names(wanted, id); });
}

/// The filter that runs the suites of these cases.
std::string filterFor(const std::vector<std::string>& ids) {
  std::string filter = ":";  // of nothing, should there be no suite
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  for (int i = 0; i < tests.total_test_suite_count(); ++i) {
    const std::string suite = tests.GetTestSuite(i)->name();
    if (isWanted(ids, idOf(suite))) filter += suite + ".*:";
  }
  return filter;
}

/// Adds up the suites of each case, and shows failures as they come, so that a long run need not be waited for.
class Rows : public testing::EmptyTestEventListener {
 public:
  explicit Rows(const std::vector<std::string>& ids) {
    for (const Case& one : allCases())
      if (isWanted(ids, one.id))
        rows_.push_back({std::string(one.id), std::string(one.name), std::string(one.criterion), kNoTest, false, 0.0});
  }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  void OnTestStart(const testing::TestInfo& test) override {
    test_ = std::string(test.test_suite_name()) + "." + test.name();
  }
  /// The unit test is locked meanwhile: asking it for the current test would wait for ever.
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    std::fprintf(stderr, "%s:%d: %s\n%s\n", result.file_name() != nullptr ? result.file_name() : "?",
                 result.line_number(), test_.c_str(), result.message());
  }
  void OnTestSuiteStart(const testing::TestSuite& suite) override { std::fprintf(stderr, "%s ...\n", suite.name()); }
  void OnTestSuiteEnd(const testing::TestSuite& suite) override {
    for (Row& row : rows_) {
      if (row.id != idOf(suite.name())) continue;
      row.pass = (row.pass || row.figure == kNoTest) && suite.Passed();
      row.seconds += static_cast<double>(suite.elapsed_time() + 1) / 1000.0;
      row.figure = figureOf(row.id);
    }
  }
  std::vector<Row> rows_;
  std::string test_;  // the one that runs
};

/// What names no case, as one line; empty: everything does.
std::string unknownOf(const std::vector<std::string>& ids) {
  std::string unknown;
  for (const std::string& wanted : ids) {
    const auto isNamed = [&](const Case& one) { return names(wanted, one.id); };
    if (std::none_of(allCases().begin(), allCases().end(), isNamed)) unknown += " " + wanted;
  }
  return unknown;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Runs the hard cases and prints what each one measured.\n\nExamples:\n"
      "  hard_cases                  all of them, at the counts of the test suite\n"
      "  hard_cases --full B1 B21    two of them at their full counts, which may take hours\n"
      "  hard_cases --markdown       the table as Markdown",
      "hard_cases");
  bool full = false, json = false, markdown = false;
  std::vector<std::string> ids;
  app.add_flag("--full", full, "full counts");
  auto* asList =
      app.add_flag("--json", json, "print a list of objects with id, case, criterion, figure, pass, seconds");
  app.add_flag("--markdown", markdown, "print a Markdown table")->excludes(asList);
  app.add_option("IDS", ids, "cases to run, as B21 or B17..B39 (default: all)");
  if (const auto ended = brittle::program::readArguments(app, argc, argv)) return *ended;
  if (const std::string unknown = unknownOf(ids); !unknown.empty()) {
    const std::string range = std::string(allCases().front().id) + " to " + std::string(allCases().back().id);
    return brittle::program::refuse(app.get_name(),
                                    {"no case" + unknown + "; expected one of " + range + ", or a range as B17..B39"});
  }

  int none = 1;
  testing::InitGoogleTest(&none, argv);
  testing::GTEST_FLAG(filter) = filterFor(ids);
  setFull(full);
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  auto* collected = new Rows(ids);
  listeners.Append(collected);  // owned by it from here on
  const bool pass = RUN_ALL_TESTS() == 0;
  if (json) {
    std::fputs(asJson(collected->rows()).c_str(), stdout);
  } else if (markdown) {
    std::fputs(asMarkdown(collected->rows()).c_str(), stdout);
  } else {
    printTable(collected->rows());
  }
  return pass && allPass(collected->rows()) ? 0 : 1;
}
