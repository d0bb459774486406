// SPDX-License-Identifier: MIT
// What an experiment found, comparison by comparison. experiment_headline.cpp says it in one line.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using study::Finding;

const char* by_text(study::PairMethod by) {
  switch (by) {
    case study::PairMethod::student_t:
      break;
    case study::PairMethod::sign_flip:
      return " (all signs, exact)";
    case study::PairMethod::sign_flip_normal_law:
      return " (all signs, by the normal law)";
  }
  return "";
}

// "fixed rate 3.2, events 2.1", in the order of the plan: a mean by itself is no finding.
std::string means_text(const ExperimentView& view, std::size_t measure, std::size_t value) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<std::string> means;
  for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
    const study::MeanEstimate mean = view.course.mean(plan.condition(arm, value), measure);
    if (mean.pairs == 0) continue;
    means.push_back(
        fmt::format("{} {}", texts::visible(plan.asked.arms[arm].name), rounded(mean.mean, half_width(mean.interval))));
  }
  return means.empty() ? std::string("no arm has a value") : texts::join(means);
}

// "mean difference 5.0 (95 % interval of this comparison alone: 2.0 to 8.0), 12 pairs"
std::string difference_text(const study::MeanEstimate& difference, double confidence) {
  const double margin = half_width(difference.interval);
  std::string out = "mean difference " + rounded(difference.mean, margin);
  if (difference.interval) {
    out += fmt::format(" ({:.4g} % interval of this comparison alone: {} to {})", 100.0 * confidence,
                       rounded(difference.interval->low, margin), rounded(difference.interval->high, margin));
  }
  return out + ", " + texts::counted(static_cast<std::uint64_t>(difference.pairs), "pair", "pairs");
}

std::string test_text(const study::ExperimentPlan& plan, const Finding& finding) {
  std::string out =
      fmt::format("; {}{}, {} after Holm", p_text(*finding.p), by_text(finding.by), p_text(*finding.adjusted));
  if (finding.unplayed_pairs > 0) {
    out += fmt::format(", with {} that could not be played counted for the side that makes p larger",
                       pairs_in_words(finding.unplayed_pairs));
  }
  out += '.';
  if (plan.test() == study::PairTest::paired_t && finding.by != study::PairMethod::student_t) {
    out += " Every pair differs by as much: without spread Student's t is not defined.";
  }
  return out;
}

// The verdict first, then the numbers.
std::string comparison_text(const ExperimentView& view, const Finding& finding) {
  const study::ExperimentPlan& plan = view.plan;
  const std::string first = texts::visible(label(plan, finding.comparison.first));
  const std::string second = texts::visible(label(plan, finding.comparison.second));
  const study::MeanEstimate& difference = finding.difference;
  if (difference.pairs == 0) return fmt::format("{} and {}: no pair has both values.", first, second);
  const std::string numbers = difference_text(difference, plan.asked.confidence);
  if (study::equal_conditions(plan, finding.comparison)) {
    return fmt::format("{} and {} are equal to the last byte, so there is no difference by construction: {}.", first,
                       second, numbers);
  }
  if (!view.course.complete()) return fmt::format("{} and {}: {}.", first, second, numbers);
  if (!finding.adjusted) return fmt::format("{} and {}: too few pairs for a test; {}.", first, second, numbers);
  const std::string tested = numbers + test_text(plan, finding);
  if (finding.prevented) {
    return fmt::format("{} and {}: no verdict, because {} could not be played; {}", first, second,
                       pairs_in_words(finding.unplayed_pairs), tested);
  }
  if (!finding.found) return fmt::format("No difference was found between {} and {}: {}", first, second, tested);
  return fmt::format("{} has {} than {}: {}", first, difference.mean > 0.0 ? "more" : "less", second, tested);
}

}  // namespace

std::vector<std::string> finding_sentences(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const auto measure = study::primary_measure(plan);
  if (!measure) return {};
  std::vector<std::string> out;
  for (std::size_t value = 0; value < plan.values(); ++value) {
    const std::string at = plan.swept() ? fmt::format(" at {}", texts::visible(plan.value(value))) : std::string();
    out.push_back(fmt::format("Means of {}, {}{}: {}.", texts::visible(plan.primary()), study::unit_of(plan.primary()),
                              at, means_text(view, *measure, value)));
  }
  const std::vector<Finding> all = study::findings(plan, view.course);
  for (const Finding& each : all) out.push_back(comparison_text(view, each));
  if (plan.comparisons().empty() || !view.course.complete()) return out;
  if (std::ranges::any_of(all, [](const Finding& each) { return each.adjusted && !each.found && !each.prevented; })) {
    out.push_back(
        "\"No difference was found\" does not show that there is none: the interval says how large one may be.");
  }
  out.push_back(fmt::format(
      "The plan fixed the test before the first match: {}, {} at {:.4g} %, two-sided, corrected by Holm.",
      plan.test() == study::PairTest::paired_t ? "Student's t test of the differences of pairs"
                                               : "sign-flip test of the differences of pairs",
      texts::counted(plan.comparisons().size(), "comparison", "comparisons"), 100.0 * (1.0 - plan.asked.confidence)));
  return out;
}

}  // namespace regista::report
