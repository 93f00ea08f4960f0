// Replaces the global allocation functions by counting ones.
#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/engine/audio/scene.h"

namespace {
std::atomic<std::size_t> count = 0;
}

std::size_t brittle::audio::allocationCount() {
  return count;
}

void* operator new(std::size_t size) {
  ++count;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
