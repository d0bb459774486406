// SPDX-License-Identifier: MIT
// Parameters of the behaviours that go to the place of their task: to support, or to search. Glue: a plugin puts them
// within its settings.
#pragma once

#include <tuple>

#include <regista/parameters.hpp>

#include "approach.hpp"
#include "gaze.hpp"
#include "lane.hpp"
#include "legal_place.hpp"
#include "supporting.hpp"

namespace behaviours {

inline constexpr auto reception_reach_parameter = regista::real(
    "reception_reach", &SupportSettings::reception_reach, {0.0, 10.0}, "m",
    "The robot leaves its place by so much for a ball that comes along, unless the ball is the opponent's; "
    "our choice: 1");

inline constexpr auto node_reached_parameter = regista::within(
    &SupportSettings::path,
    regista::real("node_reached", &EdgePathSettings::node_reached, {0.01, 2.0}, "m",
                  "A robot so near to a node or an edge is on it, where the team walks along edges; our "
                  "choice: 0.3"));

inline constexpr auto spread_parameters = regista::within(
    &SupportSettings::spread,
    regista::real("clear_of_ball", &SpreadSettings::clear_of_ball, {0.0, 5.0}, "m",
                  "The robot stands no nearer to a ball that it does not play; 0: wherever its task is")
        .tunable(),
    regista::real("apart", &SpreadSettings::apart, {0.0, 5.0}, "m",
                  "It keeps its target so far from those of more important tasks; 0: wherever its task is")
        .tunable(),
    regista::real("moved_at_most", &SpreadSettings::moved_at_most, {0.0, 10.0}, "m",
                  "For both of these its target is moved no farther; our choice: 1.2")
        .tunable());

inline constexpr auto lane_parameters = regista::within(
    &SupportSettings::lane,
    regista::real("open_passing_lane", &LaneSettings::leaves, {0.0, 5.0}, "m",
                  "A robot ahead of the ball moves up to this far from its place to be open for a pass; 0: it stays")
        .tunable(),
    regista::real("lane_clear", &LaneSettings::clear, {0.05, 3.0}, "m",
                  "A lane in which opponents leave so much room is open; our choice: 0.4")
        .tunable(),
    regista::real("lane_cost", &LaneSettings::cost, {0.0, 10.0}, "1",
                  "A place that is one metre farther away must offer this much more room; our choice: 0.25")
        .tunable(),
    regista::real("lane_constancy", &LaneSettings::constancy, {0.0, 3.0}, "m",
                  "Another place than the last one must offer this much more room; our choice: 0.1")
        .tunable());

inline constexpr auto search_turn_parameter =
    regista::real("search_turn_seconds", &SearchSettings::search_turn_seconds, {0.0, 60.0}, "s",
                  "A searching robot first turns on the spot for this long; 0: it goes at once")
        .tunable();

inline constexpr std::tuple looked_at_parameters{
    regista::boolean(
        "divides_field", &LookedAtSettings::divides,
        "A searching robot goes on to what of its part of the field was looked at longest ago, by itself or "
        "by teammates; false: it turns about at its place"),
    regista::real("sight", &LookedAtSettings::sight, {0.1, 20.0}, "m",
                  "As near as this it would have seen the ball; our choice: 2.5")
        .tunable(),
    regista::real("look_forgotten_after", &LookedAtSettings::forgotten_after, {1.0, 600.0}, "s",
                  "A look that is older counts for nothing; our choice: 30")
        .tunable(),
    regista::real("search_walk_cost", &LookedAtSettings::walk_cost, {0.0, 60.0}, "s/m",
                  "A square that is one metre farther away must have been unseen this much longer; our choice: 3")
        .tunable()};

inline constexpr std::tuple search_parameters{
    regista::real("at_target", &SearchSettings::at_target, {0.0, 5.0}, "m",
                  "A searching robot is at its place from this distance on, and turns about; our choice: 0.5")
        .tunable(),
    regista::real("search_turn_rate", &SearchSettings::turn_rate, {0.0, 3.0}, "rad/s",
                  "A searching robot turns about so fast; our choice: 0.6, slow enough for the camera")
        .tunable()};

// --- Parameters that all behaviours have in common: which news of the ball they act on, how they look about, and how
// far they keep from what the rules forbid. Glue: a plugin puts them within its conduct.

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
