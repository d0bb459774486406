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
#include <memory>
#include <system_error>

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

void read_symbols(Elf* elf, Elf_Scn* section, const GElf_Shdr& header, ObjectFile& out) {
  Elf_Data* const data = elf_getdata(section, nullptr);
  if (data == nullptr || header.sh_entsize == 0) return;
  const int count = static_cast<int>(header.sh_size / header.sh_entsize);
  for (int i = 0; i < count; ++i) {
    GElf_Sym symbol;
    if (gelf_getsym(data, i, &symbol) == nullptr) return;
    const int binding = GELF_ST_BIND(symbol.st_info);
    const char* const name = elf_strptr(elf, header.sh_link, symbol.st_name);
    if (name == nullptr || *name == '\0' || binding == STB_LOCAL) continue;
    if (symbol.st_shndx == SHN_UNDEF) {
      out.imports.emplace_back(name);
    } else if (symbol.st_shndx != SHN_ABS) {  // absolute ones are names of versions
      out.exports.emplace_back(name);
    }
  }
}

void read_dynamic(Elf* elf, Elf_Scn* section, const GElf_Shdr& header, ObjectFile& out) {
  Elf_Data* const data = elf_getdata(section, nullptr);
  if (data == nullptr || header.sh_entsize == 0) return;
  const int count = static_cast<int>(header.sh_size / header.sh_entsize);
  for (int i = 0; i < count; ++i) {
    GElf_Dyn entry;
    if (gelf_getdyn(data, i, &entry) == nullptr || entry.d_tag == DT_NULL) return;
    if (entry.d_tag == DT_NEEDED) {
      if (const char* const name = elf_strptr(elf, header.sh_link, entry.d_un.d_val)) out.needs.emplace_back(name);
    }
    if (entry.d_tag == DT_TEXTREL || (entry.d_tag == DT_FLAGS && (entry.d_un.d_val & DF_TEXTREL) != 0)) {
      out.text_relocations = true;
    }
  }
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
  for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf.get(), section)) != nullptr;) {
    GElf_Shdr header;
    if (gelf_getshdr(section, &header) == nullptr) continue;
    if (header.sh_type == SHT_DYNSYM) read_symbols(elf.get(), section, header, out);
    if (header.sh_type == SHT_DYNAMIC) read_dynamic(elf.get(), section, header, out);
  }
  std::ranges::sort(out.exports);
  std::ranges::sort(out.imports);
  return out;
}

}  // namespace regista::check
