// SPDX-License-Identifier: MIT
// File descriptors: owned, made to pipes, read and written whole, handed to other processes, and locked.
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace regista::process {

// Closed at the end.
struct FileDescriptor {
  int number = -1;  // -1: none

  FileDescriptor() = default;
  explicit FileDescriptor(int opened) : number(opened) {}
  ~FileDescriptor() { reset(); }
  FileDescriptor(FileDescriptor&& other) noexcept : number(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    reset(other.release());
    return *this;
  }

  bool is_open() const { return number != -1; }
  // To somebody else, who closes it.
  int release() { return std::exchange(number, -1); }
  void reset(int opened = -1) {
    if (number != -1) ::close(number);
    number = opened;
  }
};

// Moves it to a number that is at least so high, out of the reach of code that guesses numbers. Closed at exec.
FileDescriptor moved_up(FileDescriptor file, int lowest);

// Closed at exec. Nobody waits for the reading end; who inherits the writing end does.
struct Pipe {
  FileDescriptor read, write;
};
// Throws std::system_error.
Pipe make_pipe();

// A text as a file without a name, from its beginning: unlike a pipe it never fills. Throws std::system_error.
FileDescriptor memory_file(std::string_view text);

// All of a file, wherever it stands: who shares it is not disturbed.
std::string everything_in(int file);

// False when not all of it could be written. Makes only calls that are safe in a signal handler.
bool write_all(int descriptor, std::string_view text);
bool write_all(int descriptor, std::span<const std::uint8_t> bytes);

// What there is to read, in pieces, without waiting: at most a megabyte a call, for somebody may write without end.
// take(std::string_view) gets each piece. At the end of the pipe the descriptor is closed.
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

// Datagrams with file descriptors between processes (SCM_RIGHTS; unix(7)).
inline constexpr std::size_t most_passed_files = 8;
// False when nobody can receive it.
bool send_bytes(int socket, std::span<const std::byte> bytes, std::span<const int> files);
// Waits for a datagram of just so many bytes. False at the end of the connection, and for any other datagram. The files
// are closed at exec.
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

// A lock on a whole file between processes, also of several machines. It is a lock of the open file (fcntl,
// F_OFD_SETLK) on one byte that SQLite has no lock on ("File Locking And Concurrency", sqlite.org): flock() would be in
// the way of SQLite's own locks on network file systems, where both kinds are the same.
enum class FileLock { shared, exclusive };

// Without waiting; until the descriptor and its copies in other processes are closed. descriptor: open for reading, for
// an exclusive one for writing. operation_would_block: another holds it.
std::error_code lock_file(int descriptor, FileLock lock);
// At once, also for copies of the descriptor. Closing alone ends a lock somewhat later on some network file systems.
void unlock_file(int descriptor);

}  // namespace regista::process
