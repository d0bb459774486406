// SPDX-License-Identifier: MIT
// Mirror flips hurt: a team whose robots take their own half for the opponents' every half minute, against the same
// team undisturbed, concedes more than it scores, and is wrong about where its robots stand by metres.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "process/sanitized.hpp"
#include "teams.hpp"

namespace regista {
namespace {

constexpr int matches = sanitized ? 1 : 8;

struct Course {
  int goal_difference = 0;       // of home, over all matches
  double least_error = 1e9;      // m: of home's own places, root mean square of a match
  double largest_error = 0.0;    // the same
  double opponents_error = 0.0;  // m: the largest of away
};

Course play(double flips_per_hour) {
  match::Setup setup;
  setup.limit = 420.0;
  config::Incident flip;
  flip.kind = config::Incident::Kind::mirror_flip;
  flip.robots.choice = config::Incident::Whom::Choice::any;
  flip.per_hour = flips_per_hour;
  setup.disturbances[0].incidents = {flip};
  const auto team = shipped::plan("spqr2023");
  Course out;
  for (int seed = 1; seed <= matches; ++seed) {
    setup.seed = static_cast<std::uint64_t>(seed);
    const match::Result result = match::play(setup, {team.get(), team.get()});
    out.goal_difference += result.score[0] - result.score[1];
    const double error = result.metrics.teams[0].world_model.self.rmse_metres.value();
    out.least_error = std::min(out.least_error, error);
    out.largest_error = std::max(out.largest_error, error);
    out.opponents_error = std::max(out.opponents_error, result.metrics.teams[1].world_model.self.rmse_metres.value());
  }
  return out;
}

TEST(MirrorFlip, Hurts) {
  const Course undisturbed = play(0.0), disturbed = play(120.0);
  fmt::print(
      "goals {:+d} undisturbed, {:+d} disturbed; error at most {:.2f} m undisturbed, at least {:.2f} m disturbed\n",
      undisturbed.goal_difference, disturbed.goal_difference, undisturbed.largest_error, disturbed.least_error);
  EXPECT_LT(undisturbed.largest_error, 0.3);
  EXPECT_LT(disturbed.opponents_error, 0.3) << "only those whom it strikes";
  EXPECT_GT(disturbed.least_error, 1.0);
  if (matches < 8) return;
  EXPECT_LT(disturbed.goal_difference, undisturbed.goal_difference - 4);
}

}  // namespace
}  // namespace regista
