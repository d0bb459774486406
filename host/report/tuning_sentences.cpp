// SPDX-License-Identifier: MIT
#include "report/tuning_sentences.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/packets_spent.hpp"
#include "report/standing.hpp"
#include "report/visible_text.hpp"

namespace regista::report {
namespace {

using study::TuningStage;

std::string counted(std::uint64_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}
std::string pairs_text(std::uint64_t count) { return counted(count, "pair", "pairs"); }

// To the nearest name of a file that people say.
std::string file_name(const std::string& path) { return visible(std::filesystem::path(path).filename().string()); }

bool is_base(const study::TuningPlan& plan, const study::TuningOpponent& opponent) {
  const auto& inputs = opponent.jobs[0].away_inputs;
  return !inputs.empty() && inputs == plan.base.jobs[0].away_inputs;
}

std::string opponents_text(const study::TuningPlan& plan) {
  std::vector<std::string> out;
  for (const study::TuningOpponent& each : plan.opponents) {
    out.push_back(plan.opponents.size() == 1 ? visible(each.label)
                                             : fmt::format("{} ({:.4g} %)", visible(each.label), 100.0 * each.weight));
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

std::string base_sentence(const study::TuningPlan& plan) {
  std::string out = fmt::format("Base team: {}", visible(plan.team));
  for (std::size_t i = 0; i < plan.settings.size(); ++i) {
    out += fmt::format("{}{}", i == 0 ? " with " : ", ", visible(plan.settings[i]));
  }
  out += fmt::format(". {}: {}", plan.opponents.size() == 1 ? "Opponent" : "Opponents, with their weights",
                     opponents_text(plan));
  for (const study::TuningOpponent& each : plan.opponents) {
    if (is_base(plan, each)) out += fmt::format("; {} is the base team itself", visible(each.label));
  }
  return out + ".";
}

std::string unit_sentence(const study::TuningPlan& plan) {
  return fmt::format(
      "A pair is {}: with the tuned team at home and away{}, all with the same seed{}.",
      counted(plan.matches_of_pair(), "match", "matches"),
      plan.opponents.size() == 1 ? std::string() : fmt::format(", against each of {} opponents", plan.opponents.size()),
      plan.openings.empty() ? std::string(", from kick-off")
                            : fmt::format(" and opening, of {}", counted(plan.openings.size(), "opening", "openings")));
}

std::string search_plan_sentence(const study::TuningPlan& plan) {
  std::string out = fmt::format("Search: {} ({}), at most {} of {}", name(plan.algorithm), summary(plan.algorithm),
                                counted(plan.evaluations(plan.algorithm), "evaluation", "evaluations"),
                                pairs_text(plan.pairs_of(plan.algorithm)));
  if (plan.minutes) out += fmt::format(", and at most {:.6g} min", *plan.minutes);
  if (plan.population > 0) out += fmt::format(", population {}", plan.population);
  return out + fmt::format(", seed {}.", plan.seed);
}

std::string verification_plan_sentence(const study::TuningPlan& plan) {
  std::string out = fmt::format("Selection: at most {} on {} that the search did not play. ",
                                counted(plan.finalists, "finalist", "finalists"), pairs_text(plan.selection_pairs));
  if (plan.verification_pairs == 0 || plan.candidates == 0) return out + "Nothing is verified.";
  out += fmt::format(
      "Verification: {} against the base team, {}, on at most {} that nothing was chosen by; a paired sequential test "
      "at {:.4g} %, two-sided, which may be looked at after every pair",
      plan.candidates == 1 ? std::string("the best of them")
                           : fmt::format("the best of them, at most {},", plan.candidates),
      plan.head_to_head ? "playing each other" : "both against the same opponents", pairs_text(plan.verification_pairs),
      100.0 * (1.0 - plan.confidence));
  return out + (plan.candidates > 1 ? ", corrected by Holm." : ".");
}

std::string compared_plan_sentence(const study::TuningPlan& plan) {
  std::vector<std::string> names;
  for (const study::Algorithm each : plan.compared) {
    names.push_back(fmt::format("{} ({} for each evaluation)", name(each), pairs_text(plan.pairs_of(each))));
  }
  return fmt::format(
      "Compared: {}; {} of each, seeds from {}. Each has the same budget, {}, and what it recommends is judged with "
      "all others on the same {} that no search has seen.",
      fmt::join(names, ", "), counted(plan.repeats, "run", "runs"), plan.seed,
      counted(plan.search_pairs * plan.matches_of_pair(), "match", "matches"), pairs_text(plan.verification_pairs));
}

std::string interval_words(const study::TuningPlan& plan, std::size_t candidates) {
  return fmt::format("{:.4g} % at all times{}", 100.0 * plan.confidence,
                     candidates > 1 ? ", for all candidates together" : "");
}

std::string numbers_text(const TuningView& view, const CandidateVerdict& each, std::size_t candidates) {
  const study::TuningPlan& plan = view.plan;
  if (each.pairs == 0) return "no pair has both values";
  std::string out = visible(in_words(plan.objective));
  if (each.value) {
    out += fmt::format(" {}, the base team {}, difference ", told_text(*each.value), told_text(*each.base));
  } else {
    out += " less the base team's in the same matches ";
  }
  out += told_text(each.difference);
  const statistics::Interval& interval = each.difference.interval;
  out += has_width(interval)  ? fmt::format(" ({})", interval_words(plan, candidates))
         : interval.bounded() ? std::string(" (every pair differs by as much)")
                              : std::string(" (too few pairs for an interval)");
  out += fmt::format(", {}, {}", pairs_text(static_cast<std::uint64_t>(each.pairs)), p_text(each.p));
  if (candidates > 1) out += fmt::format(", {} after Holm", p_text(each.adjusted));
  return out;
}

std::string finding_text(const TuningView& view, const CandidateVerdict& each) {
  const bool over = view.record.stage != TuningStage::verification;
  switch (each.finding) {
    case study::VerifiedAs::better:
      return "better than the base team on seeds that nobody has chosen by";
    case study::VerifiedAs::worse:
      return "worse than the base team on seeds that nobody has chosen by";
    case study::VerifiedAs::prevented:
      return over ? fmt::format("no verdict, because {} could not be played",
                                pairs_text(view.record.verification.of()[each.candidate].unplayed_pairs()))
                  : std::string("not decided yet");
    case study::VerifiedAs::undecided:
      break;
  }
  if (each.forfeited && each.adjusted <= 1.0 - view.plan.confidence) {
    return "not taken for better, because it forfeited a match of the verification";
  }
  return over ? fmt::format(
                    "no difference from the base team was found within {}, which does not show that there is "
                    "none",
                    pairs_text(view.record.verification.pairs()))
              : std::string("not decided yet");
}

std::string optimism_text(const TuningView& view, const CandidateVerdict& each) {
  if (!each.seen)
    return "The search itself never played it: it is a mean of points that it played, and promised nothing.";
  if (!each.optimism) return {};
  const double margin = std::abs(*each.optimism) / 10.0;
  const char* const where = view.plan.head_to_head ? "the selection" : "the verification";
  const study::MeanEstimate& came = view.plan.head_to_head ? each.selected : *each.value;
  std::string out =
      fmt::format("The search had promised {}, {} gave {}", told_text(*each.seen), where, told_text(came));
  return out + (*each.optimism > 0.0 ? fmt::format(": {} of the promise was optimism.", rounded(*each.optimism, margin))
                                     : std::string(": its promise was not too high."));
}

std::string candidate_sentence(const TuningView& view, const CandidateVerdict& each, std::size_t candidates) {
  std::string out = fmt::format("Finalist {}: {}; {}.", each.finalist + 1, finding_text(view, each),
                                numbers_text(view, each, candidates));
  const std::string packets = packets_clause(each.packets, OverspentMark::loud);
  for (const std::string& more : {optimism_text(view, each), packets.empty() ? packets : "It " + packets + '.'}) {
    if (!more.empty()) out += ' ' + more;
  }
  return out;
}

// Both corrections hold, but that of the intervals is the coarser one.
std::string several_note(std::size_t candidates) {
  if (candidates < 2) return {};
  return "The intervals hold for all candidates together, and are wider than the test by Holm asks for: one that "
         "contains 0 and a difference that was found do not contradict each other.";
}

bool base_came_first(const TuningView& view) {
  return !view.record.finalists.empty() && view.record.finalists.front().values == start_values(view.plan);
}

std::string headline_of_tuning(const TuningView& view, const std::vector<CandidateVerdict>& candidates) {
  const study::TuningRecord& record = view.record;
  if (record.stage == TuningStage::search || record.stage == TuningStage::selection) {
    return "Nothing is verified yet, so nothing can be said.";
  }
  if (record.candidates.empty()) {
    return base_came_first(view) ? "The search found nothing better than the base team."
                                 : "No finalist was to be verified, so nothing can be said.";
  }
  if (record.verified()) return "The tuned team is better than the base team, on seeds that nobody has chosen by.";
  const bool over = record.stage != TuningStage::verification;
  if (record.verification.pairs() == 0) {
    return over ? "Nothing was verified, so nothing can be said." : "Nothing is verified yet, so nothing can be said.";
  }
  if (!over) return "Not decided yet whether the tuned team is better than the base team.";
  if (std::ranges::all_of(candidates, [](const auto& each) { return each.finding == study::VerifiedAs::worse; })) {
    return "What the search found is worse than the base team, on seeds that nobody has chosen by.";
  }
  if (std::ranges::find(candidates, study::VerifiedAs::prevented, &CandidateVerdict::finding) != candidates.end()) {
    return prevented_headline(record.verification.unplayed_pairs()) + ".";
  }
  const auto gave_up = [&](const auto& each) {
    return each.forfeited && each.finding == study::VerifiedAs::undecided &&
           each.adjusted <= 1.0 - view.plan.confidence;
  };
  if (std::ranges::any_of(candidates, gave_up)) {
    return "The tuned team is not taken for better: it forfeited a match of the verification.";
  }
  return fmt::format(
      "No difference between the tuned team and the base team was found within {}: this does not show that there is "
      "none.",
      pairs_text(record.verification.pairs()));
}

std::string headline_of_comparison(const TuningView& view) {
  std::vector<AlgorithmSummary> placed = algorithm_summaries(view);
  std::erase_if(placed, [](const AlgorithmSummary& each) { return !each.difference; });
  if (placed.empty()) return "No run has been judged yet, so nothing can be said.";
  std::ranges::stable_sort(placed, std::greater(), [&](const AlgorithmSummary& each) {
    return study::score_of(view.plan.objective, each.difference->median);
  });
  std::string order;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const double median = placed[i].difference->median;
    if (i > 0) order += median == placed[i - 1].difference->median ? " = " : ", ";
    order += fmt::format("{} {}", name(placed[i].algorithm), signed_text(median, 0.0));
  }
  return fmt::format("{}, median difference from the base team, the best first: {}.",
                     visible(in_words(view.plan.objective)), order);
}

TuningVerdict comparison_verdict(const TuningView& view) {
  TuningVerdict out{headline_of_comparison(view), {}};
  if (view.record.stage) return out;
  out.beside.push_back(fmt::format(
      "All had the same budget, {}, and were judged on the same {} that no search has seen; one that ended by itself "
      "played fewer.",
      counted(view.plan.search_pairs * view.plan.matches_of_pair(), "match", "matches"),
      pairs_text(view.plan.verification_pairs)));
  out.beside.push_back(fmt::format(
      "The order is that of medians over {}, with no test: it says how these runs went, not which algorithm is the "
      "better one.",
      counted(view.plan.repeats, "run", "runs")));
  return out;
}

}  // namespace

std::string objective_text(const study::TuningObjective& objective) {
  const std::string unit = unit_of(objective);
  return visible(in_words(objective)) + (unit.empty() ? std::string() : fmt::format(" ({})", unit));
}

std::string tuning_title(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  return fmt::format("{}: {} of {}, {} as {} as possible{}", visible(plan.name),
                     counted(plan.free_parameters(), "parameter", "parameters"), file_name(plan.team),
                     visible(in_words(plan.objective)), plan.objective.minimise ? "small" : "large",
                     plan.compares() ? fmt::format(", by {}", counted(plan.compared.size(), "algorithm", "algorithms"))
                                     : std::string());
}

std::string unfinished_sentence(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  if (!record.stage) return {};
  const char* const begin = "Not at its end: ";
  switch (*record.stage) {
    case TuningStage::search:
      return plan.compares()
                 ? fmt::format("{}{} of {} runs.", begin, record.compared.size(), plan.compared.size() * plan.repeats)
                 : fmt::format("{}search, {} of at most {}.", begin, record.trace.size(),
                               counted(plan.evaluations(plan.algorithm), "evaluation", "evaluations"));
    case TuningStage::selection:
      return fmt::format("{}selection of the finalists.", begin);
    case TuningStage::verification:
      return plan.compares() ? fmt::format("{}the runs are being judged.", begin)
                             : fmt::format("{}verification, {} of at most {}.", begin, record.verification.pairs(),
                                           pairs_text(plan.verification_pairs));
    case TuningStage::slices:
      return fmt::format("{}slices around what was found.", begin);
  }
  return {};
}

std::vector<std::string> setup_sentences(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  std::vector<std::string> out{base_sentence(plan),
                               fmt::format("Objective: {}, the {} the better.", objective_text(plan.objective),
                                           plan.objective.minimise ? "smaller" : "larger"),
                               unit_sentence(plan)};
  if (plan.compares()) {
    out.push_back(compared_plan_sentence(plan));
    return out;
  }
  out.push_back(search_plan_sentence(plan));
  out.push_back(verification_plan_sentence(plan));
  return out;
}

std::vector<std::string> search_sentences(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  const study::SearchStep* const best = best_step(record);
  if (view.plan.compares() || best == nullptr) return {};
  const auto value = [&](const study::SearchStep& step) {
    return told_text(told(view.plan.objective, step.played.score));
  };
  const std::uint64_t failed = static_cast<std::uint64_t>(
      std::ranges::count_if(record.trace, [](const auto& each) { return each.played.failed; }));
  std::vector<std::string> out{fmt::format("The search {} {} and {}{}.",
                                           record.ended.empty() ? "has come to" : "ended after",
                                           counted(record.trace.size(), "evaluation", "evaluations"),
                                           counted(record.trace.back().matches, "match", "matches"),
                                           record.ended.empty() ? std::string() : ": " + visible(record.ended))};
  if (best->evaluation == 1) {
    out.push_back(fmt::format("No evaluation had a better value than the base team's, {}.", value(*best)));
  } else {
    out.push_back(
        fmt::format("The base team had {} there, the best evaluation ({}) {}: the best of many noisy values, and so "
                    "optimistic. It decides nothing.",
                    value(record.trace.front()), best->evaluation, value(*best)));
  }
  if (failed > 0) {
    out.push_back(fmt::format("{} forfeited by the tuned team {} the worst value there is.",
                              counted(failed, "evaluation", "evaluations"), failed == 1 ? "counts as" : "count as"));
  }
  return out;
}

TuningVerdict tuning_verdict(const TuningView& view) {
  if (view.plan.compares()) return comparison_verdict(view);
  const std::vector<CandidateVerdict> candidates = candidate_verdicts(view);
  TuningVerdict out{headline_of_tuning(view, candidates), {}};
  for (const CandidateVerdict& each : candidates) {
    out.beside.push_back(candidate_sentence(view, each, candidates.size()));
  }
  if (base_came_first(view)) {
    out.beside.push_back(fmt::format(
        "On the {} of the selection the base team came first, with {}.", pairs_text(view.plan.selection_pairs),
        told_text(told(view.plan.objective, view.record.finalists.front().selected.score))));
  }
  if (view.record.unplayed_pairs > 0) out.beside.push_back(unplayed_sentence(view.record.unplayed_pairs));
  if (const std::string note = several_note(candidates.size()); !note.empty()) out.beside.push_back(note);
  return out;
}

const char* name(study::VerifiedAs finding) {
  switch (finding) {
    case study::VerifiedAs::better:
      return "better";
    case study::VerifiedAs::worse:
      return "worse";
    case study::VerifiedAs::prevented:
      return "no_verdict";
    case study::VerifiedAs::undecided:
      break;
  }
  return "undecided";
}

std::string scale_text(const study::Parameter& parameter) {
  const std::string scale = parameter.log_scale ? "log" : "linear";
  return parameter.integer ? scale + ", whole numbers" : scale;
}

bool has_unit(const study::Parameter& parameter) { return !parameter.unit.empty() && parameter.unit != "1"; }

std::string range_text(const study::Parameter& parameter) {
  const std::string unit = has_unit(parameter) ? fmt::format(" {}", visible(parameter.unit)) : std::string();
  if (parameter.fixed()) return fmt::format("fixed at {}{}", text_of(parameter, parameter.least), unit);
  return fmt::format("{} to {}{}", text_of(parameter, parameter.least), text_of(parameter, parameter.most), unit);
}

std::string end_text(RangeEnd end) {
  return end == RangeEnd::none    ? std::string()
         : end == RangeEnd::lower ? std::string("at the lower end")
                                  : std::string("at the upper end");
}

bool more_than_chance(const study::Slice& slice) {
  return slice.importance > 0.0 && slice.p && *slice.p <= significance_level;
}

std::string importance_value(const study::Slice& slice) { return slice.p ? rounded(slice.importance, 0.0) : "-"; }

std::string importance_text(const study::Slice& slice) {
  if (!slice.p) return "too few pairs";
  return fmt::format("{}{}", p_text(*slice.p), more_than_chance(slice) ? "" : ": no more than chance");
}

std::string values_text(const study::TuningPlan& plan, const study::ParameterValues& values) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    if (plan.parameters[i].fixed()) continue;
    out.push_back(fmt::format("{}={}", visible(plan.parameters[i].path), text_of(plan.parameters[i], values[i])));
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

std::string forfeiter(const study::TuningPlan& plan, std::size_t team) {
  if (team == 0) return "the team that is tuned";  // with whatever values, those of the base team among them
  return team <= plan.opponents.size() ? plan.opponents[team - 1].label : std::string("the base team");
}

std::string seen_text(const study::TuningPlan& plan, const study::Finalist& finalist) {
  if (!finalist.seen) return "not played";
  return finalist.seen->failed ? "forfeited" : told_text(told(plan.objective, finalist.seen->score));
}

std::string slices_note(const TuningView& view) {
  if (view.record.slices.empty()) return {};
  return fmt::format(
      "Around finalist {}, each parameter by itself, on {} of other seeds. Importance: standard deviation of the "
      "objective{} over the parameter's range, beyond what chance does; p: of a parameter that does nothing, each by "
      "itself.",
      slice_centre(view.record).value_or(0) + 1, pairs_text(view.plan.slice_pairs),
      unit_of(view.plan.objective).empty() ? std::string() : fmt::format(" ({})", unit_of(view.plan.objective)));
}

}  // namespace regista::report
