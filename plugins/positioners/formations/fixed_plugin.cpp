// SPDX-License-Identifier: MIT
// Positioner plugin around fixed_places.hpp: one point for each task whose role has a place, bound to that task. With
// `tasks.offset.at_most` large the roles stand there.
#include <optional>
#include <string>
#include <vector>

#include <regista/positioner.hpp>

#include "environment_roles.hpp"
#include "fixed_places.hpp"

namespace {

struct FixedFormation {
  static constexpr auto id = "fixed_formation", version = "1.0.0",
                        summary = "Places of roles written in a text or a file, mirrored for set plays";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  std::string places, file;
  bool mirror = false;
  static constexpr std::tuple parameters{
      regista::text("places", &FixedFormation::places,
                    "Entries \"role: x y\" in metres, field frame, separated by commas or lines; \"list/role\" for the "
                    "role of one list; goes before the file; assumption: roles not named keep their own rule"),
      regista::file("file", &FixedFormation::file,
                    "The same entries, one a line, # starts a comment; assumption: none when absent"),
      regista::boolean("mirror", &FixedFormation::mirror,
                       "In kick-ins, goal, corner and free kicks the places change side while the ball lies on the "
                       "right (y < 0): they are written for a ball on the left; our option")};

  std::vector<std::optional<formations::Place>> place_of;  // each row of the table of roles

  void setup(const regista::Environment& environment) {
    const formations::Ground ground{environment->field_length / 2.0 + environment->border_strip,
                                    environment->field_width / 2.0 + environment->border_strip};
    place_of = formations::fixed_places(file, places, formations::roles_of(environment), ground);
  }

  void place(const regista::Frame& frame, regista::Placement out) const {
    const double side = mirrored(frame.world()) ? -1.0 : 1.0;
    int index = 0;
    for (const regista::Task& task : frame.tasks()) {
      const auto row = static_cast<std::size_t>(task.id);
      if (row < place_of.size() && place_of[row]) out.point(place_of[row]->x, side * place_of[row]->y, 1.0, index);
      ++index;
    }
  }

  bool mirrored(const regista::World& world) const {
    if (!mirror || !world.ball_known() || world.ball().position[1] >= 0.0) return false;
    switch (world.game().set_play) {
      case REGISTA_SET_PLAY_KICK_IN:
      case REGISTA_SET_PLAY_GOAL_KICK:
      case REGISTA_SET_PLAY_CORNER_KICK:
      case REGISTA_SET_PLAY_PUSHING_FREE_KICK:
        return true;
      default:
        return false;
    }
  }
};

}  // namespace

REGISTA_PLUGIN(FixedFormation, regista::positioner)
