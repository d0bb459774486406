// SPDX-License-Identifier: MIT
#include "process/descriptor.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>

#include <array>
#include <cassert>
#include <cstring>
#include <system_error>

namespace regista::process {
namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

// Room for control data, aligned as its header wants it.
struct alignas(cmsghdr) Control {
  std::array<char, CMSG_SPACE(most_passed_files * sizeof(int))> bytes{};
};

constexpr off_t after_those_of_sqlite = 0x40000000 + 512;

int set_lock(int descriptor, int type) {
  struct flock wanted {};
  wanted.l_type = static_cast<short>(type);
  wanted.l_whence = SEEK_SET;
  wanted.l_start = after_those_of_sqlite;
  wanted.l_len = 1;
  return fcntl(descriptor, F_OFD_SETLK, &wanted);
}

}  // namespace

FileDescriptor moved_up(FileDescriptor file, int lowest) {
  FileDescriptor out(::fcntl(file.number, F_DUPFD_CLOEXEC, lowest));
  if (!out.is_open()) fail("cannot keep a file open");
  return out;
}

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) == -1) fail("cannot make a pipe");
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

FileDescriptor memory_file(std::string_view text) {
  FileDescriptor file(::memfd_create("regista", MFD_CLOEXEC));
  if (!file.is_open() || !write_all(file.number, text)) fail("cannot hand over a text");
  ::lseek(file.number, 0, SEEK_SET);
  return file;
}

std::string everything_in(int file) {
  std::string out;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = ::pread(file, buffer.data(), buffer.size(), static_cast<off_t>(out.size()));
    if (count == -1 && errno == EINTR) continue;
    if (count <= 0) return out;
    out.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count == -1 && errno == EINTR) continue;
    if (count == -1) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool write_all(int descriptor, std::span<const std::uint8_t> bytes) {
  return write_all(descriptor, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

bool send_bytes(int socket, std::span<const std::byte> bytes, std::span<const int> files) {
  assert(files.size() <= most_passed_files);
  iovec content{const_cast<std::byte*>(bytes.data()), bytes.size()};
  Control control;
  msghdr message{};
  message.msg_iov = &content;
  message.msg_iovlen = 1;
  if (!files.empty()) {
    message.msg_control = control.bytes.data();
    message.msg_controllen = CMSG_SPACE(files.size_bytes());
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(files.size_bytes());
    std::memcpy(CMSG_DATA(header), files.data(), files.size_bytes());
  }
  for (;;) {
    const ssize_t sent = ::sendmsg(socket, &message, MSG_NOSIGNAL);
    if (sent == -1 && errno == EINTR) continue;
    return sent == static_cast<ssize_t>(bytes.size());
  }
}

bool receive_bytes(int socket, std::span<std::byte> bytes, std::vector<FileDescriptor>& files) {
  files.clear();
  iovec content{bytes.data(), bytes.size()};
  Control control;
  msghdr message{};
  message.msg_iov = &content;
  message.msg_iovlen = 1;
  message.msg_control = control.bytes.data();
  message.msg_controllen = control.bytes.size();
  ssize_t received = -1;
  do {
    received = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
  } while (received == -1 && errno == EINTR);
  if (received <= 0) return false;
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr; header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
    std::vector<int> numbers((header->cmsg_len - CMSG_LEN(0)) / sizeof(int));
    std::memcpy(numbers.data(), CMSG_DATA(header), numbers.size() * sizeof(int));
    for (const int each : numbers) files.emplace_back(each);
  }
  return received == static_cast<ssize_t>(bytes.size()) && (message.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) == 0;
}

std::error_code lock_file(int descriptor, FileLock lock) {
  if (set_lock(descriptor, lock == FileLock::exclusive ? F_WRLCK : F_RDLCK) == 0) return {};
  if (errno == EAGAIN || errno == EACCES) return std::make_error_code(std::errc::operation_would_block);
  return {errno, std::generic_category()};
}

void unlock_file(int descriptor) { set_lock(descriptor, F_UNLCK); }

}  // namespace regista::process
