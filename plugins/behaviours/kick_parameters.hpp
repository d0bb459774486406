// SPDX-License-Identifier: MIT
// Parameters of the behaviours that kick. Glue: a plugin puts them within its settings.
#pragma once

#include <array>
#include <tuple>

#include <regista/parameters.hpp>

#include "approach.hpp"
#include "ball_play.hpp"
#include "kick_choice.hpp"

namespace behaviours {

inline constexpr std::tuple kick_parameters{
    regista::real("goal_bonus", &KickSettings::goal_bonus, {0.0, 20.0}, "m",
                  "A shot that nobody blocks is worth this much of ground besides; our choice: 4")
        .tunable(),
    regista::real("along_goal_line", &KickSettings::along_goal_line, {0.0, 1.0}, "1",
                  "Share of half the goal that shots use; our choice: 0.9")
        .tunable(),
    regista::real(
        "beside_keeper", &KickSettings::beside_keeper, {0.0, 1.0}, "1",
        "Shots that do not go to the middle are aimed off it by this share of what shots use; our choice: 0.6")
        .tunable(),
    regista::real("into_net", &KickSettings::into_net, {0.0, 5.0}, "m",
                  "A shot would roll this far behind the goal line; our choice: 1")
        .tunable(),
    regista::real("over_line", &KickSettings::over_line, {0.0, 5.0}, "m",
                  "A kick that would end nearer behind the goal line than this is no shot; our choice: 0.2"),
    regista::real("shot_cost", &KickSettings::shot_cost, {0.0, 5.0}, "1",
                  "Ground that each metre from the ball to the goal takes from the worth of a shot, because far shots "
                  "miss; our choice: 0.3")
        .tunable(),
    regista::real("pass_bonus", &KickSettings::pass_bonus, {0.0, 20.0}, "m",
                  "A pass is worth this much of ground besides, because the ball arrives at somebody; our choice: 0.5")
        .tunable(),
    regista::real("teammate_news_at_most", &KickSettings::teammate_news_at_most, {0.0, 60.0}, "s",
                  "The robot does not pass to a teammate whose news are older; our choice: 6")
        .tunable(),
    regista::real("pass_ahead", &KickSettings::pass_ahead, {-2.0, 2.0}, "m",
                  "Passes are aimed this far in front of the teammate, towards the opponent's end; our choice: 0.3")
        .tunable(),
    regista::real("shortest_pass", &KickSettings::shortest_pass, {0.0, 5.0}, "m",
                  "The robot does not pass to a place that is nearer to the ball; our choice: 1")
        .tunable(),
    regista::real("pass_miss", &KickSettings::pass_miss, {0.0, 5.0}, "m",
                  "No pass is played with a kick that ends farther short of its aim, or beyond it; our choice: 0.7")
        .tunable(),
    regista::real("slight_turn", &KickSettings::slight_turn, {0.0, 3.1}, "rad",
                  "First angle to either side of the goal at which a kick ahead is tried; our choice: 0.4")
        .tunable(),
    regista::real("half_turn", &KickSettings::half_turn, {0.0, 3.1}, "rad",
                  "Second angle to either side of the goal at which a kick ahead is tried; our choice: 0.8")
        .tunable(),
    regista::real("wide_turn", &KickSettings::wide_turn, {0.0, 3.1}, "rad",
                  "Third angle to either side of the goal at which a kick ahead is tried; our choice: 1.2")
        .tunable(),
    regista::real("dribble_distance", &KickSettings::dribble_distance, {0.1, 10.0}, "m",
                  "Wanted distance of a short kick ahead; our choice: 0.8, within a NAO's kick in walking")
        .tunable(),
    regista::real("clear_distance", &KickSettings::clear_distance, {0.1, 10.0}, "m",
                  "Wanted distance of a long kick ahead; our choice: 3, within a NAO's fast kick")
        .tunable(),
    regista::real("blocked_cost", &KickSettings::blocked_cost, {0.1, 20.0}, "m",
                  "An opponent right in the way of a kick costs this much of ground; our choice: 3")
        .tunable(),
    regista::real(
        "corridor", &KickSettings::corridor, {0.05, 3.0}, "m",
        "An opponent this far beside the way of a kick is in it, at the beginning; our choice: 0.35, more than "
        "a robot and a ball")
        .tunable(),
    regista::real("corridor_growth", &KickSettings::corridor_growth, {0.0, 2.0}, "1",
                  "That distance grows by this share of the way that the ball has rolled; our choice: 0.15")
        .tunable(),
    regista::real("behind_end", &KickSettings::behind_end, {0.0, 5.0}, "m",
                  "An opponent counts up to this far beyond the end of the way of a kick; our choice: 0.5")
        .tunable(),
    regista::real("out_cost", &KickSettings::out_cost, {0.0, 20.0}, "m",
                  "A kick that leaves the field costs this much of ground; our choice: 4")
        .tunable(),
    regista::real("constancy", &KickSettings::constancy, {0.0, 10.0}, "m",
                  "The last choice is kept unless another kick is worth this much more ground; our choice: 0.6")
        .tunable(),
    regista::real(
        "same_direction", &KickSettings::same_direction, {0.0, 1.0}, "1",
        "A kick whose direction makes an angle with the last one of a larger cosine is still that choice; our "
        "choice: 0.97, 14 degrees")};

inline constexpr std::array<const char*, 2> kick_rules{"metres", "expected_gain"};
inline constexpr regista::Range of_worth{0.0, 5.0}, of_seconds{0.0, 20.0};

// Who plays the ball, and by which rule kicks are chosen.
inline constexpr std::tuple play_parameters{
    regista::choice(
        "kick_rule", &PlaySettings::kick_rule, kick_rules,
        "How a kick is chosen: metres: by ground gained, less what opponents near its line may cost; "
        "expected_gain: by what it is worth on average, over its errors and the opponents' reach (`gain_...`)"),
    regista::within(
        &PlaySettings::gain,
        regista::real("gain_pull", &GainSettings::pull, {0.3, 20.0}, "m",
                      "The worth of a place falls to 1 / e so far from a goal; our choice: 3")
            .tunable(),
        regista::real("gain_possession", &GainSettings::possession, of_worth, "1",
                      "Worth of holding the ball rather than the opponents; our choice: 0.25")
            .tunable(),
        regista::real("gain_goal", &GainSettings::goal, of_worth, "1", "Worth of a goal; our choice: 1.5").tunable(),
        regista::real("gain_race", &GainSettings::race, {0.05, 20.0}, "s",
                      "A team that is so much sooner at the ball holds it with probability 0.73; our choice: 1.2")
            .tunable(),
        regista::real("gain_reaction", &GainSettings::reaction, of_seconds, "s",
                      "Opponents do not move for so long after a kick; our choice: 0.8")
            .tunable(),
        regista::real("gain_edge", &GainSettings::edge, {0.01, 2.0}, "m",
                      "An opponent's reach fades out over this distance; our choice: 0.15")
            .tunable(),
        regista::real("gain_walk_around", &GainSettings::walk_around, of_seconds, "s",
                      "Time for each rad that the robot has to walk around the ball before the kick; our choice: 1.9")
            .tunable(),
        regista::real("gain_hurry", &GainSettings::hurry, {0.0, 1.0}, "1",
                      "Worth of each second until the kick; our choice: 0.01")
            .tunable(),
        regista::real("gain_patience", &GainSettings::patience, of_seconds, "s",
                      "After so long at a ball that lies, the time until the kick costs more; our choice: 4")
            .tunable(),
        regista::real("gain_impatience", &GainSettings::impatience, {0.0, 1.0}, "1",
                      "So much more for each second of it, with each second beyond; our choice: 0.05")
            .tunable(),
        regista::real("gain_constancy", &GainSettings::constancy, of_worth, "1",
                      "The last choice is kept unless another kick is worth so much more; our choice: 0.05")
            .tunable(),
        regista::real("gain_receiver_age", &GainSettings::receiver_age, {0.0, 60.0}, "s",
                      "The robot does not pass to a teammate whose news are older; our choice: 4")
            .tunable(),
        regista::real("gain_considered_within", &GainSettings::considered_within, {0.0, 20.0}, "m",
                      "A robot farther from the ball does not choose its kick yet, and comes from the side of the own "
                      "goal; our choice: 2"),
        regista::real("gain_shortest_pass", &GainSettings::shortest_pass, {0.0, 5.0}, "m",
                      "A shorter kick is no pass; our choice: 1")
            .tunable(),
        regista::real("gain_into_space", &GainSettings::into_space, {0.0, 3.0}, "m",
                      "Passes are aimed at the teammate and this far in front of it; our choice: 0.4")
            .tunable()),
    regista::within(
        &PlaySettings::claim,
        regista::boolean("nearest_plays", &ClaimSettings::nearest_plays,
                         "A robot that is surely first at the ball plays it whatever its role, and the robot of the "
                         "role leaves it to a teammate that is (`claim_...`); no: the role alone decides"),
        regista::real("claim_sooner", &ClaimSettings::sooner, of_seconds, "s",
                      "So much sooner than all teammates a robot takes a ball that is not its role's; our choice: 0.1")
            .tunable(),
        regista::real("claim_kept", &ClaimSettings::kept, of_seconds, "s",
                      "While it is so much sooner it keeps what it has taken; our choice: 0")
            .tunable(),
        regista::real("claim_left", &ClaimSettings::left, of_seconds, "s",
                      "The robot of the role leaves the ball to a teammate that is so much sooner; our choice: 0.5")
            .tunable(),
        regista::real("claim_news_at_most", &ClaimSettings::news_at_most, {0.0, 60.0}, "s",
                      "The robot does not leave the ball to a teammate whose news are older; our choice: 3")
            .tunable(),
        regista::real("claim_doubt", &ClaimSettings::doubt, {0.0, 1.0}, "1",
                      "Seconds by which each second of silence makes a teammate's time uncertain; our choice: 0.05")
            .tunable(),
        regista::real("claim_room", &ClaimSettings::room, {0.0, 5.0}, "m",
                      "A robot that leaves the ball to a teammate stands this far behind it; our choice: 1.2")
            .tunable())};

inline constexpr std::tuple approach_parameters{
    regista::real("meet_within", &ApproachSettings::meet_within, {0.0, 10.0}, "s",
                  "The robot walks to where a rolling ball is when it arrives there, but no farther ahead in time than "
                  "this; our choice: 2")
        .tunable(),
    regista::real("behind", &ApproachSettings::behind, {0.0, 1.0}, "1",
                  "The robot is behind the ball where the angle between its way to the ball and the kick has a larger "
                  "cosine; our choice: 0.8, 37 degrees")
        .tunable(),
    regista::real("aligned", &ApproachSettings::aligned, {0.02, 1.5}, "rad",
                  "The robot kicks when its heading is no farther than this off the direction of the kick; our choice: "
                  "0.3")
        .tunable(),
    regista::real("stand_off", &ApproachSettings::stand_off, {0.0, 2.0}, "1",
                  "The robot stands behind the ball at this share of the distance at which it touches the ball and its "
                  "reach together; our choice: 0.5, midway between the two")
        .tunable(),
    regista::real(
        "berth", &ApproachSettings::berth, {0.0, 2.0}, "m",
        "The robot keeps this distance from the ball beyond touching it while it walks around it; our choice: "
        "0.15")
        .tunable(),
    regista::real("step_back", &ApproachSettings::step_back, {0.0, 2.0}, "m",
                  "While it walks around the ball, the robot aims this much farther behind it; our choice: 0.15")
        .tunable(),
    regista::real("creep_within", &ApproachSettings::creep_within, {0.0, 2.0}, "m",
                  "Nearer than this to where it stands for the kick, the robot creeps onto the ball; our choice: 0.12")
        .tunable(),
    regista::real("creep_aligned", &ApproachSettings::creep_aligned, {0.0, 10.0}, "1",
                  "The robot creeps when its heading is off the kick by less than this multiple of `aligned`; our "
                  "choice: 2"),
    regista::real("creep_speed", &ApproachSettings::creep_speed, {0.0, 1.0}, "m/s",
                  "Speed at which the robot creeps onto the ball; our choice: 0.12, half of a NAO's walk")
        .tunable()};

}  // namespace behaviours
