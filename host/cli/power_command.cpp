// SPDX-License-Identifier: MIT
// `regista power`: how many pairs a study needs to find a difference, and which difference its pairs can find. Both
// answers follow from the spread of stored pairs, or of the pairs of a pilot (a small study, played first).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/study_commands.hpp"
#include "config/scalar.hpp"
#include "match/metric_table.hpp"
#include "output/replaced_file.hpp"
#include "plugin/shared_object.hpp"
#include "report/given_results.hpp"
#include "results/results_file.hpp"
#include "statistics/rating.hpp"
#include "study/paired_estimates.hpp"
#include "study/study.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto power_notes = R"(Examples:
  regista power tournament.db
  regista power tournament.db --difference 0.3 --power 0.9
  regista power tournament.db --difference 20elo
  regista power tournament.db --pairs 200 --json
  regista power tournament.db --metric striker.overlap_seconds --difference 10
  regista power role_overlap.db
  regista power configs/studies/rivals.yaml
  regista power --team configs/teams/regista.yaml --team configs/teams/paper.yaml --openings configs/openings

Of results it takes all pairs that are stored. Of a study that has not been played it plays a pilot of ten pairs (--pilot) first,
on seeds of its own, into NAME.pilot.db; the same command goes on with it, or reads it once it is there.
For each pairing, or comparison of an experiment, it prints how far the differences of pairs spread, how many pairs find
a mean difference of --difference with a probability of --power, and how large a difference the study's own number of
pairs finds, or that of --pairs. The test is the one that decides such a study with a fixed number of pairs: sign flips
of a tournament's pairs at 5 %, of an experiment its own; both are two-sided and held to what Holm leaves of the level
where there are several. Few pairs know the spread only roughly, so the number of pairs has an interval of 95 %.
docs/statistics.md says how it is computed.)";

constexpr const char* points = "points";   // the metric of a match's result
constexpr std::uint64_t usual_pilot = 10;  // pairs

struct PowerOptions : StudyOptions {
  std::string metric, difference, power, pairs, pilot;
};

constexpr std::string_view elo_unit = "elo";  // of --difference: of points, 1 for a win and 0.5 for a draw

bool in_elo(const PowerOptions& options) { return options.difference.ends_with(elo_unit); }

// The numbers of the options. The constructor throws BadInput for an option that is not a number.
struct Asked {
  explicit Asked(const PowerOptions& options) {
    if (!options.power.empty()) {
      power = config::parse_rate("--power", options.power);
      if (power < 0.5)
        throw BadInput(fmt::format("--power: {}; expected a number from 0.5 on and below 1", options.power));
    }
    if (!options.difference.empty()) {
      const std::string_view elo = in_elo(options) ? elo_unit : "";
      difference = config::typed_number(options.difference.substr(0, options.difference.size() - elo.size()));
      if (!difference || !(*difference > 0.0))
        throw BadInput(fmt::format("--difference: {}; expected a number above 0, or of Elo as in 20elo",
                                   texts::in_quotes(options.difference)));
    }
    if (!options.pilot.empty()) pilot = config::parse_whole("--pilot", options.pilot, 2, study::most_pairs);
    if (!options.pairs.empty())
      pairs = static_cast<std::int64_t>(config::parse_whole("--pairs", options.pairs, 1, study::most_pairs));
  }
  double power = 0.8;
  std::uint64_t pilot = usual_pilot;  // pairs
  std::optional<double> difference;
  std::optional<std::int64_t> pairs;
};

// can_grow: whether the study can be given more pairs.
void refuse_what_says_nothing(const std::string& file, const study::PairDifferences& study, bool can_grow) {
  const auto pairs = [](const study::ComparedPairs& each) { return each.differences.count(); };
  const std::int64_t most = std::ranges::max(study.compared, {}, pairs).differences.count();
  const std::string name = texts::in_quotes(study.measure);
  if (most == 0 && !study.known.empty() && study.measure != study::goals_value &&
      std::ranges::find(study.known, study.measure) == study.known.end())
    throw BadInput(texts::unknown("metric", study.measure, "--metric", study.known));
  if (most < 2) {
    throw BadInput(fmt::format("power: {} holds {} with a value of {}; a standard deviation needs two or more", file,
                               texts::plural(static_cast<std::uint64_t>(most), "pair", "pairs"), name));
  }
  if (std::ranges::none_of(study.compared, report::has_spread)) {
    const auto even = [](const study::ComparedPairs& each) { return each.differences.uneven() == 0; };
    throw BadInput(fmt::format("power: {} has no spread in {}: {}{}", name, file,
                               std::ranges::all_of(study.compared, even)
                                   ? "all pairs are even; play longer matches"
                                   : "all pairs have one difference, which few pairs find; compare closer teams",
                               can_grow ? fmt::format("; or play more pairs: regista resume {} --pairs N", file) : ""));
  }
}

// Returns the measure to use. usual: the measure if no option names a measure; empty: the study has no primary measure.
std::string measure_of(const std::string& file, const PowerOptions& options, const std::string& usual) {
  if (in_elo(options) && !options.metric.empty() && options.metric != points) {
    throw BadInput(fmt::format("--difference {} is a difference of points; without it --metric {}, or --metric {}",
                               options.difference, options.metric, points));
  }
  std::string out = in_elo(options)          ? points
                    : options.metric.empty() ? usual
                                             : std::string(match::without_roles(options.metric));
  if (out.empty())
    throw BadInput(fmt::format("power: {} names no primary measure; --metric names a number of its matches", file));
  return out;
}

// Prints the answer. compared, several: "Pairing" or "Comparison", and its plural. own: the study's number of pairs.
template <class Plan>
int tell(const std::string& file, const campaign::Store& store, const PowerOptions& options, const Asked& asked,
         const Plan& plan, const std::string& measure, std::optional<std::int64_t> own, bool has_test,
         const char* compared, const char* several) {
  report::PowerQuestion question{
      study::design_of(plan), asked.difference, asked.pairs ? asked.pairs : own, has_test, compared, several};
  question.design.power = asked.power;
  const bool of_goals = measure == study::goals_value || measure == "goal_difference" || measure == "goals_against";
  if (!question.difference && of_goals) question.difference = study::usual_difference;
  const study::PairDifferences study = study::pair_differences(plan, store, measure);
  if (in_elo(options)) {
    // Of two teams that meet, one loses the points that the other gains. Arms of an experiment meet others.
    const bool meet = std::is_same_v<Plan, study::TournamentPlan>;
    const double score = statistics::score_of_elo(*question.difference);
    question.origin = fmt::format("{} Elo are a score of {:.4g} %, ", *question.difference, 100.0 * score);
    question.difference = (meet ? 2.0 : 1.0) * (score - 0.5);
    question.origin += fmt::format("{:.3g} points a match more than {}.", *question.difference,
                                   meet ? "the other team has" : "an arm that scores half of the points");
  }
  if (std::is_same_v<Plan, study::TournamentPlan> && measure == points && !has_test) {
    question.origin += question.origin.empty() ? "" : " ";
    question.origin += "A tournament of a fixed number of pairs tests goals; one with --sprt tests points.";
  }
  refuse_what_says_nothing(file, study, !has_test);
  output::print(options.json ? power_json(study, question) : power_text(study, question));
  return exit_done;
}

[[noreturn]] void refuse_tuning(const std::string& file) {
  throw BadInput(fmt::format(
      "power: {} is a tuning, whose verification is a sequential test; name a tournament or an experiment", file));
}

// Returns the number of pairs that the document of the study sets; nullopt if it sets none.
std::optional<std::int64_t> pairs_of(const config::Node& document) {
  const auto number = [&](const char* key) -> std::optional<double> {
    return document[key] ? config::typed_number(document[key].text()) : std::nullopt;
  };
  if (const auto pairs = number("pairs")) return static_cast<std::int64_t>(*pairs);
  if (const auto matches = number("matches")) return static_cast<std::int64_t>(*matches) / 2;
  return std::nullopt;
}

template <class Plan>
std::optional<std::int64_t> pairs_of(const Plan& plan) {
  const std::uint64_t pairs = plan.pairs_to_its_end();
  return pairs == study::most_pairs ? std::nullopt : std::optional(static_cast<std::int64_t>(pairs));
}

// Prints the answer from stored results. document: of the study whose pilot they are; null: they are the study's own.
int tell_results(const std::string& named, const PowerOptions& options, const Asked& asked,
                 const config::Node* document = nullptr) {
  const std::string file = texts::one_line(named);
  try {
    const campaign::Store store = results::read_results(named);
    const std::string plan = results::stored_plan(store), study = study::study_of(plan);
    if (study == study::tuning_study) refuse_tuning(file);
    const auto told = [&](const auto& played, const std::string& usual, bool has_test, const char* compared,
                          const char* several) {
      return tell(file, store, options, asked, played, measure_of(file, options, usual),
                  document != nullptr ? pairs_of(*document) : pairs_of(played), has_test, compared, several);
    };
    if (study == study::tournament_study) {
      const study::TournamentPlan played = study::tournament_plan_from_json(plan);
      return told(played, study::goals_value, played.asked.test.has_value(), "Pairing", "pairings");
    }
    if (study == study::experiment_study) {
      const study::ExperimentPlan played = study::experiment_plan_from_json(plan);
      if (played.comparisons().empty())
        throw BadInput(fmt::format("power: {} has one arm, which is compared with nothing", file));
      return told(played, played.primary(), false, "Comparison", "comparisons");
    }
    throw BadInput(fmt::format("power: {} is neither a tournament nor an experiment", file));
  } catch (const std::invalid_argument& error) {
    throw BadInput(fmt::format("power: {}: {}", file, error.what()));
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
}

const results::StudyKind& kind_asked(const PowerOptions& options) {
  if (options.file.empty()) return study_kind(config::DocumentKind::tournament);
  const config::Node document = config::load(options.file);
  if (document[config::DocumentKind::tuning.name]) refuse_tuning(texts::one_line(options.file));
  if (document[config::DocumentKind::experiment.name]) return study_kind(config::DocumentKind::experiment);
  config::require_kind(document, config::DocumentKind::tournament);
  return study_kind(config::DocumentKind::tournament);
}

// Returns another seed for the pilot, so that pilot and study share pairs only by chance.
std::string seed_of_pilot(const std::string& seed) {
  return std::to_string(plugin::content_hash_32("pilot " + seed) & 0x7fffffffu);
}

int play_pilot(PowerOptions options, output::OutputFiles outputs, const Asked& asked, const Invocation& invocation) {
  const results::StudyKind& kind = kind_asked(options);
  const config::Node document = config::requested(options.asked(), kind.document);
  const config::Node seed = document["seed"];
  options.set.push_back("seed=" + seed_of_pilot(seed ? seed.text() : "1"));
  if (kind.document == config::DocumentKind::tournament) {
    options.set.push_back(fmt::format("pairs={}", asked.pilot));
    if (document["test"]) options.set.push_back("test=null");
  } else {
    options.set.push_back(fmt::format("matches={}", 2 * asked.pilot));
    if (document["minutes"]) options.set.push_back("minutes=null");
  }
  if (options.results.empty()) options.results = document[kind.document.name].text() + ".pilot.db";
  std::error_code error;
  options.resume = std::filesystem::exists(options.results, error);
  options.no_page = true;
  {
    const results::PlannedStudy pilot = planned(kind, options, outputs, invocation);
    outputs.check(false);
    const auto report = kind.report(pilot.plan, nullptr, results::play_again(invocation));
    campaign::Store store = results::open_results(options.results, options.resume, report->study(),
                                                  {outputs.documents(), pilot.documents}, invocation.studies);
    options.resume = true;  // a message then says that the same command continues the pilot
    results::play_matches(*report, options, invocation, store, {});
  }
  return tell_results(options.results, options, asked, &document);
}

int power(const PowerOptions& options, const Command& command, const Invocation& invocation) {
  const Asked asked(options);
  if (options.file.empty() && options.values.overrides().empty()) {
    throw BadInput(
        "power: of which study? Name a file of results or a document, or two teams, each by --team FILE; see: regista "
        "power --help");
  }
  if (options.file.empty() || !output::is_database(options.file))
    return play_pilot(options, command.outputs("pilot"), asked, invocation);
  for (const output::GivenOption& each : command.given()) {
    constexpr std::array of_results{
        "results file or document", "--metric", "--difference", "--power", "--pairs", "--json"};
    if (each.name == "study" || std::ranges::find(of_results, each.name) != of_results.end()) continue;
    throw BadInput(fmt::format("power: {} is of a study that a pilot is played for; {} holds results", each.name,
                               texts::one_line(options.file)));
  }
  return tell_results(options.file, options, asked);
}

}  // namespace

void add_power(Command& parent, const Invocation& invocation) {
  using enum DocumentOption::Form;
  static constexpr std::array own{
      DocumentOption{"--team", "teams", teams},
      DocumentOption{"--format", "format"},
  };
  Command& command = parent.add("power", "how many pairs a study needs, and how small a difference they find");
  const auto options = std::make_shared<PowerOptions>();
  command.take("study", options->file, "[RESULTS.db]",
               "results of a tournament or an experiment, or its document, of which a pilot is played",
               Reads::documents);
  command.take("--difference", options->difference, "NUMBER",
               "mean difference that matters, in the unit of the metric, or of Elo as in 20elo; default: 0.5 goals a "
               "match");
  command.take("--power", options->power, "RATE", "probability of finding it; default 0.8");
  command.take("--pairs", options->pairs, "N",
               "print the difference that so many pairs find; default: the study's own number");
  command.take("--metric", options->metric, "NAME",
               "number of a match; default: the goals of a tournament, the primary measure of an experiment");
  add_document_options(command, *options, config::DocumentKind::tournament, own, "the study's document");
  command.take("--workers", options->workers, "N",
               "matches of the pilot at the same time; default: one for each processor core");
  add_plugin_folders(command, options->plugins);
  command.take("--pilot", options->pilot, "N", "pairs of the pilot; default 10");
  command.take("--results", options->results, "FILE", "file of the pilot; default: the study's name with .pilot.db",
               Writes::results);
  command.flag("--json", options->json, "write the result as JSON");
  command.flag("--quiet", options->quiet, "no progress on standard error");
  command.notes(power_notes, "0 done; 1 the result could not be written", command::interruptible);
  command.run = [options, &command, &invocation] { return power(*options, command, invocation); };
}

}  // namespace regista::cli
