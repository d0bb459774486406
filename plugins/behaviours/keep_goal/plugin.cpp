// SPDX-License-Identifier: MIT
// Glue of the behaviour `keep_goal`; the keeper's own part is in algorithm.hpp, how it plays the ball in
// ../kick_choice.hpp and ../approach.hpp.
#include <regista/behaviour.hpp>

#include "../ball_play.hpp"
#include "../by_phase.hpp"
#include "../kick_parameters.hpp"
#include "../place_parameters.hpp"
#include "../read_situation.hpp"
#include "../write_action.hpp"
#include "algorithm.hpp"

namespace {

using keep_goal::Settings;

struct KeepGoal {
  static constexpr auto id = "keep_goal", version = "1.0.0",
                        summary = "Stands between ball and goal, goes for shots, and clears a ball that lies near";
  static constexpr unsigned reads = REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_FACINGS;
  static constexpr unsigned purposes = REGISTA_BEHAVIOUR_KEEPS_GOAL;

  behaviours::Conduct conduct;
  behaviours::RollingSettings rolling;
  Settings settings;
  behaviours::KickSettings kick;
  behaviours::PlaySettings playing;
  behaviours::ApproachSettings approach;
  static constexpr std::tuple parameters{
      regista::within(&KeepGoal::conduct, behaviours::conduct_parameters),
      regista::within(&KeepGoal::rolling, behaviours::rolling_parameter),
      regista::within(
          &KeepGoal::settings,
          regista::real("beyond_area", &Settings::beyond_area, {-2.0, 5.0}, "m",
                        "The keeper plays a ball that is no farther from the centre of the goal than the length of the "
                        "penalty area and this; our choice: 0.2")
              .tunable(),
          regista::real("near_ball", &Settings::near_ball, {0.0, 10.0}, "m",
                        "The keeper plays a ball that is nearer to it, wherever it stands; our choice: 1")
              .tunable(),
          regista::real("slow", &Settings::slow, {0.0, 10.0}, "m/s",
                        "The keeper plays slower balls only; our choice: 0.5")
              .tunable(),
          regista::real("shot_reach", &Settings::shot_reach, {0.0, 10.0}, "m",
                        "The keeper leaves its place by so much for the line of a shot; our choice: 1.5")
              .tunable(),
          regista::real("narrow_angle", &Settings::narrow_angle, {0.0, 5.0}, "m",
                        "The keeper comes out so far at most to cover the angle between ball and posts; 0: it keeps to "
                        "the place of its task")
              .tunable(),
          regista::real("narrow_angle_share", &Settings::share, {0.0, 1.0}, "1",
                        "It comes out by this share of the way to the ball; our choice: 0.4")
              .tunable(),
          regista::real("leave_lost_ball", &Settings::leave_lost_ball, {-5.0, keep_goal::never_leaves}, "s",
                        "The keeper leaves the ball if an opponent reaches it this much earlier; our choice: 60, never")
              .tunable()),
      regista::within(&KeepGoal::kick, behaviours::kick_parameters),
      regista::within(&KeepGoal::playing, behaviours::play_parameters),
      regista::within(&KeepGoal::approach, behaviours::approach_parameters)};

  behaviours::SituationReader reader{behaviours::Duty::keeps_goal};
  behaviours::BallPlay ball_play;
  regista::Pass pass;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    pass = regista::Pass(host);
    reader.setup(environment);
    ball_play.setup(environment, host, kick, playing);
  }

  void reset(std::uint64_t) { ball_play.forget(); }

  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    const behaviours::Situation& situation = reader.read(frame, body, conduct.ball_trusted_for);
    // Also in the middle of a kick, when it cannot move: a ball that it has taken stays its own.
    const bool may = situation.phase == behaviours::Phase::playing && situation.facts.can_kick &&
                     keep_goal::plays_ball(situation, settings) &&
                     !keep_goal::comes_too_late(situation, settings, ball_play.opponents(frame));
    if (!may) ball_play.withdraw();
    const bool plays = may && ball_play.plays_ball(frame, situation, true);
    if (plays && playing.claim.nearest_plays) behaviours::announce(situation.ball, out);
    const behaviours::Movement movement = behaviours::by_phase(situation, conduct.legal, [&] {
      return plays ? behaviours::approach(situation, approach, rolling, ball_play.choose(frame, situation))
                   : keep_goal::guard(situation, settings, rolling, conduct.legal);
    });
    behaviours::say_receiver(movement, pass);
    behaviours::write_action(movement, behaviours::look(situation, conduct.gaze), out);
  }
};

}  // namespace

REGISTA_PLUGIN(KeepGoal, regista::behaviour)
