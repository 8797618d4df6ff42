// SPDX-License-Identifier: MIT
// See allocations.h.
#include "tests/support/allocations.h"

#include <cstdlib>
#include <new>

namespace {

thread_local pabd::test::Allocations taken = {0, 0};

void* counted(void* memory, std::size_t size) {
  ++taken.count;
  taken.bytes += size;
  if (memory) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size), size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto a = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(a, (size + a - 1) / a * a), size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

pabd::test::Allocations pabd::test::allocations() { return taken; }
