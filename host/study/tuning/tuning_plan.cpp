// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "config/overlay.hpp"
#include "config/parse.hpp"
#include "config/typed.hpp"
#include "study/measure.hpp"

namespace regista::study {

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
    // The start itself, whatever rounding would make of it.
    if (each.fixed()) {
      out.push_back(each.least);
      continue;
    }
    const double share = point[next++];
    out.push_back(share == share_of(each, each.start) ? each.start : value_at_share(each, share));
  }
  return out;
}

static config::Node document_of(const TuningPlan& plan) {
  try {
    return config::parse_text(plan.document, plan.asked.team);
  } catch (const config::Error& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  }
}

TunedDocument::TunedDocument(const TuningPlan& plan) : plan_(plan) {
  const config::Node document = document_of(plan);
  std::vector<std::size_t> lines{0};  // where they begin
  for (std::size_t i = 0; i < plan.document.size(); ++i) {
    if (plan.document[i] == '\n') lines.push_back(i + 1);
  }
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    const config::Node value = config::value_at(document, plan.parameters[i].path);
    if (value.kind() != config::Node::Kind::scalar) throw std::invalid_argument("its plan is damaged");
    const config::Location& where = value.where();
    const std::size_t begin =
        lines.at(static_cast<std::size_t>(where.line - 1)) + static_cast<std::size_t>(where.column - 1);
    const std::string& text = value.text();
    const bool as_it_stands = begin < plan.document.size() && plan.document.compare(begin, text.size(), text) == 0;
    if (text.empty() || value.quoted() || !as_it_stands) throw std::invalid_argument("its plan is damaged");
    places_.push_back({begin, text.size(), i});
  }
  std::ranges::sort(places_, std::greater(), &Place::begin);
  if (std::ranges::adjacent_find(places_, {}, &Place::begin) != places_.end()) {
    throw std::invalid_argument("its plan is damaged");
  }
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
    double least = 0.0, most = 1.0;  // of points
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
  // All differences equal, and as large as can be. A bet wins three quarters of a capital at most, and half is staked
  // on either side; without bounds the differences are their own spread.
  if (widest_difference(plan)) return static_cast<std::uint64_t>(std::ceil((needed + std::log(2.0)) / std::log(1.75)));
  std::uint64_t pairs = 1;
  while (0.5 * static_cast<double>(pairs - 1) - 0.5 * std::log(static_cast<double>(pairs)) < needed) ++pairs;
  return pairs;
}

static std::uint64_t matches_of_verified_pair(const TuningPlan& plan, std::uint64_t candidates) {
  return plan.head_to_head() ? 2 * candidates : (candidates + 1) * plan.matches_of_pair();
}

std::uint64_t verification_pairs_of(const TuningPlan& plan, std::size_t candidates) {
  if (candidates == 0) return 0;
  return plan.verification_pairs * matches_of_verified_pair(plan, plan.candidates()) /
         matches_of_verified_pair(plan, candidates);
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
      return plan.verification_pairs * matches_of_verified_pair(plan, plan.candidates());
    case TuningStage::slices:
      return plan.slice_points() == 0 ? 0
                                      : (plan.slice_points() * plan.free_parameters() + 1) * plan.slice_pairs() * pair;
  }
  return 0;
}

std::uint64_t most_matches(const TuningPlan& plan) {
  std::uint64_t sum = 0;
  for (const TuningStage stage :
       {TuningStage::search, TuningStage::selection, TuningStage::verification, TuningStage::slices}) {
    sum += most_matches(plan, stage);
  }
  return sum;
}

}  // namespace regista::study
