// SPDX-License-Identifier: MIT
#include "mcap/file_io.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <utility>

namespace regista::mcap {

Descriptor::~Descriptor() {
  if (number >= 0) ::close(number);
}

InputFile::InputFile(std::filesystem::path path) : path_(std::move(path)) {
  // O_NONBLOCK is set, because otherwise the opening of a pipe without a writer would wait forever.
  descriptor_.number = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat about {};
  if (descriptor_.number < 0 || ::fstat(descriptor_.number, &about) != 0)
    throw Error(path_, "cannot be opened: " + reason(errno));
  if (!S_ISREG(about.st_mode))
    throw Error(path_, S_ISDIR(about.st_mode) ? "is a folder, not a recording" : "is not a regular file");
  size_ = static_cast<std::uint64_t>(about.st_size);
}

void InputFile::read(std::uint64_t offset, std::size_t count, std::string& to) const {
  assert(offset <= size_ && count <= size_ - offset);
  to.resize(count);
  for (std::size_t done = 0; done < count;) {
    const ssize_t got = ::pread(descriptor_.number, to.data() + done, count - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error(path_, "cannot be read: " + reason(errno));
    if (got == 0) throw Error(path_, "has become shorter while it was read");
    done += static_cast<std::size_t>(got);
  }
}

OutputFile::OutputFile(std::filesystem::path path, bool replace) : path_(std::move(path)) {
  const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (replace ? O_TRUNC : O_EXCL);
  do {
    descriptor_.number = ::open(path_.c_str(), flags, 0666);
  } while (descriptor_.number < 0 && errno == EINTR);
  if (descriptor_.number < 0 && errno == EEXIST) throw Error(path_, "exists already");
  if (descriptor_.number < 0) throw Error(path_, "cannot be created: " + reason(errno));
}

void OutputFile::append(std::string_view bytes) {
  throw_if_failed();
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t written = ::write(descriptor_.number, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ += bytes.size();
  checksum_ = mcap::checksum(bytes, checksum_);
}

void OutputFile::close() {
  throw_if_failed();
  // Linux closes the descriptor even if close() fails. File systems with quotas report only here that data did not fit.
  const int answer = ::close(std::exchange(descriptor_.number, -1));
  if (answer < 0 && errno != EINTR) fail(errno);
}

void OutputFile::throw_if_failed() const {
  if (!failure_.empty()) throw Error(path_, failure_);
}

void OutputFile::fail(int error) {
  failure_ = "cannot be written: " + reason(error);
  throw Error(path_, failure_);
}

std::optional<RecordPlace> RecordWalk::next() {
  if (file_->size() - offset_ < record_prefix) return std::nullopt;
  file_->read(offset_, record_prefix, prefix_);
  Decoder in(prefix_);
  RecordPlace place;
  in(place.opcode, place.content);
  place.offset = offset_;
  if (place.content > file_->size() - offset_ - record_prefix) return std::nullopt;
  offset_ += place.length();
  return place;
}

}  // namespace regista::mcap
