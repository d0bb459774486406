// SPDX-License-Identifier: MIT
// Contexts whose answers depend on what is no input of a match: the number of the process, an address, the folder.
#include <link.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>

#include <regista/context.hpp>

namespace {

// All bits depend on all bits of the source (the finaliser of SplitMix64).
std::uint64_t mixed(std::uint64_t source) {
  source = (source ^ source >> 30) * 0xbf58476d1ce4e5b9u;
  source = (source ^ source >> 27) * 0x94d049bb133111ebu;
  return source ^ source >> 31;
}

// From its 30th answer on the source decides, bit by bit: two that differ answer otherwise before long.
template <class Source>
struct Chance {
  static constexpr auto version = "1.0.0";
  int asked = 0;
  std::uint64_t drawn = 0;
  bool holds(const regista::Frame&) {
    if (++asked < 30) return true;
    if (asked == 30) drawn = mixed(static_cast<Source*>(this)->source());
    return (drawn >> (asked % 64) & 1) == 0;
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

// A robot that is alone in its process is killed as if somebody else had done it.
struct AsksForTheProcessAndIsKilled : Chance<AsksForTheProcessAndIsKilled> {
  static constexpr auto id = "asks_for_the_process_and_is_killed",
                        summary = "Decides by the number of the process; who is alone in one is killed";
  static inline int robots = 0;
  void reset(std::uint64_t) { ++robots; }
  std::uint64_t source() const { return static_cast<std::uint64_t>(getpid()); }
  bool holds(const regista::Frame& frame) {
    if (asked == 20 && robots == 1) kill(getpid(), SIGKILL);
    return Chance::holds(frame);
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

// Whether any opponent is known, of which it does not say that it reads them.
struct ReadsMoreThanItSays {
  static constexpr auto id = "reads_more_than_it_says", version = "1.0.0", summary = "Declares to read nothing";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  bool holds(const regista::Frame& frame) { return frame.raw().mine->opponents.count == 0; }
};

REGISTA_PLUGINS(regista::Plugin<ReadsMoreThanItSays, regista::context>,
                regista::Plugin<AsksForTheProcess, regista::context>,
                regista::Plugin<AsksForAnAddress, regista::context>,
                regista::Plugin<AsksForTheProcessAndIsKilled, regista::context>,
                regista::Plugin<AsksForTheFolder, regista::context>,
                regista::Plugin<AsksWhoElseIsThere, regista::context>)
