// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "campaign/inputs.hpp"
#include "campaign/mathematics.hpp"
#include "config/overlay.hpp"
#include "config/parse.hpp"
#include "config/read.hpp"
#include "config/scalar.hpp"
#include "config/text.hpp"
#include "config/typed.hpp"
#include "match/match.hpp"
#include "plugin/declarations.hpp"
#include "study/measure.hpp"
#include "study/sequential_test_options.hpp"
#include "study/study_inputs.hpp"

namespace regista::study {
namespace {

// Of a search whose algorithm takes values for exact; see benchmarks/README.md. A small budget is better spent on fewer
// points that are known better.
constexpr std::uint64_t points_of_a_replicated_search = 200, fewest_replicates = 5;

std::uint64_t replicates(std::uint64_t search_pairs, std::size_t parameters) {
  const std::uint64_t usual = (search_pairs + points_of_a_replicated_search / 2) / points_of_a_replicated_search;
  const std::uint64_t affordable = search_pairs / (4 * (parameters + 1));  // four rounds of a simplex
  return std::max({usual, std::min(fewest_replicates, affordable), std::uint64_t{1}});
}

std::string label_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

config::Overrides overrides_of(const TuningRequest& options) {
  config::Overrides out = options.overrides;
  if (!options.matches.empty()) out.push_back("search.matches=" + options.matches);
  return out;
}

bool is_of_the_team(const Setting& setting) {
  constexpr std::array<std::string_view, 5> others{"opponent.", "rules.", "robot.", "disturbance.",
                                                   "opponent_disturbance."};
  return std::ranges::none_of(others, [&](std::string_view each) { return setting.path.starts_with(each); });
}

}  // namespace

std::uint64_t pairs_in(int matches, std::uint64_t each) { return static_cast<std::uint64_t>(matches) / each; }

std::string unknown_algorithm(const std::string& name) {
  const auto why = why_unsuitable(name);
  const std::vector<std::string> known = algorithm_names();
  return why ? fmt::format("{}: {}; offered: {}", name, *why, config::join(known))
             : config::unknown("algorithm", name, "", known);
}

TuningPlanner::TuningPlanner(const TuningRequest& options, const plugin::Catalogue& catalogue,
                             config::Mistakes& mistakes)
    : options_(options),
      mistakes_(mistakes),
      overrides_(overrides_of(options)),
      document_(config::load(options.file, overrides_)),
      tuning_(config::read_tuning(document_)),
      catalogue_(catalogue),
      program_(campaign::program_hash()),
      mathematics_(campaign::mathematics_fingerprint()) {
  describe();
}

void TuningPlanner::choose_algorithm() {
  const config::Tuning::Search& search = tuning_.search;
  const auto algorithm = algorithm_named(search.algorithm);
  if (!algorithm) {
    throw config::Error(config::at(document_, "search.algorithm").where(),
                        "search.algorithm: " + unknown_algorithm(search.algorithm));
  }
  plan_.algorithm = *algorithm;
  plan_.population = static_cast<std::uint64_t>(search.population.value_or(0));
}

bool TuningPlanner::prepare() {
  meet_opponents();
  if (mistakes_.doubtful("opponents")) return false;  // what comes next needs them all
  mistakes_.attempt("parameters", [&] { choose_parameters(); });
  mistakes_.attempt("openings", [&] {
    DocumentScenes scenes = document_scenes(tuning_.openings, setups_);
    plan_.openings = std::move(scenes.openings);
    count_goals(scenes.read);
  });
  choose_objective();
  return mistakes_.none();
}

void TuningPlanner::count_search(std::span<const Algorithm> algorithms) {
  const std::uint64_t pair = plan_.matches_of_pair();
  plan_.search_pairs = pairs_in(tuning_.search.matches, pair);
  plan_.pairs_for_all = tuning_.search.pairs.has_value();
  plan_.pairs = plan_.pairs_for_all ? static_cast<std::uint64_t>(*tuning_.search.pairs)
                                    : replicates(plan_.search_pairs, plan_.free_parameters());
  for (const Algorithm each : algorithms) {
    // One more: the base team itself.
    const std::uint64_t least =
        1 + least_evaluations(each, plan_.free_parameters(), static_cast<std::size_t>(plan_.population));
    if (plan_.evaluations(each) >= least) continue;
    require_matches("search.matches", least * plan_.pairs_of(each) * pair,
                    fmt::format("{} are too few for the first round of {}, {} points with {} matches each",
                                tuning_.search.matches, name(each), least, plan_.pairs_of(each) * pair));
  }
}

void TuningPlanner::require_matches(const char* path, std::uint64_t least, const std::string& why) const {
  config::refuse(document_, {path}, fmt::format("{}: {}: expected {} or more matches", path, why, least));
}

void TuningPlanner::describe() {
  plan_.name = tuning_.name;
  plan_.question = tuning_.question;
  plan_.team = from_here(tuning_.team);
  plan_.seed = static_cast<std::uint64_t>(tuning_.seed);
  plan_.minutes = tuning_.search.minutes;
  plan_.finalists = static_cast<std::uint64_t>(tuning_.selection.finalists);
  plan_.candidates = static_cast<std::uint64_t>(tuning_.verification.candidates);
  plan_.head_to_head = tuning_.verification.against == config::Tuning::Against::base;
  plan_.symmetric = tuning_.verification.test == config::Tuning::Test::symmetric;
  plan_.confidence = tuning_.verification.confidence;
  plan_.limits = campaign::limits_of(options_, tuning_.isolation, tuning_.play_twice, tuning_.allow_shared_memory);
  plan_.folder = std::filesystem::current_path().string();
  plan_.file = options_.file;
  plan_.overrides = overrides_;
}

// The match of the tuned team, on `side`, against another file; without values of parameters. What disturbs the tuned
// team disturbs the base team, too, when they are compared playing each other.
campaign::Job TuningPlanner::job_of(const std::string& opponent, std::size_t side, bool is_base) const {
  campaign::Job out;
  out.teams[side] = plan_.team;
  out.teams[1 - side] = opponent;
  out.rules = from_here(tuning_.rules);
  out.robot = from_here(tuning_.robot);
  const std::string own = from_here(tuning_.disturbance),
                    other = is_base ? own : from_here(tuning_.opponent_disturbance);
  out.home_disturbance = side == 0 ? own : other;
  out.away_disturbance = side == 0 ? other : own;
  out.plugins = options_.plugins;
  if (tuning_.limit) out.limit = config::real_text(*tuning_.limit);
  return out;
}

TuningOpponent TuningPlanner::opponent_of(const std::string& file, double weight, const std::vector<Setting>& settings,
                                          bool is_base) {
  TuningOpponent out;
  out.file = file;
  out.label = label_of(file);
  out.weight = weight;
  for (const std::size_t side : {0u, 1u}) {
    campaign::Job& job = out.jobs[side];
    job = job_of(file, side, is_base);
    const campaign::Job bare = job_of(file, 0, is_base);
    for (const Setting& each : settings) job.overrides.push_back(override_of(each, side));
    campaign::MatchSetup prepared = settled_match(job, side, settings, bare, catalogue_);
    job.home_inputs = campaign::team_inputs(*prepared.plans[0], *prepared.documents[0], catalogue_);
    job.away_inputs = campaign::team_inputs(*prepared.plans[1], *prepared.documents[1], catalogue_);
    job.common_inputs = campaign::common_inputs(prepared.setup, program_, mathematics_);
    if (side == 1) continue;
    if (!base_) base_ = *prepared.documents[0];
    paths_ = metric_paths_of(*prepared.plans[0]);
    setups_.push_back(std::move(prepared.setup));
  }
  return out;
}

void TuningPlanner::meet_opponents() {
  std::vector<Setting> settings;
  add_settings(tuning_.set, "set", settings);
  double sum = 0.0;
  for (const config::Tuning::Opponent& each : tuning_.opponents) sum += each.weight;
  for (const config::Tuning::Opponent& each : tuning_.opponents) {
    mistakes_.attempt("opponents", [&] { meet(each, sum, settings); });
  }
  if (mistakes_.doubtful("opponents")) return;
  meet_base(settings);
}

void TuningPlanner::meet(const config::Tuning::Opponent& each, double sum, const std::vector<Setting>& settings) {
  TuningOpponent opponent = opponent_of(from_here(each.team), each.weight / sum, settings, false);
  for (const TuningOpponent& other : plan_.opponents) {
    if (other.file == opponent.file) {
      throw config::Error(each.where,
                          fmt::format("opponents: {} is given twice; `weight` says how much it counts", opponent.file));
    }
    if (other.label == opponent.label) opponent.label = opponent.file;
  }
  plan_.opponents.push_back(std::move(opponent));
}

void TuningPlanner::meet_base(const std::vector<Setting>& settings) {
  for (const Setting& each : settings) {
    // What is set for the tuned team alone goes with it into its file; as an opponent the base team has it, too.
    if (!is_of_the_team(each)) continue;
    plan_.settings.push_back(fmt::format("{}={}", each.path, each.value));
  }
  std::vector<Setting> of_both;
  for (const Setting& each : settings) {
    if (each.path.starts_with("opponent.")) continue;
    of_both.push_back(each);
    if (!is_of_the_team(each)) continue;
    of_both.push_back(each);
    of_both.back().path = "opponent." + each.path;
  }
  plan_.base = opponent_of(plan_.team, 1.0, of_both, true);
  plan_.base.label = "the base team";
}

void TuningPlanner::choose_parameters() {
  const auto declarations = plugin::declarations(catalogue_.plugins());
  plan_.parameters = chosen_parameters(tuning_.parameters, tunables(*base_, declarations));
  if (plan_.free_parameters() == 0) {
    config::refuse(document_, {"parameters"}, "parameters: the range of each is one value: there is nothing to tune");
  }
  config::Node document = *base_;
  for (const std::string& each : settings_of(plan_, start_values(plan_))) {
    const config::Location where{"--set " + each, 0, 0};
    const std::size_t equals = each.find('=');
    document =
        config::with(document, each.substr(0, equals), config::parse_value(each.substr(equals + 1), where), where);
  }
  config::read_team(document);
  plan_.document = config::show(document, declarations, config::Remarks::without);
}

void TuningPlanner::count_goals(const std::vector<config::Opening>& scenes) {
  for (match::Setup setup : setups_) {
    if (scenes.empty()) plan_.most_goals = std::max(plan_.most_goals, match::most_goal_difference(setup));
    for (const config::Opening& scene : scenes) {
      setup.opening = scene;
      plan_.most_goals = std::max(plan_.most_goals, match::most_goal_difference(setup));
    }
  }
}

void TuningPlanner::choose_objective() {
  const bool given = static_cast<bool>(document_["objective"]);
  plan_.objective.minimise = !tuning_.objective.minimise.empty();
  if (!given) {
    plan_.objective.terms = {{"goal_difference", 1.0}};
    return;
  }
  std::vector<std::string> known(measures_of_score.begin(), measures_of_score.end());
  known.insert(known.end(), paths_.begin(), paths_.end());
  for (const auto* const terms : {&tuning_.objective.maximise, &tuning_.objective.minimise}) {
    for (const config::TuningObjective::Term& each : *terms) {
      const std::string measure(match::without_roles(each.measure));
      if (std::ranges::find(known, measure) == known.end()) {
        mistakes_.add(config::Error(each.where, "objective: " + config::unknown("measure", measure, "", known)),
                      "objective");
      }
      plan_.objective.terms.push_back({measure, each.weight});
    }
  }
}

}  // namespace regista::study
