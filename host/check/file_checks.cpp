// SPDX-License-Identifier: MIT
#include "check/file_checks.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gelf.h>
#include <libelf.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <regista/abi.h>

#include "plugin/elf_file.hpp"
#include "plugin/process_state.hpp"
#include "texts/message.hpp"

namespace regista::check {
namespace {

namespace fs = std::filesystem;

#if defined(__x86_64__)
constexpr int own_machine = EM_X86_64;
#elif defined(__aarch64__)
constexpr int own_machine = EM_AARCH64;
#else
#error "name this machine"
#endif

const char* machine_name(int machine) {
  constexpr std::array<std::pair<int, const char*>, 5> names{{{EM_386, "32-bit x86"},
                                                              {EM_X86_64, "x86-64"},
                                                              {EM_ARM, "32-bit ARM"},
                                                              {EM_AARCH64, "AArch64"},
                                                              {EM_RISCV, "RISC-V"}}};
  const auto found = std::ranges::find_if(names, [machine](const auto& each) { return each.first == machine; });
  return found == names.end() ? "another machine" : found->second;
}

void read_dynamic(const plugin::DynamicPart& part, ObjectFile& out) {
  for (const plugin::DynamicPart::Symbol& symbol : part.symbols()) {
    if (symbol.name.empty() || GELF_ST_BIND(symbol.entry.st_info) == STB_LOCAL) continue;
    if (symbol.entry.st_shndx == SHN_UNDEF) {
      out.imports.push_back(symbol.name);
    } else if (symbol.entry.st_shndx != SHN_ABS) {  // version names are absolute symbols, and are left out
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

// Returns the size in bytes that a file must have to contain all parts that its headers name.
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

// Describes what is wrong with the header; empty if the file is a shared object of this machine.
std::string wrong_with_header(Elf* elf) {
  GElf_Ehdr header;
  if (elf_kind(elf) != ELF_K_ELF || gelf_getehdr(elf, &header) == nullptr) return "is not a shared object";
  if (header.e_machine != own_machine) {
    return fmt::format("is built for {}; this machine is {}", machine_name(header.e_machine),
                       machine_name(own_machine));
  }
  if (header.e_type == ET_REL) return "is an object file that has not been linked (build it with -shared)";
  if (header.e_type != ET_DYN) return "is not a shared object";
  return {};
}

// Calls that no sound plugin needs, and why. Seeds come from reset(), time from the frame; the process is the host's.
struct Suspects {
  std::string_view why;
  std::array<std::string_view, 12> names;
};
constexpr std::array suspects{
    Suspects{"chance comes from the seed of reset()",
             {"rand", "srand", "random", "srandom", "drand48", "getrandom", "getentropy", "arc4random",
              "_ZNSt13random_device9_M_getvalEv"}},
    Suspects{"time comes from the frame",
             {"time", "clock", "gettimeofday", "clock_gettime", "_ZNSt6chrono3_V212system_clock3nowEv",
              "_ZNSt6chrono3_V212steady_clock3nowEv"}},
    Suspects{"a call must not wait", {"nanosleep", "sleep", "usleep"}},
    Suspects{"the process is the host's",
             {"fork", "vfork", "system", "popen", "execve", "execl", "execlp", "execv", "execvp", "kill", "raise",
              "setsid"}},
    Suspects{"the limits of the process are the host's", {"setrlimit"}},
    Suspects{"it differs from run to run", {"getpid"}},
    Suspects{"a call must not wait", {"pause"}},
    Suspects{"handlers of signals are the host's", {"sigprocmask", "pthread_sigmask"}},
    Suspects{"how numbers are rounded is the host's", {"feenableexcept"}},
    Suspects{"the process is the host's", {"exit", "_exit"}},
    Suspects{
        "plugins start no threads",
        {"pthread_create", "_ZNSt6thread15_M_start_threadESt10unique_ptrINS_6_StateESt14default_deleteIS1_EEPFvvE"}},
    Suspects{"handlers of signals are the host's", {"signal", "sigaction"}},
    Suspects{"timers are the host's", {"setitimer", "alarm", "timer_create"}},
    Suspects{"the locale is the host's", {"setlocale"}},
    Suspects{"the working folder is the host's", {"chdir"}},
    Suspects{"how numbers are rounded is the host's", {"fesetround", "fesetenv"}},
    Suspects{"a plugin talks to its teammates through its mailbox alone", {"socket", "connect"}},
};

// Returns the C++ class of a function of the C++ library; returns other names unchanged.
std::string_view shown(std::string_view name) {
  for (const std::string_view each :
       {"std::random_device", "std::chrono::system_clock", "std::chrono::steady_clock", "std::thread"}) {
    if (name.starts_with("_Z") && name.find(each.substr(each.rfind(':') + 1)) != std::string_view::npos) return each;
  }
  return name;
}

// Libraries of the system, compilers and sanitizers, and of shipped plugins (CGAL's arithmetic), without the version.
constexpr std::array<std::string_view, 15> everywhere{"libc",     "libm",    "libstdc++", "libgcc_s",  "libpthread",
                                                      "libdl",    "librt",   "libc++",    "libc++abi", "libasan",
                                                      "libubsan", "libtsan", "liblsan",   "libgmp",    "libmpfr"};

bool is_everywhere(std::string_view library) {
  if (library.starts_with("ld-linux")) return true;  // the loader is named after the machine
  return std::ranges::find(everywhere, library.substr(0, library.find(".so"))) != everywhere.end();
}

// Returns the first search folder that has the library. A search path may name several folders, separated by ':'.
std::optional<std::string> folder_of(const std::string& library, const std::vector<std::string>& search_paths,
                                     const fs::path& file) {
  for (const std::string& path : search_paths) {
    std::istringstream folders(path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      for (const std::string_view own : {"${ORIGIN}", "$ORIGIN"}) {
        if (folder.starts_with(own)) folder.replace(0, own.size(), file.parent_path().string());
      }
      std::error_code none;
      if (!folder.empty() && fs::exists(fs::path(folder) / library, none)) return folder;
    }
  }
  return std::nullopt;
}

using Entry = decltype(&regista_plugin_entry);

Entry entry_of(const fs::path& file) {
  const auto arithmetic = plugin::FloatingPointState::now();
  void* const handle = ::dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  arithmetic.restore();  // undoes a change of the arithmetic; the check `open` reports the change
  return handle == nullptr ? nullptr : reinterpret_cast<Entry>(::dlsym(handle, REGISTA_ENTRY_NAME));
}

}  // namespace

ObjectFile read_object(const std::filesystem::path& path) {
  ObjectFile out;
  const process::FileDescriptor file = plugin::open_file(path);
  if (!file.is_open()) {
    out.wrong = fmt::format("cannot be read: {}", std::generic_category().message(errno));
    return out;
  }
  struct stat about {};
  if (::fstat(file.number, &about) != 0 || !S_ISREG(about.st_mode)) {
    out.wrong = S_ISDIR(about.st_mode) ? "is a folder, not a shared object" : "is not a regular file";
    return out;
  }
  elf_version(EV_CURRENT);
  const plugin::ElfFile elf(elf_begin(file.number, ELF_C_READ, nullptr), &elf_end);
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

Outcome exports_of(const ObjectFile& object) {
  std::vector<std::string> others = object.exports;
  if (std::erase(others, REGISTA_ENTRY_NAME) == 0) {
    return {Status::fail, {"is no Regista plugin: it does not export " REGISTA_ENTRY_NAME}};
  }
  if (others.empty()) return {};
  const std::span shown = std::span(others).first(std::min<std::size_t>(others.size(), 5));
  std::string line = fmt::format("exports {} beside " REGISTA_ENTRY_NAME ": {}",
                                 texts::plural(others.size(), "symbol", "symbols"), fmt::join(shown, ", "));
  if (shown.size() < others.size()) line += ", ...";
  return {Status::fail,
          {std::move(line),
           "others may take its symbols for their own: link it with a version script, as "
           "regista_add_plugin does"}};
}

Outcome relocations_of(const ObjectFile& object) {
  if (!object.text_relocations) return {};
  return {Status::warn, {"its code is changed when it is loaded: compile it with -fPIC"}};
}

Outcome needs_of(const ObjectFile& object, const fs::path& file) {
  if (object.needs.empty()) return {};
  Outcome out{Status::pass, {fmt::format("needs {}", fmt::join(object.needs, ", "))}};
  for (const std::string& each : object.needs) {
    if (const auto folder = folder_of(each, object.search_paths, file)) {
      out.status = Status::warn;
      out.lines.push_back(
          fmt::format("finds {} in {}, which it was built with: others do not have that folder", each, *folder));
    } else if (!is_everywhere(each)) {
      out.status = Status::warn;
      out.lines.push_back(fmt::format("{} has to be installed wherever the plugin plays: link it statically", each));
    }
  }
  return out;
}

Outcome imports_of(const ObjectFile& object) {
  Outcome out;
  for (const Suspects& each : suspects) {
    for (const std::string_view name : each.names) {
      if (!std::ranges::binary_search(object.imports, name)) continue;
      out.status = Status::warn;
      out.lines.push_back(fmt::format("calls {}: {}", shown(name), each.why));
    }
  }
  return out;
}

Outcome shake_hands(const fs::path& file, std::uint32_t plugins) {
  const Entry entry = entry_of(file);
  if (entry == nullptr) return {Status::fail, {"cannot be opened"}};
  constexpr std::uint32_t largest = ~0u;
  using Version = std::pair<std::uint32_t, std::uint32_t>;  // major, minor
  const auto own = [&](std::uint32_t index) { return entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, index); };
  for (const auto& [of_major, of_minor] :
       {Version{REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR}, Version{0, 0}, Version{1, 0}, Version{largest, largest}}) {
    const auto host = fmt::format("a host that speaks {}.{}", of_major, of_minor);
    for (std::uint32_t i = 0; i < plugins; ++i) {
      if (entry(of_major, of_minor, i) != own(i)) {
        return {Status::fail,
                {fmt::format("gives {} another answer for descriptor {}: what fits is the host's to decide", host, i)}};
      }
    }
    for (const std::uint32_t beyond : {plugins, plugins + 1, plugins + 1000, largest}) {
      if (entry(of_major, of_minor, beyond) != nullptr) {
        return {Status::fail, {fmt::format("gives {} a descriptor {} though it has {}", host, beyond, plugins)}};
      }
    }
  }
  return {};
}

Outcome open_and_no_more(const fs::path& file) {
  entry_of(file);
  return {};
}

}  // namespace regista::check
