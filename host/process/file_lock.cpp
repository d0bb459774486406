// SPDX-License-Identifier: MIT
#include "process/file_lock.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace regista::process {
namespace {

constexpr off_t after_those_of_sqlite = 0x40000000 + 512;

int set(int descriptor, int type) {
  struct flock wanted {};
  wanted.l_type = static_cast<short>(type);
  wanted.l_whence = SEEK_SET;
  wanted.l_start = after_those_of_sqlite;
  wanted.l_len = 1;
  return fcntl(descriptor, F_OFD_SETLK, &wanted);
}

}  // namespace

std::error_code lock_file(int descriptor, FileLock lock) {
  if (set(descriptor, lock == FileLock::exclusive ? F_WRLCK : F_RDLCK) == 0) return {};
  if (errno == EAGAIN || errno == EACCES) return std::make_error_code(std::errc::operation_would_block);
  return {errno, std::generic_category()};
}

void unlock_file(int descriptor) { set(descriptor, F_UNLCK); }

}  // namespace regista::process
