// SPDX-License-Identifier: MIT
// What all behaviours do alike, tried with each of the plugins: REGISTA_CONDUCT_TESTS(id, purposes) at namespace scope.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <regista/behaviour.hpp>
#include <regista/testkit/contract.hpp>

namespace behaviours::conduct_tests {

using namespace regista::testkit;

inline FrameBuilder scene(int phase) {
  return FrameBuilder{}.own(2).robot(2).at(-2, 1).task("supporter").at(-1, -1).heading(0.3).ball(0.5, 0.3).phase(phase);
}

inline BodyBuilder body() { return BodyBuilder{}.at(-2, 1).heading(0.5).task(0).sees_ball(); }

// Where the ball is from there; no moment at which number 2 looks away from it.
inline double towards_ball() { return std::atan2(-0.7, 2.5) - 0.5; }
inline constexpr double attentive = 2.0;  // s

inline void stands_but_looks(const char* id, int phase, const BodyBuilder& body, const char* why) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, id), EnvironmentBuilder{}.own(2));
  const regista_action action = behaviour.act(scene(phase).time(attentive).build(), body);
  EXPECT_EQ(action.motion, REGISTA_MOTION_STAND) << why;
  EXPECT_EQ(action.kick, REGISTA_NO_KICK) << why;
  EXPECT_NEAR(action.gaze, towards_ball(), 1e-12) << why;
}

inline void stands(const char* id) {
  for (const int phase : {REGISTA_PHASE_INITIAL, REGISTA_PHASE_SET, REGISTA_PHASE_FINISHED}) {
    stands_but_looks(id, phase, body(), "in a phase of standing");
  }
  for (const int phase : {REGISTA_PHASE_READY, REGISTA_PHASE_PLAYING}) {
    stands_but_looks(id, phase, body().fallen(2.0), "fallen");
    stands_but_looks(id, phase, body().penalised(), "penalised");
    stands_but_looks(id, phase, body().kicking(), "in a kick");
  }
  stands_but_looks(id, REGISTA_PHASE_READY, body().task(-1), "nowhere to go");
}

// In Ready to the place of the task, but not into the other half, and in no hurry.
inline void gets_ready(const char* id) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, id), EnvironmentBuilder{}.own(2));
  const Scene ready = scene(REGISTA_PHASE_READY).set_play(REGISTA_SET_PLAY_KICK_OFF, false).build();
  const regista_action action = behaviour.act(ready, body());
  EXPECT_EQ(action.motion, REGISTA_MOTION_WALK_TO);
  EXPECT_EQ(action.walk, 0u);
  EXPECT_EQ(action.avoid_count, 0u);
  EXPECT_EQ(action.pose[0], -1.0);
  EXPECT_EQ(action.pose[1], -1.0);
  EXPECT_EQ(action.pose[2], 0.3);
  const Scene ahead = scene(REGISTA_PHASE_READY).set_play(REGISTA_SET_PLAY_KICK_OFF, false).after(1, -2).build();
  EXPECT_DOUBLE_EQ(behaviour.act(ahead, body()).pose[0], -0.35) << "a robot and the margin behind the line";
}

// A ball that is lost, too old, or not where it should be: the head sweeps, at 4 s less 0.74 s to the right end.
inline void looks_about_for_a_lost_ball(const char* id) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, id), EnvironmentBuilder{}.own(2));
  const FrameBuilder end = scene(REGISTA_PHASE_SET).time(4.0 - 2 * 0.37);
  const double right = -std::numbers::pi / 2;
  EXPECT_NEAR(behaviour.act(FrameBuilder(end).no_ball().build(), body()).gaze, right, 1e-9);
  EXPECT_NEAR(behaviour.act(FrameBuilder(end).ball_age(5.0).build(), body()).gaze, right, 1e-9);
  EXPECT_NEAR(behaviour.act(end.build(), body().ball_refuted()).gaze, right, 1e-9);
  const FrameBuilder middle = scene(REGISTA_PHASE_SET).time(attentive);
  EXPECT_NEAR(behaviour.act(FrameBuilder(middle).ball_age(4.9).build(), body()).gaze, towards_ball(), 1e-12);
}

inline void says_what_it_is_for(const char* id, unsigned purposes) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, id);
  const auto* table = static_cast<const regista_behaviour*>(plugin.descriptor().table(REGISTA_KIND_BEHAVIOUR));
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->flags, purposes);
}

}  // namespace behaviours::conduct_tests

#define REGISTA_CONDUCT_TESTS(id, purposes)                                                        \
  TEST(Conduct, StandsButLooks) { behaviours::conduct_tests::stands(id); }                         \
  TEST(Conduct, GetsReady) { behaviours::conduct_tests::gets_ready(id); }                          \
  TEST(Conduct, LooksAbout) { behaviours::conduct_tests::looks_about_for_a_lost_ball(id); }        \
  TEST(Conduct, SaysWhatItIsFor) { behaviours::conduct_tests::says_what_it_is_for(id, purposes); } \
  REGISTA_BEHAVIOUR_CONTRACT(REGISTA_PLUGIN_FILE, id)
