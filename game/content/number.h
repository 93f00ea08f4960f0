// content/number.h - numbers as level files write them: leading and trailing dots, several spaces, never the machine's
// locale.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace brittle::content {

/// Values beyond this are refused: no level is so large, and floats lose their centimetres.
inline constexpr double kLargestNumber = 1e6;

/// Without the blanks about it.
std::string_view trimmed(std::string_view text);
/// One number and nothing else (blanks around it allowed); nothing if it is none. Digits beyond the 19th are ignored.
/// May be infinite.
std::optional<double> parseNumber(std::string_view text);
/// Numbers between blanks or commas; nothing if one of them is none.
std::optional<std::vector<double>> parseNumbers(std::string_view text);
/// 0 or 1, true or false, yes or no in any case.
std::optional<bool> parseTruth(std::string_view text);

}  // namespace brittle::content
