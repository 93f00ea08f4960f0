// script/pattern.h - Lua patterns with a budget: a pattern that goes back for ever stops with an error, where the
// library's own matcher would hang outside of the reach of any instruction count. Holds no memory of its own, so a Lua
// error may jump over it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace brittle::script {

class Pattern {
 public:
  static constexpr int kMostCaptures = 32;

  struct Capture {
    const char* start;
    std::ptrdiff_t size;  // or one of the two below
  };
  static constexpr std::ptrdiff_t kUnfinished = -1;
  static constexpr std::ptrdiff_t kPosition = -2;

  /// `budget` is counted down by about one per character looked at.
  Pattern(const char* subject, std::size_t subjectSize, const char* pattern, std::size_t patternSize,
          std::int64_t& budget)
      : subject_(subject),
        subjectEnd_(subject + subjectSize),
        pattern_(pattern),
        patternEnd_(pattern + patternSize),
        budget_(&budget) {}

  /// The end of a match of the whole pattern that begins at `start`, or null: no match, or error() says what is wrong.
  const char* matchAt(const char* start) {
    captures_ = 0;
    depth_ = 0;
    return match(start, pattern_);
  }
  /// Null, or what is wrong with the pattern; also when the budget is used up.
  const char* error() const { return error_; }

  int captures() const { return captures_; }
  const Capture& capture(int index) const { return capture_[index]; }
  const char* subject() const { return subject_; }
  const char* subjectEnd() const { return subjectEnd_; }

 private:
  const char* match(const char* s, const char* p);
  const char* matchPlain(const char* s, const char* p);
  const char* longest(const char* s, const char* p, const char* next, int least);
  const char* shortest(const char* s, const char* p, const char* next);
  const char* openCapture(const char* s, const char* p, std::ptrdiff_t size);
  const char* closeCapture(const char* s, const char* p);
  const char* matchCapture(const char* s, char digit);
  const char* matchBalance(const char* s, const char* p);
  bool atFrontier(const char* s, const char* set, const char* setEnd) const;
  const char* classEnd(const char* p);
  bool matchesOne(const char* s, const char* p, const char* next) const;
  bool spend();
  const char* fail(const char* what) {
    if (error_ == nullptr) error_ = what;
    return nullptr;
  }

  const char* subject_;
  const char* subjectEnd_;
  const char* pattern_;
  const char* patternEnd_;
  std::int64_t* budget_;
  const char* error_ = nullptr;
  int captures_ = 0;
  int depth_ = 0;
  Capture capture_[kMostCaptures];
};

}  // namespace brittle::script
