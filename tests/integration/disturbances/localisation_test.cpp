// SPDX-License-Identifier: MIT
// What robots of a shipped team believe of their own poses, undisturbed and disturbed, beside the truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "teams.hpp"

namespace regista {
namespace {

using config::Incident;
using match::Side;
using shipped::Believed;

match::Setup disturbed(Incident incident, int robot, double at, double duration) {
  match::Setup setup;
  setup.limit = at + duration + 80.0;
  incident.robots = {Incident::Whom::Choice::listed, {robot}};
  incident.at = {at};
  incident.duration = duration;
  setup.disturbances[0].incidents = {incident};
  return setup;
}

// Decisions of a stretch of time, and in how many of them the belief was as expected.
struct Share {
  int all = 0, as_expected = 0;
  void add(bool expected) {
    ++all;
    as_expected += expected ? 1 : 0;
  }
};

bool right(const Believed& b) { return b.error() < 0.3 && b.heading_error() < 0.3; }
bool mirrored(const Believed& b) { return b.mirrored_error() < 0.3 && b.mirrored_heading_error() < 0.3; }

// The field is the same from the other side, so nothing but a hand, or the end of the incident, sets it right.
TEST(MirrorFlip, TurnsTheBeliefRoundAndItStaysSoForMinutes) {
  const auto paper = shipped::plan("paper"), fixed_rate = shipped::plan("fixed_rate");
  Incident flip;
  flip.kind = Incident::Kind::mirror_flip;
  constexpr double begin = 80.0, lasts = 240.0;
  int minutes = 0;
  for (const int robot : {1, 4, 6}) {
    Share before, during, after_hand, after, others;
    bool put_down = false;
    shipped::play(disturbed(flip, robot, begin, lasts), {paper.get(), fixed_rate.get()}, [&](const Believed& b) {
      if (b.side != Side::home || b.percepts.penalised) return;
      if (b.number != robot) {
        others.add(right(b));
      } else if (b.time < begin) {
        before.add(right(b));
      } else if (b.time < begin + lasts) {
        put_down = put_down || (b.percepts.placed && b.time > begin + 0.5);
        put_down ? after_hand.add(right(b)) : during.add(mirrored(b));
      } else {
        after.add(right(b));
      }
    });
    EXPECT_GE(before.all, 500) << "of 800; a penalised robot does not count";
    EXPECT_EQ(before.as_expected, before.all);
    EXPECT_GT(during.all, 10);
    EXPECT_GE(during.as_expected, during.all - 5) << "robot " << robot;
    EXPECT_GE(after_hand.as_expected, after_hand.all - 5);
    EXPECT_GE(after.all, 300);
    EXPECT_GE(after.as_expected, after.all - 5);
    EXPECT_GT(others.as_expected, 0.999 * others.all);
    minutes += during.all / 600;
    EXPECT_TRUE(put_down || during.all > 2000);
  }
  EXPECT_GE(minutes, 3);
}

TEST(PoseBias, IsWhereTheLocalisationSettles) {
  const auto paper = shipped::plan("paper"), fixed_rate = shipped::plan("fixed_rate");
  Incident bias;
  bias.kind = Incident::Kind::pose_bias;
  bias.x = 0.5;
  bias.y = 0.3;
  bias.heading = 0.087;
  constexpr double begin = 80.0, lasts = 240.0;
  Share during, after;
  double x = 0.0, y = 0.0, heading = 0.0;
  shipped::play(disturbed(bias, 3, begin, lasts), {paper.get(), fixed_rate.get()}, [&](const Believed& b) {
    if (b.side != Side::home || b.number != 3 || b.percepts.penalised) return;
    if (b.time > begin && b.time < begin + lasts) {
      const double dx = b.belief.x - b.truth.x - *bias.x, dy = b.belief.y - b.truth.y - *bias.y;
      during.add(std::hypot(dx, dy) < 0.2);
      x += dx;
      y += dy;
      heading += mind::wrap(b.belief.heading - b.truth.heading - *bias.heading);
    } else if (b.time > begin + lasts) {
      after.add(right(b));
    }
  });
  EXPECT_GT(during.all, 1000);
  EXPECT_GT(during.as_expected, 0.98 * during.all);
  EXPECT_NEAR(x / during.all, 0.0, 0.03);
  EXPECT_NEAR(y / during.all, 0.0, 0.03);
  EXPECT_NEAR(heading / during.all, 0.0, 0.03);
  EXPECT_GT(after.all, 300);
  EXPECT_GE(after.as_expected, after.all - 5);
}

// Undisturbed, a robot knows its place to a few centimetres most of the time, and takes no half for the other.
TEST(Localisation, IsGoodToAFewCentimetresMostOfTheTime) {
  const auto paper = shipped::plan("paper"), fixed_rate = shipped::plan("fixed_rate");
  match::Setup setup;
  setup.limit = 300.0;
  std::vector<double> errors;
  int flips = 0;
  shipped::play(setup, {paper.get(), fixed_rate.get()}, [&](const Believed& b) {
    if (b.percepts.penalised || b.percepts.fallen) return;
    errors.push_back(b.error());
    flips += b.error() > 1.0 && mirrored(b) ? 1 : 0;
  });
  const auto quantile = [&](double p) {
    const auto at = errors.begin() + static_cast<std::ptrdiff_t>(p * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), at, errors.end());
    return *at;
  };
  EXPECT_GT(errors.size(), 30000u);
  EXPECT_LT(quantile(0.5), 0.04);
  EXPECT_LT(quantile(0.9), 0.10);
  EXPECT_LT(quantile(0.99), 0.25);
  EXPECT_EQ(flips, 0);
}

}  // namespace
}  // namespace regista
