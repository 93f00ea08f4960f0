// The language is that of the Lua 5.2 reference manual, section 6.4.1; classes are ASCII, whatever the locale.
#include "engine/script/pattern.h"

#include <cstring>

namespace brittle::script {
namespace {

constexpr int kMostDepth = 200;

bool isIn(unsigned char c, unsigned char low, unsigned char high) {
  return c >= low && c <= high;
}

/// %a and its family; a capital letter is the complement; another character stands for itself.
bool isInClass(unsigned char c, unsigned char name) {
  const bool lower = isIn(c, 'a', 'z');
  const bool upper = isIn(c, 'A', 'Z');
  const bool digit = isIn(c, '0', '9');
  const bool visible = isIn(c, 33, 126);
  const auto kind = static_cast<unsigned char>(name | 0x20);
  bool result = false;
  switch (isIn(name, 'A', 'Z') ? kind : name) {
    case 'a':
      result = lower || upper;
      break;
    case 'c':
      result = c < 32 || c == 127;
      break;
    case 'd':
      result = digit;
      break;
    case 'g':
      result = visible;
      break;
    case 'l':
      result = lower;
      break;
    case 'p':
      result = visible && !lower && !upper && !digit;
      break;
    case 's':
      result = c == ' ' || isIn(c, 9, 13);
      break;
    case 'u':
      result = upper;
      break;
    case 'w':
      result = lower || upper || digit;
      break;
    case 'z':
      result = c == 0;
      break;  // deprecated in 5.2, still there
    case 'x':
      result = digit || isIn(c, 'a', 'f') || isIn(c, 'A', 'F');
      break;
    default:
      return c == name;
  }
  return isIn(name, 'A', 'Z') ? !result : result;
}

/// `set` points at '[', `end` one past ']'.
bool isInSet(unsigned char c, const char* set, const char* end) {
  const char* p = set + 1;
  const char* last = end - 1;
  const bool complement = *p == '^';
  if (complement) ++p;
  for (; p < last; ++p) {
    if (*p == '%' && p + 1 < last) {
      ++p;
      if (isInClass(c, static_cast<unsigned char>(*p))) return !complement;
    } else if (p + 2 < last && p[1] == '-') {
      if (isIn(c, static_cast<unsigned char>(p[0]), static_cast<unsigned char>(p[2]))) return !complement;
      p += 2;
    } else if (static_cast<unsigned char>(*p) == c) {
      return !complement;
    }
  }
  return complement;
}

}  // namespace

bool Pattern::spend() {
  if (--*budget_ >= 0) return true;
  fail("the instruction budget is used up in a pattern");
  return false;
}

/// One past the single-character class that begins at `p`; null with an error if the pattern ends within it.
const char* Pattern::classEnd(const char* p) {
  const char first = *p++;
  if (first == '%') return p < patternEnd_ ? p + 1 : fail("malformed pattern (ends with '%')");
  if (first != '[') return p;
  if (p < patternEnd_ && *p == '^') ++p;
  do {  // a ']' in the first place is part of the set
    if (p >= patternEnd_) return fail("malformed pattern (missing ']')");
    if (*p++ == '%' && p < patternEnd_) ++p;
  } while (p >= patternEnd_ || *p != ']');
  return p + 1;
}

bool Pattern::matchesOne(const char* s, const char* p, const char* next) const {
  if (s >= subjectEnd_) return false;
  const auto c = static_cast<unsigned char>(*s);
  switch (*p) {
    case '.':
      return true;
    case '%':
      return isInClass(c, static_cast<unsigned char>(p[1]));
    case '[':
      return isInSet(c, p, next);
    default:
      return static_cast<unsigned char>(*p) == c;
  }
}

const char* Pattern::match(const char* s, const char* p) {
  if (++depth_ > kMostDepth) return fail("pattern too complex");
  const char* result = matchPlain(s, p);
  --depth_;
  return result;
}

const char* Pattern::matchPlain(const char* s, const char* p) {
  while (p < patternEnd_) {
    if (!spend()) return nullptr;
    const bool escaped = *p == '%' && p + 1 < patternEnd_;
    if (*p == '(')
      return p + 1 < patternEnd_ && p[1] == ')' ? openCapture(s, p + 2, kPosition) : openCapture(s, p + 1, kUnfinished);
    if (*p == ')') return closeCapture(s, p + 1);
    if (*p == '$' && p + 1 == patternEnd_) return s == subjectEnd_ ? s : nullptr;
    if (escaped && p[1] == 'b') {
      s = matchBalance(s, p + 2);
      if (s == nullptr) return nullptr;
      p += 4;
      continue;
    }
    if (escaped && p[1] == 'f') {
      p += 2;
      if (p >= patternEnd_ || *p != '[') return fail("missing '[' after '%f' in pattern");
      const char* setEnd = classEnd(p);
      if (setEnd == nullptr || !atFrontier(s, p, setEnd)) return nullptr;
      p = setEnd;
      continue;
    }
    if (escaped && isIn(static_cast<unsigned char>(p[1]), '0', '9')) {
      s = matchCapture(s, p[1]);
      if (s == nullptr) return nullptr;
      p += 2;
      continue;
    }
    const char* next = classEnd(p);
    if (next == nullptr) return nullptr;
    const char suffix = next < patternEnd_ ? *next : '\0';
    if (suffix == '*') return longest(s, p, next, 0);
    if (suffix == '+') return longest(s, p, next, 1);
    if (suffix == '-') return shortest(s, p, next);
    const bool matches = matchesOne(s, p, next);
    if (suffix == '?') {
      if (matches) {
        const char* end = match(s + 1, next + 1);
        if (end != nullptr || error_ != nullptr) return end;
      }
      p = next + 1;
      continue;
    }
    if (!matches) return nullptr;
    ++s;
    p = next;
  }
  return s;
}

const char* Pattern::longest(const char* s, const char* p, const char* next, int least) {
  std::ptrdiff_t count = 0;
  while (matchesOne(s + count, p, next)) {
    if (!spend()) return nullptr;
    ++count;
  }
  for (; count >= least; --count) {
    const char* end = match(s + count, next + 1);
    if (end != nullptr || error_ != nullptr || !spend()) return end;
  }
  return nullptr;
}

const char* Pattern::shortest(const char* s, const char* p, const char* next) {
  for (;; ++s) {
    const char* end = match(s, next + 1);
    if (end != nullptr || error_ != nullptr || !spend()) return end;
    if (!matchesOne(s, p, next)) return nullptr;
  }
}

const char* Pattern::openCapture(const char* s, const char* p, std::ptrdiff_t size) {
  if (captures_ >= kMostCaptures) return fail("too many captures");
  capture_[captures_++] = {s, size};
  const char* end = match(s, p);
  if (end == nullptr) --captures_;
  return end;
}

const char* Pattern::closeCapture(const char* s, const char* p) {
  int index = captures_ - 1;
  while (index >= 0 && capture_[index].size != kUnfinished) --index;
  if (index < 0) return fail("invalid pattern capture");
  capture_[index].size = s - capture_[index].start;
  const char* end = match(s, p);
  if (end == nullptr) capture_[index].size = kUnfinished;
  return end;
}

const char* Pattern::matchCapture(const char* s, char digit) {
  const int index = digit - '1';
  if (index < 0 || index >= captures_ || capture_[index].size == kUnfinished) return fail("invalid capture index");
  const std::ptrdiff_t size = capture_[index].size == kPosition ? 0 : capture_[index].size;
  *budget_ -= size / 16;
  if (size > subjectEnd_ - s || std::memcmp(capture_[index].start, s, static_cast<std::size_t>(size)) != 0)
    return nullptr;
  return s + size;
}

/// `p` points at the two characters of %bxy.
const char* Pattern::matchBalance(const char* s, const char* p) {
  if (p + 1 >= patternEnd_) return fail("missing arguments to '%b'");
  if (s >= subjectEnd_ || *s != *p) return nullptr;
  int open = 1;
  while (++s < subjectEnd_) {
    if (!spend()) return nullptr;
    if (*s == p[1]) {
      if (--open == 0) return s + 1;
    } else if (*s == *p) {
      ++open;
    }
  }
  return nullptr;
}

bool Pattern::atFrontier(const char* s, const char* set, const char* setEnd) const {
  const auto before = static_cast<unsigned char>(s == subject_ ? '\0' : s[-1]);
  const auto here = static_cast<unsigned char>(s < subjectEnd_ ? *s : '\0');
  return !isInSet(before, set, setEnd) && isInSet(here, set, setEnd);
}

}  // namespace brittle::script
