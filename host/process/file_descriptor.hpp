// SPDX-License-Identifier: MIT
// File descriptors: ownership, pipes, reading, writing, transfer to other processes, locks, and shared memory.
#pragma once

#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace regista::process {

// Owns a file descriptor and closes it in the destructor.
struct FileDescriptor {
  int number = -1;  // -1: no file

  FileDescriptor() = default;
  explicit FileDescriptor(int opened) : number(opened) {}
  ~FileDescriptor() { reset(); }
  FileDescriptor(FileDescriptor&& other) noexcept : number(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    reset(other.release());
    return *this;
  }

  bool is_open() const { return number != -1; }
  // Returns the descriptor without closing it. The caller must close it.
  int release() { return std::exchange(number, -1); }
  void reset(int opened = -1) {
    if (number != -1) ::close(number);
    number = opened;
  }
};

// Moves the file to a number of at least `lowest`, which a plugin does not guess. The descriptor is closed at exec.
FileDescriptor moved_up(FileDescriptor file, int lowest);

// A pipe whose ends are closed at exec. Reading never waits; writing waits while the pipe is full.
struct Pipe {
  FileDescriptor read, write;
};
// Throws std::system_error.
Pipe make_pipe();

// Returns a nameless file in memory with the content `text`; its file position is 0, so a reader gets the whole text.
// Unlike a pipe, the file is never full. Throws std::system_error.
FileDescriptor memory_file(std::string_view text);

// Returns the whole content of a file. Does not move the file position, which other processes may share.
std::string everything_in(int file);

// Writes the whole text. Returns false if a part was not written. Makes only calls that are safe in a signal handler.
bool write_all(int descriptor, std::string_view text);
bool write_all(int descriptor, std::span<const std::uint8_t> bytes);

// While this object exists, a standard stream of this process leads to the file `to`.
class RedirectedStream {
 public:
  RedirectedStream(int stream, int to);
  ~RedirectedStream();

 private:
  int stream_;
  FileDescriptor before_;
};

// Repeats a system call while a signal interrupts it, and returns its result. Safe in a signal handler.
template <class Call>
auto uninterrupted(Call call) {
  auto out = call();
  while (out == -1 && errno == EINTR) out = call();
  return out;
}

// Reads without waiting, at most a megabyte per call, because the writer may never stop. Passes each piece to
// take(std::string_view). Closes the descriptor at the end of the pipe.
template <class Take>
void read_available(FileDescriptor& pipe, Take&& take) {
  char piece[65536];
  for (int i = 0; i < 16 && pipe.is_open(); ++i) {
    const ssize_t count = ::read(pipe.number, piece, sizeof piece);
    if (count > 0) {
      take(std::string_view(piece, static_cast<std::size_t>(count)));
    } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
      pipe.reset();
    } else if (errno == EAGAIN) {
      return;
    }
  }
}

// Largest number of file descriptors that send_bytes() and receive_bytes() pass with a datagram (SCM_RIGHTS; unix(7)).
inline constexpr std::size_t most_passed_files = 8;
// Sends a datagram to another process. Returns false if the other process cannot receive the datagram.
bool send_bytes(int socket, std::span<const std::byte> bytes, std::span<const int> files);
// Waits for a datagram of exactly this size. Returns false at the end of the connection and for a datagram of another
// size. The descriptors of received files are closed at exec.
bool receive_bytes(int socket, std::span<std::byte> bytes, std::vector<FileDescriptor>& files);

template <class T>
requires std::is_trivially_copyable_v<T>
bool send_with_files(int socket, const T& message, std::span<const int> files) {
  return send_bytes(socket, std::as_bytes(std::span<const T, 1>(&message, 1)), files);
}
template <class T>
requires std::is_trivially_copyable_v<T>
bool receive_with_files(int socket, T& message, std::vector<FileDescriptor>& files) {
  return receive_bytes(socket, std::as_writable_bytes(std::span<T, 1>(&message, 1)), files);
}

// A lock on a whole file between processes, even on several machines. The lock (fcntl, F_OFD_SETLK) is on one byte of
// the open file, a byte that SQLite never locks ("File Locking And Concurrency", sqlite.org). flock() is not used: some
// network file systems treat both kinds of locks as equal, so flock() would block SQLite's own locks there.
enum class FileLock { shared, exclusive };

// Locks without waiting, until the descriptor and its copies in other processes are closed. `descriptor` must be open
// for reading (shared lock) or writing (exclusive lock). Returns operation_would_block for a conflicting lock.
std::error_code lock_file(int descriptor, FileLock lock);
// Unlocks the file now, for all copies of the descriptor. On some network file systems, closing unlocks only later.
void unlock_file(int descriptor);

// Returns a nameless memory file of zeros, which is closed at exec. Throws std::system_error.
FileDescriptor shared_file(std::size_t bytes);
// Maps a file into memory. Throws std::system_error, also if the file is not a memory file (only memory may be written
// to) or too short (a write beyond its end would raise a signal).
void* map_shared_file(const FileDescriptor& file, std::size_t bytes);
// Maps memory that copies of this process share. No limit on file sizes applies to it. Throws std::system_error.
void* map_for_copies(std::size_t bytes);

// Selects the SharedMemory constructor for memory that only copies of this process share. The memory has no descriptor.
struct ForCopies {};
inline constexpr ForCopies for_copies;

// A value in memory that copies of this process share, and started programs with an inherited descriptor. The value
// outlives the processes that wrote it. T must have a trivial destructor and no pointers into a process.
template <class T>
class SharedMemory {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  SharedMemory() : SharedMemory(shared_file(sizeof(T))) { ::new (static_cast<void*>(value_)) T; }
  explicit SharedMemory(ForCopies) : value_(static_cast<T*>(map_for_copies(sizeof(T)))) {
    ::new (static_cast<void*>(value_)) T;
  }
  // Maps the value that another process created, from an inherited descriptor.
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
  // Removes the value from this process. The value stays in copies of this process.
  void forget() {
    file_.reset();
    if (value_ != nullptr) ::munmap(value_, sizeof(T));
    value_ = nullptr;
  }

 private:
  FileDescriptor file_;
  T* value_;
};

// A temporary folder. The constructor throws std::system_error. The destructor removes the folder.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace regista::process
