// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "config/parse.hpp"
#include "study/measure.hpp"
#include "study/plan_fields.hpp"

namespace regista::study {
namespace {

using config::Node;

const config::Location nowhere;

bool sound(const Parameter& each) {
  return each.least <= each.start && each.start <= each.most && (!each.log_scale || each.fixed() || each.least > 0.0);
}

std::string in_words(const std::vector<Parameter>& parameters) {
  std::string out;
  for (const Parameter& each : parameters) {
    out += fmt::format("{}{} {} to {} from {}{}{}", out.empty() ? "" : ", ", each.path, each.least, each.most,
                       each.start, each.integer ? ", whole" : "", each.log_scale ? ", logarithmic" : "");
  }
  return out;
}

TuningObjective objective_of(const config::Tuning& asked) {
  TuningObjective out;
  out.minimise = !asked.objective.minimise.empty();
  for (const auto* const terms : {&asked.objective.maximise, &asked.objective.minimise}) {
    for (const config::TuningObjective::Term& each : *terms)
      out.terms.push_back({std::string(match::without_roles(each.measure)), each.weight});
  }
  if (out.terms.empty()) out.terms = {{"goal_difference", 1.0}};
  return out;
}

// If the tuned team plays against the base team, the same disturbance applies to both.
void make_jobs(const TuningPlan& plan, TuningOpponent& opponent, bool is_base) {
  const config::Tuning& asked = plan.asked;
  ask_for(opponent.jobs,
          {asked.team, opponent.file, asked.disturbance, is_base ? asked.disturbance : asked.opponent_disturbance,
           settings_of(plan, is_base)},
          asked.settings, plan.plugins);
}

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> out;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    out.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

// Returns the map with `value` at the end of a path of keys. Adds the maps of the path that are missing.
Node inserted(const Node& map, std::span<const std::string> path, const Node& value) {
  std::vector<Node::Entry> entries(map.entries().begin(), map.entries().end());
  auto found = std::ranges::find(entries, path.front(), &Node::Entry::key);
  if (found == entries.end()) {
    entries.push_back({path.front(), nowhere, Node()});
    found = entries.end() - 1;
  }
  found->value = path.size() == 1 ? value : inserted(found->value, path.subspan(1), value);
  return Node::map(std::move(entries), nowhere);
}

// Adds a setting to an overlay. The value comes from the whole document, because a later setting may have replaced this
// value, and because file names in the whole document are valid in every folder.
void add(Node& overlay, const Node& whole, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const std::vector<std::string> parts = parts_of(setting.substr(0, equals));
  Node at = whole;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (at.kind() == Node::Kind::sequence) {
      overlay = inserted(overlay, std::span(parts).first(i), at);
      return;
    }
    at = at[parts[i]];
  }
  const bool removes =
      config::parse_value(std::string_view(setting).substr(equals + 1), nowhere).kind() == Node::Kind::null;
  if (at || removes) overlay = inserted(overlay, parts, at ? at : Node::null(nowhere));
}

}  // namespace

// These functions are not in the unnamed namespace, because templates find them by argument-dependent lookup.

template <Like<Parameter> Value, class Visit>
static void fields(Value& parameter, Visit& visit) {
  visit("path", parameter.path);
  visit("start", parameter.start);
  visit("least", parameter.least);
  visit("most", parameter.most);
  visit("integer", parameter.integer);
  visit("log_scale", parameter.log_scale);
  visit("unit", parameter.unit);
  visit("doc", parameter.doc);
}

template <Like<TuningOpponent> Opponent, class Visit>
static void fields(Opponent& opponent, Visit& visit) {
  visit("label", opponent.label);
  visit("home", opponent.jobs[0]);
  visit("away", opponent.jobs[1]);
}

template <Like<TuningPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit("team_document", plan.document);
  visit("parameters", plan.parameters);
  visit.maybe("starts", plan.starts);
  visit("opponents", plan.opponents);
  visit("base", plan.base);
  visit("openings", plan.openings);
  visit("most_goals", plan.most_goals);
  visit("search_pairs", plan.search_pairs);
  visit("pairs", plan.pairs);
  visit("selection_pairs", plan.selection_pairs);
  visit("verification_pairs", plan.verification_pairs);
  visit("folder", plan.folder);
  visit("plugins", plan.plugins);
  visit.maybe("program", plan.program);
}

const char* name(TuningStage stage) {
  constexpr std::array names{"search", "selection", "verification", "slices"};
  return names[static_cast<std::size_t>(stage)];
}

std::size_t TuningPlan::free_parameters() const {
  return static_cast<std::size_t>(std::ranges::count(parameters, false, &Parameter::fixed));
}

ParameterValues start_values(const TuningPlan& plan) {
  ParameterValues out;
  for (const Parameter& each : plan.parameters) out.push_back(each.start);
  return out;
}

Eigen::VectorXd point_of(const TuningPlan& plan, const ParameterValues& values) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(plan.free_parameters()));
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    if (!plan.parameters[i].fixed()) out[next++] = share_of(plan.parameters[i], values[i]);
  }
  return out;
}

ParameterValues values_of(const TuningPlan& plan, const Eigen::VectorXd& point) {
  ParameterValues out;
  Eigen::Index next = 0;
  for (const Parameter& each : plan.parameters) {
    // A fixed parameter keeps its value exactly, without rounding.
    if (each.fixed()) {
      out.push_back(each.least);
      continue;
    }
    const double share = point[next++];
    out.push_back(share == share_of(each, each.start) ? each.start : value_at_share(each, share));
  }
  return out;
}

TunedDocument::TunedDocument(const TuningPlan& plan) : plan_(plan) {
  const auto require = [](bool sound) {
    if (!sound) throw std::invalid_argument("its plan is damaged");
  };
  config::Node document;
  try {
    document = config::parse_text(plan.document, plan.asked.team);
  } catch (const config::Error& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  }
  std::vector<std::size_t> lines{0};  // offsets at which the lines begin
  for (std::size_t i = 0; i < plan.document.size(); ++i) {
    if (plan.document[i] == '\n') lines.push_back(i + 1);
  }
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    const config::Node value = config::value_at(document, plan.parameters[i].path);
    require(value.kind() == config::Node::Kind::scalar);
    const config::Location& where = value.where();
    const std::size_t begin =
        lines.at(static_cast<std::size_t>(where.line - 1)) + static_cast<std::size_t>(where.column - 1);
    const std::string& text = value.text();
    require(!text.empty() && !value.quoted() && begin < plan.document.size() &&
            plan.document.compare(begin, text.size(), text) == 0);
    places_.push_back({begin, text.size(), i});
  }
  std::ranges::sort(places_, std::greater(), &Place::begin);
  require(std::ranges::adjacent_find(places_, {}, &Place::begin) == places_.end());
}

std::string TunedDocument::with(const ParameterValues& values) const {
  std::string out = plan_.document;
  for (const Place& each : places_) {
    out.replace(each.begin, each.length, text_of(plan_.parameters[each.parameter], values[each.parameter]));
  }
  return out;
}

std::vector<std::string> settings_of(const TuningPlan& plan, const ParameterValues& values) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    out.push_back(fmt::format("{}={}", plan.parameters[i].path, text_of(plan.parameters[i], values[i])));
  }
  return out;
}

double score_of(const TuningObjective& objective, double value) { return objective.minimise ? -value : value; }
double value_of(const TuningObjective& objective, double score) { return objective.minimise ? -score : score; }

std::string in_words(const TuningObjective& objective) {
  if (objective.terms.size() == 1 && objective.terms.front().weight == 1.0) return objective.terms.front().measure;
  std::string out;
  for (const ObjectiveTerm& each : objective.terms) {
    const char* const sign = out.empty() ? (each.weight < 0.0 ? "-" : "") : each.weight < 0.0 ? " - " : " + ";
    out += fmt::format("{}{} {}", sign, std::abs(each.weight), each.measure);
  }
  return out;
}

std::optional<ScoreBounds> score_bounds(const TuningPlan& plan) {
  ScoreBounds out{0.0, 0.0};
  for (const ObjectiveTerm& each : plan.objective.terms) {
    double least = 0.0, most = 1.0;  // for the measure "points"
    if (each.measure == "goal_difference") {
      most = plan.most_goals;
      least = -most;
    } else if (each.measure != "points") {
      return std::nullopt;
    }
    const double weight = score_of(plan.objective, each.weight);
    out.low += std::min(weight * least, weight * most);
    out.high += std::max(weight * least, weight * most);
  }
  return out;
}

std::optional<double> widest_difference(const TuningPlan& plan) {
  return plan.symmetric() ? std::nullopt : difference_bound(plan);
}

std::optional<double> difference_bound(const TuningPlan& plan) {
  const std::optional<ScoreBounds> bounds = score_bounds(plan);
  if (!bounds) return std::nullopt;
  return (bounds->high - bounds->low) * (plan.head_to_head() ? 0.5 : 1.0);
}

std::uint64_t least_verification_pairs(const TuningPlan& plan) {
  const double needed = -std::log1p(-plan.confidence());
  // Counts the pairs of the best case: all differences are equal and as large as possible. The test bets half of the
  // capital on each side; a bet wins at most 3/4 of its capital. Without bounds, the test estimates the spread.
  if (widest_difference(plan)) return static_cast<std::uint64_t>(std::ceil((needed + std::log(2.0)) / std::log(1.75)));
  std::uint64_t pairs = 1;
  while (0.5 * static_cast<double>(pairs - 1) - 0.5 * std::log(static_cast<double>(pairs)) < needed) ++pairs;
  return pairs;
}

std::uint64_t verification_pairs_of(const TuningPlan& plan, std::size_t candidates) {
  if (candidates == 0) return 0;
  return plan.verification_pairs * plan.matches_of_verified_pair(plan.candidates()) /
         plan.matches_of_verified_pair(candidates);
}

campaign::Metrics wanted_metrics(const TuningPlan& plan) {
  const auto of_score = [](const ObjectiveTerm& each) {
    return std::ranges::find(measures_of_score, each.measure) != measures_of_score.end();
  };
  if (!std::ranges::all_of(plan.objective.terms, of_score)) return campaign::Metrics::wanted;
  return plan.short_games() ? campaign::Metrics::packets : campaign::Metrics::left_out;
}

std::uint64_t most_matches(const TuningPlan& plan, TuningStage stage) {
  const std::uint64_t pair = plan.matches_of_pair();
  switch (stage) {
    case TuningStage::search:
      return plan.evaluations() * plan.pairs_of_evaluation() * pair;
    case TuningStage::selection:
      return plan.finalists() * plan.selection_pairs * pair;
    case TuningStage::verification:
      return plan.verification_pairs * plan.matches_of_verified_pair(plan.candidates());
    case TuningStage::slices:
      return plan.slice_points() == 0 ? 0
                                      : (plan.slice_points() * plan.free_parameters() + 1) * plan.slice_pairs() * pair;
  }
  return 0;
}

std::uint64_t most_matches(const TuningPlan& plan) {
  using enum TuningStage;
  return most_matches(plan, search) + most_matches(plan, selection) + most_matches(plan, verification) +
         most_matches(plan, slices);
}

config::Overrides settings_of(const TuningPlan& plan, bool against_base) {
  const config::Overrides all = settings_of(plan.asked.settings.set, "set");
  if (!against_base) return all;
  config::Overrides out;
  for (const config::Override& each : all) {
    if (first_part(each.path) == "b") continue;
    out.push_back(each);
    if (is_of_own_team(each.path)) out.emplace_back("b." + each.path, each.value, each.where);
  }
  return out;
}

void complete(TuningPlan& plan) {
  plan.objective = objective_of(plan.asked);
  plan.settings.clear();
  for (const config::Override& each : settings_of(plan, false)) {
    // These settings go into the tuned team's file. The base team as an opponent also has these settings.
    if (is_of_own_team(each.path)) plan.settings.push_back(to_string(each));
  }
  plan.opponents.resize(plan.asked.opponents.size());
  double sum = 0.0;
  for (const config::Tuning::Opponent& each : plan.asked.opponents) sum += each.weight;
  for (std::size_t i = 0; i < plan.opponents.size(); ++i) {
    plan.opponents[i].file = plan.asked.opponents[i].team;
    plan.opponents[i].weight = plan.asked.opponents[i].weight / sum;
    make_jobs(plan, plan.opponents[i], false);
  }
  plan.base.file = plan.asked.team;
  make_jobs(plan, plan.base, true);
}

// Checks the numbers of a plan. The upper bounds are the same as in a tuning document.
bool sound(const TuningPlan& plan) {
  constexpr std::uint64_t most_pairs = 10'000'000;
  const auto within = [](std::uint64_t least, std::uint64_t count, std::uint64_t most) {
    return least <= count && count <= most;
  };
  const auto population = static_cast<std::size_t>(plan.population());  // used only if the algorithm has a population
  return plan.free_parameters() > 0 && plan.most_goals >= 1 && within(1, plan.pairs, most_pairs) &&
         within(plan.pairs, plan.search_pairs, most_pairs) && within(1, plan.selection_pairs, most_pairs) &&
         within(0, plan.verification_pairs, most_pairs) &&
         std::ranges::all_of(plan.parameters, [](const Parameter& each) { return sound(each); }) &&
         std::ranges::all_of(plan.starts,
                             [&](const ParameterValues& each) { return each.size() == plan.parameters.size(); }) &&
         plan.evaluations() >
             plan.starts.size() + least_evaluations(plan.algorithm(), plan.free_parameters(), population);
}

std::string to_json(const TuningPlan& plan) { return plan_text(tuning_study, plan); }

TuningPlan tuning_plan_from_json(const std::string& text) {
  return read_plan<TuningPlan>(text, tuning_study, tuning_of_version_1, [](TuningPlan& plan) {
    if (plan.opponents.size() != plan.asked.opponents.size() || !algorithm_named(plan.asked.search.algorithm) ||
        !sound(plan))
      throw std::out_of_range("what no tuning has");
    complete(plan);
  });
}

std::vector<std::string> differences(const TuningPlan& before, const TuningPlan& now) {
  std::vector<std::string> out = document_differences(before, now);
  if (before.parameters != now.parameters) {
    out.push_back(fmt::format("the parameters: was {}, now {}", in_words(before.parameters), in_words(now.parameters)));
  }
  for (const auto& [what, pairs] : {std::pair{"pairs of the search", &TuningPlan::search_pairs},
                                    {"pairs for each evaluation", &TuningPlan::pairs},
                                    {"pairs of the selection", &TuningPlan::selection_pairs},
                                    {"pairs of the verification", &TuningPlan::verification_pairs}}) {
    if (before.*pairs != now.*pairs) out.push_back(fmt::format("{}: was {}, now {}", what, before.*pairs, now.*pairs));
  }
  if (!out.empty()) return out;  // the code below needs plans with the same opponents
  InputDifferences inputs;
  const auto add = [&](const campaign::Job& old, const campaign::Job& fresh, const std::string& other) {
    inputs.add("the team: ", old.home_inputs, fresh.home_inputs);
    inputs.add(other, old.away_inputs, fresh.away_inputs);
    inputs.add("", old.common_inputs, fresh.common_inputs);
  };
  for (std::size_t i = 0; i < now.opponents.size(); ++i) {
    const OwnJobs &old = before.opponents[i].jobs, &fresh = now.opponents[i].jobs;
    add(old[0], fresh[0], now.opponents[i].label + ": ");
    inputs.add("", old[1].common_inputs, fresh[1].common_inputs);
  }
  for (const std::size_t side : {0u, 1u}) add(before.base.jobs[side], now.base.jobs[side], "the team: ");
  return std::move(inputs).with_openings(before.openings, now.openings);
}

std::string tuned_team(const TuningPlan& plan, const ParameterValues& values, const std::string& name,
                       const std::string& base) {
  const Node whole = config::parse_text(TunedDocument(plan).with(values), plan.asked.team);
  Node overlay = Node::map({}, nowhere);
  for (const std::string& each : plan.settings) {
    if (!each.starts_with("team=")) add(overlay, whole, each);  // the new file has its own name
  }
  for (const std::string& each : settings_of(plan, values)) add(overlay, whole, each);
  const Node head = Node::map(
      {{"extends", nowhere, Node::scalar(base, true, nowhere)}, {"team", nowhere, Node::scalar(name, false, nowhere)}},
      nowhere);
  return config::block(head) + '\n' + config::block(overlay);
}

}  // namespace regista::study
