// SPDX-License-Identifier: MIT
// Positioner plugin around algorithm.hpp: a point for each position of the own formation, bound to its task. With
// `tasks.offset.at_most` large the tasks are played there. The base points are the tasks before that.
//
// Positions are the tasks that the robots can take: the required ones, then the most important, one for each active
// robot. Roles named in `left_out` have no cell and get no point, such as the one that goes to the ball. Teammates
// stand where the world of the call has them; the last target of a position is that of the robot that says to hold it.
//
// Each robot climbs for the position that it holds, as in the publication: where the others walk they say themselves.
// So only its own task gets a point, from the decision after the one in which it took the role. `all_positions` is for
// assigners that weigh the places, and for pictures.
#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <regista/positioner.hpp>

#include "algorithm.hpp"

namespace {

using formation_cells::Point;
using formation_cells::Ratings;

struct FormationCells {
  static constexpr auto id = "formation_cells", version = "1.0.0",
                        summary = "The best-rated place in the Voronoi cell of each position's base point";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  Ratings ratings;
  std::string left_out = "striker";
  bool all_positions = false;
  static constexpr regista::Range deviation{0.01, 20.0};
  static constexpr std::tuple parameters{
      regista::text("left_out", &FormationCells::left_out,
                    "Names of roles without a place in the formation, separated by spaces; assumption"),
      regista::boolean("all_positions", &FormationCells::all_positions,
                       "Points for all positions, not for that of the own robot alone; B-Human: false"),
      regista::within(
          &FormationCells::ratings,
          regista::real("base", &Ratings::base, deviation, "m",
                        "Near the base point is good: standard deviation; B-Human: 2")
              .tunable(),
          regista::real("mates", &Ratings::mates, deviation, "m", "Near a teammate is bad; B-Human: 1").tunable(),
          regista::real("ball", &Ratings::ball, deviation, "m", "Near the ball is bad; B-Human: 0.5").tunable(),
          regista::real("border", &Ratings::border, deviation, "m", "Near a line of the field is bad; B-Human: 0.6")
              .tunable(),
          regista::real("cell", &Ratings::cell, deviation, "m", "Near the border of the cell is bad; B-Human: 0.05")
              .tunable(),
          regista::real("target", &Ratings::target, deviation, "m",
                        "Near the target that was last sent is good; B-Human: 1")
              .tunable(),
          regista::real("target_floor", &Ratings::target_floor, {0.0, 1.0}, "1",
                        "Far from that target the rating is this; B-Human: 0.5"),
          regista::real("step", &Ratings::step, {0.01, 5.0}, "m", "Of the ascent; B-Human: 0.1"),
          regista::integer("steps", &Ratings::steps, {0.0, 100.0}, "1", "Of the ascent, at most; B-Human: 10"),
          regista::real("keep", &Ratings::keep, {1.0, 10.0}, "1",
                        "A new place must be more than this times as good as the old one; B-Human: 1.2")
              .tunable(),
          regista::real("start", &Ratings::start, {0.0, 20.0}, "m",
                        "Farther from its place a robot starts to walk; B-Human: 0.75")
              .tunable(),
          regista::real("stop", &Ratings::stop, {0.0, 20.0}, "m",
                        "Nearer to its place it stops, where it is; B-Human: 0.6")
              .tunable())};

  int own_number = 1;
  formation_cells::Extent field;
  std::vector<bool> has_place;                   // by row of the table of roles
  std::vector<formation_cells::Place> place_of;  // the same
  std::vector<Point> sites, mates;
  std::vector<std::size_t> site_task, order;
  std::vector<std::int32_t> mate_number;
  std::vector<std::uint8_t> seen;

  void setup(const regista::Environment& environment) {
    own_number = environment->own_number;
    field = {environment->field_length / 2.0, environment->field_width / 2.0};
    std::vector<std::string> names;
    std::istringstream words(left_out);
    for (std::string word; words >> word;) names.push_back(word);
    for (const regista::Role& role : environment.roles()) {
      has_place.push_back(std::find(names.begin(), names.end(), role.name) == names.end());
    }
    place_of.resize(has_place.size());
    seen.resize(has_place.size());
    const std::size_t robots = environment->team_size, roles = has_place.size();
    sites.reserve(roles);
    mates.reserve(robots);
    for (auto* each : {&site_task, &order}) each->reserve(roles);
    mate_number.reserve(robots);
  }
  void reset(std::uint64_t) {
    for (formation_cells::Place& each : place_of) each.forget();
  }

  void place(const regista::Frame& frame, regista::Placement out) {
    const regista::World world = frame.world();
    list_sites(frame.tasks(), world.active());
    mates.clear();
    mate_number.clear();
    for (const std::int32_t number : world.active()) {
      const regista::Robot& robot = world.robot(number);
      mates.push_back({robot.pose[0], robot.pose[1]});
      mate_number.push_back(number);
    }
    formation_cells::Surroundings around{field, sites, mates, std::nullopt};
    if (world.ball_known()) around.ball = Point{world.ball().position[0], world.ball().position[1]};
    std::fill(seen.begin(), seen.end(), std::uint8_t{0});
    const regista::World mine = frame.mine();
    const std::int32_t own_role = mine.robot(own_number).role;
    for (std::size_t site = 0; site < sites.size(); ++site) {
      const regista::Task& task = frame.tasks()[site_task[site]];
      if (!all_positions && task.id != own_role) continue;
      const auto row = static_cast<std::size_t>(task.id);
      formation_cells::Position position{site, std::nullopt, holder_of(world, task.id)};
      if (position.holder) position.last_target = last_target(frame, mate_number[*position.holder]);
      seen[row] = 1;
      const formation_cells::Found found = place_of[row].update(around, position, ratings);
      out.point(found.place.x, found.place.y, std::max(0.0, found.value), static_cast<int>(site_task[site]));
    }
    for (std::size_t row = 0; row < place_of.size(); ++row) {
      if (seen[row] == 0) place_of[row].forget();
    }
  }

 private:
  static bool can_be_taken(const regista::Task& task, const regista::Span<std::int32_t>& active) {
    return task.robot == 0 || std::find(active.begin(), active.end(), task.robot) != active.end();
  }

  // The base points of the positions that the robots can take, in the order of the tasks.
  void list_sites(const regista::Span<regista::Task>& tasks, const regista::Span<std::int32_t>& active) {
    order.clear();
    for (const bool wanted : {true, false}) {
      const std::size_t first = order.size();
      for (std::size_t j = 0; j < tasks.size(); ++j) {
        const bool required = (tasks[j].flags & REGISTA_TASK_REQUIRED) != 0;
        if (required != wanted || !can_be_taken(tasks[j], active)) continue;
        std::size_t at = order.size();
        order.push_back(j);
        for (; at > first && tasks[order[at - 1]].priority > tasks[j].priority; --at) order[at] = order[at - 1];
        order[at] = j;
      }
    }
    if (order.size() > active.size()) order.resize(active.size());
    std::sort(order.begin(), order.end());
    sites.clear();
    site_task.clear();
    for (const std::size_t j : order) {
      const auto row = static_cast<std::size_t>(tasks[j].id);
      if (row >= has_place.size() || !has_place[row]) continue;
      sites.push_back(formation_cells::clamped({tasks[j].before[0], tasks[j].before[1]}, field));
      site_task.push_back(j);
    }
  }

  // Index among the mates of the lowest number that says to hold the role.
  std::optional<std::size_t> holder_of(const regista::World& world, std::int32_t role) const {
    for (std::size_t i = 0; i < mate_number.size(); ++i) {
      if (world.robot(mate_number[i]).role == role) return i;
    }
    return std::nullopt;
  }

  static std::optional<Point> last_target(const regista::Frame& frame, std::int32_t number) {
    const regista::World common = frame.common();
    const regista::Robot& robot = common.robot(number);
    if ((robot.flags & REGISTA_ROBOT_HAS_TARGET) == 0) return std::nullopt;
    return Point{robot.target[0], robot.target[1]};
  }
};

}  // namespace

REGISTA_PLUGIN(FormationCells, regista::positioner)
