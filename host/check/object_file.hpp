// SPDX-License-Identifier: MIT
// What can be known of a shared object without running it: for which machine it is, what it exports, what it needs and
// calls. Read with libelf; nothing of it is executed. Format: System V Application Binary Interface, "ELF".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace regista::check {

struct ObjectFile {
  std::string wrong;  // why it is no shared object of this machine, one line; empty: it is, and the rest is known
  std::vector<std::string> exports;       // functions and data that others can link to, sorted
  std::vector<std::string> imports;       // names that it needs of others, sorted, without versions
  std::vector<std::string> needs;         // libraries, as "libm.so.6"
  std::vector<std::string> search_paths;  // where the loader is to look for these first, as they are written
  bool text_relocations = false;          // its code is changed when it is loaded
};

// Never throws for what is wrong with the file.
ObjectFile read_object(const std::filesystem::path& file);

}  // namespace regista::check
