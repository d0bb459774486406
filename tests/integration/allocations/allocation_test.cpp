// SPDX-License-Identifier: MIT
// A match in its steady state allocates nothing: neither the match nor the minds nor the shipped plugins. Every shipped
// team plays against paper.yaml; all steps are counted once the buffers have had time to grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "config/documents.hpp"
#include "match/teams.hpp"
#include "regista/testkit/count_allocations.hpp"

namespace regista {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> teams() {
  std::vector<fs::path> out;
  for (const char* folder : {REGISTA_CONFIGS "/teams", REGISTA_FIXTURES "/teams"}) {
    for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder)) {
      if (each.is_regular_file()) out.push_back(each.path());
    }
  }
  std::ranges::sort(out);
  return out;
}

class Allocations : public ::testing::TestWithParam<fs::path> {};

TEST_P(Allocations, NoneInTheSteadyState) {
  constexpr double steady_after = 200.0, end = 400.0;  // s
  const plugin::Catalogue catalogue({REGISTA_PLUGINS});
  match::Setup setup;
  setup.limit = end;
  const mind::TeamPlan home(config::read_document<config::Team>(GetParam()), setup.rules, setup.robots[0], catalogue);
  const mind::TeamPlan away(config::read_document<config::Team>(REGISTA_CONFIGS "/teams/paper.yaml"), setup.rules,
                            setup.robots[1], catalogue);
  std::size_t steps = 0, allocating = 0;
  match::Observer observer;
  observer.step = [&](const match::Snapshot& snapshot) {
    if (testkit::counting) {
      ++steps;
      if (testkit::allocations > 0) ++allocating;
    }
    testkit::allocations = 0;
    testkit::counting = snapshot.time >= steady_after;
  };
  match::play(setup, {&home, &away}, &observer);
  testkit::counting = false;
  EXPECT_GT(steps, 9000u);
  EXPECT_EQ(allocating, 0u) << "of " << steps << " steps";
}

std::string name(const ::testing::TestParamInfo<fs::path>& info) {
  const std::string folder = info.param.parent_path().stem().string(), team = info.param.stem().string();
  return folder == "teams" ? team : folder + "_" + team;
}
INSTANTIATE_TEST_SUITE_P(Teams, Allocations, ::testing::ValuesIn(teams()), name);

}  // namespace
}  // namespace regista
