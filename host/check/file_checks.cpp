// SPDX-License-Identifier: MIT
#include "check/file_checks.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <regista/abi.h>

#include "plugin/floating_point_state.hpp"
#include "texts/message.hpp"

namespace regista::check {
namespace {

namespace fs = std::filesystem;

// Calls that no sound plugin needs: chance comes from reset() and time from the frame, and the process is the host's.
struct Suspect {
  std::string_view name, why;
  std::string_view shown = name;  // to people
};
constexpr std::array suspects{
    Suspect{"rand", "chance comes from the seed of reset()"},
    Suspect{"srand", "chance comes from the seed of reset()"},
    Suspect{"random", "chance comes from the seed of reset()"},
    Suspect{"srandom", "chance comes from the seed of reset()"},
    Suspect{"drand48", "chance comes from the seed of reset()"},
    Suspect{"getrandom", "chance comes from the seed of reset()"},
    Suspect{"getentropy", "chance comes from the seed of reset()"},
    Suspect{"arc4random", "chance comes from the seed of reset()"},
    Suspect{"_ZNSt13random_device9_M_getvalEv", "chance comes from the seed of reset()", "std::random_device"},
    Suspect{"time", "time comes from the frame"},
    Suspect{"clock", "time comes from the frame"},
    Suspect{"gettimeofday", "time comes from the frame"},
    Suspect{"clock_gettime", "time comes from the frame"},
    Suspect{"_ZNSt6chrono3_V212system_clock3nowEv", "time comes from the frame", "std::chrono::system_clock"},
    Suspect{"_ZNSt6chrono3_V212steady_clock3nowEv", "time comes from the frame", "std::chrono::steady_clock"},
    Suspect{"nanosleep", "a call must not wait"},
    Suspect{"sleep", "a call must not wait"},
    Suspect{"usleep", "a call must not wait"},
    Suspect{"fork", "the process is the host's"},
    Suspect{"vfork", "the process is the host's"},
    Suspect{"system", "the process is the host's"},
    Suspect{"popen", "the process is the host's"},
    Suspect{"execve", "the process is the host's"},
    Suspect{"execl", "the process is the host's"},
    Suspect{"execlp", "the process is the host's"},
    Suspect{"execv", "the process is the host's"},
    Suspect{"execvp", "the process is the host's"},
    Suspect{"kill", "the process is the host's"},
    Suspect{"raise", "the process is the host's"},
    Suspect{"setsid", "the process is the host's"},
    Suspect{"setrlimit", "the limits of the process are the host's"},
    Suspect{"getpid", "it differs from run to run"},
    Suspect{"pause", "a call must not wait"},
    Suspect{"sigprocmask", "handlers of signals are the host's"},
    Suspect{"pthread_sigmask", "handlers of signals are the host's"},
    Suspect{"feenableexcept", "how numbers are rounded is the host's"},
    Suspect{"exit", "the process is the host's"},
    Suspect{"_exit", "the process is the host's"},
    Suspect{"pthread_create", "plugins start no threads"},
    Suspect{"_ZNSt6thread15_M_start_threadESt10unique_ptrINS_6_StateESt14default_deleteIS1_EEPFvvE",
            "plugins start no threads", "std::thread"},
    Suspect{"signal", "handlers of signals are the host's"},
    Suspect{"sigaction", "handlers of signals are the host's"},
    Suspect{"setitimer", "timers are the host's"},
    Suspect{"alarm", "timers are the host's"},
    Suspect{"timer_create", "timers are the host's"},
    Suspect{"setlocale", "the locale is the host's"},
    Suspect{"chdir", "the working folder is the host's"},
    Suspect{"fesetround", "how numbers are rounded is the host's"},
    Suspect{"fesetenv", "how numbers are rounded is the host's"},
    Suspect{"socket", "a plugin talks to its teammates through its mailbox alone"},
    Suspect{"connect", "a plugin talks to its teammates through its mailbox alone"},
};

// Libraries of the system, of the compilers and their sanitizers, and those that shipped plugins need as well (the
// exact arithmetic of CGAL). Without the number of their version.
constexpr std::array<std::string_view, 15> everywhere{"libc",     "libm",    "libstdc++", "libgcc_s",  "libpthread",
                                                      "libdl",    "librt",   "libc++",    "libc++abi", "libasan",
                                                      "libubsan", "libtsan", "liblsan",   "libgmp",    "libmpfr"};

bool is_everywhere(std::string_view library) {
  if (library.starts_with("ld-linux")) return true;  // the loader has the machine in its name
  return std::ranges::find(everywhere, library.substr(0, library.find(".so"))) != everywhere.end();
}

// The first of these folders that has the library. Of two that are written so, ':' stands between.
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
  arithmetic.restore();  // as the host does; it is told by the check `open`
  return handle == nullptr ? nullptr : reinterpret_cast<Entry>(::dlsym(handle, REGISTA_ENTRY_NAME));
}

}  // namespace

Outcome exports_of(const ObjectFile& object) {
  std::vector<std::string> others = object.exports;
  if (std::erase(others, REGISTA_ENTRY_NAME) == 0) {
    return {Status::fail, {"is no Regista plugin: it does not export " REGISTA_ENTRY_NAME}};
  }
  if (others.empty()) return {};
  const std::size_t shown = std::min<std::size_t>(others.size(), 5);
  std::string line =
      fmt::format("exports {} beside " REGISTA_ENTRY_NAME ": {}", texts::counted(others.size(), "symbol", "symbols"),
                  fmt::join(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < others.size()) line += ", ...";
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
  for (const Suspect& each : suspects) {
    if (!std::ranges::binary_search(object.imports, each.name)) continue;
    out.status = Status::warn;
    out.lines.push_back(fmt::format("calls {}: {}", each.shown, each.why));
  }
  return out;
}

Outcome shake_hands(const fs::path& file, std::uint32_t plugins) {
  const Entry entry = entry_of(file);
  if (entry == nullptr) return {Status::fail, {"cannot be opened"}};
  struct Version {
    std::uint32_t major, minor;
  };
  constexpr std::uint32_t largest = ~0u;
  constexpr std::array versions{Version{REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR}, Version{0, 0}, Version{1, 0},
                                Version{largest, largest}};
  const auto own = [&](std::uint32_t index) { return entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, index); };
  for (const Version& version : versions) {
    const auto host = fmt::format("a host that speaks {}.{}", version.major, version.minor);
    for (std::uint32_t i = 0; i < plugins; ++i) {
      if (entry(version.major, version.minor, i) != own(i)) {
        return {Status::fail,
                {fmt::format("gives {} another answer for descriptor {}: what fits is the host's to decide", host, i)}};
      }
    }
    for (const std::uint32_t beyond : {plugins, plugins + 1, plugins + 1000, largest}) {
      if (entry(version.major, version.minor, beyond) != nullptr) {
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
