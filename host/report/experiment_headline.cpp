// SPDX-License-Identifier: MIT
// What an experiment found, in one line. It puts conditions in an order only where every difference that the order
// claims was found, after the correction for the number of comparisons; of all others it says that none was found.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using study::Finding;

constexpr std::size_t most_clauses = 4;    // that say who has more than whom
constexpr std::size_t most_names = 4;      // beside each other in one of these
constexpr std::size_t most_undecided = 2;  // comparisons without a difference that are named

// "a, b and c"
std::string in_a_row(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    out += i == 0 ? "" : i + 1 == names.size() ? " and " : ", ";
    out += names[i];
  }
  return out;
}

std::string arm_name(const study::ExperimentPlan& plan, std::size_t condition) {
  return texts::visible(plan.asked.arms[plan.conditions[condition].arm].name);
}

std::string value_name(const study::ExperimentPlan& plan, std::size_t condition) {
  return texts::visible(plan.value(plan.conditions[condition].value));
}

// Who has more, and who less.
struct Order {
  std::size_t more, less;  // conditions
};

Order order_of(const Finding& found) {
  const auto& [first, second] = found.comparison;
  return found.difference.mean > 0.0 ? Order{first, second} : Order{second, first};
}

// The comparisons by what came of them, each in the plan's order.
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

// Conditions from the one with most to the one with least; nothing unless every two of them were compared and a
// difference found.
std::optional<std::vector<std::size_t>> whole_order(const study::ExperimentPlan& plan, const Sorted& of) {
  const std::size_t arms = plan.asked.arms.size();
  if (plan.swept() || arms < 2 || of.found.size() != arms * (arms - 1) / 2) return std::nullopt;
  std::vector<std::vector<bool>> more(arms, std::vector<bool>(arms, false));
  for (const Finding* const each : of.found) more[order_of(*each).more][order_of(*each).less] = true;
  std::vector<std::size_t> out(arms), below(arms, 0);
  for (std::size_t arm = 0; arm < arms; ++arm) {
    out[arm] = arm;
    for (std::size_t other = 0; other < arms; ++other) {
      if (arm != other && !more[arm][other] && !more[other][arm]) return std::nullopt;
      below[arm] += more[arm][other] ? 1 : 0;
    }
  }
  std::ranges::sort(out, [&](std::size_t a, std::size_t b) { return below[a] > below[b]; });
  for (std::size_t i = 1; i < arms; ++i) {
    if (below[out[i - 1]] == below[out[i]]) return std::nullopt;  // a circle
  }
  return out;
}

std::string mean_text(const ExperimentView& view, std::size_t condition) {
  const study::MeanEstimate mean = view.course.mean(condition, *study::primary_measure(view.plan));
  return rounded(mean.mean, half_width(mean.interval));
}

// The means tell the same order: they may not where pairs are missing.
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

// --- Some differences ------------------------------------------------------------------------------------------------

// What differs in one name alone is told in one sentence.
struct Clause {
  std::string before, after;       // these names
  std::vector<std::string> names;  // of arms, or of values of the sweep
  bool of_values = false;
};

void add(std::vector<Clause>& clauses, const Clause& one) {
  const auto like = std::ranges::find_if(
      clauses, [&](const Clause& each) { return each.before == one.before && each.after == one.after; });
  if (like == clauses.end())
    clauses.push_back(one);
  else
    like->names.push_back(one.names.front());
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
  if (high.arm == low.arm) {  // compared with the first value
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

// Of comparisons beside others that say something else.
std::string undecided_sentence(const study::ExperimentPlan& plan, const std::vector<const Finding*>& open) {
  if (open.empty()) return {};
  if (open.size() > most_undecided) {
    return fmt::format(" No difference was found in {} of {} comparisons.", open.size(), plan.comparisons().size());
  }
  std::vector<std::string> pairs;
  for (const Finding* const each : open) pairs.push_back(between(plan, each->comparison));
  return fmt::format(" No difference was found between {}.",
                     fmt::format("{}", pairs.front()) + (pairs.size() > 1 ? ", nor between " + pairs[1] : ""));
}

// --- None -----------------------------------------------------------------------------------------------------------

std::string none_found(const study::ExperimentPlan& plan, const std::vector<const Finding*>& open) {
  const std::size_t arms = plan.asked.arms.size();
  const bool any_two = !plan.swept() && open.size() == arms * (arms - 1) / 2;
  const std::string where = open.size() == 1 ? "between " + between(plan, open.front()->comparison)
                            : any_two        ? fmt::format("between any two of the {} arms", arms)
                                             : fmt::format("in any of {} comparisons", open.size());
  return fmt::format("No difference in {} was found {}. This does not show that there is none.",
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
    return texts::counted(some.size(), "comparison", "comparisons");
  };
  if (!of.prevented.empty()) {
    out += fmt::format(" No verdict in {}: pairs could not be played.", count(of.prevented));
  }
  if (!of.untested.empty()) out += fmt::format(" Too few pairs for a test in {}.", count(of.untested));
  for (const Finding* const each : of.equal) {
    out += fmt::format(" {} are equal by construction.", between(plan, each->comparison));
  }
  return out;
}

std::string headline_of_experiment(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  if (!view.course.complete()) {
    return fmt::format("Not at its end: {} of {} matches. Nothing is tested yet.", view.course.taken(), plan.matches());
  }
  if (!study::primary_measure(plan)) return "The experiment names no primary measure, so nothing was tested.";
  if (plan.comparisons().empty()) return of_one_condition(view);
  const std::vector<Finding> all = study::findings(plan, view.course);
  const Sorted of = sorted(view, all);
  if (const auto order = whole_order(plan, of)) return order_sentence(view, *order);
  std::string out = !of.found.empty()  ? found_sentences(plan, of.found) + undecided_sentence(plan, of.open)
                    : !of.open.empty() ? none_found(plan, of.open)
                                       : std::string();
  if (out.empty() && of.prevented.size() == all.size()) return prevented_headline(view.course.unplayed_pairs()) + '.';
  if (out.empty() && of.untested.size() == all.size()) {
    return fmt::format("There are too few pairs for a test of {}.", texts::visible(plan.primary()));
  }
  out += rest(plan, of);
  return out.front() == ' ' ? out.substr(1) : out;
}

}  // namespace

std::string experiment_headline(const ExperimentView& view) {
  return caution(view.course.remarks(), view.plan.limits()) + headline_of_experiment(view);
}

}  // namespace regista::report
