// accuracy/csv.h - tables of numbers and short words for gnuplot and spreadsheets: comma separated, the columns' names
// first.
#pragma once

#include <string>
#include <vector>

#include "engine/core/result.h"

namespace brittle::accuracy {

class Csv {
 public:
  explicit Csv(std::vector<std::string> columns);
  /// Starts a row; then add its cells.
  Csv& row();
  Csv& operator<<(const std::string& text);
  Csv& operator<<(double number);
  /// Every row must have a cell for each column.
  Status write(const std::string& path) const;

 private:
  std::size_t columns_;
  std::size_t cells_ = 0;
  std::string text_;
};

/// A number with `digits` that count, as 0.0123 or 4.1e-07.
std::string shortly(double number, int digits = 3);

}  // namespace brittle::accuracy
