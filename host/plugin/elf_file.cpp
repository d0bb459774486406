// SPDX-License-Identifier: MIT
#include "plugin/elf_file.hpp"

#include <cxxabi.h>
#include <link.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "process/sanitized.hpp"

namespace regista::plugin {
namespace {

struct Interval {
  std::uintptr_t begin = 0, end = 0;
};

}  // namespace

DynamicPart::DynamicPart(Elf* elf) : elf_(elf) {
  std::size_t count = 0;
  if (elf_getphdrnum(elf, &count) != 0) return;
  std::optional<GElf_Phdr> dynamic;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    GElf_Phdr segment;
    if (gelf_getphdr(elf, i, &segment) == nullptr) return;
    if (segment.p_type == PT_LOAD) loaded_.push_back(segment);
    if (segment.p_type == PT_DYNAMIC) dynamic = segment;
  }
  if (!dynamic) return;
  Elf_Data* const data = elf_getdata_rawchunk(elf, static_cast<std::int64_t>(dynamic->p_offset),
                                              static_cast<std::size_t>(dynamic->p_filesz), ELF_T_DYN);
  GElf_Dyn entry;
  for (int i = 0; data != nullptr && gelf_getdyn(data, i, &entry) != nullptr && entry.d_tag != DT_NULL; ++i) {
    entries_.push_back(entry);
  }
  strings_ = elements(value(DT_STRTAB).value_or(0), value(DT_STRSZ).value_or(0), 1, ELF_T_BYTE);
}

std::vector<DynamicPart::Symbol> DynamicPart::symbols() const {
  std::vector<Symbol> out;
  const std::uint64_t count = symbol_count();
  const std::size_t size = gelf_fsize(elf_, ELF_T_SYM, 1, EV_CURRENT);
  Elf_Data* const data = elements(value(DT_SYMTAB).value_or(0), count, size, ELF_T_SYM);
  for (std::uint64_t i = 0; data != nullptr && i < count; ++i) {
    Symbol symbol{{}, {}};
    if (gelf_getsym(data, static_cast<int>(i), &symbol.entry) == nullptr) break;
    symbol.name = text_at(symbol.entry.st_name);
    out.push_back(std::move(symbol));
  }
  return out;
}

std::vector<std::string> DynamicPart::texts(std::int64_t tag) const {
  std::vector<std::string> out;
  for (const GElf_Dyn& each : entries_) {
    if (each.d_tag == tag) out.push_back(text_at(each.d_un.d_val));
  }
  return out;
}

std::optional<std::uint64_t> DynamicPart::value(std::int64_t tag) const {
  const auto found = std::ranges::find(entries_, tag, &GElf_Dyn::d_tag);
  if (found == entries_.end()) return std::nullopt;
  return found->d_un.d_val;
}

const GElf_Phdr* DynamicPart::segment_of(std::uint64_t address) const {
  const auto found = std::ranges::find_if(loaded_, [address](const GElf_Phdr& each) {
    return address >= each.p_vaddr && address - each.p_vaddr < each.p_filesz;
  });
  return found == loaded_.end() ? nullptr : &*found;
}

std::uint64_t DynamicPart::bytes_from(std::uint64_t address) const {
  const GElf_Phdr* const segment = segment_of(address);
  return segment == nullptr ? 0 : segment->p_filesz - (address - segment->p_vaddr);
}

Elf_Data* DynamicPart::elements(std::uint64_t address, std::uint64_t count, std::uint64_t size, Elf_Type type) const {
  if (count == 0 || count > bytes_from(address) / size) return nullptr;
  const GElf_Phdr* const segment = segment_of(address);
  const std::uint64_t offset = segment->p_offset + (address - segment->p_vaddr);
  return elf_getdata_rawchunk(elf_, static_cast<std::int64_t>(offset), static_cast<std::size_t>(count * size), type);
}

std::optional<std::uint32_t> DynamicPart::word(std::uint64_t address) const {
  const Elf_Data* const data = elements(address, 1, sizeof(std::uint32_t), ELF_T_WORD);
  if (data == nullptr) return std::nullopt;
  std::uint32_t out;
  std::memcpy(&out, data->d_buf, sizeof out);
  return out;
}

// Computes the number of symbols from a hash table, because no other part of the file has this number.
std::uint64_t DynamicPart::symbol_count() const {
  constexpr std::uint64_t word_size = sizeof(std::uint32_t);
  if (const auto table = value(DT_HASH)) return word(*table + word_size).value_or(0);
  const auto table = value(DT_GNU_HASH);
  if (!table) return 0;
  const std::uint64_t buckets = word(*table).value_or(0), first = word(*table + word_size).value_or(0);
  const std::uint64_t filter = std::uint64_t{word(*table + 2 * word_size).value_or(0)} * sizeof(std::uint64_t);
  const std::uint64_t bucket = *table + 4 * word_size + filter;
  Elf_Data* const heads = elements(bucket, buckets, word_size, ELF_T_WORD);
  if (heads == nullptr) return first;
  std::uint32_t last = 0;  // first symbol of the last chain
  for (std::uint64_t i = 0; i < buckets; ++i) {
    std::uint32_t head;
    std::memcpy(&head, static_cast<const char*>(heads->d_buf) + i * word_size, sizeof head);
    last = std::max(last, head);
  }
  if (last < first) return first;  // the object exports no symbol
  const std::uint64_t chain = bucket + (buckets + last - first) * word_size;
  const std::uint64_t most = bytes_from(chain) / word_size;
  Elf_Data* const hashes = elements(chain, most, word_size, ELF_T_WORD);
  for (std::uint64_t i = 0; hashes != nullptr && i < most; ++i) {
    std::uint32_t hash;
    std::memcpy(&hash, static_cast<const char*>(hashes->d_buf) + i * word_size, sizeof hash);
    if ((hash & 1) != 0) return last + i + 1;  // end of the chain
  }
  return 0;
}

std::string DynamicPart::text_at(std::uint64_t offset) const {
  if (strings_ == nullptr || offset >= strings_->d_size) return {};
  const char* const begin = static_cast<const char*>(strings_->d_buf) + offset;
  return {begin, ::strnlen(begin, strings_->d_size - static_cast<std::size_t>(offset))};
}

std::string readable_name(const char* name) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> demangled(abi::__cxa_demangle(name, nullptr, nullptr, &status),
                                                              &std::free);
  return status == 0 && demangled ? demangled.get() : name;
}

OwnMemory::OwnMemory(const void* inside) {
  if (addresses_are_reserved()) return;  // a sanitizer has data in this memory that the host must not read
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
    // Leaves out the rest of the last read-only page. This rest stays writable, but belongs to no variable.
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
  const process::FileDescriptor file = open_file(path);
  if (!file.is_open() || elf_version(EV_CURRENT) == EV_NONE) return {};
  const ElfFile elf(elf_begin(file.number, ELF_C_READ, nullptr), &elf_end);
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
