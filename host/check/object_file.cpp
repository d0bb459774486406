// SPDX-License-Identifier: MIT
#include "check/object_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gelf.h>
#include <libelf.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <system_error>

#include "plugin/dynamic_part.hpp"
#include "plugin/elf_file.hpp"

namespace regista::check {
namespace {

#if defined(__x86_64__)
constexpr int own_machine = EM_X86_64;
constexpr auto own_machine_name = "x86-64";
#elif defined(__aarch64__)
constexpr int own_machine = EM_AARCH64;
constexpr auto own_machine_name = "AArch64";
#else
#error "name this machine"
#endif

const char* machine_name(int machine) {
  switch (machine) {
    case EM_386:
      return "32-bit x86";
    case EM_X86_64:
      return "x86-64";
    case EM_ARM:
      return "32-bit ARM";
    case EM_AARCH64:
      return "AArch64";
    case EM_RISCV:
      return "RISC-V";
    default:
      return "another machine";
  }
}

void read_dynamic(const plugin::DynamicPart& part, ObjectFile& out) {
  for (const plugin::DynamicPart::Symbol& symbol : part.symbols()) {
    if (symbol.name.empty() || GELF_ST_BIND(symbol.entry.st_info) == STB_LOCAL) continue;
    if (symbol.entry.st_shndx == SHN_UNDEF) {
      out.imports.push_back(symbol.name);
    } else if (symbol.entry.st_shndx != SHN_ABS) {  // absolute ones are names of versions
      out.exports.push_back(symbol.name);
    }
  }
  std::ranges::sort(out.exports);
  std::ranges::sort(out.imports);
  out.needs = part.texts(DT_NEEDED);
  for (const std::int64_t tag : {DT_RPATH, DT_RUNPATH}) {
    for (const std::string& each : part.texts(tag)) out.search_paths.push_back(each);
  }
  out.text_relocations = part.value(DT_TEXTREL).has_value() || (part.value(DT_FLAGS).value_or(0) & DF_TEXTREL) != 0;
}

// How many bytes the file must have for all that its headers speak of.
std::uint64_t bytes_spoken_of(Elf* elf) {
  std::uint64_t out = 0;
  const auto reach = [&out](std::uint64_t offset, std::uint64_t length) {
    const std::uint64_t most = ~std::uint64_t{0};
    out = std::max(out, length > most - offset ? most : offset + length);
  };
  GElf_Ehdr header;
  if (gelf_getehdr(elf, &header) == nullptr) return 0;
  reach(header.e_shoff, std::uint64_t{header.e_shnum} * header.e_shentsize);
  reach(header.e_phoff, std::uint64_t{header.e_phnum} * header.e_phentsize);
  GElf_Phdr segment;
  for (int i = 0; i < header.e_phnum && gelf_getphdr(elf, i, &segment) != nullptr; ++i) {
    reach(segment.p_offset, segment.p_filesz);
  }
  for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf, section)) != nullptr;) {
    GElf_Shdr part;
    if (gelf_getshdr(section, &part) != nullptr && part.sh_type != SHT_NOBITS) reach(part.sh_offset, part.sh_size);
  }
  return out;
}

// What stands at its beginning; empty when this is a shared object of this machine.
std::string wrong_with_header(Elf* elf) {
  GElf_Ehdr header;
  if (elf_kind(elf) != ELF_K_ELF || gelf_getehdr(elf, &header) == nullptr) return "is not a shared object";
  if (header.e_machine != own_machine) {
    return fmt::format("is built for {}; this machine is {}", machine_name(header.e_machine), own_machine_name);
  }
  if (header.e_type == ET_REL) return "is an object file that has not been linked (build it with -shared)";
  if (header.e_type != ET_DYN) return "is not a shared object";
  return {};
}

}  // namespace

ObjectFile read_object(const std::filesystem::path& path) {
  ObjectFile out;
  const plugin::OpenFile file(path);
  if (file.number() < 0) {
    out.wrong = fmt::format("cannot be read: {}", std::generic_category().message(errno));
    return out;
  }
  struct stat about {};
  if (::fstat(file.number(), &about) != 0 || !S_ISREG(about.st_mode)) {
    out.wrong = S_ISDIR(about.st_mode) ? "is a folder, not a shared object" : "is not a regular file";
    return out;
  }
  elf_version(EV_CURRENT);
  const plugin::ElfFile elf(elf_begin(file.number(), ELF_C_READ, nullptr));
  out.wrong = elf == nullptr ? "is not a shared object" : wrong_with_header(elf.get());
  if (!out.wrong.empty()) return out;
  const auto bytes = static_cast<std::uint64_t>(about.st_size);
  if (const std::uint64_t spoken_of = bytes_spoken_of(elf.get()); spoken_of > bytes) {
    out.wrong = fmt::format("is cut off: its header speaks of {} bytes, it has {}", spoken_of, bytes);
    return out;
  }
  read_dynamic(plugin::DynamicPart(elf.get()), out);
  return out;
}

}  // namespace regista::check
