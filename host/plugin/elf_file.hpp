// SPDX-License-Identifier: MIT
// What is needed to read a shared object with libelf: both are closed at the end.
#pragma once

#include <fcntl.h>
#include <libelf.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

namespace regista::plugin {

class OpenFile {
 public:
  // Not blocking, so that a pipe does not keep us waiting for a writer.
  explicit OpenFile(const std::filesystem::path& path)
      : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~OpenFile() {
    if (number_ >= 0) ::close(number_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

struct CloseElf {
  void operator()(Elf* elf) const { elf_end(elf); }
};
using ElfFile = std::unique_ptr<Elf, CloseElf>;

}  // namespace regista::plugin
