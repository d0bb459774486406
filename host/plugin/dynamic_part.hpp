// SPDX-License-Identifier: MIT
// The part of a shared object that the loader reads: names that it exports and imports, libraries that it needs. Found
// by its segments as the loader finds it, not by its sections, which a file need not have. Format: System V Application
// Binary Interface, "Dynamic Linking"; the table of hashes of names as in the GNU C library.
#pragma once

#include <gelf.h>
#include <libelf.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace regista::plugin {

class DynamicPart {
 public:
  // The object must live as long. What cannot be read is taken for missing.
  explicit DynamicPart(Elf* elf);

  struct Symbol {
    std::string name;
    GElf_Sym entry;
  };
  std::vector<Symbol> symbols() const;
  // Texts of all entries with this tag, in their order.
  std::vector<std::string> texts(std::int64_t tag) const;
  std::optional<std::uint64_t> value(std::int64_t tag) const;

 private:
  // That which the loader puts at this address; null where it puts nothing of the file.
  const GElf_Phdr* segment_of(std::uint64_t address) const;
  // Of the file, from this address to the end of its segment.
  std::uint64_t bytes_from(std::uint64_t address) const;
  // So many elements from an address on; null where the file has fewer.
  Elf_Data* elements(std::uint64_t address, std::uint64_t count, std::uint64_t size, Elf_Type type) const;
  std::optional<std::uint32_t> word(std::uint64_t address) const;
  std::uint64_t symbol_count() const;
  std::string text_at(std::uint64_t offset) const;

  Elf* elf_;
  std::vector<GElf_Phdr> loaded_;
  std::vector<GElf_Dyn> entries_;
  Elf_Data* strings_ = nullptr;
};

// A name of the linker's as a programmer writes it: "Table<int>::taken".
std::string readable_name(const char* name);

}  // namespace regista::plugin
