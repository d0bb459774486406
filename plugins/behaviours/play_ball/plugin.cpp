// SPDX-License-Identifier: MIT
// Glue of the behaviour `play_ball`: chooses a kick, walks behind the ball and kicks. Looks for a ball that is lost,
// and supports while the ball must not be touched.
#include <regista/behaviour.hpp>

#include "../ball_play.hpp"
#include "../by_phase.hpp"
#include "../kick_parameters.hpp"
#include "../place_parameters.hpp"
#include "../read_situation.hpp"
#include "../write_action.hpp"

namespace {

struct PlayBall {
  static constexpr auto id = "play_ball", version = "1.0.0",
                        summary = "Walks behind the ball and kicks it at goal, to a teammate or ahead";
  static constexpr unsigned reads =
      REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_FACINGS | REGISTA_READS_WAYPOINTS | REGISTA_READS_EDGES;
  static constexpr unsigned purposes = REGISTA_BEHAVIOUR_PLAYS_BALL;

  behaviours::Conduct conduct;
  behaviours::RollingSettings rolling;
  behaviours::KickSettings kick;
  behaviours::PlaySettings playing;
  behaviours::ApproachSettings approach;
  behaviours::SupportSettings support;
  behaviours::SearchSettings search;
  static constexpr std::tuple parameters{
      regista::within(&PlayBall::conduct, behaviours::conduct_parameters),
      regista::within(&PlayBall::rolling, behaviours::rolling_parameter),
      regista::within(&PlayBall::kick, behaviours::kick_parameters),
      regista::within(&PlayBall::playing, behaviours::play_parameters),
      regista::within(&PlayBall::approach, behaviours::approach_parameters),
      regista::within(&PlayBall::support, behaviours::reception_reach_parameter, behaviours::node_reached_parameter),
      regista::within(&PlayBall::search, behaviours::search_parameters)};

  behaviours::SituationReader reader{behaviours::Duty::plays_ball};
  behaviours::BallPlay ball_play;
  regista::Pass pass;
  behaviours::SupportMemory memory;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    pass = regista::Pass(host);
    reader.setup(environment);
    ball_play.setup(environment, host, kick, playing);
    memory.path.reserve(behaviours::SituationReader::most_nodes);
  }

  void reset(std::uint64_t) { ball_play.forget(); }

  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    const behaviours::Situation& situation = reader.read(frame, body, conduct.ball_trusted_for);
    reader.read_graph(frame);
    const behaviours::Movement movement =
        behaviours::by_phase(situation, conduct.legal, [&] { return play(frame, situation, out); });
    behaviours::say_receiver(movement, pass);
    behaviours::write_action(movement, behaviours::look(situation, conduct.gaze), out);
  }

  behaviours::Movement play(const regista::Frame& frame, const behaviours::Situation& situation, regista::Action& out) {
    if (!situation.ball_trusted) return behaviours::search(situation, search, conduct.legal);
    if (!ball_play.plays_ball(frame, situation, true)) {
      const behaviours::Pose behind = behaviours::place_behind(situation, playing.claim.room);
      behaviours::announce({behind.x, behind.y}, out);
      behaviours::Situation leaving = situation;
      leaving.duty = behaviours::Duty::other;  // and stands where these may stand
      return behaviours::WalkTo{.target = behaviours::legal_place(leaving, conduct.legal, behind)};
    }
    if (!situation.facts.can_kick || ball_is_theirs(situation)) {
      return behaviours::support(situation, support, rolling, conduct.legal, {}, memory);
    }
    return behaviours::approach(situation, approach, rolling, ball_play.choose(frame, situation));
  }
};

}  // namespace

REGISTA_PLUGIN(PlayBall, regista::behaviour)
