// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "config/scalar.hpp"
#include "match/match.hpp"
#include "plugin/info.hpp"
#include "study/measure.hpp"
#include "study/plan_fields.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

// Constants for algorithms that treat values as exact (benchmarks/README.md). With a small budget, such algorithms do
// better with few points and more pairs for each point than with many points.
constexpr std::uint64_t points_of_a_replicated_search = 200, fewest_replicates = 5;

std::uint64_t replicates(std::uint64_t search_pairs, std::size_t parameters) {
  const std::uint64_t usual = (search_pairs + points_of_a_replicated_search / 2) / points_of_a_replicated_search;
  const std::uint64_t affordable = search_pairs / (4 * (parameters + 1));  // leaves the search 4 (n + 1) points or more
  return std::max({usual, std::min(fewest_replicates, affordable), std::uint64_t{1}});
}

class TuningPlanner : Planner<TuningPlan> {
 public:
  using Planner<TuningPlan>::Planner;

  TuningPlan planned() {
    complete(plan_);
    mistakes_.attempt("search", [&] { require_algorithm(); });
    mistakes_.attempt("set", [&] { require_present_names(plan_.asked.settings.set, "set"); });
    meet_opponents();
    if (mistakes_.doubtful("opponents")) return std::move(plan_);  // the steps below need all opponents
    mistakes_.attempt("parameters", [&] { choose_parameters(); });
    mistakes_.attempt("openings", [&] {
      DocumentScenes scenes = document_scenes(plan_.asked.settings.openings, setups_);
      plan_.openings = std::move(scenes.openings);
      count_goals(scenes.read);
    });
    require_objective();
    if (!mistakes_.none()) return std::move(plan_);
    mistakes_.attempt("", [&] {
      count_search();
      count_stages();
    });
    return std::move(plan_);
  }

 private:
  void require_algorithm() const {
    const config::Tuning::Search& search = plan_.asked.search;
    const auto algorithm = algorithm_named(search.algorithm);
    if (!algorithm) {
      const auto why = why_unsuitable(search.algorithm);
      const std::vector<std::string> known = algorithm_names();
      throw config::Error(
          config::value_at(document_, "search.algorithm").where(),
          "search.algorithm: " + (why ? fmt::format("{}: {}; offered: {}", search.algorithm, *why, texts::join(known))
                                      : texts::unknown("algorithm", search.algorithm, "", known)));
    }
    if (search.population && !has_population(*algorithm)) {
      config::refuse(document_, {"search.population"}, fmt::format("search.population: {} has none", name(*algorithm)));
    }
  }

  void look_at(TuningOpponent& opponent, bool is_base) {
    campaign::MatchSetup prepared =
        find_inputs(opponent.jobs, settings_of(plan_, is_base), catalogue_, program_, mathematics_);
    if (!team_) team_ = *prepared.documents[0];
    metrics_ = metric_paths_of(*prepared.plans[0]);
    setups_.push_back(std::move(prepared.setup));
  }

  void meet_opponents() {
    for (std::size_t i = 0; i < plan_.opponents.size(); ++i) {
      TuningOpponent& opponent = plan_.opponents[i];
      mistakes_.attempt("opponents", [&] {
        look_at(opponent, false);
        opponent.label = std::filesystem::path(opponent.file).stem().string();
        for (std::size_t other = 0; other < i; ++other) {
          if (plan_.opponents[other].file == opponent.file) {
            throw config::Error(
                plan_.asked.opponents[i].where,
                fmt::format("opponents: {} is given twice; `weight` says how much it counts", opponent.file));
          }
          if (plan_.opponents[other].label == opponent.label) opponent.label = opponent.file;
        }
      });
    }
    if (mistakes_.doubtful("opponents")) return;
    look_at(plan_.base, true);
    plan_.base.label = "the base team";
  }

  void choose_parameters() {
    const auto declarations = plugin::declarations(catalogue_.plugins());
    plan_.parameters = chosen_parameters(plan_.asked.parameters, tunables(*team_, declarations));
    if (plan_.free_parameters() == 0) {
      config::refuse(document_, {"parameters"}, "parameters: the range of each is one value: there is nothing to tune");
    }
    const config::Node document =
        config::override_with(*team_, config::typed_overrides(settings_of(plan_, start_values(plan_))));
    config::read_document<config::Team>(document);
    plan_.document = config::show(document, declarations, config::Remarks::without);
    for (const config::Node& each : plan_.asked.search.start_from) plan_.starts.push_back(point_given(each));
  }

  // Returns the values of a point of search.start_from. A parameter that it does not name has the base team's value.
  ParameterValues point_given(const config::Node& point) const {
    ParameterValues out = start_values(plan_);
    const std::vector<std::string> known = texts::names_of(plan_.parameters, &Parameter::path);
    for (const config::Node::Entry& each : point.entries()) {
      const auto found = std::ranges::find(known, each.key);
      if (found == known.end())
        throw config::Error(each.key_where, texts::unknown("parameter", each.key, "search.start_from", known));
      const Parameter& parameter = plan_.parameters[static_cast<std::size_t>(found - known.begin())];
      const double value = config::to_real(each.value, each.key);
      if (value < parameter.least || value > parameter.most) {
        throw config::Error(
            each.value.where(),
            fmt::format("search.start_from: {}: {} is outside {} to {}", each.key, config::real_text(value),
                        config::real_text(parameter.least), config::real_text(parameter.most)));
      }
      out[static_cast<std::size_t>(found - known.begin())] = value;
    }
    return values_of(plan_, point_of(plan_, out));  // rounded as the points of the search
  }

  void count_goals(const std::vector<config::Opening>& scenes) {
    for (match::Setup setup : setups_) {
      if (scenes.empty()) plan_.most_goals = std::max(plan_.most_goals, match::most_goal_difference(setup));
      for (const config::Opening& scene : scenes) {
        setup.opening = scene;
        plan_.most_goals = std::max(plan_.most_goals, match::most_goal_difference(setup));
      }
    }
  }

  void require_objective() {
    std::vector<std::string> known(measures_of_score.begin(), measures_of_score.end());
    known.insert(known.end(), metrics_.begin(), metrics_.end());
    const config::TuningObjective& objective = plan_.asked.objective;
    for (const auto* const terms : {&objective.maximise, &objective.minimise}) {
      for (const config::TuningObjective::Term& each : *terms) {
        const std::string measure(match::without_roles(each.measure));
        if (std::ranges::find(known, measure) != known.end()) continue;
        mistakes_.add(config::Error(each.where, "objective: " + texts::unknown("measure", measure, "", known)),
                      "objective");
      }
    }
  }

  // Throws the config::Error that the number of matches at `path` is below `least`.
  void require_matches(const char* path, std::uint64_t least, const std::string& why) const {
    config::refuse(document_, {path}, fmt::format("{}: {}: expected {} or more matches", path, why, least));
  }

  void count_search() {
    const std::uint64_t pair = plan_.matches_of_pair();
    const config::Tuning::Search& search = plan_.asked.search;
    plan_.search_pairs = static_cast<std::uint64_t>(search.matches) / pair;
    plan_.pairs = search.pairs ? static_cast<std::uint64_t>(*search.pairs)
                               : replicates(plan_.search_pairs, plan_.free_parameters());
    // One more evaluation is for the base team.
    const std::uint64_t least =
        1 + plan_.starts.size() +
        least_evaluations(plan_.algorithm(), plan_.free_parameters(), static_cast<std::size_t>(plan_.population()));
    if (plan_.evaluations() >= least) return;
    const std::uint64_t each = plan_.pairs_of_evaluation() * pair;
    require_matches("search.matches", least * each,
                    fmt::format("{} are too few for the first round of {}, {} points with {} matches each",
                                search.matches, name(plan_.algorithm()), least, each));
  }

  void count_stages() {
    const std::uint64_t pair = plan_.matches_of_pair();
    plan_.selection_pairs = static_cast<std::uint64_t>(plan_.asked.selection.matches) / (pair * plan_.finalists());
    if (plan_.selection_pairs < 1) {
      require_matches("selection.matches", pair * plan_.finalists(),
                      fmt::format("too few for {} finalists", plan_.finalists()));
    }
    const std::uint64_t together = plan_.matches_of_verified_pair(plan_.candidates());
    plan_.verification_pairs = static_cast<std::uint64_t>(plan_.asked.verification.matches) / together;
    const std::uint64_t least = least_verification_pairs(plan_);
    if (plan_.verification_pairs < least) {
      require_matches("verification.matches", least * together,
                      fmt::format("{} pairs cannot show any difference with a confidence of {}, whatever they are",
                                  plan_.verification_pairs, config::real_text(plan_.confidence())));
    }
  }

  std::optional<config::Node> team_;  // document of the base team
  std::vector<std::string> metrics_;  // paths of the metrics
  std::vector<match::Setup> setups_;  // by opponent, then the base team
};

}  // namespace

TuningPlan planned_tuning(const config::Node& document, const std::vector<std::string>& plugins,
                          const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  return TuningPlanner(document, plugins, catalogue, mistakes).planned();
}

std::vector<std::string> notes_on(const TuningPlan& plan) {
  std::vector<std::string> out;
  for (const TuningOpponent& each : plan.opponents) {
    const campaign::Job& job = each.jobs[0];
    if (job.home_inputs != job.away_inputs) continue;
    out.push_back(
        fmt::format("{} is the base team itself: its own value against it is 0 goals by construction", each.label));
  }
  return out;
}

}  // namespace regista::study
