#include "tools/accuracy/csv.h"

#include <cstdio>

#include "engine/core/assert.h"
#include "engine/core/file.h"

namespace brittle::accuracy {

Csv::Csv(std::vector<std::string> columns) : columns_(columns.size()) {
  for (std::size_t i = 0; i < columns.size(); ++i) text_ += (i == 0 ? "" : ",") + columns[i];
}

Csv& Csv::row() {
  BR_ASSERT(cells_ % columns_ == 0);
  text_ += '\n';
  return *this;
}

Csv& Csv::operator<<(const std::string& text) {
  // In quotes where a comma would end the cell.
  if (cells_++ % columns_ != 0) text_ += ',';
  text_ += text.find(',') == std::string::npos ? text : '"' + text + '"';
  return *this;
}

Csv& Csv::operator<<(double number) {
  return *this << shortly(number, 6);
}

Status Csv::write(const std::string& path) const {
  BR_ASSERT(cells_ % columns_ == 0);
  const std::string whole = text_ + '\n';
  return writeFile(path, {reinterpret_cast<const unsigned char*>(whole.data()), whole.size()});
}

std::string shortly(double number, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, number);
  return text;
}

}  // namespace brittle::accuracy
