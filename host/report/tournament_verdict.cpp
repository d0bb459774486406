// SPDX-License-Identifier: MIT
#include "report/tournament_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "report/elo_interval.hpp"
#include "report/few_uneven.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/standing.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using study::Meeting;

constexpr double level = significance_level;

Sentence team(const TournamentView& view, std::size_t index) { return named(view.label(index)); }

Sentence numbers_of(const TournamentView& view, const Meeting& meeting) {
  const auto pairs = static_cast<std::uint64_t>(total(meeting.pairs));
  const double share = meeting.matches() == 0 ? 0.5 : points(meeting.games) / static_cast<double>(meeting.matches());
  Sentence out;
  return out << "After " << texts::counted(pairs, "pair", "pairs") << " of matches "
             << team(view, meeting.pairing.first)
             << fmt::format(" has {:.1f} of {} points ({:.0f} %), goals {}:{}.", points(meeting.games),
                            meeting.matches(), 100.0 * share, meeting.goals[0], meeting.goals[1]);
}

// What may still be true, by the interval of 95 %, or why that cannot be said; nothing where the verdict says all.
std::optional<Sentence> may_be(const TournamentView& view, const Meeting& meeting) {
  switch (interval_use(view, 0)) {
    case IntervalUse::shown:
      break;
    case IntervalUse::too_few_pairs: {
      const auto count = static_cast<std::uint64_t>(uneven(meeting.pairs));
      if (count == 0) return "All pairs were even, so there is no interval.";
      return fmt::format("Only {} not even: too few pairs for an interval.",
                         texts::counted(count, "pair was", "pairs were"));
    }
    default:
      return std::nullopt;
  }
  const auto in_words = [](double elo) {
    return fmt::format("{:.0f} Elo {}", std::abs(elo), elo < 0.0 ? "weaker" : "stronger");
  };
  const statistics::Interval interval = strength(view.course, meeting)->elo.interval;
  Sentence out = "With 95 % confidence ";
  return out << team(view, meeting.pairing.first)
             << fmt::format(" is between {} and {}.", in_words(interval.low), in_words(interval.high));
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
  Sentence out = team(view, meeting.pairing.first);
  return out << fmt::format(" is not {:.4g} {} {} than ", std::abs(h1 ? elo0 : elo1), unit, h1 ? "weaker" : "stronger")
             << team(view, meeting.pairing.second) << ".";
}

Sentence by_value(const TournamentView& view, const Meeting& meeting, const std::string& value) {
  const bool more = view.course.first_has_more();
  if (value == study::goals_value) return than(view, meeting, more, " scores more goals than ");
  Sentence out = team(view, meeting.pairing.first);
  return out << fmt::format(" mostly has {} {} than ", more ? "more" : "less", value)
             << team(view, meeting.pairing.second) << ".";
}

// Numbers beside it would be read as one.
void no_verdict(const TournamentView& view, TournamentVerdict& out) {
  out.sentence = prevented_headline(view.course.unplayed_pairs()) + ".";
  out.beside.clear();
}

void of_sequential_test(const TournamentView& view, const Meeting& meeting, TournamentVerdict& out) {
  const study::Verdict verdict = view.course.verdict();
  const study::Objective objective = view.plan.objective();
  const auto* const score = std::get_if<study::ScoreTest>(&objective);
  if (verdict == study::Verdict::prevented) {
    no_verdict(view, out);
    return;
  }
  std::string few = score != nullptr ? what_the_test_rests_on(score_law(meeting.pairs)) : "";
  if (!few.empty()) few.insert(0, " ");
  if (verdict == study::Verdict::inconclusive) {
    out.sentence =
        view.course.complete() ? Sentence("The test ended without a verdict on ") : Sentence("No verdict yet on ");
    out.sentence << team(view, 0) << " and " << team(view, 1) << "." << few;
    if (const auto open = may_be(view, meeting)) out.beside.push_back(*open);
    return;
  }
  const bool h1 = verdict == study::Verdict::accept_h1;
  if (score != nullptr) {
    out.sentence = by_scores(view, meeting, *score, h1);
    out.sentence << few;
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
}

void of_two(const TournamentView& view, TournamentVerdict& out) {
  const Meeting& meeting = view.course.meetings().front();
  if (total(meeting.pairs) == 0) {
    out.sentence = "No pair of matches has been played to its end yet: nothing can be said.";
    return;
  }
  out.beside.push_back(numbers_of(view, meeting));
  if (study::equal_teams(view.plan, meeting.pairing)) {
    out.sentence << team(view, 0) << " and " << team(view, 1)
                 << " are the same team: every pair is even by construction.";
    return;
  }
  if (view.course.verdict() != study::Verdict::none) {
    of_sequential_test(view, meeting, out);
    return;
  }
  if (!view.course.complete()) {
    out.sentence = "Not at its end yet: no verdict on ";
    out.sentence << team(view, 0) << " and " << team(view, 1) << ".";
    return;
  }
  const PValues values = p_values(view.course);
  if (values.prevented.front()) {
    no_verdict(view, out);
    return;
  }
  const double p = values.adjusted.front();
  const bool first = points(meeting.games) > static_cast<double>(meeting.matches()) / 2.0;
  if (p < level) {
    out.sentence = than(view, meeting, first, " is stronger than ");
    out.beside.push_back(
        fmt::format("If the teams were equal, a result as clear as this would have a probability of {:.2g}.", p));
  } else {
    out.sentence = texts::counted(static_cast<std::uint64_t>(total(meeting.pairs)), "pair does", "pairs do");
    out.sentence << " not show which of " << team(view, 0) << " and " << team(view, 1) << " is stronger.";
    out.beside.push_back(
        fmt::format("If the teams were equal, a difference as large as this would have a probability of {:.2g}.", p));
  }
  if (const auto open = may_be(view, meeting)) out.beside.push_back(*open);
}

// 1: the first team of the pairing is stronger, -1: the second, 0: that is open.
int stronger(const TournamentView& view, const PValues& p, std::size_t pairing) {
  const Meeting& meeting = view.course.meetings()[pairing];
  if (!view.course.complete() || p.adjusted[pairing] >= level) return 0;
  return points(meeting.games) > static_cast<double>(meeting.matches()) / 2.0 ? 1 : -1;
}

void of_gauntlet(const TournamentView& view, const PValues& p, TournamentVerdict& out) {
  std::array<std::uint64_t, 3> counts{};
  const auto without_verdict = std::ranges::count(p.prevented, true);
  for (std::size_t i = 0; i < p.adjusted.size(); ++i) {
    ++counts[static_cast<std::size_t>(stronger(view, p, i) + 1)];
  }
  out.sentence = team(view, 0);
  out.sentence << fmt::format(" against {} others: stronger than {}, weaker than {}, open for {}.", p.adjusted.size(),
                              counts[2], counts[0], counts[1]);
  if (view.course.complete() && without_verdict > 0) {
    out.beside.push_back(
        fmt::format("{} of the open ones depend on pairs that could not be played, so there is no verdict on them.",
                    without_verdict));
  }
}

void of_round_robin(const TournamentView& view, const PValues& p, TournamentVerdict& out) {
  const std::vector<Ranked> ranks = ranking(view.plan, view.course);
  const std::size_t best = ranks[0].team, next = ranks[1].team;
  const auto together = std::ranges::count_if(ranks, [&](const Ranked& each) {
    return each.points == ranks[0].points && each.matches == ranks[0].matches &&
           each.elo.has_value() == ranks[0].elo.has_value() &&
           (!each.elo || std::abs(each.elo->value - ranks[0].elo->value) < 1e-6);
  });
  if (together == std::ssize(ranks)) {
    out.sentence = fmt::format("All {} teams have the same points.", ranks.size());
    return;
  }
  if (!leads_either_way(view.plan, view.course, best)) {
    no_verdict(view, out);
    out.beside.push_back("Which team leads depends on which team these pairs are counted for.");
    return;
  }
  out.sentence = team(view, best);
  if (together > 1) {
    out.sentence << fmt::format(" and {} more lead {} teams together.", together - 1, ranks.size());
    return;
  }
  out.sentence << fmt::format(" leads {} teams.", ranks.size());
  for (std::size_t i = 0; i < p.adjusted.size(); ++i) {
    const study::Pairing& pairing = view.course.meetings()[i].pairing;
    if (std::min(pairing.first, pairing.second) != std::min(best, next)) continue;
    if (std::max(pairing.first, pairing.second) != std::max(best, next)) continue;
    const int found = stronger(view, p, i) * (pairing.first == best ? 1 : -1);
    if (found > 0) {
      out.sentence << " It is stronger than " << team(view, next) << ", the second team.";
    } else if (found < 0) {
      out.sentence << " " << team(view, next) << ", the second team, is stronger in their matches.";
    } else {
      out.sentence << " No difference from " << team(view, next) << ", the second team, was found.";
    }
  }
}

void of_several(const TournamentView& view, TournamentVerdict& out) {
  if (view.course.matches() == 0) {
    out.sentence = "No match has been played yet: nothing can be said.";
    return;
  }
  const PValues p = p_values(view.course);
  if (view.plan.asked.format == config::Tournament::Format::gauntlet)
    of_gauntlet(view, p, out);
  else
    of_round_robin(view, p, out);
  if (!view.course.complete()) {
    out.beside.push_back("The tournament is not at its end: none of this is a finding yet.");
  } else {
    out.beside.push_back(
        fmt::format("A team is called stronger where a sign-flip test of its pairing finds a difference at {:.0f} "
                    "%, corrected by Holm for the number of pairings.",
                    100.0 * level));
  }
}

}  // namespace

TournamentVerdict tournament_verdict(const TournamentView& view) {
  TournamentVerdict out;
  if (view.plan.teams.size() == 2)
    of_two(view, out);
  else
    of_several(view, out);
  out.sentence = Sentence(caution(view.course.remarks(), view.plan.limits())) << out.sentence;
  for (const study::SetAside& each : view.course.set_aside()) {
    Sentence line = team(view, each.team);
    const std::string whose = each.plugin.empty() ? "a plugin of it" : "its plugin " + each.plugin;
    out.beside.push_back(line << fmt::format(" was set aside after pair {}: {} failed {} times in a row.",
                                             each.pair + 1, whose, each.failures));
  }
  if (!view.plan.pairs_before.empty()) {
    out.sentence << " Pairs were added after a look.";
    out.beside.push_back(more_pairs_sentence(view.plan.pairs_before));
  }
  if (view.course.unplayed_pairs() > 0) out.beside.push_back(unplayed_sentence(view.course.unplayed_pairs()));
  std::uint64_t forfeits = 0;
  for (const std::uint64_t count : view.course.forfeits().of_team()) forfeits += count;
  if (forfeits > 0) {
    Sentence line = texts::counted(forfeits, "match", "matches");
    out.beside.push_back(line << fmt::format(" of {} {} forfeited because a plugin failed, and {} 0:10.",
                                             view.course.matches(), forfeits == 1 ? "was" : "were",
                                             forfeits == 1 ? "counts" : "count"));
  }
  return out;
}

std::string more_pairs_sentence(const std::string& before) {
  return fmt::format(
      "It had {} pairs before it was given more. A p value and an interval hold for a number that was fixed "
      "beforehand: adding pairs until the result pleases finds differences that do not exist.",
      before);
}

}  // namespace regista::report
