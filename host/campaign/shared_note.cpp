// SPDX-License-Identifier: MIT
#include "campaign/shared_note.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>

namespace regista::campaign {
namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

}  // namespace

SharedNote::SharedNote() : descriptor_(memfd_create("regista-note", MFD_CLOEXEC)) {
  if (descriptor_ == -1) fail("cannot make shared memory");
  if (ftruncate(descriptor_, sizeof(WorkerNote)) == -1) {
    close(descriptor_);
    fail("cannot make shared memory");
  }
  map();
  std::construct_at(note_);
}

SharedNote::SharedNote(int descriptor) : descriptor_(descriptor) {
  struct stat status {};
  // Nothing but memory is written to, and a page that is too short would be a signal at the first note.
  if (fcntl(descriptor, F_GET_SEALS) == -1 || fstat(descriptor, &status) == -1 ||
      status.st_size < static_cast<off_t>(sizeof(WorkerNote))) {
    errno = EBADF;
    fail("no shared memory was handed over");
  }
  map();
}

void SharedNote::map() {
  void* const memory = mmap(nullptr, sizeof(WorkerNote), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0);
  if (memory == MAP_FAILED) fail("cannot map shared memory");
  note_ = static_cast<WorkerNote*>(memory);
}

SharedNote::SharedNote(SharedNote&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), note_(std::exchange(other.note_, nullptr)) {}

SharedNote::~SharedNote() {
  if (note_ != nullptr) munmap(note_, sizeof(WorkerNote));
  if (descriptor_ != -1) close(descriptor_);
}

}  // namespace regista::campaign
