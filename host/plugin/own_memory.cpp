// SPDX-License-Identifier: MIT
#include "plugin/own_memory.hpp"

#include <gelf.h>
#include <libelf.h>
#include <link.h>

#include <algorithm>
#include <cstring>

#include "plugin/dynamic_part.hpp"
#include "plugin/elf_file.hpp"
#include "process/sanitized.hpp"

namespace regista::plugin {
namespace {

struct Interval {
  std::uintptr_t begin = 0, end = 0;
};

}  // namespace

OwnMemory::OwnMemory(const void* inside) {
  if (addresses_are_reserved()) return;  // a sanitizer keeps what is its own there, and lets nobody look at it
  struct Wanted {
    std::uintptr_t address;
    std::vector<Part>* out;
    std::filesystem::path* file;
  } wanted{reinterpret_cast<std::uintptr_t>(inside), &parts_, &file_};
  const auto look = [](dl_phdr_info* object, std::size_t, void* raw) -> int {
    const auto& want = *static_cast<const Wanted*>(raw);
    std::vector<Interval> writable;
    Interval relro;
    bool is_it = false;
    for (int i = 0; i < object->dlpi_phnum; ++i) {
      const ElfW(Phdr)& segment = object->dlpi_phdr[i];
      const Interval at{object->dlpi_addr + segment.p_vaddr, object->dlpi_addr + segment.p_vaddr + segment.p_memsz};
      if (segment.p_type == PT_LOAD) is_it |= want.address >= at.begin && want.address < at.end;
      if (segment.p_type == PT_LOAD && (segment.p_flags & PF_W) != 0) writable.push_back(at);
      if (segment.p_type == PT_GNU_RELRO) relro = at;
      if (segment.p_type == PT_TLS && object->dlpi_tls_data != nullptr)
        want.out->push_back({static_cast<const std::byte*>(object->dlpi_tls_data), segment.p_memsz, 0, true});
    }
    if (!is_it) {
      want.out->clear();
      return 0;
    }
    *want.file = object->dlpi_name;
    // What is behind the end of the read-only part on its last page stays writable, and belongs to nobody.
    const auto add = [&](Interval part) {
      if (part.begin < part.end)
        want.out->push_back({reinterpret_cast<const std::byte*>(part.begin), part.end - part.begin,
                             part.begin - object->dlpi_addr, false});
    };
    for (const Interval& each : writable) {
      add({each.begin, std::min(each.end, std::max(each.begin, relro.begin))});
      add({std::max(each.begin, std::min(each.end, relro.end)), each.end});
    }
    return 1;
  };
  if (dl_iterate_phdr(look, &wanted) == 0) parts_.clear();
}

void OwnMemory::remember() {
  remembered_.clear();
  for (const Part& part : parts_) remembered_.insert(remembered_.end(), part.begin, part.begin + part.size);
}

std::optional<OwnMemory::Change> OwnMemory::change() const {
  const std::byte* was = remembered_.data();
  for (const Part& part : parts_) {
    if (std::memcmp(was, part.begin, part.size) != 0) {
      const std::byte* const at = std::mismatch(was, was + part.size, part.begin).second;
      return Change{part.address + static_cast<std::uint64_t>(at - part.begin), part.of_thread};
    }
    was += part.size;
  }
  return std::nullopt;
}

std::string variable_at(const std::filesystem::path& path, const OwnMemory::Change& change) {
  const OpenFile file(path);
  if (file.number() < 0 || elf_version(EV_CURRENT) == EV_NONE) return {};
  const ElfFile elf(elf_begin(file.number(), ELF_C_READ, nullptr));
  if (elf == nullptr) return {};
  for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf.get(), section)) != nullptr;) {
    GElf_Shdr header;
    if (gelf_getshdr(section, &header) == nullptr || header.sh_entsize == 0) continue;
    if (header.sh_type != SHT_SYMTAB && header.sh_type != SHT_DYNSYM) continue;
    Elf_Data* const data = elf_getdata(section, nullptr);
    for (std::uint64_t i = 0; data != nullptr && i < header.sh_size / header.sh_entsize; ++i) {
      GElf_Sym symbol;
      if (gelf_getsym(data, static_cast<int>(i), &symbol) == nullptr) break;
      if (GELF_ST_TYPE(symbol.st_info) != (change.of_thread ? STT_TLS : STT_OBJECT)) continue;
      if (change.address < symbol.st_value || change.address - symbol.st_value >= symbol.st_size) continue;
      const char* const name = elf_strptr(elf.get(), header.sh_link, symbol.st_name);
      if (name != nullptr) return readable_name(name);
    }
  }
  return {};
}

}  // namespace regista::plugin
