// Exact for what people write: up to 15 digits and a power of ten up to 22 take one correctly rounded operation. Beyond
// that the last bit of the double may be off, by the same amount everywhere.
#include "game/content/number.h"

#include <cstdint>
#include <string>

namespace brittle::content {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',';
}
bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  char peek() const { return at < text.size() ? text[at] : '\0'; }
  bool take(char c) {
    if (peek() != c || at >= text.size()) return false;
    ++at;
    return true;
  }
};

struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
  bool any = false;
};

void readDigits(Cursor& cursor, Decimal& decimal, int step) {
  for (; isDigit(cursor.peek()); ++cursor.at) {
    decimal.any = true;
    if (decimal.digits < 1'000'000'000'000'000'000ull) {
      decimal.digits = decimal.digits * 10 + static_cast<std::uint64_t>(cursor.peek() - '0');
      decimal.exponent += step;
    } else {
      decimal.exponent += step + 1;
    }
  }
}

/// False if an exponent begins and has no digits.
bool readExponent(Cursor& cursor, Decimal& decimal) {
  if (!cursor.take('e') && !cursor.take('E')) return true;
  const bool negative = cursor.take('-');
  if (!negative) cursor.take('+');
  if (!isDigit(cursor.peek())) return false;
  int exponent = 0;
  for (; isDigit(cursor.peek()); ++cursor.at)
    if (exponent < 10000) exponent = exponent * 10 + (cursor.peek() - '0');
  decimal.exponent += negative ? -exponent : exponent;
  return true;
}

double scaled(const Decimal& decimal) {
  double value = static_cast<double>(decimal.digits);
  if (decimal.digits == 0) return 0.0;
  double power = 1.0;
  const int size = decimal.exponent < 0 ? -decimal.exponent : decimal.exponent;
  for (int i = 0; i < size && i < 400; ++i) {
    power *= 10.0;
    if (power < 1e22) continue;
    value = decimal.exponent < 0 ? value / power : value * power;
    power = 1.0;
  }
  return decimal.exponent < 0 ? value / power : value * power;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> parseNumber(std::string_view text) {
  Cursor cursor{trimmed(text)};
  const bool negative = cursor.take('-');
  if (!negative) cursor.take('+');
  Decimal decimal;
  readDigits(cursor, decimal, 0);
  if (cursor.take('.')) readDigits(cursor, decimal, -1);
  if (!decimal.any || !readExponent(cursor, decimal) || cursor.at != cursor.text.size()) return std::nullopt;
  const double value = scaled(decimal);
  return negative ? -value : value;
}

std::optional<std::vector<double>> parseNumbers(std::string_view text) {
  std::vector<double> numbers;
  std::size_t at = 0;
  while (at < text.size()) {
    if (isBlank(text[at])) {
      ++at;
      continue;
    }
    const std::size_t start = at;
    while (at < text.size() && !isBlank(text[at])) ++at;
    const std::optional<double> number = parseNumber(text.substr(start, at - start));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<bool> parseTruth(std::string_view text) {
  std::string word(trimmed(text));
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (word == "1" || word == "true" || word == "yes") return true;
  if (word == "0" || word == "false" || word == "no") return false;
  return std::nullopt;
}

}  // namespace brittle::content
