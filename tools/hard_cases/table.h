// hard_cases/table.h - the table of hard cases: one row per case, on the terminal, as Markdown or as JSON.
#pragma once

#include <string>
#include <vector>

namespace brittle::hard {

struct Row {
  std::string id, name, criterion, figure;
  bool pass = false;
  double seconds = 0.0;
};

bool allPass(const std::vector<Row>& rows);
void printTable(const std::vector<Row>& rows);
/// Two cases to a line: what happens and what was found; one that failed says so.
std::string asMarkdown(const std::vector<Row>& rows);
/// A list of objects with id, case, criterion, figure, pass and seconds.
std::string asJson(const std::vector<Row>& rows);

}  // namespace brittle::hard
