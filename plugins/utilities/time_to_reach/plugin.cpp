// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the host's times of the chosen world's active robots to the tasks, which contain
// what is left of getting up.
#include <vector>

#include <regista/utility.hpp>

#include "algorithm.hpp"

namespace {

using time_to_reach::Settings;

struct TimeToReach {
  static constexpr auto id = "time_to_reach", version = "1.0.0", summary = "How soon the robot can be at the task";
  static constexpr unsigned reads = REGISTA_READS_PREVIOUS | REGISTA_READS_TIMES;
  Settings settings;
  double getting_up = 0.0;
  static constexpr std::array<const char*, 2> forms{"linear", "inverse"};
  static constexpr std::tuple parameters{
      regista::within(
          &TimeToReach::settings,
          regista::choice("form", &Settings::form, forms,
                          "linear: max(0, 1 - t / scale); inverse: 1 / (1 + t / scale); our choice"),
          regista::real(
              "scale", &Settings::scale, {0.5, 600.0}, "s",
              "Time at which the utility is 0 (linear) or a half (inverse); our choice: 60, from corner to corner "
              "after getting up")
              .tunable(),
          regista::real(
              "incumbent", &Settings::incumbent, {0.0, 60.0}, "s",
              "The task that a robot holds counts as so much nearer; B-Human: 1; our choice: 0, for that is what "
              "`persistence` is for")
              .tunable()),
      regista::real("getting_up", &TimeToReach::getting_up, {0.0, 60.0}, "s",
                    "A robot on the ground counts as so much farther, besides the estimated time until it stands; "
                    "B-Human, without that estimate: 5; our choice: 0")
          .tunable()};

  std::vector<time_to_reach::Row> rows;

  void setup(const regista::Environment& environment) { rows.reserve(environment->team_size); }
  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    rows.clear();
    for (const int number : world.active()) {
      const regista::Robot& robot = world.robot(number);
      const bool fallen = (robot.flags & REGISTA_ROBOT_FALLEN) != 0;
      rows.push_back(
          {fallen ? getting_up : 0.0, settings.incumbent > 0.0 ? held_by(frame, robot) : time_to_reach::no_task});
    }
    const regista_matrix& times = frame.raw().time_to_task;
    assert(times.rows == out.rows() && times.columns == out.columns());
    time_to_reach::score(rows, out.columns(), {times.values, times.stride}, settings, {out.data(), out.stride()});
  }

 private:
  // In `mine` the own task is that of this robot's last assignment; in `common` only what was sent counts.
  static int held_by(const regista::Frame& frame, const regista::Robot& robot) {
    const bool decides = robot.number == frame.own_number() && frame.raw().knowledge == REGISTA_MINE;
    const int held = decides ? frame.previous_task(robot.number) : robot.role;
    if (held < 0) return time_to_reach::no_task;
    int column = 0;
    for (const regista::Task& task : frame.tasks()) {
      if (task.id == held) return column;
      ++column;
    }
    return time_to_reach::no_task;
  }
};

}  // namespace

REGISTA_PLUGIN(TimeToReach, regista::utility)
