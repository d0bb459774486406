// SPDX-License-Identifier: MIT
// Contexts whose answers depend on what is no input of a match: the number of the process, an address, the folder. Each
// of them tells two processes apart for sure, so that a test need not be lucky.
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <regista/context.hpp>

namespace {

// What the first process was, for the second to be another; in the folder that the variable names.
constexpr auto folder = "CHANCE_FOLDER";

// Whether this process is another than the one that asked first.
bool is_another_one(std::uint64_t mine) {
  const char* const place = std::getenv(folder);
  if (place == nullptr) return false;
  std::array<char, 4096> path{};
  std::snprintf(path.data(), path.size(), "%s/first", place);
  std::FILE* file = std::fopen(path.data(), "r");
  unsigned long long first = 0;
  if (file != nullptr) {
    const bool read = std::fscanf(file, "%llu", &first) == 1;
    std::fclose(file);
    return read && first != mine;
  }
  file = std::fopen(path.data(), "w");
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

struct AsksForTheFolder {
  static constexpr auto id = "asks_for_the_folder", version = "1.0.0", summary = "Decides by the working folder";
  bool holds(const regista::Frame&) {
    std::array<char, 4096> here{};
    return getcwd(here.data(), here.size()) != nullptr && here[1] != '\0';
  }
};

REGISTA_PLUGINS(regista::Plugin<AsksForTheProcess, regista::context>,
                regista::Plugin<AsksForAnAddress, regista::context>,
                regista::Plugin<AsksForTheFolder, regista::context>)
