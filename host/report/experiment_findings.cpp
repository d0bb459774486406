// SPDX-License-Identifier: MIT
// What an experiment found, in words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/text.hpp"
#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/visible_text.hpp"

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

// "fixed rate 3.2 > events 2.1 > paper 1.0"
std::string order_text(const ExperimentView& view, std::size_t measure, std::size_t value) {
  const study::ExperimentPlan& plan = view.plan;
  struct Placed {
    std::size_t arm;
    study::MeanEstimate mean;
  };
  std::vector<Placed> placed;
  for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
    placed.push_back({arm, view.course.mean(plan.condition(arm, value), measure)});
  }
  std::erase_if(placed, [](const Placed& each) { return each.mean.pairs == 0; });
  std::ranges::stable_sort(placed, [](const Placed& a, const Placed& b) { return a.mean.mean > b.mean.mean; });
  std::string out;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (i > 0) out += placed[i].mean.mean == placed[i - 1].mean.mean ? " = " : " > ";
    out += fmt::format("{} {}", visible(plan.arms[placed[i].arm].name),
                       rounded(placed[i].mean.mean, half_width(placed[i].mean.interval)));
  }
  return out.empty() ? "no arm has a value" : out;
}

std::string comparison_text(const ExperimentView& view, const Finding& finding) {
  const study::ExperimentPlan& plan = view.plan;
  const std::string first = visible(label(plan, finding.comparison.first));
  const std::string second = visible(label(plan, finding.comparison.second));
  const study::MeanEstimate& difference = finding.difference;
  if (difference.pairs == 0) return fmt::format("{} and {}: no pair has both values.", first, second);
  const double margin = half_width(difference.interval), size = std::abs(difference.mean);
  std::string out = difference.mean == 0.0 ? fmt::format("{} has as much as {}", first, second)
                                           : fmt::format("{} has {} {} than {}", first, rounded(size, margin),
                                                         difference.mean > 0.0 ? "more" : "less", second);
  if (difference.interval) {
    out += fmt::format(" (difference {} to {}, {:.4g} % by itself)", rounded(difference.interval->low, margin),
                       rounded(difference.interval->high, margin), 100.0 * plan.confidence);
  }
  out += ", " + config::counted(static_cast<std::uint64_t>(difference.pairs), "pair", "pairs");
  if (study::equal_conditions(plan, finding.comparison)) {
    return out + ": the two are equal to the last byte, so there is no difference by construction.";
  }
  if (!view.course.complete()) return out + ".";
  if (!finding.adjusted) return out + ": too few pairs for a test.";
  if (plan.test == study::PairTest::paired_t && finding.by != study::PairMethod::student_t) {
    out += "; every pair differs by as much, and without spread Student's t is not defined";
  }
  out += fmt::format("; {}{}, {} after Holm", p_text(*finding.p), by_text(finding.by), p_text(*finding.adjusted));
  if (finding.unplayed_pairs > 0) {
    out += fmt::format(" with {} that could not be played counted for whichever side makes it larger",
                       pairs_in_words(finding.unplayed_pairs));
  }
  if (finding.prevented) {
    return out + fmt::format(": no verdict: {} could not be played.", pairs_in_words(finding.unplayed_pairs));
  }
  return out + (finding.found ? ": a difference was found."
                              : ": no difference was found, which does not prove that "
                                "there is none.");
}

}  // namespace

std::vector<std::string> finding_sentences(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const auto measure = study::primary_measure(plan);
  if (!measure) return {};
  std::vector<std::string> out;
  const std::string what = fmt::format("{}, {}", visible(plan.primary), study::unit_of(plan.primary));
  for (std::size_t value = 0; value < plan.values.size(); ++value) {
    const std::string at = plan.swept() ? fmt::format(" at {}", visible(plan.values[value])) : std::string();
    out.push_back(fmt::format("{}{}: {}.", what, at, order_text(view, *measure, value)));
  }
  for (const Finding& each : study::findings(plan, view.course)) out.push_back(comparison_text(view, each));
  if (!plan.comparisons.empty() && view.course.complete()) {
    out.push_back(fmt::format(
        "The test was fixed beforehand: {}, {} at {:.4g} %, two-sided, corrected by Holm.",
        plan.test == study::PairTest::paired_t ? "Student's t on differences of pairs"
                                               : "all signs that differences of pairs could have had",
        config::counted(plan.comparisons.size(), "comparison", "comparisons"), 100.0 * (1.0 - plan.confidence)));
  }
  return out;
}

}  // namespace regista::report
