// SPDX-License-Identifier: MIT
// Reads shared objects, as files and in memory, with libelf. Formats: System V ABI, "Dynamic Linking" and "Program
// Loading"; the GNU hash table of symbol names as in the GNU C library; "ELF Handling For Thread-Local Storage".
#pragma once

#include <fcntl.h>
#include <gelf.h>
#include <libelf.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/file_descriptor.hpp"

namespace regista::plugin {

// Opens a file for reading. Does not block, so that a pipe without a writer does not make the host wait.
inline process::FileDescriptor open_file(const std::filesystem::path& path) {
  return process::FileDescriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
}

using ElfFile = std::unique_ptr<Elf, decltype(&elf_end)>;

// The part of a shared object that the loader reads: exported and imported names, and needed libraries. This class
// finds the part by the segments, as the loader does, because a file may have no sections.
class DynamicPart {
 public:
  // `elf` must outlive this object. Unreadable data are treated as missing data.
  explicit DynamicPart(Elf* elf);

  struct Symbol {
    std::string name;
    GElf_Sym entry;
  };
  std::vector<Symbol> symbols() const;
  // texts() returns the texts of all entries of the dynamic section with this tag (DT_*), in file order. value()
  // returns the value of the first entry with this tag.
  std::vector<std::string> texts(std::int64_t tag) const;
  std::optional<std::uint64_t> value(std::int64_t tag) const;

 private:
  // Returns the segment that the loader puts at this address; null if there is none.
  const GElf_Phdr* segment_of(std::uint64_t address) const;
  // Counts the bytes from this address to the end of its segment in the file.
  std::uint64_t bytes_from(std::uint64_t address) const;
  // Reads `count` elements of `size` bytes from this address on; null if the segment has fewer elements.
  Elf_Data* elements(std::uint64_t address, std::uint64_t count, std::uint64_t size, Elf_Type type) const;
  std::optional<std::uint32_t> word(std::uint64_t address) const;
  std::uint64_t symbol_count() const;
  std::string text_at(std::uint64_t offset) const;

  Elf* elf_;
  std::vector<GElf_Phdr> loaded_;
  std::vector<GElf_Dyn> entries_;
  Elf_Data* strings_ = nullptr;
};

// Converts a name of a symbol table into the name in the source code, such as "Table<int>::taken".
std::string readable_name(const char* name);

// The writable memory of a shared object, which all instances of its plugins share: the writable segments (PT_LOAD),
// without the part that becomes read-only after relocation (PT_GNU_RELRO), and the thread's variables (PT_TLS).
class OwnMemory {
 public:
  // Finds the memory of the object that contains this address; nothing without such an object or under a sanitizer.
  explicit OwnMemory(const void* inside);

  const std::filesystem::path& file() const { return file_; }  // file of the object
  // Stores the current content of the memory. change() compares the memory with it.
  void remember();
  // A byte that has changed since remember(): virtual address in the ELF file; whether its variable is thread-local.
  struct Change {
    std::uint64_t address = 0;
    bool of_thread = false;
  };
  std::optional<Change> change() const;

 private:
  struct Part {
    const std::byte* begin;
    std::size_t size;
    std::uint64_t address;
    bool of_thread;
  };
  std::filesystem::path file_;
  std::vector<Part> parts_;
  std::vector<std::byte> remembered_;
};

// Returns the name of the changed variable, such as "taken". Empty if the file's symbol table has no name for it.
std::string variable_at(const std::filesystem::path& file, const OwnMemory::Change& change);

}  // namespace regista::plugin
