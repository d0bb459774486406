// SPDX-License-Identifier: MIT
// The values that a study lays over documents: of all arms, of one, of the sweep. A path is one of the study's own team
// (an arm's, the tuned one) unless it begins with opponent, rules, robot, disturbance (of the own team) or
// opponent_disturbance.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "config/experiment.hpp"
#include "config/node.hpp"
#include "plugin/catalogue.hpp"

namespace regista::study {

struct Setting {
  std::string path, value;  // as they stand in the document; value: YAML in one line
  config::Location path_where, value_where;
};

// Those of an arm at a value of the sweep (0 where there is none): later ones win. Throws config::Error for a path that
// cannot be set, or that both the arm and the sweep set.
std::vector<Setting> settings_of(const config::Experiment& experiment, const config::Node& document, std::size_t arm,
                                 std::size_t value);

// Those of one map of a document; what: its name for messages, "set".
void add_settings(const config::Node& map, const std::string& what, std::vector<Setting>& out);

// As `regista match --set` says it when the arm's team plays on this side.
std::string override_of(const Setting& setting, std::size_t side);

// The error of a match that was set up with these, at the place in the experiment's document that it is about, with the
// nearest of the paths that there are where its path is none of them; else as it is. known: called for that.
config::Error told_at_its_place(const config::Error& error, const std::vector<Setting>& settings, std::size_t side,
                                const std::function<std::vector<std::string>()>& known);

// The match of a job in which the study's own team stands on `side`. Throws config::Error with its place. bare: the
// job without any setting, that team at home.
campaign::MatchSetup settled_match(const campaign::Job& job, std::size_t side, const std::vector<Setting>& settings,
                                   const campaign::Job& bare, const plugin::Catalogue& catalogue);

}  // namespace regista::study
