// SPDX-License-Identifier: MIT
#include "output/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "config/bad_input.hpp"

namespace regista::output {
namespace {}  // namespace

std::string reason_of(int error) { return std::generic_category().message(error); }

void occupy_standard_streams() {
  // Readable, so that writing to it fails as writing to a closed one does.
  for (int expected = STDIN_FILENO; expected <= STDERR_FILENO; ++expected) {
    if (fcntl(expected, F_GETFD) == -1) open("/dev/null", O_RDONLY);  // takes the lowest free number: this one
  }
}

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    const int error = errno;
    const std::string message = fmt::format("cannot write to standard output: {}", reason_of(error));
    if (error == EPIPE) throw ReaderGone(message);
    throw WriteError(message);
  }
}

OutputFile::OutputFile(const std::filesystem::path& path)
    : name_(path.string()), file_(std::fopen(path.c_str(), "wb")) {
  if (file_ == nullptr) throw config::BadInput(fmt::format("cannot write {}: {}", name_, reason_of(errno)));
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail();
}

void OutputFile::close() {
  std::FILE* const file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0) fail();
}

void OutputFile::fail() const { throw WriteError(fmt::format("cannot write to {}: {}", name_, reason_of(errno))); }

}  // namespace regista::output
