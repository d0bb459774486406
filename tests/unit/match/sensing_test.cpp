// SPDX-License-Identifier: MIT
// What a robot measures, against brute-force geometry and the profile's laws.
#include "match/sensing.hpp"

#include <gtest/gtest.h>
#include <regista/abi.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "match/chance.hpp"
#include "mind/team_plan.hpp"

namespace regista::match {
namespace {

BodyState standing(double x, double y, double heading) {
  return {static_cast<float>(x),
          static_cast<float>(y),
          static_cast<float>(heading),
          static_cast<float>(std::cos(heading)),
          static_cast<float>(std::sin(heading)),
          0.0f,
          0.0f,
          0.0f};
}

// One robot looks; two a side.
struct Scene {
  config::Robot profile;
  config::Disturbance disturbance;
  config::FieldSize field;
  Roster roster{2};
  Disturbances trouble{disturbance, field, roster.team_size, 1, Side::home};
  Points robots;
  BodyState own = standing(0.0, 0.0, 0.0);
  Vector ball{100.0, 0.0};
  mind::Percepts percepts;

  Scene() {
    robots.count = 4;
    profile.camera.false_balls_per_frame = 0.0;
  }
  void put(int id, double x, double y) {
    robots.x[static_cast<std::size_t>(id)] = static_cast<float>(x);
    robots.y[static_cast<std::size_t>(id)] = static_cast<float>(y);
  }
  struct Counts {
    int balls = 0, robots = 0, landmarks = 0;
  };
  // Robot 0 looks `frames` times; `each` sees every percept.
  template <class Each>
  Counts look(int frames, Each each, double head = 0.0) {
    const Marks marks(field, profile.camera);
    Sensing sensing(profile, trouble, marks, roster, 0, 1, 0.15);
    put(0, own.x, own.y);
    sensing.look(head);
    Counts counts;
    for (int i = 0; i < frames; ++i) {
      sensing.sense({own, ball, robots}, 100.0 + i, static_cast<std::uint32_t>(i), true, percepts);
      counts.balls += static_cast<int>(percepts.balls.size());
      counts.robots += static_cast<int>(percepts.robots.size());
      counts.landmarks += static_cast<int>(percepts.landmarks.size());
      each(percepts);
    }
    return counts;
  }
  Counts look(int frames, double head = 0.0) {
    return look(
        frames, [](const mind::Percepts&) {}, head);
  }
};

TEST(Sensing, SeesTheBallWithItsProbability) {
  Scene scene;
  scene.ball = {2.0, 0.5};
  EXPECT_NEAR(scene.look(20000).balls / 20000.0, 0.9, 0.011);
  scene.disturbance.camera.ball_blindness = 0.5;
  EXPECT_NEAR(scene.look(20000).balls / 20000.0, 0.45, 0.018);
}

TEST(Sensing, SeesNothingOutsideItsSectorAndRange) {
  Scene scene;
  const double edge = scene.profile.camera.half_angle;
  const auto seen = [&](double bearing, double distance, double head) {
    scene.ball = {distance * std::cos(bearing), distance * std::sin(bearing)};
    return scene.look(50, head).balls > 0;
  };
  for (const double head : {0.0, 0.7, -1.2}) {
    EXPECT_TRUE(seen(head + edge - 0.001, 2.0, head));
    EXPECT_TRUE(seen(head - edge + 0.001, 2.0, head));
    EXPECT_FALSE(seen(head + edge + 0.001, 2.0, head));
    EXPECT_FALSE(seen(head - edge - 0.001, 2.0, head));
    EXPECT_FALSE(seen(head + std::numbers::pi, 2.0, head));
    EXPECT_TRUE(seen(head, 4.999, head));
    EXPECT_FALSE(seen(head, 5.001, head));
  }
}

TEST(Sensing, AWideCameraSeesBehindItself) {
  Scene scene;
  scene.profile.camera.half_angle = 2.5;
  scene.ball = {2.0 * std::cos(2.4), 2.0 * std::sin(2.4)};
  EXPECT_GT(scene.look(50).balls, 0);
  scene.ball = {2.0 * std::cos(2.6), 2.0 * std::sin(2.6)};
  EXPECT_EQ(scene.look(50).balls, 0);
}

// Brute force: does a disc cut the segment between the eye and the object?
TEST(Sensing, SeesNothingBehindARobot) {
  Chance chance(11, Purpose::robot, Side::home, 0, 0, 0);
  int hidden_scenes = 0, open_scenes = 0;
  for (int i = 0; i < 2000; ++i) {
    Scene scene;
    scene.own = standing(chance.uniform() - 0.5, chance.uniform() - 0.5, 0.3);
    const Vector eye{scene.own.x, scene.own.y};
    const auto place = [&](double distance) {
      const double bearing = 0.3 + 0.4 * (2.0 * chance.uniform() - 1.0);
      return eye + distance * Vector{std::cos(bearing), std::sin(bearing)};
    };
    const double far = 1.0 + 3.0 * chance.uniform();
    scene.ball = place(far);
    const double near = 0.4 + 3.5 * chance.uniform();
    const Vector robot = place(near);
    scene.put(2, robot.x, robot.y);
    if (std::fabs(far - near) < 0.2) continue;
    const Vector way = scene.ball - eye;
    double nearest = 1e9;
    for (int k = 0; k <= 2000; ++k) nearest = std::fmin(nearest, length(eye + (k / 2000.0) * way - robot));
    if (std::fabs(nearest - 0.15) < 0.002) continue;
    const bool hides = nearest < 0.15;
    ASSERT_EQ(scene.look(20).balls == 0, hides);
    (hides ? hidden_scenes : open_scenes) += 1;
  }
  EXPECT_GT(hidden_scenes, 100);
  EXPECT_GT(open_scenes, 100);
}

TEST(Sensing, NoiseHasTheProfilesDeviation) {
  Scene scene;
  scene.own = standing(1.0, -1.0, 2.0);
  const double bearing = 0.3, distance = 3.0;
  scene.ball = Vector{scene.own.x, scene.own.y} + distance * Vector{std::cos(2.0 + bearing), std::sin(2.0 + bearing)};
  double sum = 0.0, squares = 0.0, angles = 0.0, angle_squares = 0.0;
  const int seen = scene
                       .look(20000,
                             [&](const mind::Percepts& percepts) {
                               for (const auto& ball : percepts.balls) {
                                 const double d = ball.position.norm() / distance - 1.0;
                                 const double a = std::atan2(ball.position.y(), ball.position.x()) - bearing;
                                 sum += d;
                                 squares += d * d;
                                 angles += a;
                                 angle_squares += a * a;
                                 EXPECT_NEAR(ball.along, 3.0 * scene.profile.camera.distance_noise, 1e-6);
                                 EXPECT_NEAR(ball.across, 3.0 * scene.profile.camera.bearing_noise, 1e-6);
                               }
                             })
                       .balls;
  EXPECT_NEAR(sum / seen, 0.0, 0.002);
  EXPECT_NEAR(std::sqrt(squares / seen) / scene.profile.camera.distance_noise, 1.0, 0.03);
  EXPECT_NEAR(angles / seen, 0.0, 0.001);
  EXPECT_NEAR(std::sqrt(angle_squares / seen) / scene.profile.camera.bearing_noise, 1.0, 0.03);
}

TEST(Sensing, SeesRobotsWithColourAndWithoutName) {
  Scene scene;
  scene.put(1, 1.0, 0.2);   // teammate
  scene.put(3, 2.0, -0.3);  // opponent
  int own = 0, other = 0;
  scene.look(20000, [&](const mind::Percepts& percepts) {
    for (std::size_t i = 0; i < percepts.robots.size(); ++i) {
      const auto& robot = percepts.robots[i];
      (robot.own_team ? own : other) += 1;
      EXPECT_NEAR(robot.position.x(), robot.own_team ? 1.0 : 2.0, 0.6);
      if (i > 0) {
        EXPECT_GE(robot.position.norm(), percepts.robots[i - 1].position.norm());
      }
    }
  });
  EXPECT_NEAR(own / 20000.0, 0.6, 0.018);
  EXPECT_NEAR(other / 20000.0, 0.6, 0.018);
  scene.put(1, nowhere, nowhere);  // penalised
  scene.put(3, 4.1, 0.0);          // out of range
  EXPECT_EQ(scene.look(200).robots, 0);
}

TEST(Sensing, FalseBallsComeAtTheirRateAndInsideTheSector) {
  Scene scene;
  scene.profile.camera.false_balls_per_frame = 0.2;
  const int seen = scene
                       .look(
                           20000,
                           [&](const mind::Percepts& percepts) {
                             for (const auto& ball : percepts.balls) {
                               EXPECT_LE(ball.position.norm(), 5.0);
                               EXPECT_LE(std::fabs(std::atan2(ball.position.y(), ball.position.x()) - 0.5),
                                         scene.profile.camera.half_angle + 1e-9);
                             }
                           },
                           0.5)
                       .balls;
  EXPECT_NEAR(seen / 20000.0, 0.2, 0.015);
}

TEST(Sensing, TheHeadTurnsAtItsSpeedAndNoFarther) {
  Scene scene;
  const Marks marks(scene.field, scene.profile.camera);
  Sensing sensing(scene.profile, scene.trouble, marks, scene.roster, 0, 1, 0.15);
  sensing.sense({scene.own, scene.ball, scene.robots}, 1.0, 0, true, scene.percepts);
  EXPECT_EQ(scene.percepts.view.heading, 0.0);
  sensing.look(9.0);
  sensing.sense({scene.own, scene.ball, scene.robots}, 1.1, 1, true, scene.percepts);
  EXPECT_NEAR(scene.percepts.view.heading, 0.1 * scene.profile.camera.head_speed, 1e-12);
  sensing.sense({scene.own, scene.ball, scene.robots}, 9.0, 2, true, scene.percepts);
  EXPECT_NEAR(scene.percepts.view.heading, scene.profile.camera.head_yaw, 1e-12);
}

TEST(Sensing, ABlindRobotSeesNothing) {
  Scene scene;
  scene.ball = {1.0, 0.0};
  const Marks marks(scene.field, scene.profile.camera);
  Sensing sensing(scene.profile, scene.trouble, marks, scene.roster, 0, 1, 0.15);
  for (std::uint32_t tick = 0; tick < 50; ++tick) {
    sensing.sense({scene.own, scene.ball, scene.robots}, tick, tick, false, scene.percepts);
    EXPECT_FALSE(scene.percepts.camera);
    EXPECT_TRUE(scene.percepts.balls.empty() && scene.percepts.landmarks.empty());
  }
}

TEST(Sensing, LandmarksComeFromTheirList) {
  Scene scene;
  scene.profile.camera.distance_noise = scene.profile.camera.bearing_noise = 0.0;
  scene.own = standing(3.0, 0.0, 0.0);
  const auto all = mind::landmarks(scene.field);
  EXPECT_EQ(all.size(), 21u);
  int posts = 0;
  scene.look(
      2000,
      [&](const mind::Percepts& percepts) {
        for (const auto& seen : percepts.landmarks) {
          bool exists = false;
          for (const auto& mark : all) {
            exists = exists || (mark.kind == seen.kind &&
                                std::hypot(mark.x - 3.0 - seen.position.x(), mark.y - seen.position.y()) < 1e-5);
          }
          ASSERT_TRUE(exists);
          posts += seen.kind == REGISTA_LANDMARK_GOAL_POST ? 1 : 0;
        }
      },
      0.45);
  EXPECT_NEAR(posts / 2000.0, 0.9, 0.04);  // the left one; the right one is outside of the view
}

TEST(Sensing, OdometryIsTheTrueMotionWithItsNoise) {
  Scene scene;
  scene.profile.odometry.scale_bias = 0.0;
  const Marks marks(scene.field, scene.profile.camera);
  Sensing sensing(scene.profile, scene.trouble, marks, scene.roster, 0, 1, 0.15);
  const auto sense = [&](double x, double y, double heading, std::uint32_t tick) {
    scene.own = standing(x, y, heading);
    sensing.sense({scene.own, scene.ball, scene.robots}, tick, tick, false, scene.percepts);
  };
  sense(0.0, 0.0, 1.0, 0);
  double stretch = 0.0, squares = 0.0, turn_squares = 0.0;
  constexpr int count = 5000;
  for (std::uint32_t i = 1; i <= count; ++i) {
    // 0.1 m ahead and 0.05 m to the left as seen at the beginning, then 0.2 rad.
    const double heading = 1.0;
    sense(0.1 * std::cos(heading) - 0.05 * std::sin(heading), 0.1 * std::sin(heading) + 0.05 * std::cos(heading),
          heading + 0.2, 2 * i);
    const mind::Pose step = scene.percepts.odometry;
    ASSERT_NEAR(step.y / step.x, 0.5, 1e-5);
    stretch += step.x / 0.1 - 1.0;
    squares += std::pow(step.x / 0.1 - 1.0, 2);
    turn_squares += std::pow(step.heading / 0.2 - 1.0, 2);
    sense(0.0, 0.0, heading, 2 * i + 1);
  }
  EXPECT_NEAR(stretch / count, 0.0, 0.004);
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.003);
  EXPECT_NEAR(std::sqrt(turn_squares / count), 0.05, 0.003);
  sense(0.0, 0.0, 1.0, 3 * count);
  EXPECT_EQ(scene.percepts.odometry.x, 0.0) << "standing is measured well";
}

TEST(Sensing, TheScaleBiasIsDrawnOncePerRobot) {
  double squares = 0.0;
  constexpr int matches = 3000;
  for (int seed = 0; seed < matches; ++seed) {
    Scene scene;
    scene.profile.odometry.distance_noise = 0.0;
    const Marks marks(scene.field, scene.profile.camera);
    Sensing sensing(scene.profile, scene.trouble, marks, scene.roster, 0, static_cast<std::uint64_t>(seed), 0.15);
    double first = 0.0;
    for (std::uint32_t tick = 0; tick < 4; ++tick) {
      scene.own = standing(tick, 0.0, 0.0);
      sensing.sense({scene.own, scene.ball, scene.robots}, tick, tick, false, scene.percepts);
      if (tick == 1) first = scene.percepts.odometry.x;
      if (tick > 1) {
        ASSERT_DOUBLE_EQ(scene.percepts.odometry.x, first);
      }
    }
    squares += (first - 1.0) * (first - 1.0);
  }
  EXPECT_NEAR(std::sqrt(squares / matches), 0.03, 0.002);
}

TEST(Sensing, APlacedRobotKnowsWhereInItsOwnFieldFrame) {
  Scene scene;
  const Marks marks(scene.field, scene.profile.camera);
  Sensing sensing(scene.profile, scene.trouble, marks, scene.roster, 0, 1, 0.15);
  double squares = 0.0;
  constexpr int count = 4000;
  for (std::uint32_t tick = 0; tick < count; ++tick) {
    sensing.put_down({1.0, 2.0, 0.5}, -1.0, tick);
    sensing.sense({scene.own, scene.ball, scene.robots}, tick, tick, false, scene.percepts);
    ASSERT_TRUE(scene.percepts.placed);
    EXPECT_EQ(scene.percepts.odometry.x, 0.0) << "carried, not walked";
    squares += std::pow(scene.percepts.placed->pose.x + 1.0, 2);
    EXPECT_NEAR(scene.percepts.placed->pose.y, -2.0, 0.35);
    EXPECT_NEAR(scene.percepts.placed->pose.heading, 0.5 - std::numbers::pi, 0.35);
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.004);
  sensing.sense({scene.own, scene.ball, scene.robots}, count, count, false, scene.percepts);
  EXPECT_FALSE(scene.percepts.placed);
}

// --- Troubles --------------------------------------------------------------------------------------------------------

config::Disturbance from_the_start(config::Incident incident) {
  incident.at = {0.0};
  config::Disturbance out;
  out.incidents = {incident};
  return out;
}

// Robot 0 stands at `own` and looks `frames` times.
template <class Each>
void look_disturbed(const config::Disturbance& disturbance, const BodyState& own, double direction, int frames,
                    Each each) {
  Scene scene;
  const Marks marks(scene.field, scene.profile.camera);
  Disturbances trouble(disturbance, scene.field, scene.roster.team_size, 1, Side::home);
  trouble.update(0.0);
  Sensing sensing(scene.profile, trouble, marks, scene.roster, 0, 1, 0.15);
  sensing.put_down({own.x, own.y, own.heading}, direction, 0);
  scene.ball = {0.0, 2.0};
  for (int i = 0; i < frames; ++i) {
    sensing.sense({own, scene.ball, scene.robots}, 100.0 + i, static_cast<std::uint32_t>(i), true, scene.percepts);
    each(scene.percepts);
  }
}

TEST(GhostBall, IsSeenAtItsPlaceAsOftenAsTheBallWouldBe) {
  config::Incident ghost;
  ghost.kind = config::Incident::Kind::ghost_ball;
  ghost.x = 2.0;
  ghost.y = 0.5;
  constexpr int frames = 4000;
  for (const double direction : {1.0, -1.0}) {  // in either half it lies at the same place of the team's field frame
    int seen = 0;
    Vector sum;
    // Looks at it from a place that is the same in the team's frame.
    const BodyState own = standing(direction * 1.0, direction * 0.5, direction > 0.0 ? 0.0 : std::numbers::pi);
    look_disturbed(from_the_start(ghost), own, direction, frames, [&](const mind::Percepts& percepts) {
      for (const auto& ball : percepts.balls) {
        ++seen;
        sum = sum + Vector{ball.position.x(), ball.position.y()};
      }
    });
    EXPECT_NEAR(seen / double(frames), 0.9, 4.0 * std::sqrt(0.09 / frames));
    EXPECT_NEAR(sum.x / seen, 1.0, 0.005);
    EXPECT_NEAR(sum.y / seen, 0.0, 0.005);
  }
}

TEST(BlindCamera, GivesImagesWithNothingInThem) {
  config::Incident blind;
  blind.kind = config::Incident::Kind::blind_camera;
  config::Incident ghost;
  ghost.kind = config::Incident::Kind::ghost_ball;
  ghost.x = 2.0;
  ghost.y = 0.0;
  config::Disturbance disturbance = from_the_start(blind);
  ghost.at = {0.0};
  disturbance.incidents.push_back(ghost);
  disturbance.camera.ghost_balls = 10.0;
  look_disturbed(disturbance, standing(0.0, 0.0, 0.0), 1.0, 100, [&](const mind::Percepts& percepts) {
    EXPECT_TRUE(percepts.camera);
    EXPECT_TRUE(percepts.balls.empty() && percepts.robots.empty() && percepts.landmarks.empty());
  });
}

// The landmarks of a robot with a biased pose are those of an undisturbed one that stands there.
TEST(PoseBias, ShowsLandmarksAsFromTheBiasedPose) {
  config::Incident bias;
  bias.kind = config::Incident::Kind::pose_bias;
  bias.x = 0.4;
  bias.y = -0.3;
  bias.heading = 0.2;
  for (const double direction : {1.0, -1.0}) {
    const BodyState own = standing(2.0, 0.5, 0.1);
    const BodyState there = standing(2.0 + direction * 0.4, 0.5 - direction * 0.3, 0.3);
    std::vector<mind::LandmarkSighting> expected, seen;
    std::vector<mind::PlacedPose> told;
    look_disturbed({}, there, direction, 200, [&](const mind::Percepts& percepts) {
      expected.insert(expected.end(), percepts.landmarks.begin(), percepts.landmarks.end());
    });
    look_disturbed(from_the_start(bias), own, direction, 200, [&](const mind::Percepts& percepts) {
      seen.insert(seen.end(), percepts.landmarks.begin(), percepts.landmarks.end());
      if (percepts.placed) told.push_back(*percepts.placed);
    });
    ASSERT_GT(expected.size(), 100u);
    ASSERT_EQ(seen.size(), expected.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_EQ(seen[i].kind, expected[i].kind);
      EXPECT_NEAR((seen[i].position - expected[i].position).norm(), 0.0, 1e-5);
    }
    ASSERT_EQ(told.size(), 1u);
    EXPECT_NEAR(told[0].pose.x, direction * there.x, 0.2);
    EXPECT_NEAR(told[0].pose.y, direction * there.y, 0.2);
  }
}

TEST(BallBlindness, HidesGhostsToo) {
  config::Incident ghost;
  ghost.kind = config::Incident::Kind::ghost_ball;
  ghost.x = 2.0;
  ghost.y = 0.0;
  config::Disturbance disturbance = from_the_start(ghost);
  disturbance.camera.ball_blindness = 1.0;
  look_disturbed(disturbance, standing(0.0, 0.0, 0.0), 1.0, 100,
                 [&](const mind::Percepts& percepts) { EXPECT_TRUE(percepts.balls.empty()); });
}

}  // namespace
}  // namespace regista::match
