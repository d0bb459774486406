// SPDX-License-Identifier: MIT
#include "mcap/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

#include "mcap/error.hpp"

namespace regista::mcap {
InputFile::InputFile(std::filesystem::path path) : path_(std::move(path)) {
  // O_NONBLOCK: a pipe without a writer would wait for ever.
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) throw Error(path_, "cannot be opened: " + reason(errno));
  struct stat about {};
  const int answer = ::fstat(descriptor_, &about);
  const int error = errno;
  const bool is_regular = answer == 0 && S_ISREG(about.st_mode);
  if (is_regular) {
    size_ = static_cast<std::uint64_t>(about.st_size);
    return;
  }
  ::close(std::exchange(descriptor_, -1));
  if (answer != 0) throw Error(path_, "cannot be opened: " + reason(error));
  throw Error(path_, S_ISDIR(about.st_mode) ? "is a folder, not a recording" : "is not a regular file");
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void InputFile::read(std::uint64_t offset, std::size_t count, std::string& to) const {
  assert(offset <= size_ && count <= size_ - offset);
  to.resize(count);
  for (std::size_t done = 0; done < count;) {
    const ssize_t got = ::pread(descriptor_, to.data() + done, count - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error(path_, "cannot be read: " + reason(errno));
    if (got == 0) throw Error(path_, "has become shorter while it was read");
    done += static_cast<std::size_t>(got);
  }
}

}  // namespace regista::mcap
