// SPDX-License-Identifier: MIT
// Parameters that the predictors of the ball have in common. Glue: a plugin puts them within its settings.
#pragma once

#include <tuple>

#include <regista/parameters.hpp>

#include "ball_hypotheses.hpp"
#include "rolling.hpp"

namespace ball {

// acceleration_noise: its documentation, which depends on what else the predictor knows of kicks.
constexpr auto rolling_parameters(const char* acceleration_noise) {
  return std::tuple{
      regista::real("deceleration", &RollingModel::deceleration, {0.05, 1.0}, "m/s^2",
                    "Deceleration of a rolling ball; 0.30 to 0.35 on SPL carpet")
          .tunable(),
      regista::real("stop_speed", &RollingModel::stop_speed, {0.0, 0.3}, "m/s",
                    "A ball slower than this stands; 0.08 as SPL teams have it"),
      regista::real("acceleration_noise", &RollingModel::acceleration_noise, {0.01, 3.0}, "m/s^1.5", acceleration_noise)
          .tunable()
          .log_scale(),
      regista::real("direction_noise", &RollingModel::direction_noise, {0.0, 1.0}, "rad/s^0.5",
                    "Standard deviation of the direction after one second of rolling; assumption")
          .tunable()};
}

inline constexpr auto drag_parameter = regista::real(
    "drag", &RollingModel::drag, {0.0, 3.0}, "1/s",
    "Share of its speed that a rolling ball loses in a second besides; 0 on carpet, 0.62 in the 2D simulation "
    "league, where 94 % are kept in a cycle of 0.1 s");

inline constexpr auto slide_parameter =
    regista::real("slide_deceleration", &RollingModel::slide_deceleration, {0.0, 10.0}, "m/s^2",
                  "Deceleration of a kicked ball while it slides, until it rolls with 5/7 of its speed; 3.5 on the "
                  "carpet of the Small "
                  "Size League; 0, as in Regista's matches: it rolls at once");

inline constexpr auto resting_noise_parameter =
    regista::real("resting_noise", &RollingModel::resting_noise, {0.0, 0.3}, "m/s^0.5",
                  "Standard deviation of a resting ball's place after one second (nudges); assumption");

// gate, merge_distance: their documentation, which depends on what a hypothesis is.
constexpr auto evidence_parameters(const char* gate, const char* merge_distance) {
  return std::tuple{
      regista::integer("measurements_for_velocity", &Evidence::measurements_for_velocity, {2, 20}, "1",
                       "Sightings before a velocity is believed; 4 as SPL teams have it")
          .tunable(),
      regista::real("gate", &Evidence::gate, {1.0, 50.0}, "1", gate).tunable(),
      regista::real("detection_probability", &Evidence::detection_probability, {0.05, 0.99}, "1",
                    "Probability that a ball well inside the visible area is seen; below the 0.9 of SPL detectors "
                    "because robots hide it for several images in a row")
          .tunable(),
      regista::real("false_density", &Evidence::false_density, {1e-5, 1.0}, "1/m^2",
                    "False sightings per square metre and image; well above the 0.0005 per image of SPL detectors "
                    "because false ones come back at the same spot")
          .tunable()
          .log_scale(),
      regista::real("edge_margin", &Evidence::edge_margin, {0.0, 2.0}, "m",
                    "Nearer than this to the edge of the visible area a miss says nothing; assumption")
          .tunable(),
      regista::real("surprise", &Evidence::surprise, {1e-4, 2.0}, "1/s",
                    "How often the ball is somewhere else altogether, as when somebody carries it; assumption")
          .tunable()
          .log_scale(),
      regista::real("prune_weight", &Evidence::prune_weight, {1e-4, 0.2}, "1",
                    "Hypotheses below this probability are dropped; assumption")
          .log_scale(),
      regista::real("merge_distance", &Evidence::merge_distance, {0.0, 0.5}, "m", merge_distance)};
}

}  // namespace ball
