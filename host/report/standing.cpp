// SPDX-License-Identifier: MIT
#include "report/standing.hpp"

#include <algorithm>

namespace regista::report {

double points(const statistics::GameCounts& games) {
  return static_cast<double>(games.seen[2]) + 0.5 * static_cast<double>(games.seen[1]);
}

bool is_prevented(const study::Tournament& course, const study::Meeting& meeting) {
  if (meeting.unplayed_pairs == 0 || !course.complete()) return false;
  if (course.verdict() != study::Verdict::none) return course.verdict() == study::Verdict::prevented;
  return p_values(course).prevented[static_cast<std::size_t>(&meeting - course.meetings().data())];
}

bool is_without_verdict(const study::TournamentPlan& plan, const study::Tournament& course) {
  if (plan.teams.size() == 2) return is_prevented(course, course.meetings().front());
  if (plan.asked.format != config::Tournament::Format::round_robin || !course.complete()) return false;
  return !leads_either_way(plan, course, ranking(plan, course).front().team);
}

bool is_of_fixed_number(const study::TournamentPlan& plan, const study::Tournament& course) {
  return std::holds_alternative<study::FixedNumber>(plan.objective()) && course.complete();
}

std::optional<Strength> strength(const study::Tournament& course, const study::Meeting& meeting) {
  if (total(meeting.pairs) == 0 || is_prevented(course, meeting)) return std::nullopt;
  Strength out{};
  out.law = score_law(meeting.pairs);
  out.elo = elo(out.law);
  out.normalized_elo = normalized_elo(out.law);
  out.superiority = likelihood_of_superiority(out.law);
  out.pair_ratio = pair_ratio(meeting.pairs);
  out.draw_ratio = static_cast<double>(meeting.pairs.seen[2]) / static_cast<double>(total(meeting.pairs));
  out.score_ratio = variance_ratio(meeting.pairs, meeting.games);
  out.goals_ratio = statistics::variance_ratio(meeting.goals_of_pairs, meeting.goals_of_matches);
  constexpr std::int64_t fewest_for_goals = 6;
  if (total(meeting.pairs) >= fewest_for_goals && meeting.unplayed_pairs == 0)
    out.goals_t = statistics::paired_t(meeting.goals_of_pairs);
  return out;
}

namespace {

int side_of(const statistics::WholeCounts& goals) {
  statistics::Count more = 0;
  for (const auto& [difference, pairs] : goals) more += difference * pairs;
  return more > 0 ? 1 : more < 0 ? -1 : 0;
}

struct PRange {
  double least, most;
};

PRange p_either_way(const study::Meeting& meeting, int most_goals) {
  const double without = statistics::sign_flip_p(meeting.goals_by_pair);
  if (meeting.unplayed_pairs == 0) return {without, without};
  statistics::WholeCounts lost = meeting.goals_by_pair, won = meeting.goals_by_pair;
  lost[-2 * most_goals] += static_cast<statistics::Count>(meeting.unplayed_pairs);
  won[2 * most_goals] += static_cast<statistics::Count>(meeting.unplayed_pairs);
  const double if_lost = statistics::sign_flip_p(lost), if_won = statistics::sign_flip_p(won);
  const int side = side_of(meeting.goals_by_pair);
  const bool agree = side == side_of(lost) && side == side_of(won);
  return {std::min({without, if_lost, if_won}), agree ? std::max({without, if_lost, if_won}) : 1.0};
}

}  // namespace

PValues p_values(const study::Tournament& course) {
  PValues out;
  std::vector<double> least;
  std::vector<std::size_t> met;  // in a tournament in rounds, most pairings never meet and are not tested
  for (std::size_t i = 0; i < course.meetings().size(); ++i) {
    const study::Meeting& meeting = course.meetings()[i];
    const PRange p = p_either_way(meeting, course.most_goals());
    out.single.push_back(p.most);
    least.push_back(p.least);
    if (course.calendar().rounds() == 0 || meeting.matches() > 0) met.push_back(i);
  }
  const auto corrected = [&met](const std::vector<double>& all) {
    std::vector<double> of_met, result(all.size(), 1.0);
    for (const std::size_t i : met) of_met.push_back(all[i]);
    of_met = statistics::holm(of_met);
    for (std::size_t k = 0; k < met.size(); ++k) result[met[k]] = of_met[k];
    return result;
  };
  out.adjusted = corrected(out.single);
  const std::vector<double> at_best = corrected(least);
  for (std::size_t i = 0; i < at_best.size(); ++i) {
    out.prevented.push_back(course.meetings()[i].unplayed_pairs > 0 && at_best[i] < significance_level &&
                            out.adjusted[i] >= significance_level);
  }
  return out;
}

int decided_for(const study::Tournament& course, const PValues& p, std::size_t pairing) {
  if (!course.complete() || p.adjusted[pairing] >= significance_level) return 0;
  return side_of(course.meetings()[pairing].goals_by_pair);
}

bool leads_either_way(const study::TournamentPlan& plan, const study::Tournament& course, std::size_t team) {
  if (course.unplayed_pairs() == 0) return true;
  for (std::size_t other = 0; other < plan.teams.size(); ++other) {
    if (other == team) continue;
    statistics::SquareTable won = points_won(plan, course);
    for (const study::Meeting& meeting : course.meetings()) {
      const std::size_t a = meeting.pairing.first, b = meeting.pairing.second;
      const double points = 2.0 * static_cast<double>(meeting.unplayed_pairs);
      if (a == team || b == other)
        won.at(b, a) += points;
      else if (b == team || a == other)
        won.at(a, b) += points;
    }
    const auto elo = statistics::bradley_terry_elo(won);
    const auto elo_or_share = [&](std::size_t of) {
      if (elo) return (*elo)[of];
      double mine = 0.0, all = 0.0;
      for (std::size_t i = 0; i < plan.teams.size(); ++i) {
        mine += won.at(of, i);
        all += won.at(of, i) + won.at(i, of);
      }
      return all == 0.0 ? 0.5 : mine / all;
    };
    if (elo_or_share(team) <= elo_or_share(other)) return false;
  }
  return true;
}

statistics::SquareTable points_won(const study::TournamentPlan& plan, const study::Tournament& course) {
  return statistics::points_won(plan.teams.size(), encounters(course));
}

std::vector<statistics::Encounter> encounters(const study::Tournament& course) {
  std::vector<statistics::Encounter> out;
  for (const study::Meeting& meeting : course.meetings()) {
    statistics::Encounter each{meeting.pairing.first, meeting.pairing.second, meeting.pairs, {}};
    if (total(meeting.games) > each.games_played()) {  // only the first match of the last pair has been played
      const double left = points(meeting.games) - each.points();
      using enum statistics::GameOutcome;
      each.games.add(left > 0.75 ? win : left > 0.25 ? draw : loss);
    }
    out.push_back(each);
  }
  return out;
}

std::vector<Ranked> ranking(const study::TournamentPlan& plan, const study::Tournament& course) {
  const std::size_t teams = plan.teams.size();
  std::vector<Ranked> out(teams);
  statistics::SquareTable payoff(teams);
  std::size_t met = 0;
  for (std::size_t team = 0; team < teams; ++team) {
    out[team].team = team;
    out[team].failures = course.forfeits().of_team()[team];
  }
  for (const study::Meeting& meeting : course.meetings()) {
    const std::size_t a = meeting.pairing.first, b = meeting.pairing.second;
    const double games = static_cast<double>(total(meeting.games)), of_a = points(meeting.games);
    if (games > 0.0) {
      payoff.at(a, b) = of_a / games - 0.5;
      ++met;
    }
    payoff.at(b, a) = -payoff.at(a, b);
    for (const std::size_t side : {0u, 1u}) {
      Ranked& team = out[side == 0 ? a : b];
      team.wins += static_cast<std::uint64_t>(meeting.games.seen[2 - 2 * side]);
      team.losses += static_cast<std::uint64_t>(meeting.games.seen[2 * side]);
      team.draws += static_cast<std::uint64_t>(meeting.games.seen[1]);
      team.matches += meeting.matches();
      team.points += side == 0 ? of_a : games - of_a;
      team.scored += meeting.goals[side];
      team.conceded += meeting.goals[1 - side];
    }
  }
  if (const auto elo = statistics::bradley_terry(teams, encounters(course))) {
    for (Ranked& team : out) team.elo = (*elo)[team.team];
  }
  if (met == teams * (teams - 1) / 2) {
    const statistics::NashAverage nash = statistics::nash_average(payoff);
    for (Ranked& team : out) team.nash = nash.share[team.team];
  }
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
