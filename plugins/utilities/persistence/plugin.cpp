// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: who holds which role, and for how long, in the chosen world.
//
// In `mine` the own role is the one of this robot's last assignment. In `common` the own row is what was last sent,
// like every other row: nothing that teammates cannot know may enter a matrix that all are to share.
#include <vector>

#include <regista/utility.hpp>

#include "algorithm.hpp"

namespace {

enum class ForRobots { all, own };

struct Persistence {
  static constexpr auto id = "persistence", version = "1.2.0", summary = "How long the robot has held the role";
  static constexpr unsigned reads = REGISTA_READS_PREVIOUS;
  persistence_utility::Settings settings;
  ForRobots for_robots = ForRobots::all;
  static constexpr std::array<const char*, 2> for_robots_choices{"all", "own"};
  static constexpr std::tuple parameters{
      regista::within(
          &Persistence::settings,
          regista::real("ramp_seconds", &persistence_utility::Settings::ramp_seconds, {0.0, 120.0}, "s",
                        "Time from which on a held role counts fully, 0: at once; SPQR 2022: 10, 2023: 0")
              .tunable(),
          regista::real(
              "fade", &persistence_utility::Settings::fade, {0.0, 1.0}, "1",
              "Factor for each whole second for which the role has been held; 1: it does not fade; SPQR 2022: 1, "
              "2023: 0.9")
              .tunable(),
          regista::boolean("step", &persistence_utility::Settings::step,
                           "A role counts nothing before `ramp_seconds`; SPQR 2022, whose whole numbers make it so")),
      regista::choice("for_robots", &Persistence::for_robots, for_robots_choices,
                      "all: every robot's role counts; own: only the own one, as in SPQR's released code")};

  std::vector<persistence_utility::Holder> holders;
  std::vector<int> tasks;

  void setup(const regista::Environment& environment) {
    holders.reserve(environment->team_size);
    tasks.reserve(environment.roles().size());
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    const bool is_private = frame.raw().knowledge == REGISTA_MINE;
    holders.clear();
    tasks.clear();
    for (const int number : world.active()) {
      const bool own = number == frame.own_number();
      const regista::Robot& robot = world.robot(number);
      persistence_utility::Holder holder;
      if (own || for_robots == ForRobots::all) {
        holder.role = own && is_private ? frame.previous_task(number) : robot.role;
        holder.held = holder.role == robot.role ? frame.time() - robot.role_since : 0.0;
      }
      holders.push_back(holder);
    }
    for (const regista::Task& task : frame.tasks()) tasks.push_back(task.id);
    persistence_utility::score(holders, tasks, settings, out.data(), out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(Persistence, regista::utility)
