// SPDX-License-Identifier: MIT
// Scenes and environments hold what they were told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <regista/testkit/dice.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/kind_checks.hpp>
#include <regista/testkit/measurement_scenario.hpp>
#include <regista/testkit/scenes.hpp>

namespace {

using namespace regista::testkit;

TEST(FrameBuilder, RobotsThatAreNamedAreActiveAndTheOthersUnknown) {
  const Scene scene = FrameBuilder{}.team_size(5).own(3).robot(4).at(1, 2).heading(0.5).age(0.3).robot(1).build();
  const regista::World world = scene.frame().mine();
  ASSERT_EQ(world.robots().size(), 5u);
  ASSERT_EQ(world.active().size(), 2u);
  EXPECT_EQ(world.active()[0], 1);
  EXPECT_EQ(world.active()[1], 4);
  EXPECT_EQ(world.robot(4).pose[1], 2.0);
  EXPECT_EQ(world.robot(4).age, 0.3);
  EXPECT_EQ(world.robot(3).flags, std::uint32_t{REGISTA_ROBOT_SELF});
  EXPECT_EQ(world.robot(2).flags, 0u);
  for (int n = 1; n <= 5; ++n) EXPECT_EQ(world.robot(n).number, n);
}

TEST(FrameBuilder, PenalisedRobotsTakeNoTask) {
  const Scene scene = FrameBuilder{}.robot(1).robot(2).penalised().robot(3).fallen(2.0).build();
  EXPECT_EQ(scene.rows(), 2u);
  EXPECT_EQ(scene.frame().mine().robot(3).time_until_up, 2.0);
}

TEST(FrameBuilder, CommonEqualsMineButForWhatIsChanged) {
  const FrameBuilder base = FrameBuilder{}.own(2).robot(1).at(1, 1).robot(2).at(2, 2).opponent(3, 0).ball(0, 1);
  EXPECT_EQ(base.build().frame().common().robot(1).pose[0], 1.0);
  const Scene scene = FrameBuilder(base)
                          .common([](WorldBuilder& w) { w.robot(1).at(-1, 1).no_ball().no_opponents(); })
                          .knowledge(REGISTA_COMMON)
                          .build();
  const regista::Frame frame = scene.frame();
  EXPECT_EQ(frame.mine().robot(1).pose[0], 1.0);
  EXPECT_EQ(frame.common().robot(1).pose[0], -1.0);
  EXPECT_EQ(frame.world().robot(1).pose[0], -1.0);
  EXPECT_TRUE(frame.mine().ball_known());
  EXPECT_FALSE(frame.world().ball_known());
  EXPECT_EQ(frame.world().opponents().size(), 0u);
}

TEST(FrameBuilder, TimesAreDistanceAtWalkingSpeedAfterGettingUp) {
  const Scene scene = FrameBuilder{}
                          .walk_speed(0.5)
                          .robot(2)
                          .at(0, 0)
                          .robot(3)
                          .at(3, 4)
                          .fallen(2.0)
                          .task("striker")
                          .at(3, 4)
                          .task("goalkeeper")
                          .at(0, 0)
                          .after(0, 1)
                          .build();
  const regista::Frame frame = scene.frame();
  EXPECT_DOUBLE_EQ(frame.time_to_task(0, 0), 10.0);
  EXPECT_DOUBLE_EQ(frame.time_to_task(0, 1), 2.0);
  EXPECT_DOUBLE_EQ(frame.time_to_task(1, 0), 2.0);
  EXPECT_DOUBLE_EQ(frame.time_to_task(1, 1), 2.0 + std::sqrt(18.0) / 0.5);
}

TEST(FrameBuilder, NamesOfRolesAreRowsOfTheTable) {
  const Scene scene = FrameBuilder{}
                          .roles({"keeper", "kicker"})
                          .own(1)
                          .robot(1)
                          .role("kicker")
                          .task("kicker")
                          .previous(2, "keeper")
                          .build();
  EXPECT_EQ(scene.frame().mine().robot(1).role, 1);
  EXPECT_EQ(scene.frame().tasks()[0].id, 1);
  EXPECT_EQ(scene.frame().tasks()[0].priority, 0);
  EXPECT_EQ(scene.frame().previous_task(2), 0);
  EXPECT_EQ(scene.frame().previous_task(1), -1);
  EXPECT_THROW(FrameBuilder{}.task("kikcer"), std::logic_error);
}

TEST(FrameBuilder, SaysWhatComesFirst) {
  EXPECT_THROW(FrameBuilder{}.at(0, 0), std::logic_error);
  EXPECT_THROW(FrameBuilder{}.required(), std::logic_error);
  EXPECT_THROW(FrameBuilder{}.opponent(0, 0).role("striker"), std::logic_error);
  EXPECT_THROW(FrameBuilder{}.robot(8), std::logic_error);
}

TEST(Scene, CopiesOutliveTheOriginal) {
  std::vector<Scene> kept;
  {
    const Scene original = FrameBuilder{}.robot(1).at(1, 2).task(0).waypoint(3, 4).edge(0, 0).build();
    kept.push_back(original);
  }
  EXPECT_EQ(kept[0].frame().world().robot(1).pose[1], 2.0);
  EXPECT_EQ(kept[0].frame().waypoints()[0].x, 3.0);
}

TEST(Scene, GrownIsTheSameSeenThroughTheStrides) {
  const Scene scene = FrameBuilder{}
                          .robot(2)
                          .at(1, 2)
                          .robot(6)
                          .at(3, 4)
                          .opponent(5, 6)
                          .opponent(7, 8)
                          .task(3)
                          .task(4)
                          .waypoint(1, 0)
                          .waypoint(2, 0)
                          .edge(0, 1)
                          .previous(7, 4)
                          .build();
  const Scene grown = scene.grown({24});
  const regista::Frame a = scene.frame(), b = grown.frame();
  EXPECT_EQ(b.raw().size, a.raw().size + 24);
  EXPECT_EQ(b.raw().tasks.stride, a.raw().tasks.stride + 24);
  EXPECT_EQ(b.world().game().size, sizeof(regista_game) + 24);
  EXPECT_EQ(b.common().ball().size, sizeof(regista_ball) + 24);
  EXPECT_EQ(b.world().game().time_left, a.world().game().time_left);
  EXPECT_EQ(b.world().active()[1], 6);
  EXPECT_EQ(b.world().opponents()[1].position[1], 8.0);
  EXPECT_EQ(b.tasks()[1].id, 4);
  EXPECT_EQ(b.edges()[0].to, 1u);
  EXPECT_EQ(b.previous_task(7), 4);
  EXPECT_GT(b.raw().time_to_task.stride, b.raw().time_to_task.columns);
  EXPECT_EQ(b.time_to_task(1, 1), a.time_to_task(1, 1));
  const auto* tail = reinterpret_cast<const unsigned char*>(&b.tasks()[0]) + sizeof(regista_task);
  EXPECT_TRUE(std::all_of(tail, tail + 24, [](unsigned char byte) { return byte == 0xff; }));
}

TEST(Scene, NoticesEveryWrite) {
  const auto fresh = [] {
    return FrameBuilder{}.robot(2).opponent(5, 6).task(3).waypoint(1, 0).edge(0, 0).ball(0, 0).build();
  };
  const Scene scene = fresh();
  EXPECT_TRUE(scene.unchanged());
  const auto spoilt = [&](const auto& write) {
    const Scene copy = fresh();
    write(const_cast<regista_frame&>(copy.raw()), copy.frame());
    return !copy.unchanged();
  };
  using Raw = regista_frame;
  using View = regista::Frame;
  EXPECT_TRUE(spoilt([](Raw& f, const View&) { f.time += 1; }));
  EXPECT_TRUE(spoilt([](Raw& f, const View&) { const_cast<double&>(f.time_to_task.values[0]) += 1; }));
  EXPECT_TRUE(spoilt([](Raw&, const View& v) { const_cast<regista_robot&>(v.common().robot(2)).age = 1; }));
  EXPECT_TRUE(spoilt([](Raw&, const View& v) { const_cast<regista_ball&>(v.mine().ball()).age = 1; }));
  EXPECT_TRUE(spoilt([](Raw&, const View& v) { const_cast<regista_game&>(v.common().game()).half = 2; }));
  EXPECT_TRUE(spoilt([](Raw&, const View& v) { const_cast<regista_waypoint&>(v.waypoints()[0]).x = 9; }));
  EXPECT_TRUE(spoilt([](Raw&, const View& v) { const_cast<regista_edge&>(v.edges()[0]).to = 9; }));
  EXPECT_TRUE(spoilt([](Raw&, const View& v) { const_cast<std::int32_t&>(v.mine().active()[0]) = 9; }));
}

TEST(Scene, ShowsNoMoreThanIsRead) {
  const Scene scene = FrameBuilder{}
                          .robot(2)
                          .opponent(5, 6)
                          .task(3)
                          .at(1, 2)
                          .waypoint(1, 0)
                          .waypoint(2, 0)
                          .edge(0, 1)
                          .ball(1, 1)
                          .previous(2, 3)
                          .build();
  const auto with = [&](std::uint32_t reads) { return scene.shown({{}, reads}); };
  const Scene nothing = with(REGISTA_READS_NOTHING);
  const regista::Frame frame = nothing.frame();
  EXPECT_TRUE(frame.mine().opponents().empty() && frame.common().opponents().empty());
  EXPECT_TRUE(frame.waypoints().empty() && frame.edges().empty());
  EXPECT_EQ(frame.raw().previous.count, 0u);
  EXPECT_EQ(frame.raw().time_to_task.rows + frame.raw().time_to_task.columns, 0u);
  EXPECT_TRUE(std::isnan(frame.tasks()[0].after[2]) && std::isnan(frame.tasks()[0].before[2]));
  EXPECT_EQ(frame.tasks()[0].after[1], 2.0);
  EXPECT_TRUE(std::isnan(frame.mine().ball().covariance[9]) && std::isnan(frame.common().robot(2).covariance[0]));
  EXPECT_EQ(frame.mine().ball().position[0], 1.0);
  EXPECT_TRUE(nothing.unchanged());
  const Scene mine = with(REGISTA_READS_OPPONENTS_MINE);
  EXPECT_EQ(mine.frame().mine().opponents().size(), 1u);
  EXPECT_TRUE(mine.frame().common().opponents().empty());
  EXPECT_EQ(with(REGISTA_READS_WAYPOINTS).frame().waypoints().size(), 2u);
  EXPECT_EQ(with(REGISTA_READS_EDGES).frame().edges().size(), 1u);
  EXPECT_EQ(with(REGISTA_READS_PREVIOUS).frame().previous_task(2), 3);
  EXPECT_EQ(with(REGISTA_READS_TIMES).raw().time_to_task.rows, 1u);
  EXPECT_EQ(with(REGISTA_READS_FACINGS).frame().tasks()[0].after[2], 0.0);
  EXPECT_EQ(with(REGISTA_READS_COVARIANCES).frame().mine().opponents().size(), 0u);
  EXPECT_EQ(with(REGISTA_READS_COVARIANCES).frame().mine().ball().covariance[9], 0.04);
}

TEST(Scene, EarlierStepsOfADecisionSeeLess) {
  const Scene scene = FrameBuilder{}.robot(2).task(3).waypoint(1, 0).waypoint(2, 0).edge(0, 1).build();
  const Scene placing = scene.before_placing(), deciding = scene.before_tasks();
  EXPECT_EQ(placing.frame().tasks().size(), 1u);
  EXPECT_TRUE(placing.frame().waypoints().empty() && placing.frame().edges().empty());
  EXPECT_EQ(placing.raw().time_to_task.rows, 0u);
  EXPECT_TRUE(deciding.frame().tasks().empty());
}

// Truth: the measures of the SPL rule book 2023.
TEST(EnvironmentBuilder, LandmarksOfTheSplField) {
  const Setting setting = EnvironmentBuilder{}.build();
  std::multiset<std::tuple<int, double, double>> seen;
  for (const regista::Landmark& l : setting.environment().landmarks()) seen.emplace(l.kind, l.x, l.y);
  EXPECT_EQ(seen.size(), 1u + 4u + 2u + 4u + 2u + 4u + 4u);
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      EXPECT_EQ(seen.count({REGISTA_LANDMARK_GOAL_POST, sx * 4.5, sy * 0.8}), 1u);
      EXPECT_EQ(seen.count({REGISTA_LANDMARK_CORNER, sx * 4.5, sy * 3.0}), 1u);
      EXPECT_EQ(seen.count({REGISTA_LANDMARK_T_JUNCTION, sx * 4.5, sy * 1.1}), 1u);
      EXPECT_EQ(seen.count({REGISTA_LANDMARK_T_JUNCTION, sx * 4.5, sy * 2.0}), 1u);
    }
    EXPECT_EQ(seen.count({REGISTA_LANDMARK_PENALTY_MARK, sx * 3.2, 0.0}), 1u);
    EXPECT_EQ(seen.count({REGISTA_LANDMARK_T_JUNCTION, 0.0, sx * 3.0}), 1u);
  }
  EXPECT_EQ(seen.count({REGISTA_LANDMARK_CENTRE, 0.0, 0.0}), 1u);
}

// Truth: the NAO of configs/robots/nao.yaml and the rules of configs/rules/spl2023.yaml.
TEST(EnvironmentBuilder, TheUsualBodyIsANao) {
  const Setting setting = EnvironmentBuilder{}.build();
  const regista::Environment e = setting.environment();
  ASSERT_EQ(e.kicks().size(), 3u);
  EXPECT_STREQ(e.kicks()[1].name, "long");
  EXPECT_EQ(e.kicks()[1].minimum_distance, 5.4);
  EXPECT_EQ(e.kicks()[2].maximum_distance, 1.0);
  EXPECT_EQ(e.kicks()[0].impact, 0.65);
  EXPECT_EQ(e->goal_post_radius, 0.05);
  EXPECT_EQ(e->halves, 2u);
  EXPECT_EQ(e->half_length, 600.0);
  ASSERT_EQ(e.events().size(), static_cast<std::size_t>(REGISTA_EVENT_COUNT));
  EXPECT_STREQ(e.events()[REGISTA_EVENT_GOT_UP].name, "got_up");
  EXPECT_EQ(e.events()[REGISTA_EVENT_GOT_UP].kind, REGISTA_EVENT_GOT_UP);
  EXPECT_EQ(e->set_play_distance, 0.75);
  EXPECT_NEAR(e->head_yaw, std::acos(0.0), 1e-15);
  EXPECT_NEAR(e->kick_reach_angle, std::acos(0.5), 1e-15);
}

TEST(EnvironmentBuilder, KicksAreWhatOneSays) {
  EXPECT_TRUE(EnvironmentBuilder{}.no_kicks().build().environment().kicks().empty());
  const Setting setting = EnvironmentBuilder{}.no_kicks().kick("nudge", 0.1, 0.2, 0.5, 0.3).build({24});
  const regista::Environment e = setting.environment();
  ASSERT_EQ(e.kicks().size(), 1u);
  EXPECT_STREQ(e.kicks()[0].name, "nudge");
  EXPECT_EQ(e.kicks()[0].duration, 0.5);
  EXPECT_EQ(e->kicks.stride, sizeof(regista_kick) + 24);
  const regista_kick* kept = &e.kicks()[0];
  setting.end_of_create();
  EXPECT_TRUE(std::isnan(kept->duration)) << "kicks end with create()";
}

TEST(BodyBuilder, HoldsWhatItWasTold) {
  const BodyBuilder body = BodyBuilder{}.at(1, 2).heading(0.5).task(3).sees_ball().fallen(2.0).robot_near(4, 5);
  EXPECT_EQ(body.raw().pose[1], 2.0);
  EXPECT_EQ(body.raw().pose[2], 0.5);
  EXPECT_EQ(body.raw().task, 3);
  EXPECT_EQ(body.raw().flags, std::uint32_t{REGISTA_BODY_SEES_BALL | REGISTA_BODY_FALLEN});
  EXPECT_EQ(body.raw().time_until_up, 2.0);
  ASSERT_EQ(body.near().size(), 1u);
  EXPECT_EQ(body.near()[0].y, 5.0);
  EXPECT_EQ(BodyBuilder{}.raw().task, -1);
}

TEST(EnvironmentBuilder, RolesKeepTheirNamesAndPrioritiesPerList) {
  const Setting setting =
      EnvironmentBuilder{}.roles({"keeper", "kicker"}).role("seeker", 4, "searching").role("sweeper").build();
  const auto roles = setting.environment().roles();
  ASSERT_EQ(roles.size(), 4u);
  EXPECT_STREQ(roles[1].name, "kicker");
  EXPECT_EQ(roles[1].priority, 1);
  EXPECT_STREQ(roles[2].list, "searching");
  EXPECT_EQ(roles[2].priority, 0);
  EXPECT_EQ(roles[2].robot, 4);
  EXPECT_EQ(roles[3].priority, 2);
}

TEST(Scenes, HaveEveryShapeAndRisingTime) {
  for (const int size : team_sizes) {
    double time = -1.0;
    std::set<std::string> names;
    bool no_rows = false, no_columns = false, more_tasks = false, fewer_tasks = false, crowd = false, common = false;
    for (const Scene& scene : scenes(size)) {
      EXPECT_EQ(scene.team_size(), static_cast<unsigned>(size));
      EXPECT_GT(scene.raw().time, time);
      time = scene.raw().time;
      EXPECT_TRUE(names.insert(scene.name()).second) << scene.name();
      no_rows |= scene.rows() == 0;
      no_columns |= scene.columns() == 0;
      more_tasks |= scene.rows() > 0 && scene.columns() > scene.rows();
      fewer_tasks |= scene.columns() > 0 && scene.columns() < scene.rows();
      crowd |= scene.frame().world().opponents().size() == 11;
      common |= scene.raw().knowledge == REGISTA_COMMON;
      for (const regista::Task& task : scene.frame().tasks()) {
        EXPECT_LT(static_cast<std::size_t>(task.id), usual_roles().size());
        EXPECT_LE(task.robot, size);
      }
    }
    EXPECT_TRUE(no_rows && no_columns && more_tasks && fewer_tasks && crowd && common);
  }
}

bool is_motion(const double (&p)[4][4]) {
  const double place[3] = {p[0][0], p[0][1], p[1][1]};
  const double rest[7] = {p[0][2], p[0][3], p[1][2], p[1][3], p[2][2], p[2][3], p[3][3]};
  return detail::is_covariance(place, rest);
}
bool is_place(const double (&p)[4][4]) {
  const double place[3] = {p[0][0], p[0][1], p[1][1]};
  return detail::is_covariance(place);
}

// Truth: A A^T is positive semi-definite; what is less than it by more than its smallest eigenvalue is not.
TEST(Covariance, IsToldFromWhatIsNone) {
  Dice dice(3);
  for (int round = 0; round < 1000; ++round) {
    double a[4][4], p[4][4];
    const double unit[4] = {1e3, 1.0, 1e-3, 1e-6};
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) a[i][k] = k < 1 + round % 4 ? unit[i] * dice.real(-1, 1) : 0.0;
    }
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        p[i][j] = 0.0;
        for (int k = 0; k < 4; ++k) p[i][j] += a[i][k] * a[j][k];
      }
    }
    EXPECT_TRUE(is_motion(p));
    EXPECT_TRUE(is_place(p));
    const int i = round % 4, j = (i + 1) % 4;
    const bool in_place = i == 0;
    const double before = p[i][j];
    p[i][j] = p[j][i] = 1.001 * std::sqrt(p[i][i] * p[j][j]);
    EXPECT_FALSE(is_motion(p)) << "correlation above 1";
    EXPECT_EQ(is_place(p), !in_place) << "correlation above 1";
    p[i][j] = p[j][i] = before;
    p[i][i] = -p[i][i];
    EXPECT_FALSE(is_motion(p)) << "negative variance";
    EXPECT_EQ(is_place(p), i > 1) << "negative variance";
  }
}

TEST(MeasurementScenario, IsSoundInput) {
  for (const std::uint32_t subject : {1u, 2u, 4u, 8u}) {
    bool nothing = false, twice = false, far = false, packet = false;
    for (const Tick& tick : measurement_scenario(subject, subject != 8u, 1)) {
      EXPECT_GT(tick.dt, 0.0);
      nothing |= tick.corrects && tick.measurements.empty();
      for (const regista_measurement& m : tick.measurements) {
        EXPECT_LE(m.covariance[1] * m.covariance[1], m.covariance[0] * m.covariance[2] * (1 + 1e-12));
        far |= std::abs(m.position[0]) > 100.0;
      }
      twice |= tick.measurements.size() > 1 &&
               std::memcmp(&tick.measurements.front(), &tick.measurements.back(), sizeof(regista_measurement)) == 0;
      if (tick.absorbs) {
        packet = true;
        Findings findings;
        for (const regista_track& track : *tick.absorbs) check_track(track, subject, findings);
        EXPECT_TRUE(findings.empty()) << findings.text();
      }
    }
    EXPECT_TRUE(subject == 8u || (nothing && twice && far)) << subject;
    EXPECT_TRUE(subject == 1u || packet) << subject;
  }
}

TEST(Findings, KeepEachTextOnceAndCountWhatIsLeftOut) {
  Findings findings;
  for (int k = 0; k < 25; ++k) {
    findings.where("corner", "scene " + std::to_string(k));
    findings.say("row ", k, " is wrong");
    findings.say("the same");
  }
  ASSERT_EQ(findings.lines().size(), 21u);
  EXPECT_EQ(findings.lines().at(0), "row 0 is wrong (corner; scene 0)");
  EXPECT_EQ(findings.lines().at(1), "the same (corner; scene 0)");
  EXPECT_EQ(findings.lines().back(), "and 6 more like these");
  EXPECT_TRUE(findings.text().ends_with("and 6 more like these\n"));
  // Doubts are counted apart.
  for (int k = 0; k < 22; ++k) findings.doubt("robot ", k);
  EXPECT_EQ(findings.doubts().back(), "and 2 more like these");
  EXPECT_EQ(findings.lines().back(), "and 6 more like these");
}

}  // namespace
