// SPDX-License-Identifier: MIT
// Plays matches and prints the hashes over their course. A program without studies, reports and command line: what is
// to play the same with another compiler is built with it in a third of the time.
//
//   state_hashes SEED A.yaml B.yaml [A.yaml B.yaml ...]     plugins: those of lib/regista/plugins beside it
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <utility>

#include "campaign/match_setup.hpp"
#include "config/scalar.hpp"
#include "match/digest.hpp"
#include "match/teams.hpp"
#include "plugin/catalogue.hpp"

int main(int argc, char** argv) {
  using namespace regista;
  if (argc < 4 || argc % 2 != 0) {
    std::fputs("usage: state_hashes SEED A.yaml B.yaml [A.yaml B.yaml ...]\n", stderr);
    return 2;
  }
  try {
    const auto folder = std::filesystem::canonical("/proc/self/exe").parent_path() / "../lib/regista/plugins";
    const plugin::Catalogue catalogue({folder.lexically_normal()});
    for (int i = 2; i < argc; i += 2) {
      campaign::Job job;
      job.teams = {argv[i], argv[i + 1]};
      job.seed = config::parse_whole("--seed", argv[1], 0, UINT64_MAX);
      campaign::MatchSetup prepared = campaign::match_setup(job, catalogue);
      const std::array<const mind::TeamPlan*, 2> plans{prepared.plans[0].get(), prepared.plans[1].get()};
      const match::Result result = match::play(std::move(prepared.setup), plans);
      fmt::print("{} {} {}\n", match::hash_text(result.hash), argv[i], argv[i + 1]);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "state_hashes: {}\n", error.what());
    return 1;
  }
  return 0;
}
