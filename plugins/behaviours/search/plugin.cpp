// SPDX-License-Identifier: MIT
// Glue of the behaviour `search`, which ../searching.hpp is.
#include <regista/behaviour.hpp>

#include "../by_phase.hpp"
#include "../conduct_parameters.hpp"
#include "../place_parameters.hpp"
#include "../read_situation.hpp"
#include "../write_action.hpp"

namespace {

struct Search {
  static constexpr auto id = "search", version = "1.0.0",
                        summary = "Turns about at the place of the task, or where it stands";
  static constexpr unsigned reads = REGISTA_READS_FACINGS;
  static constexpr unsigned purposes = REGISTA_BEHAVIOUR_SEARCHES;

  behaviours::Conduct conduct;
  behaviours::SearchSettings settings;
  static constexpr std::tuple parameters{regista::within(&Search::conduct, behaviours::conduct_parameters),
                                         regista::within(&Search::settings, behaviours::search_parameters)};

  behaviours::SituationReader reader{behaviours::Duty::other};

  void setup(const regista::Environment& environment) { reader.setup(environment); }

  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    const behaviours::Situation& situation = reader.read(frame, body, conduct.ball_trusted_for);
    const behaviours::Movement movement = behaviours::by_phase(
        situation, conduct.legal, [&] { return behaviours::search(situation, settings, conduct.legal); });
    behaviours::write_action(movement, behaviours::look(situation, conduct.gaze), out);
  }
};

}  // namespace

REGISTA_PLUGIN(Search, regista::behaviour)
