// SPDX-License-Identifier: MIT
// Contexts whose answers depend on what is no input of a match: the number of the process, an address, the folder. Each
// of them tells two processes apart for sure, so that a test need not be lucky.
#include <link.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <regista/context.hpp>

namespace {

// What the first process was, for the second to be another; in the folder that the variable names.
constexpr auto folder = "CHANCE_FOLDER";

// The name of a file there; empty when there is no such folder.
std::string file_of(const char* name) {
  const char* const place = std::getenv(folder);
  return place == nullptr ? std::string() : std::string(place) + '/' + name;
}

// Whether this process is another than the one that asked first.
bool is_another_one(std::uint64_t mine) {
  const std::string path = file_of("first");
  if (path.empty()) return false;
  std::FILE* file = std::fopen(path.c_str(), "r");
  unsigned long long first = 0;
  if (file != nullptr) {
    const bool read = std::fscanf(file, "%llu", &first) == 1;
    std::fclose(file);
    return read && first != mine;
  }
  file = std::fopen(path.c_str(), "w");
  std::fprintf(file, "%llu", static_cast<unsigned long long>(mine));
  std::fclose(file);
  return false;
}

template <class Source>
struct Chance {
  static constexpr auto version = "1.0.0";
  int asked = 0;
  bool other = false;
  // From its 30th answer on it depends on the process.
  bool holds(const regista::Frame&) {
    if (++asked == 30) other = is_another_one(static_cast<Source*>(this)->source());
    return !other;
  }
};

}  // namespace

struct AsksForTheProcess : Chance<AsksForTheProcess> {
  static constexpr auto id = "asks_for_the_process", summary = "Decides by the number of the process";
  std::uint64_t source() const { return static_cast<std::uint64_t>(getpid()); }
};

struct AsksForAnAddress : Chance<AsksForAnAddress> {
  static constexpr auto id = "asks_for_an_address", summary = "Decides by where it lies in memory";
  std::uint64_t source() const { return reinterpret_cast<std::uintptr_t>(this); }
};

// The second process is killed as if somebody else had done it; those that come after it tell the difference.
struct AsksForTheProcessAndIsKilled : Chance<AsksForTheProcessAndIsKilled> {
  static constexpr auto id = "asks_for_the_process_and_is_killed",
                        summary = "Decides by the number of the process; the second process is killed";
  std::uint64_t source() const { return static_cast<std::uint64_t>(getpid()); }
  bool holds(const regista::Frame& frame) {
    const bool out = Chance::holds(frame);
    if (other) {
      if (std::FILE* const file = std::fopen(file_of("killed").c_str(), "wx"); file != nullptr) {
        std::fclose(file);
        kill(getpid(), SIGKILL);
      }
    }
    return out;
  }
};

struct AsksForTheFolder {
  static constexpr auto id = "asks_for_the_folder", version = "1.0.0", summary = "Decides by the working folder";
  bool holds(const regista::Frame&) {
    std::array<char, 4096> here{};
    return getcwd(here.data(), here.size()) != nullptr && here[1] != '\0';
  }
};

// How many shared objects the process has opened: more, when other plugins are there.
struct AsksWhoElseIsThere {
  static constexpr auto id = "asks_who_else_is_there", version = "1.0.0", summary = "Decides by the number of plugins";
  bool holds(const regista::Frame&) {
    int objects = 0;
    const auto count = [](dl_phdr_info*, std::size_t, void* into) {
      ++*static_cast<int*>(into);
      return 0;
    };
    dl_iterate_phdr(count, &objects);
    return objects % 2 == 0;
  }
};

REGISTA_PLUGINS(regista::Plugin<AsksForTheProcess, regista::context>,
                regista::Plugin<AsksForAnAddress, regista::context>,
                regista::Plugin<AsksForTheProcessAndIsKilled, regista::context>,
                regista::Plugin<AsksForTheFolder, regista::context>,
                regista::Plugin<AsksWhoElseIsThere, regista::context>)
