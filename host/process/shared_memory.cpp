// SPDX-License-Identifier: MIT
#include "process/shared_memory.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

namespace regista::process {
namespace {

[[noreturn]] void fail_to_share(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

}  // namespace

FileDescriptor shared_file(std::size_t bytes) {
  FileDescriptor file(::memfd_create("regista-note", MFD_CLOEXEC));
  if (!file.is_open() || ::ftruncate(file.number, static_cast<off_t>(bytes)) == -1)
    fail_to_share("cannot make shared memory");
  return file;
}

void* map_shared_file(const FileDescriptor& file, std::size_t bytes) {
  struct stat status {};
  if (::fcntl(file.number, F_GET_SEALS) == -1 || ::fstat(file.number, &status) == -1 ||
      status.st_size < static_cast<off_t>(bytes)) {
    errno = EBADF;
    fail_to_share("no shared memory was handed over");
  }
  void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_NORESERVE, file.number, 0);
  if (memory == MAP_FAILED) fail_to_share("cannot map shared memory");
  return memory;
}

void* map_for_copies(std::size_t bytes) {
  void* const memory =
      ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) fail_to_share("cannot map shared memory");
  return memory;
}

void unmap(void* memory, std::size_t bytes) { ::munmap(memory, bytes); }

}  // namespace regista::process
