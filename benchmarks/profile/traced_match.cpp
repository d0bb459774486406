// SPDX-License-Identifier: MIT
// The first seconds of a match, for footprint.py: before and after each decision in open play something is written to
// an address of its own, which a trace of all memory references shows. Plugins are opened in this process, for a
// tracer slows it down too much for the limits of a process that looks at them.
//
//     traced_match HOME AWAY SECONDS
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "config/documents.hpp"
#include "match/teams.hpp"

namespace {

// At an address that nothing else has, so that a trace shows it.
volatile int* marks() {
  void* const wanted = reinterpret_cast<void*>(0x5eed00000000);
  void* const got =
      mmap(wanted, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
  if (got != wanted) throw std::runtime_error("the address of the marks is taken");
  return static_cast<volatile int*>(got);
}

int run(const char* home, const char* away, double seconds) {
  using namespace regista;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(REGISTA_PLUGINS)) {
    if (entry.path().extension() == ".so") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  const auto catalogue = plugin::Catalogue::of_files(files, plugin::Catalogue::Looking::here);
  match::Setup setup;
  setup.rules.durations.ready = setup.rules.durations.set = 0.1;
  setup.limit = seconds;
  const mind::TeamPlan plans[] = {
      mind::TeamPlan(config::read_document<config::Team>(home), setup.rules, setup.robots[0], catalogue),
      mind::TeamPlan(config::read_document<config::Team>(away), setup.rules, setup.robots[1], catalogue),
  };
  volatile int *const begin = marks(), *const end = begin + 16;
  std::array<std::vector<mind::Mind>, 2> minds;
  std::array<std::vector<mind::Think>, 2> think;
  for (const match::Side side : match::both_sides) {
    const mind::TeamPlan& plan = plans[match::index(side)];
    setup.roles[match::index(side)] = match::roles(plan);
    setup.reasons[match::index(side)] = plan.reasons();
    setup.plugin_metrics[match::index(side)] = plan.metrics();
    minds[match::index(side)] = match::minds(plan, side, setup.seed, {});
    for (mind::Mind& mind : minds[match::index(side)]) {
      think[match::index(side)].push_back([&mind, begin, end](const mind::Percepts& percepts,
                                                              std::span<const mind::HeardPacket> heard,
                                                              mind::Outcome& out) {
        const bool traced = percepts.game.phase == mind::Phase::playing;
        if (traced) *begin = 1;
        mind.think(percepts, heard, out);
        if (traced) *end = 1;
      });
    }
  }
  match::play(setup, think[0], think[1]);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fputs("usage: traced_match HOME AWAY SECONDS\n", stderr);
    return 2;
  }
  try {
    return run(arguments[1], arguments[2], std::strtod(arguments[3], nullptr));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
