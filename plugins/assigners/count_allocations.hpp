// SPDX-License-Identifier: MIT
// For tests: counts the program's allocations between two marks. Include it in one file of a test's program only, for
// it replaces the allocation functions.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace count_allocations {

inline bool counting = false;
inline std::size_t allocations = 0;

inline std::size_t during(const auto& work) {
  allocations = 0;
  counting = true;
  work();
  counting = false;
  return allocations;
}

inline void* counted(std::size_t size) {
  if (counting) ++allocations;
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace count_allocations

void* operator new(std::size_t size) { return count_allocations::counted(size); }
void* operator new[](std::size_t size) { return count_allocations::counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
