// SPDX-License-Identifier: MIT
#include "report/tournament_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "report/number.hpp"
#include "report/standing.hpp"
#include "statistics/paired_tests.hpp"
#include "study/paired_estimates.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using study::Meeting;

Sentence team(const TournamentView& view, std::size_t index) { return named(view.shown(index)); }

Sentence numbers_of(const TournamentView& view, const Meeting& meeting) {
  const auto pairs = static_cast<std::uint64_t>(total(meeting.pairs));
  const double share = meeting.matches() == 0 ? 0.5 : points(meeting.games) / static_cast<double>(meeting.matches());
  return Sentence("After ") << pairs_in_words(pairs) << fmt::format(" of {} ", games_word(view.plan))
                            << team(view, meeting.pairing.first)
                            << fmt::format(" has {:.1f} of {} points ({:.0f} %), goals {}:{}.", points(meeting.games),
                                           meeting.matches(), 100.0 * share, meeting.goals[0], meeting.goals[1]);
}

// Returns " (95 % interval 2.90 to 4.48)" for the leading team; empty without an interval.
std::string interval_clause(const Strength& known) {
  if (!known.goals_t) return {};
  const statistics::Interval seen = known.goals_t->interval;
  const auto [low, high] = known.goals_t->mean < 0.0 ? statistics::Interval{-seen.high, -seen.low} : seen;
  const double margin = (high - low) / 2.0;
  return fmt::format(" (95 % interval {} to {})", rounded(low, margin), rounded(high, margin));
}

Sentence beats(const TournamentView& view, const Meeting& meeting, int side) {
  const char* const verb = view.plan.pairs_before.empty() ? " beats " : " is ahead of ";  // the number was not fixed
  const Strength known = *strength(view.course, meeting);
  const double goals = meeting.goals_of_pairs.mean(),
               margin = known.goals_t ? half_width(known.goals_t->interval) : 0.0;
  return team(view, side > 0 ? meeting.pairing.first : meeting.pairing.second)
         << verb << team(view, side > 0 ? meeting.pairing.second : meeting.pairing.first)
         << fmt::format(" by {} goals a {}{}.", rounded(std::abs(goals), margin), game_word(view.plan),
                        interval_clause(known));
}

// Returns a sentence: the played pairs can find a difference that matters, or a tournament of how many can.
// beside: gets what that number rests on.
std::string what_more_would_find(const TournamentView& view, const Meeting& meeting, std::vector<Sentence>& beside) {
  if (const std::string few = too_few_pairs(view.plan); !few.empty()) return few + ".";
  const auto pairs = static_cast<std::uint64_t>(total(meeting.pairs));
  if (!(meeting.goals_of_pairs.standard_deviation() > 0.0)) return "All pairs ended with the same goal difference.";
  const statistics::Spread spread(meeting.goals_of_pairs);
  const auto needed = [&](const statistics::Spread& each) {
    return statistics::pairs_needed(study::usual_difference, each, study::design_of(view.plan));
  };
  const std::string found = fmt::format("find a difference of {} goals a {} in four of five cases.",
                                        study::usual_difference, game_word(view.plan));
  const auto all = needed(spread);
  if (!all) return fmt::format("No tournament of up to {} pairs would {}", statistics::most_pairs_asked, found);
  if (static_cast<std::uint64_t>(*all) > pairs) {
    const auto [low, high] = statistics::spread_interval(spread, meeting.goals_of_pairs.count());
    beside.push_back(fmt::format(
        "That number rests on these {} ({} uneven); with 95 % confidence it is about {} to {}.", pairs_in_words(pairs),
        meeting.goals_of_pairs.uneven(), pairs_text(needed(low)), pairs_text(needed(high))));
    return fmt::format("A new tournament of about {} pairs would {}", pairs_text(all), found);
  }
  return pairs_in_words(pairs) + " " + found;
}

Sentence than(const TournamentView& view, const Meeting& meeting, bool first_is_more, const char* what) {
  const auto& [first, second] = meeting.pairing;
  return team(view, first_is_more ? first : second) << what << team(view, first_is_more ? second : first) << ".";
}

Sentence by_scores(const TournamentView& view, const Meeting& meeting, const study::ScoreTest& test, bool h1) {
  const auto& [elo0, elo1] = test.design.hypotheses;
  const std::string unit = test.design.model == statistics::Model::logistic ? "Elo" : "nElo";
  if (h1 && elo1 > 0.0) return than(view, meeting, true, " is stronger than ");
  if (!h1 && elo0 < 0.0) return than(view, meeting, false, " is stronger than ");
  return team(view, meeting.pairing.first)
         << fmt::format(" is not {:.4g} {} {} than ", std::abs(h1 ? elo0 : elo1), unit, h1 ? "weaker" : "stronger")
         << team(view, meeting.pairing.second) << ".";
}

Sentence by_value(const TournamentView& view, const Meeting& meeting, const std::string& value) {
  const bool more = view.course.first_has_more();
  if (value == study::goals_value) return than(view, meeting, more, " scores more goals than ");
  return team(view, meeting.pairing.first) << fmt::format(" mostly has {} {} than ", more ? "more" : "less", value)
                                           << team(view, meeting.pairing.second) << ".";
}

// Returns the text of a tournament without a verdict. The text has no numbers, which would look like a verdict.
TournamentVerdict no_verdict(const TournamentView& view) {
  return {prevented_headline(view.course.unplayed_pairs()) + ".", {}};
}

// `out` has the numbers that stand beside the verdict.
TournamentVerdict of_sequential_test(const TournamentView& view, const Meeting& meeting, TournamentVerdict out) {
  const study::Verdict verdict = view.course.verdict();
  const study::Objective objective = view.plan.objective();
  const auto* const score = std::get_if<study::ScoreTest>(&objective);
  if (verdict == study::Verdict::prevented) return no_verdict(view);
  std::string few = score != nullptr ? what_the_test_rests_on(score_law(meeting.pairs)) : "";
  if (!few.empty()) few.insert(0, " ");
  if (verdict == study::Verdict::inconclusive) {
    out.sentence =
        view.course.complete() ? Sentence("The test ended without a verdict on ") : Sentence("No verdict yet on ");
    out.sentence << team(view, 0) << " and " << team(view, 1) << "." << few;
    return out;
  }
  const bool h1 = verdict == study::Verdict::accept_h1;
  if (score != nullptr) {
    out.sentence = by_scores(view, meeting, *score, h1) << few;
    const auto& [elo0, elo1] = score->design.hypotheses;
    out.beside.push_back(fmt::format(
        "The test accepted {}: the scores speak for a strength of {} rather than {} {}; error rates {:.4g} and {:.4g}.",
        name(verdict), h1 ? elo1 : elo0, h1 ? elo0 : elo1,
        score->design.model == statistics::Model::logistic ? "Elo" : "nElo", score->design.rates.alpha,
        score->design.rates.beta));
  } else {
    const auto test = std::get<study::ValueTest>(view.plan.objective());
    out.sentence = by_value(view, meeting, test.value);
    out.beside.push_back(fmt::format("The test found a difference, with an error rate of {:.4g}.", test.alpha));
    if (meeting.metric && (meeting.metric->difference().mean() > 0.0) != view.course.first_has_more()) {
      out.beside.push_back("But the mean points the other way: a few pairs differ much in that direction.");
    }
  }
  out.beside.push_back(
      "Elo and the other estimates are biased towards the verdict, because the test decided when to stop.");
  return out;
}

TournamentVerdict of_two(const TournamentView& view) {
  const Meeting& meeting = view.course.meetings().front();
  if (total(meeting.pairs) == 0) return {"No pair of matches has been played to its end yet: nothing can be said.", {}};
  const Sentence both = team(view, 0) << " and " << team(view, 1);
  TournamentVerdict out{both, {numbers_of(view, meeting)}};
  if (study::equal_teams(view.plan, meeting.pairing)) {
    out.sentence << " are the same team: every pair is even by construction.";
    return out;
  }
  if (view.course.verdict() != study::Verdict::none) return of_sequential_test(view, meeting, std::move(out));
  if (!view.course.complete()) {
    out.sentence = Sentence("Not at its end yet: no verdict on ") << both << ".";
    return out;
  }
  const PValues values = p_values(view.course);
  if (values.prevented.front()) return no_verdict(view);
  if (const int side = decided_for(view.course, values, 0); side != 0) {
    out.sentence = beats(view, meeting, side);
  } else {
    out.sentence = Sentence("Not decided between ") << both << ". " << what_more_would_find(view, meeting, out.beside);
    const Strength known = *strength(view.course, meeting);
    if (known.goals_t) {
      const double margin = half_width(known.goals_t->interval);
      out.beside.push_back(Sentence("With 95 % confidence ")
                           << team(view, 0)
                           << fmt::format(" scores between {} and {} goals a {} more than ",
                                          rounded(known.goals_t->interval.low, margin),
                                          rounded(known.goals_t->interval.high, margin), game_word(view.plan))
                           << team(view, 1) << ".");
      if (!known.goals_t->interval.contains(0.0)) {
        out.beside.push_back(
            "This interval excludes 0, but it supposes that goal differences of pairs follow a normal law. The sign "
            "flips suppose no law, and they decide.");
      }
    }
  }
  out.beside.push_back(
      fmt::format("If the teams were equal, goals as unequal as these would have a probability of {:.2g} (exact sign "
                  "flips of the pairs' goal differences).",
                  values.adjusted.front()));
  return out;
}

TournamentVerdict of_gauntlet(const TournamentView& view, const PValues& p) {
  std::array<std::uint64_t, 3> counts{};
  for (std::size_t i = 0; i < p.adjusted.size(); ++i) {
    ++counts[static_cast<std::size_t>(decided_for(view.course, p, i) + 1)];
  }
  TournamentVerdict out;
  out.sentence = team(view, 0) << fmt::format(" against {} others: beats {}, loses to {}, not decided against {}.",
                                              p.adjusted.size(), counts[2], counts[0], counts[1]);
  const auto without_verdict = std::ranges::count(p.prevented, true);
  if (view.course.complete() && without_verdict > 0) {
    out.beside.push_back(
        fmt::format("{} of those not decided depend on pairs that could not be played, so there is no verdict on them.",
                    without_verdict));
  }
  return out;
}

TournamentVerdict of_round_robin(const TournamentView& view, const PValues& p) {
  const std::vector<Ranked> ranks = ranking(view.plan, view.course);
  const std::size_t best = ranks[0].team, next = ranks[1].team;
  const auto together = std::ranges::count_if(ranks, [&](const Ranked& each) {
    return each.points == ranks[0].points && each.matches == ranks[0].matches &&
           each.elo.has_value() == ranks[0].elo.has_value() &&
           (!each.elo || std::abs(each.elo->value - ranks[0].elo->value) < 1e-6);
  });
  if (together == std::ssize(ranks)) return {fmt::format("All {} teams have the same points.", ranks.size()), {}};
  if (!leads_either_way(view.plan, view.course, best)) {
    TournamentVerdict out = no_verdict(view);
    out.beside.push_back("Which team leads depends on which team these pairs are counted for.");
    return out;
  }
  std::vector<int> decided;  // result of decided_for() for each pairing
  for (std::size_t i = 0; i < p.adjusted.size(); ++i) decided.push_back(decided_for(view.course, p, i));
  if (view.course.complete() && std::ranges::count(decided, 0) == std::ssize(decided)) {
    Sentence none = fmt::format("No difference was found between {} teams", ranks.size());
    if (const std::string few = too_few_pairs(view.plan); !few.empty()) return {none << ". " + few + ".", {}};
    if (together == 1) none << "; " << team(view, best) << " has the highest rating";
    return {none << ".", {}};
  }
  Sentence out = team(view, best);
  if (together > 1) return {out << fmt::format(" and {} more lead {} teams together.", together - 1, ranks.size()), {}};
  out << fmt::format(" leads {} teams.", ranks.size());
  for (std::size_t i = 0; view.course.complete() && i < decided.size(); ++i) {
    const Meeting& meeting = view.course.meetings()[i];
    if (std::minmax(meeting.pairing.first, meeting.pairing.second) != std::minmax(best, next)) continue;
    if (decided[i] != 0) {
      out << " " << beats(view, meeting, decided[i]);
    } else {
      out << " No difference from " << team(view, next) << ", the second team, was found.";
    }
  }
  return {out, {}};
}

// Who leads a Swiss tournament, or has won a knock-out. The rounds rank teams, and test no difference between them.
Sentence of_rounds(const TournamentView& view) {
  const auto rounds = view.course.calendar().drawn();
  if (view.plan.asked.format == config::Tournament::Format::knock_out) {
    const auto last =
        std::ranges::find_if(rounds.rbegin(), rounds.rend(), [](const auto& each) { return !each.empty(); });
    if (!view.course.complete() || last == rounds.rend())
      return fmt::format("Round {} of {} is played.", rounds.size(), view.plan.rounds());
    return team(view, view.course.winner(view.course.meetings()[last->front()])) << " wins the knock-out.";
  }
  const std::vector<double> points = view.course.swiss_standing().points;
  const double most = *std::ranges::max_element(points);
  const auto leader = static_cast<std::size_t>(std::ranges::find(points, most) - points.begin());
  const auto together = std::ranges::count(points, most);
  Sentence out = team(view, leader);
  if (together > 1) out << fmt::format(" and {} more", together - 1);
  return out << fmt::format(" {} most points, {:.1f}, in round {} of {}.", together > 1 ? "have" : "has", most,
                            rounds.size(), view.plan.rounds());
}

TournamentVerdict of_several(const TournamentView& view) {
  if (view.course.matches() == 0) return {"No match has been played yet: nothing can be said.", {}};
  const PValues p = p_values(view.course);
  TournamentVerdict out = view.plan.asked.format == config::Tournament::Format::gauntlet ? of_gauntlet(view, p)
                          : view.plan.rounds() > 0 ? TournamentVerdict{of_rounds(view), {}}
                                                   : of_round_robin(view, p);
  if (!view.course.complete()) {
    out.beside.push_back("The tournament is not at its end: none of this is a finding yet.");
  } else {
    out.beside.push_back(fmt::format(
        "A team beats another one where exact sign flips of the pairs' goal differences find it at {:.0f} %, "
        "corrected by Holm for the number of pairings.",
        100.0 * significance_level));
  }
  return out;
}

}  // namespace

TournamentVerdict tournament_verdict(const TournamentView& view) {
  TournamentVerdict out = view.plan.teams.size() == 2 ? of_two(view) : of_several(view);
  out.sentence = Sentence(caution(view.course.remarks(), view.plan.limits())) << out.sentence;
  for (const study::SetAside& each : view.course.set_aside()) {
    const std::string whose = each.plugin.empty() ? "a plugin of it" : "its plugin " + each.plugin;
    out.beside.push_back(team(view, each.team)
                         << fmt::format(" was set aside after pair {}: {} failed {} times in a row.", each.pair + 1,
                                        whose, each.failures));
  }
  const auto goalless = [](const Meeting& each) { return each.goals[0] + each.goals[1] == 0; };
  if (view.plan.short_games() && view.course.complete() && std::ranges::all_of(view.course.meetings(), goalless))
    out.beside.push_back(fmt::format("No {} had a goal. Play longer ones, or whole matches.", game_word(view.plan)));
  if (!view.plan.pairs_before.empty()) {
    out.sentence << " Pairs were added after a look.";
    out.beside.push_back(more_pairs_sentence(view.plan.pairs_before));
  }
  if (view.plan.ended_after) out.beside.push_back(stopped_sentence(view.plan));
  if (view.course.unplayed_pairs() > 0) out.beside.push_back(unplayed_sentence(view.course.unplayed_pairs()));
  const auto& of_team = view.course.forfeits().of_team();
  const std::uint64_t forfeits = std::accumulate(of_team.begin(), of_team.end(), std::uint64_t{0});
  if (forfeits > 0) {
    out.beside.push_back(Sentence(texts::plural(forfeits, "match", "matches")) << fmt::format(
                             " of {} {} forfeited because a plugin failed, and {} 0:10.", view.course.matches(),
                             forfeits == 1 ? "was" : "were", forfeits == 1 ? "counts" : "count"));
  }
  return out;
}

}  // namespace regista::report
