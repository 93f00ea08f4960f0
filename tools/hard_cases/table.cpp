#include "tools/hard_cases/table.h"

#include <algorithm>
#include <cstdio>

namespace brittle::hard {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string rounded(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", seconds);
  return text;
}

}  // namespace

bool allPass(const std::vector<Row>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.pass; });
}

void printTable(const std::vector<Row>& rows) {
  std::string failed;
  double seconds = 0.0;
  for (const Row& row : rows) {
    std::printf("%-4s %s  %s\n           must   %s\n           found  %s (%s s)\n", row.id.c_str(),
                row.pass ? "pass" : "FAIL", row.name.c_str(), row.criterion.c_str(), row.figure.c_str(),
                rounded(row.seconds).c_str());
    seconds += row.seconds;
    if (!row.pass) failed += " " + row.id;
  }
  std::printf("%zu cases in %.0f s, %s%s\n", rows.size(), seconds,
              failed.empty() ? "all hold" : "FAILED:", failed.c_str());
}

std::string asMarkdown(const std::vector<Row>& rows) {
  std::string out = "| | case | found | | case | found |\n| --- | --- | --- | --- | --- | --- |\n";
  const std::size_t half = (rows.size() + 1) / 2;
  const auto cells = [&](std::size_t i) {
    if (i >= rows.size()) return std::string("| | ");
    return rows[i].id + " | " + rows[i].name + " | " + (rows[i].pass ? "" : "**FAILS** ") + rows[i].figure;
  };
  for (std::size_t i = 0; i < half; ++i) out += "| " + cells(i) + " | " + cells(half + i) + " |\n";
  return out;
}

std::string asJson(const std::vector<Row>& rows) {
  std::string out = "[";
  for (const Row& row : rows) {
    out += out.size() > 1 ? ",\n " : "\n ";
    out += "{\"id\": " + quoted(row.id) + ", \"case\": " + quoted(row.name) +
           ", \"criterion\": " + quoted(row.criterion) + ", \"figure\": " + quoted(row.figure) +
           ", \"pass\": " + (row.pass ? "true" : "false") + ", \"seconds\": " + rounded(row.seconds) + "}";
  }
  return out + "\n]\n";
}

}  // namespace brittle::hard
