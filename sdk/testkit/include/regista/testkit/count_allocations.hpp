// SPDX-License-Identifier: MIT
// Counts the allocations of a program and of the plugins it has loaded. Include it in one file of a program only, for
// it replaces the allocation functions. (Sanitizers bring their own: leave such a test out there.)
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace regista::testkit {

inline bool counting = false;        // while true,
inline std::size_t allocations = 0;  // this goes up by one for each

// How often `work` allocates.
inline std::size_t allocations_during(const auto& work) {
  allocations = 0;
  counting = true;
  work();
  counting = false;
  return allocations;
}

inline void* counted_or_null(std::size_t size, std::size_t alignment) {
  if (counting) ++allocations;
  return alignment <= alignof(std::max_align_t)
             ? std::malloc(size)
             : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

inline void* counted(std::size_t size, std::size_t alignment) {
  void* const memory = counted_or_null(size, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace regista::testkit

// Never put into their callers: there g++ and valgrind would take what allocates and what frees for strangers.
[[gnu::noinline]] void* operator new(std::size_t size) { return regista::testkit::counted(size, 1); }
[[gnu::noinline]] void* operator new[](std::size_t size) { return regista::testkit::counted(size, 1); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return regista::testkit::counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new[](std::size_t size, std::align_val_t alignment) {
  return regista::testkit::counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return regista::testkit::counted_or_null(size, 1);
}
[[gnu::noinline]] void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return regista::testkit::counted_or_null(size, 1);
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return regista::testkit::counted_or_null(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return regista::testkit::counted_or_null(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
