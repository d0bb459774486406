// SPDX-License-Identifier: MIT
// From a tuning's document to what every search of its values needs: the teams and their files, the parameters, the
// openings, the objective, the budget. Which stages follow the search is for those who plan them (tuning_setup.hpp,
// search_comparison_setup.hpp); everything that can be wrong is found before the first match.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/documents.hpp"
#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "config/overlay.hpp"
#include "match/match.hpp"
#include "plugin/catalogue.hpp"
#include "study/document_settings.hpp"
#include "study/tuning/algorithm.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "study/tuning/tuning_setup.hpp"

namespace regista::study {

// Pairs that so many matches make, where each pair takes `each` of them.
std::uint64_t pairs_in(int matches, std::uint64_t each);

// What is said of a name that no algorithm has: why it is not offered, or the nearest, and all that are.
std::string unknown_algorithm(const std::string& name);

// Its steps are taken in the order in which they stand here, each once. They throw config::BadInput and config::Error,
// or list it in `mistakes`, as that wants it. Options, catalogue and mistakes outlive it.
class TuningPlanner {
 public:
  // Reads the document, and notes what it says of itself.
  TuningPlanner(const TuningRequest& options, const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

  const config::Tuning& asked() const { return tuning_; }
  const config::Node& document() const { return document_; }
  TuningPlan& plan() { return plan_; }

  void choose_algorithm();
  // Opponents, parameters, openings, objective. False: there are mistakes, so that nothing can be counted.
  bool prepare();
  // The budget of the search; refuses one that is too small for the first round of one of these algorithms.
  void count_search(std::span<const Algorithm> algorithms);
  // Refuses the number of matches at `path`. Throws.
  void require_matches(const char* path, std::uint64_t least, const std::string& why) const;

 private:
  void describe();
  campaign::Job job_of(const std::string& opponent, std::size_t side, bool is_base) const;
  TuningOpponent opponent_of(const std::string& file, double weight, const std::vector<Setting>& settings,
                             bool is_base);
  void meet_opponents();
  void meet(const config::Tuning::Opponent& each, double sum, const std::vector<Setting>& settings);
  void meet_base(const std::vector<Setting>& settings);
  void choose_parameters();
  void count_goals(const std::vector<config::Opening>& scenes);
  void choose_objective();

  const TuningRequest& options_;
  config::Mistakes& mistakes_;
  config::Overrides overrides_;
  config::Node document_;
  config::Tuning tuning_;
  const plugin::Catalogue& catalogue_;
  std::string program_, mathematics_;
  TuningPlan plan_;
  std::optional<config::Node> base_;  // the team's document
  std::vector<std::string> paths_;    // of its metrics
  std::vector<match::Setup> setups_;  // by opponent, then the base team
};

}  // namespace regista::study
