// SPDX-License-Identifier: MIT
// Checks of a plugin's file. Some checks read the file with libelf and run no code of it. Other checks open the file
// and so run its code. Format of the file: System V Application Binary Interface, "ELF".
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "check/isolation.hpp"

namespace regista::check {

// The contents of a shared object that can be read without running it.
struct ObjectFile {
  std::string wrong;  // reason why the file is not a shared object of this machine, one line; empty: nothing is wrong
  std::vector<std::string> exports;       // names of functions and data that the object offers to other objects, sorted
  std::vector<std::string> imports;       // names that the object needs from other objects, sorted, without versions
  std::vector<std::string> needs;         // names of needed libraries, such as "libm.so.6"
  std::vector<std::string> search_paths;  // folders where the loader looks first for `needs`, as written in the file
  bool text_relocations = false;          // true: the loader must change the code of the object
};

// Reads a file. Sets ObjectFile::wrong and does not throw if something is wrong with the file.
ObjectFile read_object(const std::filesystem::path& file);

// Fails if the object does not export the entry function, or exports other symbols.
Outcome exports_of(const ObjectFile& object);
// Warns if the loader must change the code of the object.
Outcome relocations_of(const ObjectFile& object);
// Warns of each library that is not on every machine. `file`: path of the object.
Outcome needs_of(const ObjectFile& object, const std::filesystem::path& file);
// Warns of each call that no sound plugin needs.
Outcome imports_of(const ObjectFile& object);

// --- Functions that open the file and so run its code. They must be called only in a child process.

// Checks that the file gives hosts of all versions the same descriptors, and that their number is `plugins`.
Outcome shake_hands(const std::filesystem::path& file, std::uint32_t plugins);
// Opens the file and does nothing else. The caller checks how the process then ends: see Ending.
Outcome open_and_no_more(const std::filesystem::path& file);

}  // namespace regista::check
