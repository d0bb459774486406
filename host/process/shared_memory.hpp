// SPDX-License-Identifier: MIT
// A value that several processes see, and that outlives those that wrote to it.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

#include "process/descriptor.hpp"

namespace regista::process {

// New memory without a name, all zero. Closed at exec. Throws std::system_error.
FileDescriptor shared_file(std::size_t bytes);
// Throws std::system_error: also where the file is something else than memory, or too short, for nothing but memory is
// to be written to, and a page that is too short would be a signal at the first write.
void* map_shared_file(const FileDescriptor& file, std::size_t bytes);
// Without a file, which a limit on the size of files would be one on. Throws std::system_error.
void* map_for_copies(std::size_t bytes);
void unmap(void* memory, std::size_t bytes);

// Only copies of this process are to see it: no descriptor is needed.
struct ForCopies {};
inline constexpr ForCopies for_copies;

// T has no pointers into this process and no destructor that does anything. Copies of this process see the same value;
// a program that is started does where it is given the descriptor.
template <class T>
class SharedMemory {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  SharedMemory() : SharedMemory(shared_file(sizeof(T))) { ::new (static_cast<void*>(value_)) T; }
  explicit SharedMemory(ForCopies) : value_(static_cast<T*>(map_for_copies(sizeof(T)))) {
    ::new (static_cast<void*>(value_)) T;
  }
  // That of another process, by a descriptor that was inherited.
  explicit SharedMemory(FileDescriptor inherited)
      : file_(std::move(inherited)), value_(static_cast<T*>(map_shared_file(file_, sizeof(T)))) {}
  ~SharedMemory() { forget(); }
  SharedMemory(SharedMemory&& other) noexcept
      : file_(std::move(other.file_)), value_(std::exchange(other.value_, nullptr)) {}
  SharedMemory& operator=(SharedMemory&&) = delete;

  T& operator*() const { return *value_; }
  T* operator->() const { return value_; }
  int descriptor() const { return file_.number; }
  void move_descriptor_up(int lowest) { file_ = moved_up(std::move(file_), lowest); }
  void clear() { *value_ = T{}; }
  // Takes it away from this process; a copy may still have it.
  void forget() {
    file_.reset();
    if (value_ != nullptr) unmap(value_, sizeof(T));
    value_ = nullptr;
  }

 private:
  FileDescriptor file_;
  T* value_;
};

}  // namespace regista::process
