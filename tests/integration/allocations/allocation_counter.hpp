// SPDX-License-Identifier: MIT
// Replaces the program's allocation functions, those of loaded plugins too, by ones that count. To be included by one
// file of a program.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace regista::counter {

inline bool counting = false;
inline std::size_t allocations = 0;

inline void* counted(std::size_t size, std::size_t alignment) {
  if (counting) ++allocations;
  void* const memory = alignment <= alignof(std::max_align_t)
                           ? std::malloc(size)
                           : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace regista::counter

void* operator new(std::size_t size) { return regista::counter::counted(size, 1); }
void* operator new[](std::size_t size) { return regista::counter::counted(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return regista::counter::counted(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return regista::counter::counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
