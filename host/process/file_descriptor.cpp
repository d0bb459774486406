// SPDX-License-Identifier: MIT
#include "process/file_descriptor.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <array>
#include <cassert>
#include <cstdio>
#include <cstring>

namespace regista::process {
namespace {

// Space for the control data of a datagram, aligned for its header.
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

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

void* mapped(std::size_t bytes, int flags, int file) {
  void* const out = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_NORESERVE | flags, file, 0);
  if (out == MAP_FAILED) fail("cannot map shared memory");
  return out;
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
    const ssize_t count =
        uninterrupted([&] { return ::pread(file, buffer.data(), buffer.size(), static_cast<off_t>(out.size())); });
    if (count <= 0) return out;
    out.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = uninterrupted([&] { return ::write(descriptor, text.data(), text.size()); });
    if (count == -1) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool write_all(int descriptor, std::span<const std::uint8_t> bytes) {
  return write_all(descriptor, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

RedirectedStream::RedirectedStream(int stream, int to) : stream_(stream) {
  std::fflush(stdout);  // the buffered text belongs to the old file
  before_.reset(::fcntl(stream, F_DUPFD_CLOEXEC, 10));
  if (before_.is_open()) ::dup2(to, stream);
}

RedirectedStream::~RedirectedStream() {
  if (!before_.is_open()) return;
  std::fflush(stdout);
  ::dup2(before_.number, stream_);
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
  const ssize_t sent = uninterrupted([&] { return ::sendmsg(socket, &message, MSG_NOSIGNAL); });
  return sent == static_cast<ssize_t>(bytes.size());
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
  const ssize_t received = uninterrupted([&] { return ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC); });
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

FileDescriptor shared_file(std::size_t bytes) {
  FileDescriptor file(::memfd_create("regista-note", MFD_CLOEXEC));
  if (!file.is_open() || ::ftruncate(file.number, static_cast<off_t>(bytes)) == -1) fail("cannot make shared memory");
  return file;
}

void* map_shared_file(const FileDescriptor& file, std::size_t bytes) {
  struct stat status {};
  if (::fcntl(file.number, F_GET_SEALS) == -1 || ::fstat(file.number, &status) == -1 ||
      status.st_size < static_cast<off_t>(bytes)) {
    errno = EBADF;
    fail("no shared memory was handed over");
  }
  return mapped(bytes, 0, file.number);
}

void* map_for_copies(std::size_t bytes) { return mapped(bytes, MAP_ANONYMOUS, -1); }

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  // Uses an absolute path, because the process may change its folder.
  std::string pattern = (error ? fs::path("/tmp") : fs::absolute(parent)) / "regista-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), "no folder for temporary files");
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace regista::process
