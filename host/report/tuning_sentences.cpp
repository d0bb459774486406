// SPDX-License-Identifier: MIT
#include "report/tuning_sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/estimate_text.hpp"
#include "report/experiment.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/packets_spent.hpp"
#include "report/standing.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using study::TuningStage;

std::string search_plan_sentence(const study::TuningPlan& plan) {
  std::string out =
      fmt::format("Search: {} ({}), at most {} of {}", name(plan.algorithm()), summary(plan.algorithm()),
                  counted(plan.evaluations(), "evaluation", "evaluations"), pairs_text(plan.pairs_of_evaluation()));
  if (plan.asked.search.minutes) out += fmt::format(", and at most {:.6g} min", *plan.asked.search.minutes);
  if (plan.population() > 0) out += fmt::format(", population {}", plan.population());
  return out + fmt::format(", seed {}.", plan.seed());
}

std::string verification_plan_sentence(const study::TuningPlan& plan) {
  std::string out = fmt::format("Selection: at most {} on {} that the search did not play. ",
                                counted(plan.finalists(), "finalist", "finalists"), pairs_text(plan.selection_pairs));
  if (plan.verification_pairs == 0 || plan.candidates() == 0) return out + "Nothing is verified.";
  out += fmt::format(
      "Verification: {} against the base team, {}, on at most {} with held-out seeds; a paired sequential test at "
      "{:.4g} %, two-sided, valid after every pair",
      plan.candidates() == 1 ? std::string("the best of them")
                             : fmt::format("the best of them, at most {},", plan.candidates()),
      plan.head_to_head() ? "playing each other" : "both against the same opponents",
      pairs_text(plan.verification_pairs), 100.0 * (1.0 - plan.confidence()));
  return out + (plan.candidates() > 1 ? ", corrected by Holm." : ".");
}

std::string interval_words(const study::TuningPlan& plan, std::size_t candidates) {
  return fmt::format("anytime-valid {:.4g} % interval{}", 100.0 * plan.confidence(),
                     candidates > 1 ? ", for all candidates together" : "");
}

std::string numbers_text(const TuningView& view, const CandidateVerdict& each, std::size_t candidates) {
  const study::TuningPlan& plan = view.plan;
  if (each.pairs == 0) return "no pair has both values";
  std::string out = texts::visible(in_words(plan.objective));
  if (each.value) {
    out += fmt::format(" {}, the base team {}, difference ", with_interval(*each.value), with_interval(*each.base));
  } else {
    out += " less the base team's in the same matches ";
  }
  out += signed_with_interval(each.difference);
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
      return "better than the base team on held-out seeds";
    case study::VerifiedAs::worse:
      return "worse than the base team on held-out seeds";
    case study::VerifiedAs::prevented:
      return over ? fmt::format("no verdict, because {} could not be played",
                                pairs_text(view.record.verification.of()[each.candidate].unplayed_pairs()))
                  : std::string("not decided yet");
    case study::VerifiedAs::undecided:
      break;
  }
  if (each.forfeited && each.adjusted <= 1.0 - view.plan.confidence()) {
    return "not found better, because it forfeited a match of the verification";
  }
  return over ? fmt::format("no difference from the base team was found in {}, which does not show that there is none",
                            pairs_text(view.record.verification.pairs()))
              : std::string("not decided yet");
}

std::string optimism_text(const TuningView& view, const CandidateVerdict& each) {
  if (!each.seen) return "The search did not play this point: it is the mean of points that the search played.";
  if (!each.optimism) return {};
  const double margin = std::abs(*each.optimism) / 10.0;
  const char* const where = view.plan.head_to_head() ? "the selection" : "the verification";
  const study::MeanEstimate& came = view.plan.head_to_head() ? each.selected : *each.value;
  std::string out = fmt::format("The search had {}, {} gave {}", with_interval(*each.seen), where, with_interval(came));
  return out + (*each.optimism > 0.0
                    ? fmt::format(": the search was too optimistic by {}.", rounded(*each.optimism, margin))
                    : std::string(": the search was not too optimistic."));
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
  return "The intervals hold for all candidates together and are wider than the test by Holm needs. So an interval may "
         "contain 0 although a difference was found.";
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
                                 : "The plan verifies no finalist, so nothing can be said.";
  }
  if (record.verified()) return "The tuned team is better than the base team on held-out seeds.";
  const bool over = record.stage != TuningStage::verification;
  if (record.verification.pairs() == 0) {
    return over ? "Nothing was verified, so nothing can be said." : "Nothing is verified yet, so nothing can be said.";
  }
  if (!over) return "Not decided yet whether the tuned team is better than the base team.";
  if (std::ranges::all_of(candidates, [](const auto& each) { return each.finding == study::VerifiedAs::worse; })) {
    return "What the search found is worse than the base team on held-out seeds.";
  }
  if (std::ranges::find(candidates, study::VerifiedAs::prevented, &CandidateVerdict::finding) != candidates.end()) {
    return prevented_headline(record.verification.unplayed_pairs()) + ".";
  }
  const auto gave_up = [&](const auto& each) {
    return each.forfeited && each.finding == study::VerifiedAs::undecided &&
           each.adjusted <= 1.0 - view.plan.confidence();
  };
  if (std::ranges::any_of(candidates, gave_up)) {
    return "The tuned team was not found better: it forfeited a match of the verification.";
  }
  return fmt::format(
      "No difference between the tuned team and the base team was found in {}. This does not show that there is none.",
      pairs_text(record.verification.pairs()));
}

}  // namespace

std::string unfinished_sentence(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  if (!record.stage) return {};
  const char* const begin = "Not at its end: ";
  switch (*record.stage) {
    case TuningStage::search:
      return fmt::format("{}search, {} of at most {}.", begin, record.trace.size(),
                         counted(plan.evaluations(), "evaluation", "evaluations"));
    case TuningStage::selection:
      return fmt::format("{}selection of the finalists.", begin);
    case TuningStage::verification:
      return fmt::format("{}verification, {} of at most {}.", begin, record.verification.pairs(),
                         pairs_text(plan.verification_pairs));
    case TuningStage::slices:
      return fmt::format("{}slices around what was found.", begin);
  }
  return {};
}

std::vector<std::string> setup_sentences(const TuningView& view) {
  std::vector<std::string> out = problem_sentences(view.plan);
  out.push_back(search_plan_sentence(view.plan));
  out.push_back(verification_plan_sentence(view.plan));
  return out;
}

std::vector<std::string> search_sentences(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  const study::SearchStep* const best = best_step(record);
  if (best == nullptr) return {};
  const auto value = [&](const study::SearchStep& step) {
    return with_interval(of_objective(view.plan.objective, step.played.score));
  };
  const std::uint64_t failed = static_cast<std::uint64_t>(
      std::ranges::count_if(record.trace, [](const auto& each) { return each.played.failed; }));
  std::vector<std::string> out{fmt::format("The search {} {} and {}{}.",
                                           record.ended.empty() ? "has come to" : "ended after",
                                           counted(record.trace.size(), "evaluation", "evaluations"),
                                           counted(record.trace.back().matches, "match", "matches"),
                                           record.ended.empty() ? std::string() : ": " + texts::visible(record.ended))};
  if (best->evaluation == 1) {
    out.push_back(fmt::format("No evaluation had a better value than the base team's, {}.", value(*best)));
  } else {
    out.push_back(
        fmt::format("The base team had {} there, the best evaluation ({}) {}. The best of many noisy values is "
                    "optimistic: it decides nothing.",
                    value(record.trace.front()), best->evaluation, value(*best)));
  }
  if (failed > 0) {
    out.push_back(fmt::format("{} forfeited by the tuned team {} the worst value.",
                              counted(failed, "evaluation", "evaluations"), failed == 1 ? "has" : "have"));
  }
  return out;
}

TuningVerdict tuning_verdict(const TuningView& view) {
  const std::vector<CandidateVerdict> candidates = candidate_verdicts(view);
  TuningVerdict out{caution(view.record.tally.remarks, view.plan.limits()) + headline_of_tuning(view, candidates), {}};
  for (const CandidateVerdict& each : candidates) {
    out.beside.push_back(candidate_sentence(view, each, candidates.size()));
  }
  if (base_came_first(view)) {
    out.beside.push_back(fmt::format(
        "On the {} of the selection the base team came first, with {}.", pairs_text(view.plan.selection_pairs),
        with_interval(of_objective(view.plan.objective, view.record.finalists.front().selected.score))));
  }
  if (view.record.tally.unplayed_pairs > 0) out.beside.push_back(unplayed_sentence(view.record.tally.unplayed_pairs));
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

std::string seen_text(const study::TuningPlan& plan, const study::Finalist& finalist) {
  if (!finalist.seen) return "not played";
  return finalist.seen->failed ? "forfeited" : with_interval(of_objective(plan.objective, finalist.seen->score));
}

std::string slices_note(const TuningView& view) {
  if (view.record.slices.empty()) return {};
  return fmt::format(
      "Each parameter varied alone around finalist {}, on {} of other seeds. Importance: standard deviation of the "
      "objective{} over the parameter's range, less the part that chance explains. p: of the hypothesis that the "
      "parameter has no effect, for each parameter alone.",
      slice_centre(view.record).value_or(0) + 1, pairs_text(view.plan.slice_pairs()),
      unit_of(view.plan.objective).empty() ? std::string() : fmt::format(" ({})", unit_of(view.plan.objective)));
}

}  // namespace regista::report
