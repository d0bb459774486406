// SPDX-License-Identifier: MIT
// Parameters that all behaviours have in common: which news of the ball they act on, how they look about, and how far
// they keep from what the rules forbid. Glue: a plugin puts them within its conduct.
#pragma once

#include <tuple>

#include <regista/parameters.hpp>

#include "gaze.hpp"
#include "legal_place.hpp"
#include "rolling_ball.hpp"

namespace behaviours {

struct Conduct {
  double ball_trusted_for = 5.0;  // s: nobody acts on older news of the ball
  GazeSettings gaze;
  LegalPlaceSettings legal;
};

inline constexpr std::tuple conduct_parameters{
    regista::real("ball_trusted_for", &Conduct::ball_trusted_for, {0.0, 60.0}, "s",
                  "The robot does not act on older news of the ball; our choice: 5")
        .tunable(),
    regista::within(
        &Conduct::gaze,
        regista::real("sweep_period", &GazeSettings::sweep_period, {0.5, 20.0}, "s",
                      "The head turns to and fro in this time while the ball is lost; our choice: 4")
            .tunable(),
        regista::real("glance_every", &GazeSettings::glance_every, {0.5, 30.0}, "s",
                      "So often the robot looks away from the ball, for landmarks and other robots; our choice: 4")
            .tunable(),
        regista::real("glance_lasts", &GazeSettings::glance_lasts, {0.0, 10.0}, "s",
                      "So long it looks away from the ball each time; our choice: 1.2")
            .tunable(),
        regista::real("eyes_on_ball_within", &GazeSettings::eyes_on_ball_within, {0.0, 20.0}, "m",
                      "The robot does not look away from a ball that is nearer; our choice: 0.8, a few steps")
            .tunable(),
        regista::real("phase_per_robot", &GazeSettings::phase_per_robot, {0.0, 10.0}, "s",
                      "Robots look about this much later from one shirt number to the next; our choice: 0.37, so that "
                      "no two of seven do it at once")),
    regista::within(&Conduct::legal,
                    regista::real("margin", &LegalPlaceSettings::margin, {0.0, 1.0}, "m",
                                  "Distance kept beyond what a rule asks for, because the robot does not know exactly "
                                  "where it stands; our choice: 0.2")
                        .tunable())};

inline constexpr auto rolling_parameter =
    regista::real("rolling", &RollingSettings::rolling, {0.01, 3.0}, "m/s",
                  "A faster ball is met where it will be, a slower one is walked to; our choice: 0.25, the speed at "
                  "which a NAO walks")
        .tunable();

}  // namespace behaviours
