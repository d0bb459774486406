// SPDX-License-Identifier: MIT
#include "mcap/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "mcap/checksum.hpp"
#include "mcap/error.hpp"

namespace regista::mcap {
OutputFile::OutputFile(std::filesystem::path path, bool replace) : path_(std::move(path)) {
  const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (replace ? O_TRUNC : O_EXCL);
  do {
    descriptor_ = ::open(path_.c_str(), flags, 0666);
  } while (descriptor_ < 0 && errno == EINTR);
  if (descriptor_ < 0 && errno == EEXIST) throw Error(path_, "exists already");
  if (descriptor_ < 0) throw Error(path_, "cannot be created: " + reason(errno));
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::append(std::string_view bytes) {
  throw_if_failed();
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ += bytes.size();
  checksum_ = mcap::checksum(bytes, checksum_);
}

void OutputFile::close() {
  throw_if_failed();
  // Linux closes the descriptor whatever it answers; file systems with quotas report what did not fit only here.
  const int answer = ::close(std::exchange(descriptor_, -1));
  if (answer < 0 && errno != EINTR) fail(errno);
}

void OutputFile::throw_if_failed() const {
  if (!failure_.empty()) throw Error(path_, failure_);
}

void OutputFile::fail(int error) {
  failure_ = "cannot be written: " + reason(error);
  throw Error(path_, failure_);
}

}  // namespace regista::mcap
