// SPDX-License-Identifier: MIT
// What an experiment found, comparison by comparison, and what is to be known to read its tables.
// experiment_headline.cpp says in one line what was found.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

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
  return by == study::PairMethod::sign_flip              ? " (all signs, exact)"
         : by == study::PairMethod::sign_flip_normal_law ? " (all signs, by the normal law)"
                                                         : "";
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

std::string minutes(double seconds) { return fixed(seconds / 60.0, 1); }

// By arm; of a sweep from the least to the most.
std::string playing_note(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<double> seconds;
  std::vector<std::string> by_arm;
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    const auto each = view.course.playing_seconds_of_a_match(i);
    if (!each) continue;
    seconds.push_back(*each);
    by_arm.push_back(fmt::format("{} {}", texts::visible(label(plan, i)), minutes(*each)));
  }
  if (seconds.empty()) return {};
  const std::string least = minutes(*std::ranges::min_element(seconds));
  const std::string most = minutes(*std::ranges::max_element(seconds));
  const std::string range = !plan.swept()   ? fmt::format("{}", fmt::join(by_arm, ", "))
                            : least == most ? least
                                            : fmt::format("{} to {}", least, most);
  return fmt::format("Mean minutes of a match in the phase Playing: {}.", range);
}

// Of games that are shorter than a match: all arms, of a sweep those conditions that overspend.
std::string packets_note(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<std::string> spent;
  std::size_t conditions = 0, overspent = 0;
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    const study::PacketsSpent& packets = view.course.packets(i);
    if (packets.games() == 0) continue;
    ++conditions;
    if (packets.overspent()) ++overspent;
    if (plan.swept() && !packets.overspent()) continue;
    spent.push_back(fmt::format("{} {:.4g} of {:.4g}{}", texts::visible(label(plan, i)), packets.spent(),
                                packets.share(), packets.overspent() ? " (OVERSPENT)" : ""));
  }
  if (conditions == 0) return {};
  const std::string all = fmt::format("{}", fmt::join(spent, ", "));
  const std::string of_sweep = overspent == 0
                                   ? fmt::format("within it in all {} conditions", conditions)
                                   : fmt::format("above it in {} of {} conditions, {}", overspent, conditions, all);
  return fmt::format("Packets per match, and the share of the budget for games of this length: {}.",
                     plan.swept() ? of_sweep : all);
}

bool of_both_teams(std::string_view path) {
  const std::string_view document = path.substr(0, path.find('.'));
  return document == "rules" || document == "robot";
}

std::string opponent_note(const study::ExperimentPlan& plan) {
  std::vector<std::string> paths;
  const auto add = [&](std::string_view path) {
    if (!of_both_teams(path)) return;
    const std::string shown = texts::visible(path);
    if (std::ranges::find(paths, shown) == paths.end()) paths.push_back(shown);
  };
  add(plan.sweep());
  for (const config::Experiment::Arm& arm : plan.asked.arms) {
    for (const config::Node::Entry& each : arm.set.entries()) add(each.key);
  }
  if (paths.empty()) return {};
  return fmt::format("Rules and robot apply to the opponent, too: the opponent is not the same at all values of {}.",
                     fmt::join(paths, ", "));
}

std::string interval_note(const study::ExperimentPlan& plan) {
  if (plan.primary().empty() || plan.comparisons().size() < 2) return {};
  return fmt::format(
      "Each {:.4g} % interval holds for its own comparison, p after Holm for all {} comparisons together. So an "
      "interval may leave out 0 although no difference was found.",
      100.0 * plan.asked.confidence, plan.comparisons().size());
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

std::vector<std::string> experiment_notes(const ExperimentView& view) {
  std::vector<std::string> out{playing_note(view), packets_note(view), opponent_note(view.plan),
                               interval_note(view.plan)};
  std::erase(out, "");
  return out;
}

}  // namespace regista::report
