// SPDX-License-Identifier: MIT
#include "plugin/shared_object.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gelf.h>
#include <libelf.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <exception>
#include <memory>
#include <string_view>
#include <system_error>

#include "plugin/address_ranges.hpp"
#include "plugin/descriptor.hpp"
#include "plugin/dynamic_part.hpp"
#include "plugin/elf_file.hpp"
#include "plugin/floating_point_state.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

constexpr std::uint32_t most_descriptors = 1000;
constexpr const char* truncated = "is damaged: it ends too early";

std::string system_message(int code) { return std::generic_category().message(code); }

// Whether [offset, offset + size) is inside a file of `file_size` bytes.
bool inside(std::uint64_t offset, std::uint64_t size, std::uint64_t file_size) {
  return offset <= file_size && size <= file_size - offset;
}

// The loader maps segments without asking whether the file has them; touching what is missing kills the process.
bool complete(Elf* elf, const GElf_Ehdr& header, std::uint64_t file_size) {
  if (!inside(header.e_phoff, std::uint64_t{header.e_phnum} * header.e_phentsize, file_size)) return false;
  if (!inside(header.e_shoff, std::uint64_t{header.e_shnum} * header.e_shentsize, file_size)) return false;
  for (int i = 0; i < header.e_phnum; ++i) {
    GElf_Phdr segment;
    if (gelf_getphdr(elf, i, &segment) == nullptr) return false;
    if (segment.p_type == PT_LOAD && !inside(segment.p_offset, segment.p_filesz, file_size)) return false;
  }
  return true;
}

bool exports(Elf* elf, std::string_view wanted) {
  return std::ranges::any_of(DynamicPart(elf).symbols(), [&](const DynamicPart::Symbol& each) {
    return each.name == wanted && each.entry.st_shndx != SHN_UNDEF && GELF_ST_TYPE(each.entry.st_info) == STT_FUNC;
  });
}

constexpr const char* remedy = "build it with -fvisibility=hidden, or -fno-gnu-unique";

bool is_writable(Elf* elf, std::uint64_t address) {
  GElf_Phdr segment;
  for (int i = 0; gelf_getphdr(elf, i, &segment) != nullptr; ++i) {
    if (segment.p_type == PT_LOAD && address >= segment.p_vaddr && address - segment.p_vaddr < segment.p_memsz)
      return (segment.p_flags & PF_W) != 0;
  }
  return false;
}

// A variable of which there is one in the process, however many files have it (STB_GNU_UNIQUE): of two builds of a
// plugin the second would run with the first one's. Those of the C++ library are meant so. Empty when there is none.
std::string variable_of_all_files(Elf* elf) {
  for (const DynamicPart::Symbol& each : DynamicPart(elf).symbols()) {
    if (GELF_ST_BIND(each.entry.st_info) != STB_GNU_UNIQUE || each.entry.st_shndx == SHN_UNDEF) continue;
    const bool of_thread = GELF_ST_TYPE(each.entry.st_info) == STT_TLS;  // its value is no address
    if (!of_thread && !is_writable(elf, each.entry.st_value)) continue;
    const std::string name = readable_name(each.name.c_str());
    std::string_view of = name;
    if (constexpr std::string_view guard = "guard variable for "; of.starts_with(guard)) of.remove_prefix(guard.size());
    if (!of.starts_with("std::") && !of.starts_with("__gnu_cxx::")) return name;
  }
  return {};
}

// Why the file is no plugin, as far as that can be known without running it; empty when it may be one.
std::string why_no_plugin(const std::filesystem::path& path) {
  const OpenFile file(path);
  const int code = errno;
  if (file.number() < 0) {
    return code == ENOENT ? "does not exist" : fmt::format("cannot be read: {}", system_message(code));
  }
  struct stat about {};
  if (::fstat(file.number(), &about) != 0) return fmt::format("cannot be read: {}", system_message(errno));
  if (S_ISDIR(about.st_mode)) return "is a folder, not a shared object";
  if (!S_ISREG(about.st_mode)) return "is not a regular file";
  if (about.st_size == 0) return "is empty";
  if (elf_version(EV_CURRENT) == EV_NONE) return "cannot be checked: libelf is too old";
  const ElfFile elf(elf_begin(file.number(), ELF_C_READ, nullptr));
  GElf_Ehdr header;
  if (elf == nullptr || elf_kind(elf.get()) != ELF_K_ELF) return "is not a shared object";
  if (gelf_getehdr(elf.get(), &header) == nullptr) return truncated;
  if (header.e_type != ET_DYN) return "is not a shared object";
  if (!complete(elf.get(), header, static_cast<std::uint64_t>(about.st_size))) return truncated;
  if (!exports(elf.get(), REGISTA_ENTRY_NAME)) return "is no Regista plugin: it does not export " REGISTA_ENTRY_NAME;
  if (const std::string name = variable_of_all_files(elf.get()); !name.empty()) {
    return fmt::format("shares a variable with every other build of it that is loaded: {} (STB_GNU_UNIQUE); {}", name,
                       remedy);
  }
  return {};
}

// The loader's message, without the path that it begins with: whoever prints a refusal names the file.
std::string loader_message(const std::filesystem::path& path) {
  const char* const raw = ::dlerror();
  std::string_view text = raw != nullptr ? raw : "unknown error";
  const std::string prefix = path.string() + ": ";
  if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
  return std::string(text);
}

bool share_a_kind(const regista_descriptor& a, const regista_descriptor& b) {
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    if (implements(a, kind) && implements(b, kind)) return true;
  }
  return false;
}

// Where another object has it, two files would be one plugin. Memory of nobody's is the file's own.
bool lies_elsewhere(const void* descriptor, const void* entry) {
  Dl_info there{}, here{};
  return ::dladdr(descriptor, &there) != 0 && ::dladdr(entry, &here) != 0 && there.dli_fbase != here.dli_fbase;
}

SharedObject refuse(const std::string& reason) { return {{}, texts::one_line(reason), {}}; }

SharedObject shake_hands(decltype(&regista_plugin_entry) entry) {
  SharedObject out;
  for (std::uint32_t i = 0; i <= most_descriptors; ++i) {
    const regista_descriptor* const next = entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, i);
    if (next == nullptr) {
      if (out.descriptors.empty()) return refuse("contains no plugin");
      return out;
    }
    if (const std::string wrong = what_is_wrong(*next, i); !wrong.empty()) return refuse(wrong);
    if (lies_elsewhere(next, reinterpret_cast<const void*>(entry)))
      return refuse(fmt::format("its plugin \"{}\" lies in another file: {}", next->id, remedy));
    for (const regista_descriptor* other : out.descriptors) {
      if (std::string_view(other->id) == next->id && share_a_kind(*other, *next)) {
        return refuse(fmt::format("contains two plugins \"{}\" of the same kind", next->id));
      }
    }
    out.descriptors.push_back(next);
  }
  return refuse("its list of plugins has no end");
}

}  // namespace

SharedObject open_shared_object(const std::filesystem::path& file) {
  // Without a slash the loader would look in its own folders.
  const std::filesystem::path path = std::filesystem::absolute(file);
  if (const std::string why = why_no_plugin(path); !why.empty()) return refuse(why);
  // Start-up code of -ffast-math sets how the processor treats small numbers, for everybody.
  const FloatingPointState before = FloatingPointState::now();
  void* const handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  const std::string changed = FloatingPointState::now().changed_from(before);
  before.restore();
  if (handle == nullptr) return refuse("cannot be opened: " + loader_message(path));
  note_address_range(handle);
  void* const entry = ::dlsym(handle, REGISTA_ENTRY_NAME);
  if (entry == nullptr) return refuse("cannot be opened: " + loader_message(path));
  try {
    SharedObject out = shake_hands(reinterpret_cast<decltype(&regista_plugin_entry)>(entry));
    if (!changed.empty()) out.remark = fmt::format("{} when it was opened; that was undone", changed);
    return out;
  } catch (const std::exception& exception) {
    return refuse(fmt::format("threw while it was asked for its plugins: {}", exception.what()));
  } catch (...) {
    return refuse("threw while it was asked for its plugins");
  }
}

}  // namespace regista::plugin
