// SPDX-License-Identifier: MIT
#include "report/tuning_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/number.hpp"
#include "report/standing.hpp"
#include "statistics/moments.hpp"
#include "study/measure.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

statistics::Interval turned(const study::TuningObjective& objective, const statistics::Interval& scores) {
  const double a = report::of_objective(objective, scores.low), b = report::of_objective(objective, scores.high);
  return {std::min(a, b), std::max(a, b)};
}

study::MeanEstimate mean_of(const statistics::Moments& moments, double confidence) {
  study::MeanEstimate out;
  out.pairs = moments.count();
  out.mean = moments.mean();
  out.standard_deviation = moments.standard_deviation();
  if (out.pairs < 2 || out.standard_deviation == 0.0) return out;
  const double margin = statistics::student_t_quantile(0.5 + confidence / 2.0, static_cast<double>(out.pairs - 1)) *
                        out.standard_deviation / std::sqrt(static_cast<double>(out.pairs));
  out.interval = {out.mean - margin, out.mean + margin};
  return out;
}

RangeEnd end_of(const study::Parameter& parameter, double value) {
  constexpr double near = 0.01;
  const double share = study::share_of(parameter, value);
  return share <= near ? RangeEnd::lower : share >= 1.0 - near ? RangeEnd::upper : RangeEnd::none;
}

using study::TuningStage;
using texts::plural;

// Returns the unit in brackets: " (per match)".
std::string unit_text(const study::TuningObjective& objective) {
  const std::string unit = unit_of(objective);
  return unit.empty() ? unit : fmt::format(" ({})", unit);
}

bool is_base(const study::TuningPlan& plan, const study::TuningOpponent& opponent) {
  const auto& inputs = opponent.jobs[0].away_inputs;
  return !inputs.empty() && inputs == plan.base.jobs[0].away_inputs;
}

std::string base_sentence(const study::TuningPlan& plan) {
  const bool one = plan.opponents.size() == 1;
  std::vector<std::string> opponents;
  std::string itself;
  for (const study::TuningOpponent& each : plan.opponents) {
    opponents.push_back(one ? each.label : fmt::format("{} ({:.4g} %)", each.label, 100.0 * each.weight));
    if (is_base(plan, each)) itself += fmt::format("; {} is the base team itself", each.label);
  }
  return fmt::format("Base team: {}{}{}. {}: {}{}.", plan.asked.team, plan.settings.empty() ? "" : " with ",
                     fmt::join(plan.settings, ", "), one ? "Opponent" : "Opponents, with their weights",
                     fmt::join(opponents, ", "), itself);
}

std::string unit_sentence(const study::TuningPlan& plan) {
  return fmt::format(
      "A pair is {}: with the tuned team at home and away{}, all with the same seed{}.",
      plural(plan.matches_of_pair(), "match", "matches"),
      plan.opponents.size() == 1 ? std::string() : fmt::format(", against each of {} opponents", plan.opponents.size()),
      plan.openings.empty() ? std::string(", from kick-off")
                            : " and scene, of " + scenes_in_words(plan.openings, plan.asked.settings.limit));
}

std::string search_plan_sentence(const study::TuningPlan& plan) {
  std::string out =
      fmt::format("Search: {} ({}), at most {} of {}", name(plan.algorithm()), summary(plan.algorithm()),
                  plural(plan.evaluations(), "evaluation", "evaluations"), pairs_in_words(plan.pairs_of_evaluation()));
  if (plan.asked.search.minutes) out += fmt::format(", and at most {:.6g} min", *plan.asked.search.minutes);
  if (plan.population() > 0) out += fmt::format(", population {}", plan.population());
  return out + fmt::format(", seed {}.", plan.seed());
}

std::string verification_plan_sentence(const study::TuningPlan& plan) {
  std::string out =
      fmt::format("Selection: at most {} on {} that the search did not play. ",
                  plural(plan.finalists(), "finalist", "finalists"), pairs_in_words(plan.selection_pairs));
  if (plan.verification_pairs == 0 || plan.candidates() == 0) return out + "Nothing is verified.";
  out += fmt::format(
      "Verification: {} against the base team, {}, on at most {} with held-out seeds; a paired sequential test at "
      "{:.4g} %, two-sided, valid after every pair",
      plan.candidates() == 1 ? std::string("the best of them")
                             : fmt::format("the best of them, at most {},", plan.candidates()),
      plan.head_to_head() ? "playing each other" : "both against the same opponents",
      pairs_in_words(plan.verification_pairs), 100.0 * (1.0 - plan.confidence()));
  return out + (plan.candidates() > 1 ? ", corrected by Holm." : ".");
}

std::string numbers_text(const TuningView& view, const CandidateVerdict& each, std::size_t candidates) {
  const study::TuningPlan& plan = view.plan;
  if (each.pairs == 0) return "no pair has both values";
  std::string out = in_words(plan.objective);
  if (each.value) {
    out += fmt::format(" {}, the base team {}, difference ", with_interval(*each.value), with_interval(*each.base));
  } else {
    out += " less the base team's in the same matches ";
  }
  out += signed_with_interval(each.difference);
  const statistics::Interval& interval = each.difference.interval;
  out += has_width(interval)  ? fmt::format(" (anytime-valid {:.4g} % interval{})", 100.0 * plan.confidence(),
                                           candidates > 1 ? ", for all candidates together" : "")
         : interval.bounded() ? std::string(" (every pair differs by as much)")
                              : std::string(" (too few pairs for an interval)");
  out += fmt::format(", {}, {}", pairs_in_words(static_cast<std::uint64_t>(each.pairs)), p_text(each.p));
  if (candidates > 1) out += fmt::format(", {} after Holm", p_text(each.adjusted));
  return out;
}

std::string finding_text(const TuningView& view, const CandidateVerdict& each) {
  const bool over = view.record.stage != TuningStage::verification;
  if (each.finding == study::VerifiedAs::better || each.finding == study::VerifiedAs::worse)
    return fmt::format("{} than the base team on held-out seeds", name(each.finding));
  if (each.finding == study::VerifiedAs::prevented) {
    return over ? fmt::format("no verdict, because {} could not be played",
                              pairs_in_words(view.record.verification.of()[each.candidate].unplayed_pairs()))
                : std::string("not decided yet");
  }
  if (each.forfeited && each.adjusted <= 1.0 - view.plan.confidence()) {
    return "not found better, because it forfeited a match of the verification";
  }
  return over ? fmt::format(
                    "no difference from the base team was found in {}, but there may still be a smaller difference",
                    pairs_in_words(view.record.verification.pairs()))
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
  const std::string packets = packets_clause(each.packets);
  for (const std::string& more : {optimism_text(view, each), packets.empty() ? packets : "It " + packets + '.'}) {
    if (!more.empty()) out += ' ' + more;
  }
  return out;
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
      "No difference between the tuned team and the base team was found in {}. There may still be a smaller "
      "difference.",
      pairs_in_words(record.verification.pairs()));
}

}  // namespace

double of_objective(const study::TuningObjective& objective, double score) {
  return study::value_of(objective, score) + 0.0;  // avoids -0
}

statistics::Estimate of_objective(const study::TuningObjective& objective, const statistics::Estimate& score) {
  return {of_objective(objective, score.value), turned(objective, score.interval)};
}

study::MeanEstimate of_objective(const study::TuningObjective& objective, study::MeanEstimate score) {
  score.mean = of_objective(objective, score.mean);
  if (score.interval) score.interval = turned(objective, *score.interval);
  return score;
}

std::string unit_of(const study::TuningObjective& objective) {
  const bool one = objective.terms.size() == 1 && objective.terms.front().weight == 1.0;
  return one ? study::unit_of(objective.terms.front().measure) : std::string();
}

MatchesByStage matches_by_stage(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  const std::uint64_t pair = plan.matches_of_pair();
  MatchesByStage out;
  if (!record.trace.empty()) out.search = record.trace.back().matches;
  out.selection = record.finalists.size() * plan.selection_pairs * pair;
  const std::uint64_t candidates = record.verification.of().size();
  out.verification = record.verification.pairs() * (plan.head_to_head() ? 2 * candidates : (candidates + 1) * pair);
  if (record.slices.empty()) return out;
  std::uint64_t points = 1;  // the tuned point, which all slices share, counts once
  for (const study::Slice& each : record.slices) points += each.points.size() - 1;
  out.slices = points * plan.slice_pairs() * pair;
  return out;
}

const study::SearchStep* best_step(const study::TuningRecord& record) {
  const study::SearchStep* best = nullptr;
  for (const study::SearchStep& each : record.trace) {
    if (best == nullptr || each.played.counted > best->played.counted) best = &each;
  }
  return best;
}

std::vector<TunedValue> tuned_values(const TuningView& view) {
  const std::optional<std::size_t> kept = view.record.tuned();
  std::vector<TunedValue> out;
  if (!kept) return out;
  for (std::size_t i = 0; i < view.plan.parameters.size(); ++i) {
    const study::Parameter& parameter = view.plan.parameters[i];
    if (parameter.fixed()) continue;
    const double tuned = view.record.finalists[*kept].values[i];
    out.push_back({i, parameter.start, tuned, end_of(parameter, tuned)});
  }
  return out;
}

std::optional<std::size_t> slice_centre(const study::TuningRecord& record) {
  if (record.finalists.empty()) return std::nullopt;
  return record.tuned().value_or(0);
}

std::vector<CandidateVerdict> candidate_verdicts(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  const std::vector<double> adjusted = record.verification.adjusted();
  std::vector<CandidateVerdict> out;
  for (std::size_t i = 0; i < record.verification.of().size(); ++i) {
    const study::ScoreDifference& scores = record.verification.of()[i];
    const study::Finalist& finalist = record.finalists[record.candidates[i]];
    CandidateVerdict& each = out.emplace_back();
    each.candidate = i;
    each.finalist = record.candidates[i];
    each.finding = record.finding(i);
    each.forfeited = record.candidate_failed[i];
    each.packets = record.candidate_packets[i];
    if (finalist.seen) each.seen = of_objective(plan.objective, finalist.seen->score);
    each.selected = of_objective(plan.objective, finalist.selected.score);
    each.pairs = scores.difference().count();
    each.difference = each.pairs == 0 ? statistics::Estimate{0.0, {-HUGE_VAL, HUGE_VAL}}
                                      : of_objective(plan.objective, scores.estimate());
    each.p = scores.p();
    each.adjusted = adjusted[i];
    if (!plan.head_to_head() && each.pairs > 0) {
      each.value = of_objective(plan.objective, mean_of(scores.candidate(), plan.confidence()));
      each.base = of_objective(plan.objective, mean_of(scores.base(), plan.confidence()));
    }
    const bool known = plan.head_to_head() ? finalist.selected.score.pairs > 0 : each.pairs > 0;
    if (finalist.seen && finalist.seen->score.pairs > 0 && known) {
      each.optimism =
          finalist.seen->score.mean - (plan.head_to_head() ? finalist.selected.score.mean : scores.candidate().mean());
    }
  }
  return out;
}

std::string problem_title(const study::TuningPlan& plan) {
  return fmt::format("{}: {} of {}, {} as {} as possible", plan.asked.name,
                     plural(plan.free_parameters(), "parameter", "parameters"),
                     std::filesystem::path(plan.asked.team).filename().string(), in_words(plan.objective),
                     plan.objective.minimise ? "small" : "large");
}

std::vector<Sentence> setup_sentences(const study::TuningPlan& plan) {
  return {base_sentence(plan),
          fmt::format("Objective: {}{}, the {} the better.", in_words(plan.objective), unit_text(plan.objective),
                      plan.objective.minimise ? "smaller" : "larger"),
          unit_sentence(plan), search_plan_sentence(plan), verification_plan_sentence(plan)};
}

std::vector<Sentence> search_sentences(const TuningView& view) {
  const study::TuningRecord& record = view.record;
  const study::SearchStep* const best = best_step(record);
  if (best == nullptr) return {};
  const auto value = [&](const study::SearchStep& step) {
    return with_interval(of_objective(view.plan.objective, step.played.score));
  };
  const std::uint64_t failed = static_cast<std::uint64_t>(
      std::ranges::count_if(record.trace, [](const auto& each) { return each.played.failed; }));
  std::vector<Sentence> out{fmt::format(
      "The search {} {} and {}{}.", record.ended.empty() ? "has come to" : "ended after",
      plural(record.trace.size(), "evaluation", "evaluations"), plural(record.trace.back().matches, "match", "matches"),
      record.ended.empty() ? std::string() : ": " + record.ended)};
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
                              plural(failed, "evaluation", "evaluations"), failed == 1 ? "has" : "have"));
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
        "On the {} of the selection the base team came first, with {}.", pairs_in_words(view.plan.selection_pairs),
        with_interval(of_objective(view.plan.objective, view.record.finalists.front().selected.score))));
  }
  if (view.record.tally.unplayed_pairs > 0) out.beside.push_back(unplayed_sentence(view.record.tally.unplayed_pairs));
  // The test uses Holm's correction. The intervals divide alpha by the number of candidates, which makes them wider.
  if (candidates.size() > 1)
    out.beside.push_back(
        "The intervals hold for all candidates together and are wider than the test by Holm needs. So an interval may "
        "contain 0 although a difference was found.");
  return out;
}

const char* name(study::VerifiedAs finding) {
  constexpr std::array names{"undecided", "better", "worse", "no_verdict"};  // order of study::VerifiedAs
  return names[static_cast<std::size_t>(finding)];
}

bool more_than_chance(const study::Slice& slice) {
  return slice.importance > 0.0 && slice.p && *slice.p <= significance_level;
}

std::string importance_text(const study::Slice& slice) {
  if (!slice.p) return "too few pairs";
  return fmt::format("{}{}", p_text(*slice.p), more_than_chance(slice) ? "" : ": no more than chance");
}

std::string slices_note(const TuningView& view) {
  if (view.record.slices.empty()) return {};
  return fmt::format(
      "Each parameter varied alone around finalist {}, on {} of other seeds. Importance: standard deviation of the "
      "objective{} over the parameter's range, less the part that chance explains. p: of the hypothesis that the "
      "parameter has no effect, for each parameter alone.",
      slice_centre(view.record).value_or(0) + 1, pairs_in_words(view.plan.slice_pairs()),
      unit_text(view.plan.objective));
}

bool has_unit(const study::Parameter& parameter) { return !parameter.unit.empty() && parameter.unit != "1"; }

std::string range_text(const study::Parameter& parameter) {
  const std::string unit = has_unit(parameter) ? ' ' + parameter.unit : "";
  if (parameter.fixed()) return fmt::format("fixed at {}{}", text_of(parameter, parameter.least), unit);
  return fmt::format("{} to {}{}", text_of(parameter, parameter.least), text_of(parameter, parameter.most), unit);
}

ForfeitWords forfeit_words(const study::TuningPlan& plan) {
  return {[&plan](std::size_t team) -> std::string {
            if (team == 0) return "the team that is tuned";  // team 0 has tuned values or the values of the base team
            return team <= plan.opponents.size() ? plan.opponents[team - 1].label : "the base team";
          },
          {},
          "A forfeit of the tuned team counts against it; in the search it has the worst value. Pairs that another "
          "team forfeited are left out."};
}

WhatWasPlayed what_was_played(const study::TuningPlan& plan) {
  const campaign::Job& first = plan.opponents.front().jobs[0];
  WhatWasPlayed out = what_was_played(plan.asked.settings, first.common_inputs, inputs_of(plan.openings));
  out.teams.push_back(played_team("the team that is tuned", plan.asked.team, first.home_inputs,
                                  profile_of(first.common_inputs, "home disturbance", plan.asked.disturbance)));
  out.teams.back().set = plan.settings;
  for (const study::TuningOpponent& each : plan.opponents) {
    const campaign::Job& job = each.jobs[0];
    out.teams.push_back(
        played_team(each.label, each.file, job.away_inputs,
                    profile_of(job.common_inputs, "away disturbance", plan.asked.opponent_disturbance)));
  }
  for (const config::Override& each : study::settings_of(plan, false)) {
    const std::string text = to_string(each);
    if (std::ranges::find(plan.settings, text) == plan.settings.end()) out.set.push_back(text);
  }
  out.amount = fmt::format("{} matches at most, {} of them for the search, seed {}", most_matches(plan),
                           most_matches(plan, TuningStage::search), plan.seed());
  out.may_end_by_the_clock = plan.asked.search.minutes.has_value();
  complete(out, plan);
  return out;
}

}  // namespace regista::report
