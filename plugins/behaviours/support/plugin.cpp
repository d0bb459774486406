// SPDX-License-Identifier: MIT
// Glue of the behaviour `support`, which ../supporting.hpp is.
#include <regista/behaviour.hpp>

#include "../ball_play.hpp"
#include "../by_phase.hpp"
#include "../kick_parameters.hpp"
#include "../place_parameters.hpp"
#include "../read_situation.hpp"
#include "../write_action.hpp"

namespace {

struct Support {
  static constexpr auto id = "support", version = "1.0.0",
                        summary = "Walks to the place of the task, and receives a ball that comes along";
  static constexpr unsigned reads =
      REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_FACINGS | REGISTA_READS_WAYPOINTS | REGISTA_READS_EDGES;

  behaviours::Conduct conduct;
  behaviours::RollingSettings rolling;
  behaviours::SupportSettings settings;
  behaviours::KickSettings kick;
  behaviours::PlaySettings playing;
  behaviours::ApproachSettings approach;
  static constexpr std::tuple parameters{
      regista::within(&Support::conduct, behaviours::conduct_parameters),
      regista::within(&Support::rolling, behaviours::rolling_parameter),
      regista::within(&Support::settings, behaviours::reception_reach_parameter.tunable(),
                      behaviours::node_reached_parameter, behaviours::spread_parameters, behaviours::lane_parameters),
      regista::within(&Support::kick, behaviours::kick_parameters),
      regista::within(&Support::playing, behaviours::play_parameters),
      regista::within(&Support::approach, behaviours::approach_parameters)};

  behaviours::SituationReader reader{behaviours::Duty::other};
  behaviours::BallPlay ball_play;
  regista::Pass pass;
  behaviours::SupportMemory memory;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    pass = regista::Pass(host);
    reader.setup(environment);
    ball_play.setup(environment, host, kick, playing);
    memory.path.reserve(behaviours::SituationReader::most_nodes);
  }

  void reset(std::uint64_t) {
    ball_play.forget();
    memory.lane.forget();
  }

  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    const behaviours::Situation& situation = reader.read(frame, body, conduct.ball_trusted_for);
    reader.read_graph(frame);
    reader.read_targets(frame, body);
    // Also in the middle of a kick, when it cannot move: a ball that it has taken stays its own.
    const bool may =
        situation.phase == behaviours::Phase::playing && situation.facts.can_kick && !ball_is_theirs(situation);
    if (!may) ball_play.withdraw();
    const bool takes_ball = may && ball_play.plays_ball(frame, situation, false);
    if (takes_ball) behaviours::announce(situation.ball, out);
    const behaviours::Movement movement = behaviours::by_phase(situation, conduct.legal, [&] {
      return takes_ball
                 ? behaviours::approach(situation, approach, rolling, ball_play.choose(frame, situation))
                 : behaviours::support(situation, settings, rolling, conduct.legal, ball_play.opponents(frame), memory);
    });
    behaviours::say_receiver(movement, pass);
    behaviours::write_action(movement, behaviours::look(situation, conduct.gaze), out);
  }
};

}  // namespace

REGISTA_PLUGIN(Support, regista::behaviour)
