// SPDX-License-Identifier: MIT
#include "report/standing.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/bradley_terry.hpp"
#include "statistics/multiplicity.hpp"
#include "statistics/rating.hpp"
#include "statistics/sign_flip.hpp"
#include "statistics/variance_ratio.hpp"

namespace regista::report {

double points(const statistics::GameCounts& games) {
  return static_cast<double>(games.seen[2]) + 0.5 * static_cast<double>(games.seen[1]);
}

std::optional<Strength> strength(const study::Meeting& meeting) {
  if (total(meeting.pairs) == 0) return std::nullopt;
  Strength out{};
  out.law = score_law(meeting.pairs);
  out.elo = elo(out.law);
  out.normalized_elo = normalized_elo(out.law);
  out.superiority = likelihood_of_superiority(out.law);
  out.pair_ratio = pair_ratio(meeting.pairs);
  out.draw_ratio = static_cast<double>(meeting.pairs.seen[2]) / static_cast<double>(total(meeting.pairs));
  out.score_ratio = variance_ratio(meeting.pairs, meeting.games);
  out.goals_ratio = statistics::variance_ratio(meeting.goals_of_pairs, meeting.goals_of_matches);
  out.goals_t = statistics::paired_t(meeting.goals_of_pairs);
  return out;
}

PValues p_values(const study::Tournament& course) {
  PValues out;
  for (const study::Meeting& meeting : course.meetings()) out.single.push_back(statistics::sign_flip_p(meeting.pairs));
  out.adjusted = statistics::holm(out.single);
  return out;
}

statistics::SquareTable points_won(const study::TournamentPlan& plan, const study::Tournament& course) {
  statistics::SquareTable out(plan.teams.size());
  for (const study::Meeting& meeting : course.meetings()) {
    const std::size_t a = meeting.pairing.first, b = meeting.pairing.second;
    out.at(a, b) = points(meeting.games);
    out.at(b, a) = static_cast<double>(total(meeting.games)) - out.at(a, b);
  }
  return out;
}

std::vector<Ranked> ranking(const study::TournamentPlan& plan, const study::Tournament& course) {
  const std::size_t teams = plan.teams.size();
  std::vector<Ranked> out(teams);
  statistics::SquareTable payoff(teams);
  for (std::size_t team = 0; team < teams; ++team) {
    out[team].team = team;
    out[team].failures = course.failures()[team];
  }
  for (const study::Meeting& meeting : course.meetings()) {
    const std::size_t a = meeting.pairing.first, b = meeting.pairing.second;
    const statistics::Count losses = meeting.games.seen[0], draws = meeting.games.seen[1], wins = meeting.games.seen[2];
    const double games = static_cast<double>(total(meeting.games)), of_a = points(meeting.games);
    if (games > 0.0) payoff.at(a, b) = of_a / games - 0.5;
    payoff.at(b, a) = -payoff.at(a, b);
    const auto add = [draws, &meeting](Ranked& team, statistics::Count w, statistics::Count l, double p,
                                       std::uint64_t scored, std::uint64_t conceded) {
      team.wins += static_cast<std::uint64_t>(w);
      team.losses += static_cast<std::uint64_t>(l);
      team.draws += static_cast<std::uint64_t>(draws);
      team.matches += meeting.matches();
      team.points += p;
      team.scored += scored;
      team.conceded += conceded;
    };
    add(out[a], wins, losses, of_a, meeting.goals[0], meeting.goals[1]);
    add(out[b], losses, wins, games - of_a, meeting.goals[1], meeting.goals[0]);
  }
  if (const auto elo = statistics::bradley_terry(points_won(plan, course))) {
    for (Ranked& team : out) team.elo = (*elo)[team.team];
  }
  const statistics::NashAverage nash = statistics::nash_average(payoff);
  for (Ranked& team : out) team.nash = nash.share[team.team];
  const auto share = [](const Ranked& team) {
    return team.matches == 0 ? 0.5 : team.points / static_cast<double>(team.matches);
  };
  std::ranges::stable_sort(out, [&](const Ranked& x, const Ranked& y) {
    if (x.elo && y.elo && x.elo->value != y.elo->value) return x.elo->value > y.elo->value;
    return share(x) > share(y);
  });
  return out;
}

}  // namespace regista::report
