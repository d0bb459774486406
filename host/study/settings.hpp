// SPDX-License-Identifier: MIT
// What a study says of its matches: the profiles they are played under, and the values that it lays over documents. In
// experiments and tunings a path is one of the study's own team (an arm's, the tuned one) unless it begins with
// opponent, rules, robot, disturbance (of the own team) or opponent_disturbance.
#pragma once

#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "config/experiment.hpp"
#include "config/load.hpp"
#include "config/match_settings.hpp"
#include "config/node.hpp"
#include "plugin/catalogue.hpp"

namespace regista::study {

// Those of one map of a document; what: its name for messages, "set". Throws config::Error for a path that cannot be
// set.
config::Overrides settings_of(const config::Node& set, const std::string& what);

// Those of an arm at a value of the sweep (0 where there is none): later ones win. document: that the experiment was
// read from. Throws config::Error for a path that cannot be set, or that both the arm and the sweep set.
config::Overrides settings_of(const config::Experiment& experiment, const config::Node& document, std::size_t arm,
                              std::size_t value);

// As `regista match --set` has them where the study's own team plays on this side.
config::Overrides on_side(const config::Overrides& settings, std::size_t side);
std::vector<std::string> as_typed(const config::Overrides& settings);

// Rules, robot and limit. plugins: folders.
campaign::Job job_under(const config::MatchSettings& settings, const std::vector<std::string>& plugins);

// The match of a job with these settings in the place of its own texts. said: the same as the study's document has
// them. Throws config::Error at the place there, or in another document, that asks for what cannot be.
campaign::MatchSetup match_of(const campaign::Job& job, const config::Overrides& settings,
                              const config::Overrides& said, const plugin::Catalogue& catalogue);

}  // namespace regista::study
