// SPDX-License-Identifier: MIT
// Plugins that reach for what is not theirs.
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <thread>

#include <regista/context.hpp>
#include <regista/sender.hpp>

namespace {

// Calls act(begin, end) for each part of memory that this process shares with others and may write.
template <class Act>
void each_shared(const char* named, Act act) {
  std::FILE* const maps = std::fopen("/proc/self/maps", "r");
  char line[512];
  while (maps != nullptr && std::fgets(line, sizeof line, maps) != nullptr) {
    unsigned long begin = 0, end = 0;
    char rights[8] = {};
    if (std::sscanf(line, "%lx-%lx %7s", &begin, &end, rights) != 3 || std::strcmp(rights, "rw-s") != 0) continue;
    if (std::strstr(line, named) != nullptr) act(reinterpret_cast<char*>(begin), reinterpret_cast<char*>(end));
  }
  if (maps != nullptr) std::fclose(maps);
}

}  // namespace

// A thread of it writes zeros to all memory that other processes may see, again and again.
struct WipesSharedMemory {
  static constexpr auto id = "wipes_shared_memory", version = "1.0.0",
                        summary = "Its thread wipes what it shares with other processes";
  int asked = 0;
  bool holds(const regista::Frame&) {
    static bool started = false;
    if (++asked != 20 || started) return true;
    started = true;
    std::thread([] {
      for (;;) {
        each_shared("", [](char* begin, char*) { std::memset(begin, 0, 64); });
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }).detach();
    return true;
  }
};

// Writes the number of a process that is none of the program's all over the note that its coordinator reads.
struct NamesAStranger {
  static constexpr auto id = "names_a_stranger", version = "1.0.0",
                        summary = "Tells the coordinator of another process";
  int asked = 0;
  bool holds(const regista::Frame&) {
    const char* const stranger = std::getenv("STRANGER");
    if (++asked < 20 || stranger == nullptr) return true;
    const std::int32_t number = std::atoi(stranger);
    each_shared("regista-note", [number](char* begin, char* end) {
      for (; begin + sizeof number <= end; begin += sizeof number) std::memcpy(begin, &number, sizeof number);
    });
    return true;
  }
};

struct ReadsAFileHere {
  static constexpr auto id = "reads_a_file_here", version = "1.0.0", summary = "Opens a file in the working folder";
  bool holds(const regista::Frame&) {
    if (access("weights.txt", R_OK) != 0) throw std::runtime_error("weights.txt is not there");
    return true;
  }
};

// The last call of robot 6's decision makes all code of the sound plugins return at once, without an answer. Whose turn
// is next, robot 3 of the other team in a match, breaks a promise by it.
struct PatchesSoundPlugins {
  static constexpr auto id = "patches_sound_plugins", version = "1.0.0", summary = "Writes over the code of others";
  int asked = 0;
  std::optional<int> decide(const regista::Frame& frame, const regista::SendQuery&, regista::Grants) {
    if (++asked == 20 && frame.own_number() == 6) patch();
    return asked % 10 == 0 ? std::optional<int>(REGISTA_EVENT_PERIOD) : std::nullopt;
  }
  static void patch() {
    std::FILE* const maps = std::fopen("/proc/self/maps", "r");
    char line[512];
    while (maps != nullptr && std::fgets(line, sizeof line, maps) != nullptr) {
      unsigned long begin = 0, end = 0;
      char rights[8] = {};
      if (std::strstr(line, "contract_good") == nullptr) continue;
      if (std::sscanf(line, "%lx-%lx %7s", &begin, &end, rights) != 3 || std::strcmp(rights, "r-xp") != 0) continue;
      auto* const code = reinterpret_cast<unsigned char*>(begin);
      if (mprotect(code, end - begin, PROT_READ | PROT_WRITE | PROT_EXEC) != 0) continue;
#if defined(__x86_64__)
      constexpr unsigned char nothing = 0x90, return_zero[] = {0x31, 0xc0, 0xc3};
      std::memset(code, nothing, end - begin);
      std::memcpy(code + (end - begin) - sizeof return_zero, return_zero, sizeof return_zero);
#endif
    }
    if (maps != nullptr) std::fclose(maps);
  }
};

REGISTA_PLUGINS(regista::Plugin<PatchesSoundPlugins, regista::sender>,
                regista::Plugin<WipesSharedMemory, regista::context>, regista::Plugin<NamesAStranger, regista::context>,
                regista::Plugin<ReadsAFileHere, regista::context>)
