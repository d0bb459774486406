// SPDX-License-Identifier: MIT
// Every shipped opening is played for its length by two shipped teams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/documents.hpp"
#include "config/rules.hpp"
#include "match/teams.hpp"

namespace regista {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> openings() {
  std::vector<fs::path> out;
  for (const fs::directory_entry& each : fs::directory_iterator(REGISTA_CONFIGS "/openings")) {
    out.push_back(each.path());
  }
  std::ranges::sort(out);
  return out;
}

class Openings : public ::testing::TestWithParam<fs::path> {
 protected:
  static void SetUpTestSuite() {
    catalogue_.emplace(std::vector<fs::path>{REGISTA_PLUGINS});
    for (const char* name : {"paper", "fixed_rate"}) {
      const config::Team team =
          config::read_document<config::Team>(fs::path(REGISTA_CONFIGS) / "teams" / (std::string(name) + ".yaml"));
      plans_.push_back(std::make_unique<const mind::TeamPlan>(team, config::Rules{}, config::Robot{}, *catalogue_));
    }
  }
  static void TearDownTestSuite() {
    plans_.clear();
    catalogue_.reset();
  }

  static match::Result play(std::uint64_t seed, const match::Observer* observer = nullptr) {
    match::Setup setup;
    setup.opening = config::read_document<config::Opening>(GetParam());
    setup.seed = seed;
    return match::play(setup, {plans_[0].get(), plans_[1].get()}, observer);
  }

  static inline std::optional<plugin::Catalogue> catalogue_;
  static inline std::vector<std::unique_ptr<const mind::TeamPlan>> plans_;
};

TEST_P(Openings, IsPlayedForItsLength) {
  const config::Opening opening = config::read_document<config::Opening>(GetParam());
  match::Observer observer;
  std::optional<double> began;
  observer.event = [&](double time, const match::Event& event, const match::GameState& state) {
    if (event.kind != match::EventKind::opening) return;
    began = time;
    EXPECT_TRUE(state.in_play());
  };
  double jump = 0.0;  // of a robot in the first physics step: bodies that overlap are pushed apart
  observer.step = [&](const match::Snapshot& now) {
    if (now.time > 0.03) return;
    for (std::size_t i = 0; i < 14; ++i) {
      const auto& wanted = i < 7 ? opening.home[i] : opening.away[i - 7];
      jump = std::max(jump, std::hypot(now.bodies[i].x - wanted.at[0], now.bodies[i].y - wanted.at[1]));
    }
  };
  const match::Result result = play(1, &observer);
  EXPECT_EQ(began, 0.0);
  EXPECT_LT(jump, 0.001);
  EXPECT_EQ(result.ended, match::Ended::limit);
  EXPECT_NEAR(result.simulated_seconds, opening.length, 1e-9);
  EXPECT_GT(result.metrics.in_play_seconds, 1.0);
  // Somebody finds the ball and goes for it.
  EXPECT_GT(result.metrics.teams[0].touches + result.metrics.teams[1].touches, 0);
  EXPECT_NE(play(2).hash, result.hash);
}

// The opening played with the whole budget, or its share of it, by two teams with these values laid over.
match::Result play_with(config::ShortGames short_games, const config::Overrides& overrides,
                        const plugin::Catalogue& all, const fs::path& file) {
  match::Setup setup;
  setup.opening = config::read_document<config::Opening>(file);
  setup.rules.messages.short_games = short_games;
  config::fit_packets(setup.rules, match::limit_of(setup), true);
  const config::Team team =
      config::read_document<config::Team>(fs::path(REGISTA_CONFIGS) / "teams" / "paper.yaml", overrides);
  const mind::TeamPlan plan(team, setup.rules, config::Robot{}, all);
  return match::play(setup, {&plan, &plan});
}

// Who would send twice as much as its share of a packet a second stops before the last packet, one of which is its
// reserve.
TEST_P(Openings, NobodySpendsMoreThanTheShare) {
  const config::Overrides much{"sender.params.minimum_interval=0.5", "sender.params.period=0.5",
                               "sender.params.period_goalkeeper=0.5", "sender.params.pace=none",
                               "sender.params.reserve=10"};
  const double length = config::read_document<config::Opening>(GetParam()).length;
  const auto whole = play_with(config::ShortGames::whole, much, *catalogue_, GetParam());
  const auto share = play_with(config::ShortGames::share, much, *catalogue_, GetParam());
  EXPECT_GT(whole.packets[0], 1.5 * length);
  for (const int packets : share.packets) EXPECT_EQ(packets, static_cast<int>(length) - 1);
}

// Who does not need more than the share plays as if it had the whole.
TEST_P(Openings, WhoIsThriftyPlaysTheSameMatch) {
  const config::Overrides little{"sender.params.minimum_interval=10", "sender.params.reserve=10"};
  const auto whole = play_with(config::ShortGames::whole, little, *catalogue_, GetParam());
  const auto share = play_with(config::ShortGames::share, little, *catalogue_, GetParam());
  EXPECT_GT(share.packets[0], 0);
  EXPECT_EQ(whole.packets, share.packets);
  EXPECT_EQ(whole.hash, share.hash);
}

std::string name(const ::testing::TestParamInfo<fs::path>& info) { return info.param.stem().string(); }
INSTANTIATE_TEST_SUITE_P(Shipped, Openings, ::testing::ValuesIn(openings()), name);

}  // namespace
}  // namespace regista
