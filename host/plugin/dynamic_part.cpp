// SPDX-License-Identifier: MIT
#include "plugin/dynamic_part.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace regista::plugin {

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

// Only the tables of hashes tell it.
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
  std::uint32_t last = 0;  // the symbol with which the last chain begins
  for (std::uint64_t i = 0; i < buckets; ++i) {
    std::uint32_t head;
    std::memcpy(&head, static_cast<const char*>(heads->d_buf) + i * word_size, sizeof head);
    last = std::max(last, head);
  }
  if (last < first) return first;  // it exports nothing
  const std::uint64_t chain = bucket + (buckets + last - first) * word_size;
  const std::uint64_t most = bytes_from(chain) / word_size;
  Elf_Data* const hashes = elements(chain, most, word_size, ELF_T_WORD);
  for (std::uint64_t i = 0; hashes != nullptr && i < most; ++i) {
    std::uint32_t hash;
    std::memcpy(&hash, static_cast<const char*>(hashes->d_buf) + i * word_size, sizeof hash);
    if ((hash & 1) != 0) return last + i + 1;  // the end of the chain
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

}  // namespace regista::plugin
