// SPDX-License-Identifier: MIT
// The findings of an experiment, comparison by comparison, and notes that readers of its tables need.
// experiment_headline.cpp writes the findings in one line.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "config/scalar.hpp"
#include "report/experiment_report.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "study/paired_estimates.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using study::Finding;

const char* by_text(study::PairMethod by) {
  return by == study::PairMethod::sign_flip              ? " (all signs, exact)"
         : by == study::PairMethod::sign_flip_normal_law ? " (all signs, by the normal law)"
                                                         : "";
}

// Lists the means of the arms in the order of the plan: "fixed rate 3.2, events 2.1".
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

// Returns " (95 % interval of this trend alone: 20.2 to 40.0), 12 pairs". scale: factor for both ends of the interval.
std::string interval_and_pairs(const study::MeanEstimate& of, double scale, double confidence, const char* what) {
  std::string out;
  if (of.interval) {
    const double one = scale * of.interval->low, other = scale * of.interval->high,
                 margin = std::abs(scale) * half_width(of.interval);
    out = fmt::format(" ({:.4g} % interval of this {} alone: {} to {})", 100.0 * confidence, what,
                      rounded(std::min(one, other), margin), rounded(std::max(one, other), margin));
  }
  return out + ", " + pairs_in_words(static_cast<std::uint64_t>(of.pairs));
}

// Returns "mean difference 5.0 (95 % interval of this comparison alone: 2.0 to 8.0), 12 pairs".
std::string difference_text(const study::MeanEstimate& difference, double confidence) {
  return "mean difference " + rounded(difference.mean, half_width(difference.interval)) +
         interval_and_pairs(difference, 1.0, confidence, "comparison");
}

std::string test_text(const study::ExperimentPlan& plan, const study::Tested& finding) {
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

// Returns a verdict and its numbers. found: verdict with a finding. none: verdict without a finding. subject: begins
// the text if there is no verdict. line: words before the numbers if there is no finding.
std::string tested_text(const ExperimentView& view, const study::Tested& of, const std::string& subject,
                        const std::string& line, const std::string& numbers, const std::string& none,
                        const std::string& found) {
  if (!view.course.complete()) return fmt::format("{}: {}{}.", subject, line, numbers);
  if (!of.adjusted) return fmt::format("{}: too few pairs for a test; {}{}.", subject, line, numbers);
  const std::string tested = numbers + test_text(view.plan, of);
  if (of.prevented) {
    return fmt::format("{}: no verdict, because {} could not be played; {}{}", subject,
                       pairs_in_words(of.unplayed_pairs), line, tested);
  }
  return of.found ? found + ": " + tested : none + ": " + line + tested;
}

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
  return tested_text(view, finding, fmt::format("{} and {}", first, second), "", numbers,
                     fmt::format("No difference was found between {} and {}", first, second),
                     fmt::format("{} has {} than {}", first, difference.mean > 0.0 ? "more" : "less", second));
}

// Returns the rise of the fitted line over all swept values: "by 30.1 from 0 to 0.6 (95 % interval of this trend alone:
// 20.2 to 40.0), 12 pairs". sign: -1 if the verb of the sentence is "falls", so that the number is positive.
std::string rise_text(const study::ExperimentPlan& plan, const study::MeanEstimate& slope, double sign) {
  const auto [least, most] = std::ranges::minmax(study::swept_numbers(plan));
  const double length = sign * (most - least), margin = std::abs(length) * half_width(slope.interval);
  return fmt::format("by {} from {} to {}{}", rounded(length * slope.mean, margin), config::real_text(least),
                     config::real_text(most), interval_and_pairs(slope, length, plan.asked.confidence, "trend"));
}

std::string trend_text(const ExperimentView& view, const study::Trend& trend) {
  const study::ExperimentPlan& plan = view.plan;
  const std::string what = fmt::format("{} of {}", texts::visible(plan.primary()),
                                       texts::visible(plan.asked.arms[trend.arm].name)),
                    over = texts::visible(plan.sweep());
  if (trend.slope.pairs == 0) return fmt::format("{}: no pair has values at all values of {}.", what, over);
  const bool falls = trend.slope.mean < 0.0;
  const std::string numbers = rise_text(plan, trend.slope, falls ? -1.0 : 1.0);
  return tested_text(view, trend, fmt::format("{} over {}", what, over),
                     fmt::format("the line that fits best {} ", falls ? "falls" : "rises"), numbers,
                     fmt::format("No trend over {} was found for {}", over, what),
                     fmt::format("{} {} with {}", what, falls ? "falls" : "rises", over));
}

std::string minutes(double seconds) { return fixed(seconds / 60.0, 1); }

// Returns a note with the minutes of play of each arm; for a sweep with the smallest and the largest number of minutes.
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
  const auto [low, high] = std::ranges::minmax(seconds);
  const std::string least = minutes(low), most = minutes(high);
  const std::string range = !plan.swept()   ? fmt::format("{}", fmt::join(by_arm, ", "))
                            : least == most ? least
                                            : fmt::format("{} to {}", least, most);
  return fmt::format("Mean minutes of a match in the phase Playing: {}.", range);
}

// Returns a note on the packets of short games: for all arms, or in a sweep for the condition most above its share.
std::string packets_note(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<std::string> spent;
  std::size_t above = 0;
  const auto text_of = [&](std::size_t condition) {
    const study::PacketsSpent& packets = view.course.packets(condition);
    return fmt::format("{} {:.4g} of {:.4g}{}", texts::visible(label(plan, condition)), packets.spent(),
                       packets.share(), packets.above_share() ? " (more than its share)" : "");
  };
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    const study::PacketsSpent& packets = view.course.packets(i);
    if (packets.games() == 0) continue;
    spent.push_back(text_of(i));
    if (!packets.above_share()) continue;
    ++above;
    if (!most || packets.over() > view.course.packets(*most).over()) most = i;
  }
  if (spent.empty()) return {};
  const std::string amounts =
      !plan.swept() ? fmt::format("{}", fmt::join(spent, ", "))
      : above == 0  ? fmt::format("within it, or at most 5 % above it, in all {} conditions", spent.size())
                    : fmt::format("more than 5 % above it in {} of {} conditions, most of all {}", above, spent.size(),
                                  text_of(*most));
  return fmt::format("Packets per match, and the share of the budget for games of this length: {}.", amounts);
}

std::string opponent_note(const study::ExperimentPlan& plan) {
  std::vector<std::string> paths;
  const auto add = [&](std::string_view path) {
    const std::string_view document = path.substr(0, path.find('.'));
    if (document == "rules" || document == "robot") texts::add_once(paths, texts::visible(path));
  };
  add(plan.sweep());
  for (const config::Experiment::Arm& arm : plan.asked.arms) {
    for (const config::Node::Entry& each : arm.set.entries()) add(each.key);
  }
  if (paths.empty()) return {};
  return fmt::format("Rules and robot apply to the opponent, too: the opponent is not the same at all values of {}.",
                     fmt::join(paths, ", "));
}

// Returns the number of tests in words: "3 comparisons and 2 trends".
std::string family_text(const study::Findings& all) {
  std::string out = texts::plural(all.comparisons.size(), "comparison", "comparisons");
  return all.trends.empty() ? out : out + " and " + texts::plural(all.trends.size(), "trend", "trends");
}

std::string interval_note(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const study::Findings all = study::findings(plan, view.course);
  if (all.comparisons.size() + all.trends.size() < 2) return {};
  return fmt::format(
      "Each {:.4g} % interval holds for its own {}, p after Holm for all {} together. So an interval may leave out 0 "
      "although nothing was found.",
      100.0 * plan.asked.confidence, all.trends.empty() ? "comparison" : "comparison or trend", family_text(all));
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
  const study::Findings all = study::findings(plan, view.course);
  for (const study::Trend& each : all.trends) out.push_back(trend_text(view, each));
  for (const Finding& each : all.comparisons) out.push_back(comparison_text(view, each));
  if (plan.comparisons().empty() || !view.course.complete()) return out;
  const auto open = [](const study::Tested& each) { return each.adjusted && !each.found && !each.prevented; };
  if (std::ranges::any_of(all.comparisons, open)) {
    out.push_back(
        "Where no difference was found, there may still be a smaller difference: the interval shows how large it may "
        "be.");
  }
  out.push_back(fmt::format(
      "The plan fixed the test before the first match: {} of the differences{} of pairs, {} at {:.4g} %, two-sided, "
      "corrected by Holm.",
      plan.test() == study::PairTest::paired_t ? "Student's t test" : "sign-flip test",
      all.trends.empty() ? "" : " and slopes", family_text(all), 100.0 * (1.0 - plan.asked.confidence)));
  if (plan.ended_after) out.push_back(stopped_sentence(plan));
  if (!plan.pairs_before.empty()) out.push_back(more_pairs_sentence(plan.pairs_before));
  return out;
}

std::vector<std::string> experiment_notes(const ExperimentView& view) {
  std::vector<std::string> out{playing_note(view), packets_note(view), opponent_note(view.plan), interval_note(view)};
  std::erase(out, "");
  return out;
}

}  // namespace regista::report
