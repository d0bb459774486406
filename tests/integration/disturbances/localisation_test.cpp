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

match::Setup disturbed(Incident::Kind kind, int robot, double at, double duration) {
  match::Setup setup;
  setup.limit = 400.0;
  Incident incident;
  incident.kind = kind;
  incident.robots = {Incident::Whom::Choice::listed, {robot}};
  incident.at = {at};
  incident.duration = duration;
  setup.disturbances[0].incidents = {incident};
  return setup;
}

TEST(MirrorFlip, TurnsTheBeliefRoundAndItStaysSo) {
  const auto paper = shipped::plan("paper"), fixed_rate = shipped::plan("fixed_rate");
  for (const int robot : {1, 4}) {
    const match::Setup setup = disturbed(Incident::Kind::mirror_flip, robot, 80.0, 240.0);
    int before = 0, mirrored = 0, during = 0, after = 0, right = 0, others = 0, others_right = 0;
    bool put_down = false;
    shipped::play(setup, {paper.get(), fixed_rate.get()}, [&](const Believed& b) {
      if (b.side != Side::home || b.percepts.penalised) return;
      if (b.number != robot) {
        ++others;
        others_right += b.error() < 0.5 ? 1 : 0;
        return;
      }
      if (b.time < 80.0) {
        before += b.error() < 0.5 ? 1 : 0;
      } else if (b.time < 320.0) {
        put_down = put_down || (b.percepts.placed && b.time > 81.0);
        if (put_down) return;
        ++during;
        mirrored += b.mirrored_error() < 0.5 && b.mirrored_heading_error() < 0.5 ? 1 : 0;
      } else {
        ++after;
        right += b.error() < 0.5 && b.heading_error() < 0.5 ? 1 : 0;
      }
    });
    printf("robot %d: before %d during %d mirrored %d after %d right %d others %d/%d\n", robot, before, during,
           mirrored, after, right, others_right, others);
  }
}

}  // namespace
}  // namespace regista
