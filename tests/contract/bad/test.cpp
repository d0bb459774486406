// SPDX-License-Identifier: MIT
// Every check is able to fail: each of the plugins here breaks one promise, and the check that guards the promise says
// so in these words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regista/testkit/checks.hpp>

namespace {

using namespace regista::testkit;

struct Case {
  std::int32_t kind;
  const char *file, *id, *check, *finding;
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.id << ", " << c.check; }
};

Findings run(const Case& c, const Options& options = {}) {
  for (const Check& check : contract(c.kind)) {
    if (check.name == c.check) return check.run(Loaded(c.file, c.id), options);
  }
  Findings none;
  none.say("no check of this name");
  return none;
}

class Reports : public testing::TestWithParam<Case> {};

TEST_P(Reports, TheBrokenPromise) {
  EXPECT_THAT(run(GetParam()).lines(), testing::Contains(testing::HasSubstr(GetParam().finding)));
}

std::string name(const testing::TestParamInfo<Case>& info) {
  return std::string(info.param.id) + "_" + info.param.check;
}

constexpr auto assigner = [](const char* id, const char* check, const char* finding) {
  return Case{REGISTA_KIND_ASSIGNER, BAD_ASSIGNERS, id, check, finding};
};
INSTANTIATE_TEST_SUITE_P(
    Assigner, Reports,
    testing::Values(assigner("throws", "promises", "assign: nothing works today"),
                    assigner("throws_oddly", "promises", "assign: threw something that is no std::exception"),
                    assigner("twice", "promises", "assign: column 0 given to rows 0 and 1"),
                    assigner("beyond", "promises", "assign: row 0 got column 7 of 7"),
                    assigner("takes_forbidden", "promises", "got column 0, which is forbidden"),
                    assigner("idles", "promises", "has no task although column 0 is free and allowed"),
                    assigner("says_unknown", "promises", "is unknown, but nothing is negotiated"),
                    assigner("counts", "determinism", "two instances with the same seed"),
                    assigner("keeps", "determinism", "after reset() with the same seed"),
                    assigner("ignores_stride", "growth", "step by stride, not by sizeof"),
                    assigner("scribbles", "promises", "assign: wrote to the utilities"),
                    assigner("scribbles_tasks", "promises", "assign: wrote to its input"),
                    assigner("overruns", "promises", "assign: columns: wrote past the capacity of 7"),
                    assigner("throws_across", "promises", "assign: threw an exception across the boundary"),
                    assigner("fails_silently", "promises", "assign: failed and did not say why"),
                    assigner("fails_at_length", "promises", "assign: its error has more than one line"),
                    assigner("fails_endlessly", "promises", "assign: error text does not end"),
                    assigner("odd_status", "promises", "assign: returned 7"),
                    assigner("never_created", "promises", "create: no such formation"),
                    assigner("never_reset", "promises", "reset: not again"),
                    assigner("wrong_in_a_corner", "promises", "assign: not made for this (high: depth"),
                    assigner("chokes_on_messages", "mailbox", "receive: threw an exception across the boundary"),
                    assigner("writes_to_messages", "mailbox", "receive: wrote to the bytes of the message")),
    name);

constexpr auto utility = [](const char* id, const char* check, const char* finding) {
  return Case{REGISTA_KIND_UTILITY, BAD_SCORERS, id, check, finding};
};
INSTANTIATE_TEST_SUITE_P(Utility, Reports,
                         testing::Values(utility("steps_by_value_size", "growth", "change the result"),
                                         utility("not_a_number", "promises", "score: row 0, column 0 is"),
                                         utility("infinite", "promises", "column 0 is inf"),
                                         utility("negative", "promises", "score: row 0, column 6 is -1e-12"),
                                         utility("no_gap", "growth", "change the result"),
                                         utility("steps_by_size", "growth", "change the result"),
                                         utility("refuses_larger_frames", "growth", "change the result"),
                                         utility("keeps_the_environment", "promises", "score: row 0, column 0 is")),
                         name);

constexpr auto context = [](const char* id, const char* check, const char* finding) {
  return Case{REGISTA_KIND_CONTEXT, BAD_SCORERS, id, check, finding};
};
INSTANTIATE_TEST_SUITE_P(Context, Reports,
                         testing::Values(context("answers_two", "promises", "holds: answered 2, neither 0 nor 1"),
                                         context("answers_nothing", "promises", "holds: answered -77"),
                                         context("remembers", "determinism", "after reset()"),
                                         context("refuses_larger_games", "growth", "change the result"),
                                         context("refuses_larger_balls", "growth", "change the result"),
                                         context("scribbles_world", "promises", "holds: wrote to its input")),
                         name);

constexpr auto sender = [](const char* id, const char* finding) {
  return Case{REGISTA_KIND_SENDER, BAD_SCORERS, id, "promises", finding};
};
INSTANTIATE_TEST_SUITE_P(
    Sender, Reports,
    testing::Values(sender("sends_two", "decide: send is 2, neither 0 nor 1"),
                    sender("no_such_reason", "decide: sends for the reason 14, which does not exist"),
                    sender("no_such_own_reason", "decide: sends for the reason 1001, which does not exist"),
                    sender("grants_the_unoffered", "which nobody offered"),
                    sender("grants_twice", "decide: granted an offer twice"),
                    sender("grants_too_many", "granted: says"), sender("grants_past_the_end", "granted: wrote past")),
    name);

constexpr auto positioner = [](const char* id, const char* check, const char* finding) {
  return Case{REGISTA_KIND_POSITIONER, BAD_POSITIONERS, id, check, finding};
};
INSTANTIATE_TEST_SUITE_P(
    Positioner, Reports,
    testing::Values(positioner("off_the_field", "promises", "place: point 0 at (5.3, 0) is outside the field"),
                    positioner("nowhere_at_all", "promises", "place: point 0 at (0, nan) is outside the field"),
                    positioner("bad_score", "promises", "place: point 0 has the score -0.5"),
                    positioner("no_such_task", "promises", "place: point 0 names task 7 of 7"),
                    positioner("no_such_robot", "promises", "place: point 0 names robot 12 of 7"),
                    positioner("edge_to_nowhere", "promises", "place: edge 0 from 0 to 5 with only 1 points"),
                    positioner("edge_to_itself", "promises", "place: edge 0 leads from point 0 to itself"),
                    positioner("edge_twice", "promises", "place: the edge between points 1 and 0 stands twice"),
                    positioner("cell_of_nobody", "promises", "place: a cell belongs to robot 0"),
                    positioner("two_cells", "promises", "place: robot 1 has two cells"),
                    positioner("clockwise_cell", "promises", "place: the cell of robot 1 is not counter-clockwise"),
                    positioner("cell_off_the_field", "promises", "place: the cell of robot 1 leaves the field"),
                    positioner("cell_past_the_end", "promises", "has vertices past the end"),
                    positioner("counts_too_far", "promises", "points: says 257 of at most 256"),
                    positioner("ignores_capacity", "capacity", "points: wrote past the capacity of 1"),
                    positioner("steps_by_point_room", "growth", "change the result"),
                    positioner("steps_by_edge_room", "growth", "change the result"),
                    positioner("steps_by_cell_room", "growth", "change the result"),
                    positioner("steps_by_vertex_room", "growth", "change the result"),
                    positioner("moves_the_room", "promises", "vertices: changed more of its room than the count"),
                    positioner("fills_the_tail", "growth", "change the result")),
    name);

constexpr auto behaviour = [](const char* id, const char* check, const char* finding) {
  return Case{REGISTA_KIND_BEHAVIOUR, BAD_BEHAVIOURS, id, check, finding};
};
INSTANTIATE_TEST_SUITE_P(
    Behaviour, Reports,
    testing::Values(behaviour("walks_nowhere", "promises", "act: the pose (nan, 0, 0) is nowhere"),
                    behaviour("walks_too_far", "promises", "act: the pose (0, -20000, 0) is nowhere"),
                    behaviour("faces_nowhere", "promises", "act: the pose (0, 0, inf) is nowhere"),
                    behaviour("endlessly_fast", "promises", "act: a velocity is not finite"),
                    behaviour("no_such_motion", "promises", "act: the motion 3 does not exist"),
                    behaviour("no_such_walk", "promises", "act: the walk 8 has flags that do not exist"),
                    behaviour("no_such_flag", "promises", "act: the flags 2 do not all exist"),
                    behaviour("looks_behind_itself", "promises", "act: the gaze is 3.5, outside [-pi, pi]"),
                    behaviour("looks_nowhere", "promises", "act: the gaze is nan, outside [-pi, pi]"),
                    behaviour("tells_no_target", "promises", "act: the target is not finite"),
                    behaviour("no_such_kick", "promises", "act: kick 3 of 3"),
                    behaviour("negative_kick", "promises", "act: kick -2 of 3"),
                    behaviour("relies_on_kicks", "promises", "act: kick 0 of 0"),
                    behaviour("kicks_too_far", "promises", "is 4.6, outside of that of \"fast\", [1.6, 4.5]"),
                    behaviour("kicks_no_distance", "promises", "act: the distance of a kick is nan"),
                    behaviour("kicks_full_turn", "promises", "act: the direction of a kick is 6, outside [-pi, pi]"),
                    behaviour("avoids_negatively", "promises", "act: avoids no disc at (1, 2) of radius -0.1"),
                    behaviour("avoids_nothing", "promises", "act: avoids no disc at (nan, 2) of radius 0.1"),
                    behaviour("avoids_too_many", "promises", "act: more discs to avoid than there is room for"),
                    behaviour("counts_too_many_discs", "promises", "act: avoids 9 discs of at most 8"),
                    behaviour("writes_past_the_discs", "promises", "act: wrote past the end of its output struct"),
                    behaviour("changes_the_size", "promises", "act: wrote to the size of its output struct"),
                    behaviour("scribbles_body", "promises", "act: wrote to the body"),
                    behaviour("scribbles_robots_near", "promises", "act: wrote to the body"),
                    behaviour("wholly_upright", "promises", "act: lies"),
                    behaviour("needs_a_task", "promises", "act: no task"),
                    behaviour("remembers_the_ball", "determinism", "after reset() with the same seed"),
                    behaviour("counts_decisions", "determinism", "two instances with the same seed"),
                    behaviour("keeps_the_kicks", "promises", "act: the distance of a kick is"),
                    behaviour("steps_by_kick_size", "growth", "change the result"),
                    behaviour("steps_by_point_size", "growth", "change the result"),
                    behaviour("refuses_larger_bodies", "growth", "change the result"),
                    behaviour("refuses_larger_actions", "growth", "change the result")),
    name);

constexpr auto predictor = [](const char* id, const char* check, const char* finding) {
  return Case{REGISTA_KIND_PREDICTOR, BAD_PREDICTORS, id, check, finding};
};
INSTANTIATE_TEST_SUITE_P(
    Predictor, Reports,
    testing::Values(predictor("nan_track", "promises", "a value of a track is not finite"),
                    predictor("indefinite_covariance", "promises", "a covariance is not positive semi-definite"),
                    predictor("indefinite_motion", "promises", "a covariance is not positive semi-definite"),
                    predictor("too_far", "promises", "a place or velocity is beyond 10000"),
                    predictor("negative_velocity_variance", "promises", "a variance of the velocity is negative"),
                    predictor("negative_variance", "promises", "a variance of the heading is negative"),
                    predictor("full_turn", "promises", "a heading is outside (-pi, pi]"),
                    predictor("no_weight", "promises", "a weight is outside (0, 1]"),
                    predictor("from_the_future", "promises", "an age is negative"),
                    predictor("nobody_self", "promises", "must be exactly one track"),
                    predictor("someone_else", "promises", "labelled with the own number"),
                    predictor("self_confident", "uncertainty", "the own position became surer by itself"),
                    predictor("sure_of_heading", "uncertainty", "the own heading became surer by itself"),
                    predictor("same_labels", "promises", "two tracks have one label"),
                    predictor("renames", "labels", "does not keep its track and label"),
                    predictor("invents", "promises", "a label appeared although nothing was measured"),
                    predictor("keeps_after_absorb", "promises", "a packet replaces the whole model"),
                    predictor("too_many_tracks", "promises", "more tracks than the host has room for"),
                    predictor("worst_first", "promises", "the best hypothesis of the ball does not come first"),
                    predictor("descending_labels", "promises", "the labels of teammates do not ascend"),
                    predictor("strange_teammate", "promises", "the label of a teammate is no shirt number"),
                    predictor("deaf_to_teammates", "promises", "a teammate that was heard of has no track"),
                    predictor("counts_tracks", "determinism", "two instances with the same seed"),
                    predictor("steps_by_track_size", "growth", "change the result"),
                    predictor("steps_by_track_room", "growth", "change the result"),
                    predictor("forgets_the_age", "track_at", "is not what the model holds"),
                    predictor("forgets_the_target", "track_at", "is not what the model holds"),
                    predictor("changes_the_model", "track_at", "changed the model")),
    name);

// Who touches memory that is not his dies of it, after a line that says what it was.
class Faults : public testing::TestWithParam<Case> {};

TEST_P(Faults, EndTheProcessWithTheReason) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(run(GetParam()), GetParam().finding);
}

INSTANTIATE_TEST_SUITE_P(
    Memory, Faults,
    testing::Values(assigner("reads_behind", "memory", "memory: it went behind the end of what it was given"),
                    assigner("reads_one_row_more", "memory", "memory: it went behind the end of what it was given"),
                    assigner("overruns", "memory", "memory: it went behind the end of what it was given"),
                    assigner("scribbles", "memory", "memory: it wrote to what it may only read"),
                    assigner("scribbles_tasks", "memory", "memory: it wrote to what it may only read"),
                    assigner("reads_behind_messages", "memory", "memory: it went behind the end of what it was given"),
                    assigner("writes_to_messages", "memory", "memory: it wrote to what it may only read"),
                    utility("keeps_the_environment", "memory", "memory: it used what had ended with an earlier call")),
    name);

// Promises that a plugin may choose to give.
TEST(Options, OrderOfOpponentsIsLookedAtWhenAskedFor) {
  const Case c = utility("first_opponent_counts", "order", "");
  const Loaded plugin(c.file, c.id);
  const Check order = contract(c.kind).back();
  ASSERT_EQ(order.name, "order");
  EXPECT_FALSE(order.applies(plugin, {}));
  EXPECT_TRUE(order.applies(plugin, {.order_of_opponents_is_irrelevant = true}));
  EXPECT_THAT(run(c, {.order_of_opponents_is_irrelevant = true}).lines(),
              testing::Contains(testing::HasSubstr("depends on the order in which the opponents are listed")));
}

TEST(Options, AnIdleRobotMayBeAllowed) {
  EXPECT_TRUE(run(assigner("idles", "promises", ""), {.may_idle = true}).empty());
  // Which is no leave to be unknown.
  EXPECT_THAT(run(assigner("says_unknown", "promises", ""), {.may_idle = true}).lines(),
              testing::Contains(testing::HasSubstr("is unknown, but nothing is negotiated")));
}

// What is wrong in one way is not called wrong in another: findings point at their cause.
TEST(Findings, AreAboutTheOneBrokenPromise) {
  EXPECT_EQ(run(positioner("off_the_field", "promises", "")).lines().size(), 1u);
  EXPECT_TRUE(run(positioner("off_the_field", "determinism", "")).empty());
  EXPECT_TRUE(run(positioner("off_the_field", "growth", "")).empty());
  EXPECT_TRUE(run(positioner("ignores_capacity", "promises", "")).empty());
  EXPECT_TRUE(run(assigner("keeps", "promises", "")).empty());
  EXPECT_TRUE(run(assigner("chokes_on_messages", "promises", "")).empty());
  for (const char* id : {"steps_by_point_room", "steps_by_edge_room", "steps_by_cell_room", "steps_by_vertex_room"}) {
    EXPECT_TRUE(run(positioner(id, "promises", "")).empty()) << id;
  }
  for (const char* id : {"forgets_the_age", "forgets_the_target"}) {
    EXPECT_TRUE(run(predictor(id, "promises", "")).empty()) << id;
  }
}

TEST(Findings, NameTheParametersAndTheScene) {
  const Findings found = run(assigner("wrong_in_a_corner", "promises", ""));
  ASSERT_EQ(found.lines().size(), 1u);
  EXPECT_EQ(found.lines().front(), "assign: not made for this (high: depth; 3 robots: usual, utilities 0)");
}

TEST(Findings, APluginOfAnotherKindIsReported) {
  Case c = assigner("throws", "promises", "");
  c.kind = REGISTA_KIND_SENDER;
  EXPECT_THAT(run(c).lines(), testing::ElementsAre("\"throws\" does not implement this kind"));
}

}  // namespace
