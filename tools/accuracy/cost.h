// accuracy/cost.h - what work costs in instructions, where the machine counts them; its time is tools/bench's clock.
#pragma once

#include <cstdint>

namespace brittle::accuracy {

/// Counts the instructions that this thread executes outside the kernel, through the processor's own counters. Virtual
/// machines often have none: then isThere is false and the counts are 0.
class InstructionCounter {
 public:
  InstructionCounter();
  ~InstructionCounter();
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;

  bool isThere() const { return file_ >= 0; }
  std::uint64_t now() const;

 private:
  int file_ = -1;
};

}  // namespace brittle::accuracy
