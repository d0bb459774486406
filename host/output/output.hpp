// SPDX-License-Identifier: MIT
// Writing that is not lost silently: a full disk or a reader who went away is an error, found before the program ends.
#pragma once

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace regista::output {

// what() names the target and the reason of the system.
class WriteError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What the system says of an error number.
std::string reason_of(int error);

// Nobody reads standard output any longer, as of `regista plugin list | head -1`.
class ReaderGone : public WriteError {
  using WriteError::WriteError;
};

// To be called before any file is opened: a file must not take the place of a standard stream that the program was
// started without.
void occupy_standard_streams();

// Writes all of `text` to standard output and makes sure that it left the program. Throws ReaderGone, WriteError.
void print(std::string_view text);

// A file that is written as the work goes on.
class OutputFile {
 public:
  // Creates the file, or empties it. Throws BadInput when that is not possible.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);  // throws WriteError
  void close();                       // throws WriteError; nothing may be written afterwards

 private:
  [[noreturn]] void fail() const;
  std::string name_;
  std::FILE* file_;
};

}  // namespace regista::output
