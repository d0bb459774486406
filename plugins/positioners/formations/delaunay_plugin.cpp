// SPDX-License-Identifier: MIT
// Positioner plugin around formation.hpp: one point for each task whose role has a position, bound to that task. With
// `tasks.offset.at_most` large the formation decides where roles stand.
#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <regista/positioner.hpp>

#include "environment_roles.hpp"
#include "formation.hpp"
#include "formation_file.hpp"
#include "role_numbers.hpp"

namespace {

struct DelaunayFormation {
  static constexpr auto id = "delaunay_formation", version = "1.0.0",
                        summary = "Formation file of librcsc: positions linear in the triangle of samples of the ball";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  std::string file, roles;
  double file_length = 105.0, file_width = 68.0;
  formations::Beyond beyond = formations::Beyond::nearest_point;
  static constexpr std::array beyond_names{"nearest_point", "nearest_sample"};
  static constexpr std::tuple parameters{
      regista::file(
          "file", &DelaunayFormation::file,
          "Formation file of librcsc, in JSON as HELIOS base publishes it, or in its older text forms; it is needed"),
      regista::text(
          "roles", &DelaunayFormation::roles,
          "Entries \"role: number\" separated by commas or lines, roles not named keep their own rule; empty: "
          "by importance 1, 11, 2, 3, 6, 7, 8, 9, 10, 4, 5; our choice"),
      regista::real("file_length", &DelaunayFormation::file_length, {1.0, 1000.0}, "m",
                    "Length of the field that the file is for; RoboCup 2D simulation: 105"),
      regista::real("file_width", &DelaunayFormation::file_width, {1.0, 1000.0}, "m",
                    "Width of the field that the file is for; RoboCup 2D simulation: 68"),
      regista::choice("beyond", &DelaunayFormation::beyond, beyond_names,
                      "With the ball outside of all samples: as at the nearest point of their hull, our choice, or at "
                      "the nearest sample, librcsc's")};

  std::optional<formations::Formation> formation;
  std::vector<int> position_of;  // each row of the table of roles
  formations::Position limit{};

  void setup(const regista::Environment& environment) {
    if (file.empty()) throw std::invalid_argument("file: none is named, or it is empty; a formation file is needed");
    const std::vector<formations::Sample> samples = formations::read_formation(file);
    position_of = formations::role_numbers(roles, formations::roles_of(environment), samples.front().positions.size(),
                                           environment->team_size);
    formation.emplace(samples, environment->field_length / file_length, environment->field_width / file_width, beyond);
    limit = {environment->field_length / 2.0 + environment->border_strip,
             environment->field_width / 2.0 + environment->border_strip};
    file.clear();
    file.shrink_to_fit();
  }

  // A ball that nobody knows of counts as one at the centre.
  void place(const regista::Frame& frame, regista::Placement out) const {
    const regista::World world = frame.world();
    formations::Position ball{0.0, 0.0};
    if (world.ball_known()) ball = {world.ball().position[0], world.ball().position[1]};
    const formations::Shares shares = formation->shares(ball);
    int index = 0;
    for (const regista::Task& task : frame.tasks()) {
      const auto row = static_cast<std::size_t>(task.id);
      if (row < position_of.size() && position_of[row] != formations::no_position) {
        const formations::Position p = formation->position(shares, static_cast<std::size_t>(position_of[row]));
        out.point(std::clamp(p.x, -limit.x, limit.x), std::clamp(p.y, -limit.y, limit.y), 1.0, index);
      }
      ++index;
    }
  }
};

}  // namespace

REGISTA_PLUGIN(DelaunayFormation, regista::positioner)
