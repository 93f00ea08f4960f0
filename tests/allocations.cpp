// Replaces the global allocation functions by counting ones. In a file of its own, so that the compiler does not see
// through the pair at its uses. (Arrays come this way too.)
#include "tests/allocations.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::atomic<std::size_t> count{0}, bytes{0};
std::atomic<int> fill{-1};

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  count.fetch_add(1, std::memory_order_relaxed);
  const std::size_t size = malloc_usable_size(memory);
  bytes.fetch_add(size, std::memory_order_relaxed);
  if (const int byte = fill.load(std::memory_order_relaxed); byte >= 0) std::memset(memory, byte, size);
  return memory;
}

void release(void* memory) {
  bytes.fetch_sub(malloc_usable_size(memory), std::memory_order_relaxed);
  std::free(memory);
}

}  // namespace

std::size_t allocationCount() {
  return count.load(std::memory_order_relaxed);
}

std::size_t allocatedBytes() {
  return bytes.load(std::memory_order_relaxed);
}

void fillAllocations(int byte) {
  fill.store(byte, std::memory_order_relaxed);
}

void* operator new(std::size_t size) {
  return counted(std::malloc(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}
