// SPDX-License-Identifier: MIT
// Positioner plugin around field.hpp: one point for each task that any robot may take, bound to that task. With
// `tasks.offset.at_most` large the roles are played there. The base point of a role is the place that its rule gives.
//
// Our decisions. Whoever plays a role does not repel itself from it: of teammates, those repel that say they play
// another one of the tasks, for a robot without a role will have one in a moment. The last pose is what the robot that
// plays the role has last said to walk to, not what this robot has computed: so all who know the same prefer the same,
// and nothing is remembered. The heading stays that of the role's rule. A role that is bound to one robot, as the
// goalkeeper's, has no field, nor has one that the offset leaves where it is, as the striker's, where the host tells.
#include <algorithm>
#include <optional>
#include <vector>

#include <regista/positioner.hpp>
#include <regista/roles.hpp>

#include "field.hpp"

namespace {

struct PreferredPoses {
  static constexpr auto id = "preferred_poses", version = "1.0.0",
                        summary = "Places of roles moved off teammates, opponents and the border (CS Freiburg)";
  static constexpr unsigned reads = REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_OPPONENTS_COMMON;
  preferred_poses::Settings settings;
  double likely = 0.5;
  using S = preferred_poses::Settings;
  static constexpr regista::Range metres{0.05, 10.0};
  static constexpr std::tuple parameters{
      regista::within(
          &PreferredPoses::settings,
          regista::real("region", &S::region, {0.0, 3.0}, "m",
                        "The region of a role reaches so far from its own place along either axis (assumption)")
              .tunable(),
          regista::real("step", &S::step, {0.1, 2.0}, "m", "Distance between points of the grid (assumption)"),
          regista::real("mate_reach", &S::mate_reach, metres, "m",
                        "Teammates that play other roles repel so far (assumption)")
              .tunable(),
          regista::real("opponent_reach", &S::opponent_reach, metres, "m", "Opponents repel so far (assumption)")
              .tunable(),
          regista::real("border_reach", &S::border_reach, metres, "m", "The lines repel so far inwards (assumption)")
              .tunable(),
          regista::real("home_reach", &S::home_reach, metres, "m", "The role's own place attracts so far (assumption)")
              .tunable(),
          regista::real("home_weight", &S::home_weight, {0.0, 10.0}, "1",
                        "Attraction of the role's own place; each thing that repels has 1 (assumption)")
              .tunable(),
          regista::real("last_bonus", &S::last_bonus, {0.0, 1.0}, "1",
                        "The point that the role's robot last said to walk to counts so much more (assumption)")
              .tunable()),
      regista::real("likely", &PreferredPoses::likely, {0.0, 1.0}, "1",
                    "Opponents whose existence is less probable do not repel (assumption)")
          .tunable()};

  // A teammate that says to play one of the tasks.
  struct Player {
    preferred_poses::Point at;
    std::int32_t role;
    std::optional<preferred_poses::Point> target;
  };
  preferred_poses::Search search;
  preferred_poses::Lawn lawn{};
  std::vector<Player> players;
  std::vector<preferred_poses::Point> mates, opponents;
  std::vector<char> stays;  // by id: the offset leaves the role where it is

  void setup(const regista::Environment& environment, const regista::Host& host) {
    lawn = {environment->field_length / 2.0, environment->field_width / 2.0};
    constexpr std::size_t most_opponents = 64;  // more than a world has; only memory depends on it
    players.reserve(environment->team_size);
    mates.reserve(environment->team_size);
    opponents.reserve(most_opponents);
    search.reserve(std::max<std::size_t>(most_opponents, environment->team_size));
    const regista::Roles roles(host);
    for (int role = 0; role < static_cast<int>(environment.roles().size()); ++role) {
      const std::optional<regista::RoleFacts> facts = roles.role(role);
      stays.push_back(facts && facts->moves == 0 ? 1 : 0);
    }
  }

  void place(const regista::Frame& frame, regista::Placement out) {
    const regista::World world = frame.world();
    opponents.clear();
    for (const regista::Opponent& opponent : world.opponents()) {
      if (opponent.weight >= likely) opponents.push_back({opponent.position[0], opponent.position[1]});
    }
    read_players(frame, world);
    int index = 0;
    for (const regista::Task& task : frame.tasks()) {
      if (task.robot == 0 && stays[static_cast<std::size_t>(task.id)] == 0) {
        const preferred_poses::Point best = search.best(scene_of(task), lawn, settings);
        out.point(best.x, best.y, 1.0, index);
      }
      ++index;
    }
  }

 private:
  void read_players(const regista::Frame& frame, const regista::World& world) {
    players.clear();
    for (const int number : world.active()) {
      const regista::Robot& robot = world.robot(number);
      bool plays = false;
      for (const regista::Task& task : frame.tasks()) plays = plays || task.id == robot.role;
      if (!plays) continue;
      Player& player = players.emplace_back(Player{{robot.pose[0], robot.pose[1]}, robot.role, std::nullopt});
      if ((robot.flags & REGISTA_ROBOT_HAS_TARGET) != 0) player.target = {robot.target[0], robot.target[1]};
    }
  }

  preferred_poses::Scene scene_of(const regista::Task& task) {
    preferred_poses::Scene scene{{}, opponents, lawn.nearest({task.before[0], task.before[1]}), std::nullopt};
    mates.clear();
    for (const Player& player : players) {
      if (player.role != task.id) {
        mates.push_back(player.at);
      } else if (!scene.last) {
        scene.last = player.target;
      }
    }
    scene.mates = mates;
    return scene;
  }
};

}  // namespace

REGISTA_PLUGIN(PreferredPoses, regista::positioner)
