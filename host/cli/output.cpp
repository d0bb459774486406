// SPDX-License-Identifier: MIT
#include "cli/output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "cli/end_of_program.hpp"

namespace regista::cli {
namespace {

std::string reason_of(int error) { return std::generic_category().message(error); }

}  // namespace

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw WriteError(fmt::format("cannot write to standard output: {}", reason_of(errno)));
  }
}

OutputFile::OutputFile(const std::filesystem::path& path)
    : name_(path.string()), file_(std::fopen(path.c_str(), "wb")) {
  if (file_ == nullptr) throw BadInput(fmt::format("cannot write {}: {}", name_, reason_of(errno)));
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

void OutputFile::fail() const { throw WriteError(fmt::format("cannot write {}: {}", name_, reason_of(errno))); }

}  // namespace regista::cli
