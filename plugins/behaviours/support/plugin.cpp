// SPDX-License-Identifier: MIT
// Glue of the behaviour `support`, which ../supporting.hpp is.
#include <regista/behaviour.hpp>

#include "../by_phase.hpp"
#include "../conduct_parameters.hpp"
#include "../place_parameters.hpp"
#include "../read_situation.hpp"
#include "../write_action.hpp"

namespace {

struct Support {
  static constexpr auto id = "support", version = "1.0.0",
                        summary = "Walks to the place of the task, and receives a ball that comes along";
  static constexpr unsigned reads = REGISTA_READS_FACINGS | REGISTA_READS_WAYPOINTS | REGISTA_READS_EDGES;

  behaviours::Conduct conduct;
  behaviours::RollingSettings rolling;
  behaviours::SupportSettings settings;
  static constexpr std::tuple parameters{
      regista::within(&Support::conduct, behaviours::conduct_parameters),
      regista::within(&Support::rolling, behaviours::rolling_parameter),
      regista::within(&Support::settings, behaviours::reception_reach_parameter.tunable(),
                      behaviours::node_reached_parameter)};

  behaviours::SituationReader reader{behaviours::Duty::other};
  behaviours::EdgePath path;

  void setup(const regista::Environment& environment) {
    reader.setup(environment);
    path.reserve(behaviours::SituationReader::most_nodes);
  }

  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    const behaviours::Situation& situation = reader.read(frame, body, conduct.ball_trusted_for);
    reader.read_graph(frame);
    const behaviours::Movement movement = behaviours::by_phase(situation, conduct.legal, [&] {
      return behaviours::support(situation, settings, rolling, conduct.legal, path);
    });
    behaviours::write_action(movement, behaviours::look(situation, conduct.gaze), out);
  }
};

}  // namespace

REGISTA_PLUGIN(Support, regista::behaviour)
