// SPDX-License-Identifier: MIT
// Every promise of an action that can be broken, beside the message that names robot, tick and value.
#include "plugin/kinds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "plugin/call_inputs.hpp"
#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
std::function<void(regista_action&)> answer;  // of the behaviour below

// The puppet as a behaviour whose robot has two kinds of kick.
class BehaviourTest : public PuppetTest {
 protected:
  static const void* table(std::int32_t kind) {
    static const regista_behaviour calls{
        sizeof calls, 0,
        [](void*, const regista_frame*, const regista_body*, regista_action* out, regista_error*) -> std::int32_t {
          answer(*out);
          return REGISTA_OK;
        }};
    return kind == REGISTA_KIND_BEHAVIOUR ? &calls : nullptr;
  }

  // What the check says of an action that is changed so; nothing when it is sound.
  std::string said(std::function<void(regista_action&)> change) {
    answer = std::move(change);
    static const regista_descriptor descriptor = [] {
      regista_descriptor out = Puppet::descriptor();
      out.table = &table;
      return out;
    }();
    static const regista_kick kicks[]{{"fast", 1.6, 4.5, 1.6, 0.65, 0.07, 0.1},
                                      {"long", 5.4, 5.4, 1.65, 0.65, 0.0, 0.0}};
    regista_environment place = environment();
    place.kicks = {kicks, 2, sizeof(regista_kick)};
    static const Caller caller{"paper", 3, 417};
    Behaviour behaviour(std::make_shared<Instance>(Found{"puppet.so", &descriptor}, resolve(descriptor, use("puppet")),
                                                   place, nullptr, &caller));
    const Scene scene;
    regista_body body{};
    body.size = sizeof body;
    body.task = -1;
    return message_of([&] { last_ = behaviour.act(scene.frame, body); });
  }
  static std::string broken(const std::string& what) { return Puppet::failure("act: " + what); }

  std::optional<regista_action> last_;
};

TEST_F(BehaviourTest, OnEntryItStandsAndLooksAhead) {
  EXPECT_EQ(said([](regista_action& action) {
              EXPECT_EQ(action.size, sizeof action);
              EXPECT_EQ(action.motion, REGISTA_MOTION_STAND);
              EXPECT_EQ(action.kick, REGISTA_NO_KICK);
              EXPECT_EQ(action.gaze, 0.0);
              EXPECT_EQ(action.avoid_count, 0u);
            }),
            "");
  ASSERT_TRUE(last_);
  EXPECT_EQ(last_->kick, REGISTA_NO_KICK);
}

TEST_F(BehaviourTest, PlacesAreFiniteAndNear) {
  const auto walk = [](double x, double y, double heading) {
    return [=](regista_action& action) {
      action.motion = REGISTA_MOTION_WALK_TO;
      action.pose[0] = x;
      action.pose[1] = y;
      action.pose[2] = heading;
    };
  };
  EXPECT_EQ(said(walk(1.0, -2.0, 3.0)), "");
  EXPECT_EQ(said(walk(nan, 0.0, 0.0)), broken("walks to (nan, 0), heading 0"));
  EXPECT_EQ(said(walk(0.0, 2e4, 0.0)), broken("walks to (0, 20000), heading 0"));
  EXPECT_EQ(said(walk(0.0, 0.0, nan)), broken("walks to (0, 0), heading nan"));
  EXPECT_EQ(said([](regista_action& action) { action.pose[0] = nan; }), "") << "it stands: nobody looks at the pose";
}

TEST_F(BehaviourTest, VelocitiesAreFiniteWhereTheyAreUsed) {
  EXPECT_EQ(said([](regista_action& action) {
              action.motion = REGISTA_MOTION_VELOCITY;
              action.velocity[1] = nan;
            }),
            broken("velocity is (0, nan), turn 0"));
  EXPECT_EQ(said([](regista_action& action) {
              action.motion = REGISTA_MOTION_WALK_TO;
              action.velocity[1] = nan;
            }),
            "");
  EXPECT_EQ(said([](regista_action& action) {
              action.motion = REGISTA_MOTION_WALK_TO;
              action.walk = REGISTA_WALK_CREEP;
              action.velocity[0] = nan;
            }),
            broken("velocity is (nan, 0), turn 0"));
}

TEST_F(BehaviourTest, MotionsExist) {
  EXPECT_EQ(said([](regista_action& action) { action.motion = 7; }), broken("motion 7 does not exist"));
}

TEST_F(BehaviourTest, DiscsToAvoidAreThereAndRound) {
  const auto avoids = [](std::uint32_t count, regista_disc first) {
    return [=](regista_action& action) {
      action.motion = REGISTA_MOTION_WALK_TO;
      action.avoid_count = count;
      action.avoid[0] = first;
    };
  };
  EXPECT_EQ(said(avoids(1, {1.0, 2.0, 0.3})), "");
  EXPECT_EQ(said(avoids(9, {1.0, 2.0, 0.3})), broken("avoids 9 discs; there is room for 8"));
  EXPECT_EQ(said(avoids(1, {1.0, 2.0, -0.3})), broken("avoids a disc at (1, 2) of radius -0.3"));
  EXPECT_EQ(said(avoids(1, {nan, 2.0, 0.3})), broken("avoids a disc at (nan, 2) of radius 0.3"));
}

TEST_F(BehaviourTest, KicksAreThoseOfTheRobot) {
  const auto kicks = [](int kick, double distance, double direction) {
    return [=](regista_action& action) {
      action.kick = kick;
      action.kick_distance = distance;
      action.kick_direction = direction;
    };
  };
  EXPECT_EQ(said(kicks(0, 4.5, -0.2)), "");
  EXPECT_EQ(said(kicks(1, 5.4, 3.0)), "");
  EXPECT_EQ(said(kicks(2, 1.0, 0.0)), broken("kick 2 of 2 does not exist"));
  EXPECT_EQ(said(kicks(-2, 1.0, 0.0)), broken("kick -2 of 2 does not exist"));
  EXPECT_EQ(said(kicks(0, 9.0, 0.0)), broken("asks kick 0 (fast) to roll 9 m; it rolls 1.6 to 4.5 m"));
  EXPECT_EQ(said(kicks(0, nan, 0.0)), broken("asks kick 0 (fast) to roll nan m; it rolls 1.6 to 4.5 m"));
  EXPECT_EQ(said(kicks(0, 2.0, 4.0)), broken("kick's direction is 4; it is within -pi and pi"));
}

TEST_F(BehaviourTest, GazeAndTargetAreFinite) {
  EXPECT_EQ(said([](regista_action& action) { action.gaze = 9.0; }), broken("gaze is 9; it is within -pi and pi"));
  EXPECT_EQ(said([](regista_action& action) { action.gaze = nan; }), broken("gaze is nan; it is within -pi and pi"));
  EXPECT_EQ(said([](regista_action& action) { action.target[0] = nan; }), "") << "it tells of none";
  EXPECT_EQ(said([](regista_action& action) {
              action.flags = REGISTA_ACTION_TARGET;
              action.target[0] = nan;
            }),
            broken("tells of a target at (nan, 0)"));
}

// --- Declared reads -------------------------------------------------------------------------------------------------

struct Whole {
  Whole() {
    for (regista_world* world : {&mine, &common}) {
      *world = {sizeof mine, 0, &game, &ball, {&robot, 1, sizeof robot}, {&opponent, 1, sizeof opponent}, {}};
    }
    frame.size = sizeof frame;
    frame.mine = &mine;
    frame.common = &common;
    frame.tasks = {&task, 1, sizeof task};
    frame.waypoints = {&point, 1, sizeof point};
    frame.edges = {&edge, 1, sizeof edge};
    frame.previous = {&previous, 1, sizeof previous};
    frame.time_to_task = {&time, 1, 1, 1, 0};
  }
  regista_game game{};
  regista_ball ball{};
  regista_robot robot{};
  regista_opponent opponent{};
  regista_task task{};
  regista_waypoint point{};
  regista_edge edge{};
  std::int32_t previous = 0;
  double time = 1.0;
  regista_world mine{}, common{};
  regista_frame frame{};
};

TEST(DeclaredReadsTest, LeaveOutWhatIsNotDeclaredAndNothingElse) {
  Whole whole;
  whole.robot.pose[0] = 2.5;
  whole.ball.position[1] = -1.5;
  DeclaredReads nothing(REGISTA_READS_NOTHING);
  const regista_frame& shown = *nothing.of(whole.frame);
  EXPECT_EQ(shown.mine->opponents.count, 0u);
  EXPECT_EQ(shown.common->opponents.count, 0u);
  EXPECT_EQ(shown.waypoints.count, 0u);
  EXPECT_EQ(shown.edges.count, 0u);
  EXPECT_EQ(shown.previous.data, nullptr);
  EXPECT_EQ(shown.time_to_task.values, nullptr);
  const auto& task = *static_cast<const regista_task*>(shown.tasks.data);
  EXPECT_TRUE(std::isnan(task.before[2]) && std::isnan(task.after[2]));
  const auto& robot = *static_cast<const regista_robot*>(shown.mine->robots.data);
  EXPECT_TRUE(std::isnan(robot.covariance[0]) && std::isnan(shown.common->ball->covariance[9]));
  EXPECT_EQ(robot.pose[0], 2.5);
  EXPECT_EQ(shown.mine->ball->position[1], -1.5);
  EXPECT_EQ(task.after[0], 0.0);
  EXPECT_EQ(whole.robot.covariance[0], 0.0) << "the host's own stays what it is";
}

TEST(DeclaredReadsTest, EachPartByItself) {
  Whole whole;
  const auto shown = [&](std::uint32_t reads, auto look) {
    DeclaredReads declared(reads);
    return look(*declared.of(whole.frame));
  };
  EXPECT_EQ(shown(REGISTA_READS_OPPONENTS_MINE, [](const regista_frame& f) { return f.mine->opponents.count; }), 1u);
  EXPECT_EQ(shown(REGISTA_READS_OPPONENTS_MINE, [](const regista_frame& f) { return f.common->opponents.count; }), 0u);
  EXPECT_EQ(shown(REGISTA_READS_OPPONENTS_COMMON, [](const regista_frame& f) { return f.common->opponents.count; }),
            1u);
  EXPECT_EQ(shown(REGISTA_READS_WAYPOINTS, [](const regista_frame& f) { return f.waypoints.count; }), 1u);
  EXPECT_EQ(shown(REGISTA_READS_EDGES, [](const regista_frame& f) { return f.edges.count; }), 1u);
  EXPECT_EQ(shown(REGISTA_READS_PREVIOUS, [](const regista_frame& f) { return f.previous.count; }), 1u);
  EXPECT_EQ(shown(REGISTA_READS_TIMES, [](const regista_frame& f) { return f.time_to_task.values[0]; }), 1.0);
  EXPECT_EQ(shown(REGISTA_READS_COVARIANCES, [](const regista_frame& f) { return f.mine->ball->covariance[0]; }), 0.0);
  EXPECT_EQ(shown(REGISTA_READS_FACINGS,
                  [](const regista_frame& f) { return static_cast<const regista_task*>(f.tasks.data)->after[2]; }),
            0.0);
}

}  // namespace
}  // namespace regista::plugin::test
