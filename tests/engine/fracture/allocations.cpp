// Replaces the global allocation functions by counting ones. In a file of its own: a compiler that sees both ends of
// them in one takes `free` for a mistake.
#include <cstdlib>
#include <new>

#include "tests/engine/fracture/scene.h"

namespace {
std::size_t count = 0;
}

std::size_t brittle::fracture::allocationCount() {
  return count;
}

void* operator new(std::size_t size) {
  ++count;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
