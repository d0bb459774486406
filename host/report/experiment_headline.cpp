// SPDX-License-Identifier: MIT
// Writes the findings of an experiment in one line. The line orders conditions ("a > b > c") only if the experiment
// found all differences between these conditions, after the correction for the number of comparisons. For other tested
// comparisons, the line says that no difference was found.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "report/experiment_report.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using study::Finding;

constexpr std::size_t most_clauses = 4;    // largest number of clauses in the line
constexpr std::size_t most_names = 4;      // largest number of names in a list of a clause
constexpr std::size_t most_undecided = 2;  // largest number of comparisons without a finding that the line names

std::string arm_name(const study::ExperimentPlan& plan, std::size_t condition) {
  return texts::visible(plan.asked.arms[plan.conditions[condition].arm].name);
}

std::string value_name(const study::ExperimentPlan& plan, std::size_t condition) {
  return texts::visible(plan.value(plan.conditions[condition].value));
}

struct Order {
  std::size_t more, less;  // indices of the conditions with the larger and the smaller mean
};

Order order_of(const Finding& found) {
  const auto& [first, second] = found.comparison;
  return found.difference.mean > 0.0 ? Order{first, second} : Order{second, first};
}

// The comparisons by outcome, each list in the order of the plan. found: a difference was found. open: the test found
// no difference. prevented: unplayed pairs prevent a verdict. equal: the conditions cannot differ.
struct Sorted {
  std::vector<const Finding*> found, open, prevented, untested, equal;
};

Sorted sorted(const ExperimentView& view, const std::vector<Finding>& all) {
  Sorted out;
  for (const Finding& each : all) {
    const bool equal = study::equal_conditions(view.plan, each.comparison);
    (equal            ? out.equal
     : each.prevented ? out.prevented
     : each.found     ? out.found
     : each.adjusted  ? out.open
                      : out.untested)
        .push_back(&each);
  }
  return out;
}

// Returns the conditions from the largest mean to the smallest mean, or nothing if a comparison has no finding.
std::optional<std::vector<std::size_t>> whole_order(const study::ExperimentPlan& plan, const Sorted& of) {
  const std::size_t arms = plan.asked.arms.size();
  if (plan.swept() || arms < 2 || of.found.size() != arms * (arms - 1) / 2) return std::nullopt;
  std::vector<std::size_t> out(arms), below(arms, 0);
  std::iota(out.begin(), out.end(), std::size_t{0});
  for (const Finding* const each : of.found) ++below[order_of(*each).more];
  const auto arms_below = [&](std::size_t arm) { return below[arm]; };
  std::ranges::sort(out, std::ranges::greater(), arms_below);
  const bool circle = std::ranges::adjacent_find(out, {}, arms_below) != out.end();
  return circle ? std::nullopt : std::optional(out);
}

std::string mean_text(const ExperimentView& view, std::size_t condition) {
  const study::MeanEstimate mean = view.course.mean(condition, *study::primary_measure(view.plan));
  return rounded(mean.mean, half_width(mean.interval));
}

// Returns whether the means have this order. They may not: a mean uses all pairs, a comparison only complete pairs.
bool means_agree(const ExperimentView& view, const std::vector<std::size_t>& order) {
  const std::size_t measure = *study::primary_measure(view.plan);
  return std::ranges::is_sorted(order, [&](std::size_t a, std::size_t b) {
    return view.course.mean(a, measure).mean > view.course.mean(b, measure).mean;
  });
}

std::string order_sentence(const ExperimentView& view, const std::vector<std::size_t>& order) {
  const study::ExperimentPlan& plan = view.plan;
  const bool with_means = means_agree(view, order);
  if (order.size() == 2) {
    std::string out = fmt::format("{} has more {} than {}", arm_name(plan, order[0]), texts::visible(plan.primary()),
                                  arm_name(plan, order[1]));
    if (with_means) {
      out += fmt::format(": {} against {} {}", mean_text(view, order[0]), mean_text(view, order[1]),
                         study::unit_of(plan.primary()));
    }
    return out + '.';
  }
  std::string chain;
  for (const std::size_t arm : order) {
    chain += (chain.empty() ? "" : " > ") + arm_name(plan, arm) + (with_means ? ' ' + mean_text(view, arm) : "");
  }
  return fmt::format("{}, {}: {}. Every difference was found.", texts::visible(plan.primary()),
                     study::unit_of(plan.primary()), chain);
}

// A sentence about several findings whose sentences would differ only in one name. The sentence lists the names.
struct Clause {
  std::string before, after;       // words around the names
  std::vector<std::string> names;  // names of arms, or values of the sweep if of_values is true
  bool of_values = false;
};

void add(std::vector<Clause>& clauses, const Clause& one) {
  for (Clause& each : clauses) {
    if (each.before == one.before && each.after == one.after) return each.names.push_back(one.names.front());
  }
  clauses.push_back(one);
}

Clause clause_of(const study::ExperimentPlan& plan, const Finding& found) {
  const auto [more, less] = order_of(found);
  const auto what = texts::visible(plan.primary());
  const study::Condition &high = plan.conditions[more], &low = plan.conditions[less];
  if (!plan.swept())
    return {fmt::format("{} has more {} than ", arm_name(plan, more), what), "", {arm_name(plan, less)}};
  if (high.value == low.value) {
    return {fmt::format("{} has more {} than {} at ", arm_name(plan, more), what, arm_name(plan, less)),
            "",
            {value_name(plan, more)},
            true};
  }
  if (high.arm == low.arm) {  // the comparison is between one arm at two values of the sweep
    const bool rises = low.value == 0;
    return {fmt::format("{} has {} {} at ", arm_name(plan, more), rises ? "more" : "less", what),
            fmt::format(" than at {}", value_name(plan, rises ? less : more)),
            {value_name(plan, rises ? more : less)},
            true};
  }
  return {fmt::format("{} has more {} than ", texts::visible(label(plan, more)), what),
          "",
          {texts::visible(label(plan, less))}};
}

std::string sentence_of(const study::ExperimentPlan& plan, const Clause& clause) {
  const std::string sweep = clause.of_values ? " of " + texts::visible(plan.sweep()) : std::string();
  std::string names = in_a_row(clause.names);
  if (clause.of_values && clause.after.empty() && clause.names.size() == plan.values()) {
    names = fmt::format("each of the {} values", plan.values());
  } else if (clause.names.size() > most_names) {
    names = clause.of_values ? fmt::format("{} of {} values", clause.names.size(), plan.values())
                             : fmt::format("{} other arms", clause.names.size());
  }
  return clause.before + names + sweep + clause.after + '.';
}

std::string found_sentences(const study::ExperimentPlan& plan, const std::vector<const Finding*>& found) {
  std::vector<Clause> clauses;
  for (const Finding* const each : found) add(clauses, clause_of(plan, *each));
  std::string out;
  std::size_t told = 0;
  for (std::size_t i = 0; i < std::min(clauses.size(), most_clauses); ++i) {
    out += (i > 0 ? " " : "") + sentence_of(plan, clauses[i]);
    told += clauses[i].names.size();
  }
  if (told < found.size()) {
    const std::size_t left = found.size() - told;
    out += fmt::format(" {} more {} found.", left, left == 1 ? "difference was" : "differences were");
  }
  return out;
}

std::string between(const study::ExperimentPlan& plan, const study::Comparison& comparison) {
  return fmt::format("{} and {}", texts::visible(label(plan, comparison.first)),
                     texts::visible(label(plan, comparison.second)));
}

// Returns a sentence about the comparisons without a finding, for a line that also has findings.
std::string undecided_sentence(const study::ExperimentPlan& plan, const std::vector<const Finding*>& open) {
  if (open.empty()) return {};
  if (open.size() > most_undecided) {
    return fmt::format(" No difference was found in {} of {} comparisons.", open.size(), plan.comparisons().size());
  }
  std::vector<std::string> pairs;
  for (const Finding* const each : open) pairs.push_back(between(plan, each->comparison));
  return fmt::format(" No difference was found between {}.", fmt::join(pairs, ", nor between "));
}

std::string none_found(const study::ExperimentPlan& plan, const std::vector<const Finding*>& open, bool and_no_trend) {
  const std::size_t arms = plan.asked.arms.size();
  const bool any_two = !plan.swept() && open.size() == arms * (arms - 1) / 2;
  const std::string where = open.size() == 1 ? "between " + between(plan, open.front()->comparison)
                            : any_two        ? fmt::format("between any two of the {} arms", arms)
                                             : fmt::format("in any of {} comparisons", open.size());
  if (and_no_trend) {
    return fmt::format(
        "No trend of {} over {} was found, and no difference {}. There may still be smaller differences.",
        texts::visible(plan.primary()), texts::visible(plan.sweep()), where);
  }
  return fmt::format("No difference in {} was found {}. There may still be a smaller difference.",
                     texts::visible(plan.primary()), where);
}

std::string of_one_condition(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const study::MeanEstimate mean = view.course.mean(0, *study::primary_measure(plan));
  if (mean.pairs == 0) return fmt::format("{} has no value.", texts::visible(plan.primary()));
  return fmt::format("{} has {} {}, {}. There is no other arm to compare it with.", arm_name(plan, 0),
                     rounded(mean.mean, half_width(mean.interval)), texts::visible(plan.primary()),
                     study::unit_of(plan.primary()));
}

std::string rest(const study::ExperimentPlan& plan, const Sorted& of) {
  std::string out;
  const auto count = [](const std::vector<const Finding*>& some) {
    return texts::plural(some.size(), "comparison", "comparisons");
  };
  if (!of.prevented.empty()) out += fmt::format(" No verdict in {}: pairs could not be played.", count(of.prevented));
  if (!of.untested.empty()) out += fmt::format(" Too few pairs for a test in {}.", count(of.untested));
  for (const Finding* const each : of.equal) {
    out += fmt::format(" {} are equal by construction.", between(plan, each->comparison));
  }
  return out;
}

struct SortedTrends {
  std::vector<std::string> rising, falling, open;  // names of arms; open: the test of the arm found no trend
  std::size_t untested = 0, prevented = 0;
};

SortedTrends sorted(const study::ExperimentPlan& plan, const std::vector<study::Trend>& all) {
  SortedTrends out;
  for (const study::Trend& each : all) {
    const std::string name = texts::visible(plan.asked.arms[each.arm].name);
    if (each.prevented) {
      ++out.prevented;
    } else if (each.found) {
      (each.slope.mean > 0.0 ? out.rising : out.falling).push_back(name);
    } else if (each.adjusted) {
      out.open.push_back(name);
    } else {
      ++out.untested;
    }
  }
  return out;
}

std::string arms_in_words(const study::ExperimentPlan& plan, const std::vector<std::string>& names) {
  if (names.size() > 1 && names.size() == plan.arms()) return fmt::format("all {} arms", plan.arms());
  return names.size() > most_names ? fmt::format("{} of {} arms", names.size(), plan.arms()) : in_a_row(names);
}

// Returns sentences such as "packets of all 3 arms rises with disturbance.radio.loss."; empty if no trend was found.
std::string trend_sentences(const study::ExperimentPlan& plan, const SortedTrends& of) {
  const std::string what = texts::visible(plan.primary()), over = texts::visible(plan.sweep());
  std::string out;
  const auto add = [&](const std::vector<std::string>& names, const char* verb) {
    if (names.empty()) return;
    out += out.empty() ? fmt::format("{} of {} {} with {}.", what, arms_in_words(plan, names), verb, over)
                       : fmt::format(" That of {} {}.", arms_in_words(plan, names), verb);
  };
  add(of.rising, "rises");
  add(of.falling, "falls");
  if (!out.empty() && !of.open.empty()) out += fmt::format(" No trend was found for {}.", arms_in_words(plan, of.open));
  return out;
}

std::string rest_of_trends(const study::ExperimentPlan& plan, const SortedTrends& of, bool told) {
  std::string out;
  const auto count = [](std::size_t arms) { return texts::plural(arms, "arm", "arms"); };
  if (of.rising.empty() && of.falling.empty() && !of.open.empty() && !told) {
    out += fmt::format(" No trend over {} was found{}.", texts::visible(plan.sweep()),
                       of.open.size() < plan.arms() ? " for " + arms_in_words(plan, of.open) : "");
  }
  if (of.prevented > 0) {
    out += fmt::format(" No verdict on the trend of {}: pairs could not be played.", count(of.prevented));
  }
  if (of.untested > 0) out += fmt::format(" Too few pairs for a test of the trend of {}.", count(of.untested));
  return out;
}

std::string headline_of_experiment(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  if (!view.course.complete()) {
    return fmt::format("Not at its end: {} of {} matches. Nothing is tested yet.", view.course.taken(), plan.matches());
  }
  if (!study::primary_measure(plan)) return "The experiment names no primary measure, so nothing was tested.";
  if (plan.comparisons().empty()) return of_one_condition(view);
  const study::Findings all = study::findings(plan, view.course);
  const Sorted of = sorted(view, all.comparisons);
  const SortedTrends trends = sorted(plan, all.trends);
  if (const auto order = whole_order(plan, of)) return order_sentence(view, *order);
  const std::size_t tested = all.comparisons.size() + all.trends.size();
  if (of.prevented.size() + trends.prevented == tested) return prevented_headline(view.course.unplayed_pairs()) + '.';
  if (of.untested.size() + trends.untested == tested) {
    return fmt::format("There are too few pairs for a test of {}.", texts::visible(plan.primary()));
  }
  std::string out = trend_sentences(plan, trends);
  const bool none_at_all = out.empty() && of.found.empty() && !of.open.empty();
  const bool no_trend = none_at_all && !trends.open.empty() && trends.open.size() == all.trends.size();
  if (none_at_all)
    out = none_found(plan, of.open, no_trend);
  else
    out += (of.found.empty() ? "" : ' ' + found_sentences(plan, of.found)) + undecided_sentence(plan, of.open);
  out += rest_of_trends(plan, trends, no_trend) + rest(plan, of);
  return out.front() == ' ' ? out.substr(1) : out;
}

}  // namespace

std::string in_a_row(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

std::string experiment_headline(const ExperimentView& view) {
  std::string out = caution(view.course.remarks(), view.plan.limits()) + headline_of_experiment(view);
  // For Student's t test, headline_of_experiment() has already reported too few pairs.
  const bool of_signs = view.plan.test() == study::PairTest::sign_flip;
  if (const std::string few = too_few_pairs(view.plan); of_signs && view.course.complete() && !few.empty())
    out += ' ' + few + '.';
  if (!view.plan.pairs_before.empty()) out += " Pairs were added after a look.";
  return out;
}

}  // namespace regista::report
