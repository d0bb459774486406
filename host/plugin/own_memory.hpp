// SPDX-License-Identifier: MIT
// The memory that a shared object has for itself and that all instances of its plugins share: its writable segments
// less what is read-only after relocation (PT_LOAD, PT_GNU_RELRO), and the block of its thread's variables (PT_TLS).
// Format: System V Application Binary Interface, "Program Loading"; "ELF Handling For Thread-Local Storage".
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace regista::plugin {

class OwnMemory {
 public:
  // Of the object that has this address; empty when none has, and where an address sanitizer is at work.
  explicit OwnMemory(const void* inside);

  const std::filesystem::path& file() const { return file_; }  // of the object
  void remember();
  // A byte that is not what it was: its address in the file's own numbers, and whether that counts in the TLS segment.
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

// The variable there, by the file's table of symbols: "taken"; empty where it has none for it.
std::string variable_at(const std::filesystem::path& file, const OwnMemory::Change& change);

}  // namespace regista::plugin
