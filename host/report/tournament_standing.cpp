// SPDX-License-Identifier: MIT
// The section about the standing of the teams: a table of the teams; for two teams the block of numbers that users of
// the test frames of chess engines know; for more teams the table of all pairings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "report/number.hpp"
#include "report/standing.hpp"
#include "report/tournament_report.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using study::Meeting;

constexpr std::size_t most_crossed = 24;        // largest number of teams in a table of all teams against all teams
constexpr std::size_t most_open_pairings = 15;  // largest number of pairings that a page shows without a click
constexpr std::size_t most_pairings = 2000;     // largest number of pairings that the report lists

std::string or_none(const std::optional<double>& number) { return number ? fixed(*number, 2) : "-"; }

double percent(double part, double whole) { return whole == 0.0 ? 0.0 : 100.0 * part / whole; }

Sentence who_of(const TournamentView& view, const Meeting& meeting, const char* between = " – ") {
  return named(view.shown(meeting.pairing.first)) << between << named(view.shown(meeting.pairing.second));
}

// Where most teams never meet, a table of all against all makes no sense.
bool all_meet(const TournamentView& view) { return view.plan.asked.format == config::Tournament::Format::round_robin; }

Table teams_table(const TournamentView& view, std::vector<Ranked> ranks) {
  const bool several = view.plan.teams.size() > 2;
  std::vector<Heading> headings{{"Team", Column::words}};
  const bool with_nash = ranks.front().nash.has_value();
  if (several) headings = {{"Rank"}, {"Team", Column::words}, {"Elo"}};
  if (several && with_nash) headings.push_back({"Nash share"});
  for (const char* each : {"Matches", "Won", "Drawn", "Lost", "Points", "Goals", "Forfeits"})
    headings.push_back({each});
  Table out(headings);
  if (!several) std::ranges::sort(ranks, {}, &Ranked::team);
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const Ranked& each = ranks[i];
    std::vector<Cell> cells;
    if (several) {
      cells = {i + 1, named(view.shown(each.team)),
               !each.elo ? std::string("–")
               : each.elo->interval.bounded()
                   ? fmt::format("{} ± {:.1f}", with_sign(each.elo->value, 1), each.elo->margin())
                   : with_sign(each.elo->value, 1)};
      if (with_nash) cells.emplace_back(fixed(*each.nash, 2));
    } else {
      cells.push_back(Sentence(Sentence::Kind::mark, each.team == 0 ? "first" : "second")
                      << named(view.shown(each.team)));
    }
    cells.insert(cells.end(), {each.matches, each.wins, each.draws, each.losses, fmt::format("{:.1f}", each.points),
                               fmt::format("{}:{}", each.scored, each.conceded), each.failures});
    out.row(std::move(cells));
  }
  return out;
}

void add_score_test(const statistics::SequentialTest& test, const std::optional<Strength>& known, Section& lines,
                    Table& table) {
  const statistics::SequentialBounds bounds = test.bounds();
  const double llr = test.ratio().value;
  const auto& [elo0, elo1] = test.design().hypotheses;
  const char* const approximate = test.ratio().method == statistics::Method::closed_form ? ", approximate" : "";
  lines.line(fmt::format("LLR: {} ({} %) ({:.2f}, {:.2f}) [{}, {}] {}{}, stops at {} or {}", fixed(llr, 2),
                         fixed(percent(llr, llr < 0.0 ? -bounds.lower : bounds.upper), 1), bounds.lower, bounds.upper,
                         fixed(elo0, 2), fixed(elo1, 2), name(test.design().model), approximate,
                         fixed(test.stopping().lower, 2), fixed(test.stopping().upper, 2)),
             Readers::terminal);
  if (const std::string few = known ? what_the_test_rests_on(known->law) : ""; !few.empty())
    lines.line(few, Readers::terminal);
  table.row({"Log-likelihood ratio (LLR)",
             fmt::format("{} of ({:.2f}, {:.2f})", with_sign(llr, 2), bounds.lower, bounds.upper),
             fmt::format("H0: {}, H1: {} {} Elo; stops at {} or {}{}", elo0, elo1, name(test.design().model),
                         fixed(test.stopping().lower, 2), fixed(test.stopping().upper, 2), approximate)});
}

void add_metric(const TournamentView& view, const Meeting& meeting, Section& lines, Table& table) {
  const auto test = std::get<study::ValueTest>(view.plan.objective());
  const study::MetricDifference& metric = *meeting.metric;
  const statistics::Estimate estimate = metric.estimate();
  const auto& [less, equal, more] = metric.signs();
  const std::string interval = fmt::format("[{:.4g}, {:.4g}]", estimate.interval.low, estimate.interval.high);
  lines.line(fmt::format("{}: {:.4g} and {:.4g} per match, difference {:+.4g} {}, approximately", test.value,
                         metric.first().mean(), metric.second().mean(), estimate.value, interval),
             Readers::terminal);
  lines.line(named(view.shown(meeting.pairing.first))
                 << fmt::format(" has less in {}, as much in {}, more in {} pairs, p at any time {:.2g}", less, equal,
                                more, metric.test().p()),
             Readers::terminal);
  if (meeting.pairs_without_metric > 0) {
    lines.line(fmt::format("{} without it: a match was forfeited, or has no such number",
                           pairs_in_words(meeting.pairs_without_metric)),
               Readers::terminal);
  }
  table.row({"Difference of " + test.value, fmt::format("{:+.4g}", estimate.value),
             fmt::format("means {:.4g} and {:.4g}; interval {}, for many pairs", metric.first().mean(),
                         metric.second().mean(), interval)});
  table.row({"Pairs with less, as much, more of it", fmt::format("{}, {}, {}", less, equal, more),
             fmt::format("p at any time {:.2g}; {} without it", metric.test().p(), meeting.pairs_without_metric)});
}

// Adds goals and the goal difference with its interval. These numbers decide a tournament without a sequential test.
void add_goals(const TournamentView& view, const Meeting& meeting, const std::optional<Strength>& known, Section& lines,
               Table& table, Table& others) {
  std::string goals = fmt::format("Goals: {}:{}", meeting.goals[0], meeting.goals[1]);
  if (!known) return lines.line(goals, Readers::terminal);
  const bool fixed_number = is_of_fixed_number(view.plan, view.course);
  const bool with_t = fixed_number && known->goals_t;
  const double mean = meeting.goals_of_pairs.mean();
  goals += fmt::format(", per {} {}", game_word(view.plan), with_sign(mean, 3));
  if (with_t) goals += fmt::format(" {}, 95 % by Student's t", interval_text(known->goals_t->interval, 3));
  lines.line(goals, Readers::terminal);
  table.row({fmt::format("Goal difference of a {}", game_word(view.plan)),
             with_sign(mean, 3) + (with_t ? " " + signed_interval_text(known->goals_t->interval, 3) : std::string()),
             with_t ? "mean of the pairs, with its 95 % interval by Student's t" : "mean of the pairs"});
  if (fixed_number) {
    const double p = p_values(view.course).single.front();
    lines.line(fmt::format("p {:.2g}: exact sign flips of the pairs' goal differences", p), Readers::terminal);
    table.row({"Sign-flip test", fmt::format("p {:.2g}", p),
               meeting.unplayed_pairs == 0
                   ? "the test that decides: probability of goals as unequal as these if the teams were equal"
                   : "the same; pairs that could not be played are counted for the team that makes p larger"});
  }
  others.row({"Goal difference at any time", signed_interval_text(meeting.goals_sequence.interval(), 3),
              "an interval that holds at every look: for a tournament that still runs"});
}

// Adds numbers that readers know from other programs. These numbers decide nothing unless the test uses scores.
void add_others(const Meeting& meeting, const Strength& known, Section& lines, Table& table) {
  lines.line(fmt::format("Elo: {}, nElo: {}", with_margin(known.elo), with_margin(known.normalized_elo)),
             Readers::terminal);
  const std::string superiority = known.superiority ? fmt::format("{:.2f} %", 100.0 * *known.superiority) : "-";
  lines.line(fmt::format("LOS: {}, DrawRatio: {:.2f} %, PairsRatio: {}", superiority, 100.0 * known.draw_ratio,
                         or_none(known.pair_ratio)),
             Readers::terminal);
  lines.line(fmt::format("Variance ratio of pairing: {} of scores, {} of goals", or_none(known.score_ratio),
                         or_none(known.goals_ratio)),
             Readers::terminal);
  const std::string why = why_no_interval(known.law);
  table.row({"Elo", signed_text(known.elo, 1),
             "strength by points won, to compare with ratings: 400 Elo mean odds of ten to one"});
  table.row({"Normalised Elo", signed_text(known.normalized_elo, 1),
             "strength divided by the spread of a match, to plan tests: how soon one sees it" +
                 (why.empty() ? why : ". " + why)});
  table.row({"LOS", superiority, "likelihood of superiority: how much of the law of the mean score is above one half"});
  table.row({"Draw ratio", fmt::format("{:.1f} %", 100.0 * known.draw_ratio),
             "pairs that ended even, which say nothing of who scores more points"});
  table.row({"Pairs won to lost", or_none(known.pair_ratio), "pairs in which the first team had more points, to less"});
  table.row({"Pairs by points", fmt::format("{}", fmt::join(meeting.pairs.seen, " · ")),
             "both lost · lost and drawn · even · won and drawn · both won, for tests on scores"});
}

// Adds the pairing of two teams. A terminal shows lines as the chess program fastchess prints them, a page tables.
void add_meeting(const TournamentView& view, Section& out) {
  const Meeting& meeting = view.course.meetings().front();
  const std::optional<Strength> known = strength(view.course, meeting);
  const std::vector<Heading> headings{{"Number", Column::words}, {"Value"}, {"What it says", Column::words}};
  Table table{headings}, others{headings};
  const auto& [losses, draws, wins] = meeting.games.seen;
  out.line(fmt::format("Games: {}, Wins: {}, Losses: {}, Draws: {}, Points: {:.1f} ({:.2f} %)", meeting.matches(), wins,
                       losses, draws, points(meeting.games),
                       percent(points(meeting.games), static_cast<double>(meeting.matches()))),
           Readers::terminal);
  add_goals(view, meeting, known, out, table, others);
  if (meeting.score_test) add_score_test(*meeting.score_test, known, out, table);
  if (meeting.metric) add_metric(view, meeting, out, table);
  out.line(fmt::format("Ptnml(0-2): [{}]", fmt::join(meeting.pairs.seen, ", ")), Readers::terminal);
  if (!known) return;
  add_others(meeting, *known, out, others);
  out.table(std::move(table), Readers::page);
  others.summary = "Other numbers of strength, and what each is for";
  out.table(std::move(others), Readers::page);
}

void add_ranking(const TournamentView& view, Section& out) {
  const std::vector<Ranked> ranks = ranking(view.plan, view.course);
  out.table(teams_table(view, ranks));
  if (std::ranges::any_of(ranks, [](const Ranked& each) { return each.elo && !each.elo->interval.bounded(); }))
    out.line(no_margin_of_team(), Readers::terminal);
}

// Adds a table of all teams against all teams. A cell has the share of points that the row's team won.
void add_cross_table(const TournamentView& view, Section& out) {
  const std::vector<Ranked> ranks = ranking(view.plan, view.course);
  if (ranks.size() > most_crossed || !all_meet(view)) return;
  const statistics::SquareTable won = points_won(view.plan, view.course);
  Table table{{{"Share of points, %", Column::words}}};
  table.style = Table::Style::heat;
  constexpr std::size_t most_named = 10;  // largest number of columns that have room for the names of teams
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    table.headings.push_back(
        {ranks.size() <= most_named ? named(view.shown(ranks[i].team)) : Sentence(std::to_string(i + 1))});
  }
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    std::vector<Cell> cells{Sentence(std::to_string(i + 1) + ' ') << named(view.shown(ranks[i].team))};
    for (const Ranked& other : ranks) {
      const double mine = won.at(ranks[i].team, other.team), all = mine + won.at(other.team, ranks[i].team);
      const bool played = all > 0.0 && other.team != ranks[i].team;
      const double share = played ? 100.0 * mine / all : 50.0;
      Cell& cell = cells.emplace_back(played ? fmt::format("{:.0f}", share) : "–");
      // Above 50 % a cell has the colour of series 1, below 50 % of series 2. The colour is stronger far from 50 %.
      cell.series = share > 50.0 ? 1 : share < 50.0 ? 2 : 0;
      cell.ground = std::abs(share - 50.0) * 0.9;
    }
    table.row(std::move(cells));
  }
  out.items.push_back({Lines{{"All against all"}, Lines::Style::heading}, Readers::page});
  out.table(std::move(table), Readers::page);
}

// Formats a goal difference per game: "+0.85 [0.40, 1.30]".
std::string goals_a_game(const Strength& known, const Meeting& meeting, bool with_interval) {
  const double mean = meeting.goals_of_pairs.mean();
  if (!with_interval || !known.goals_t) return with_sign(mean, 2);
  return signed_with_interval(statistics::Estimate{mean, known.goals_t->interval});
}

Table pairings_table(const TournamentView& view) {
  const bool with_p = is_of_fixed_number(view.plan, view.course), with_unplayed = view.course.unplayed_pairs() > 0;
  Table out{{{"Pairing", Column::words},
             {"Won – drawn – lost"},
             {"Goals"},
             {fmt::format("Goals a {}", game_word(view.plan))}}};
  if (with_unplayed) out.headings.push_back({"Pairs not played"});
  if (with_p) out.headings.push_back({"p (Holm)"});
  const PValues p = p_values(view.course);
  for (std::size_t i = 0; i < std::min(p.adjusted.size(), most_pairings); ++i) {
    const Meeting& meeting = view.course.meetings()[i];
    if (view.plan.rounds() > 0 && meeting.matches() == 0) continue;  // never drawn
    const auto& [losses, draws, wins] = meeting.games.seen;
    const std::optional<Strength> known = strength(view.course, meeting);
    std::vector<Cell> cells{who_of(view, meeting), fmt::format("{} – {} – {}", wins, draws, losses),
                            fmt::format("{}:{}", meeting.goals[0], meeting.goals[1]),
                            known ? goals_a_game(*known, meeting, with_p) : "–"};
    if (with_unplayed) cells.emplace_back(meeting.unplayed_pairs);
    if (with_p) cells.emplace_back(fmt::format("{:.2g}{}", p.adjusted[i], p.prevented[i] ? ": no verdict" : ""));
    out.row(std::move(cells));
  }
  out.summary = fmt::format("{} pairings, from the point of view of the team named first{}", out.rows.size(),
                            with_p ? "; p: exact sign flips of the pairs' goal differences, corrected by Holm" : "");
  out.open = out.rows.size() <= most_open_pairings;
  return out;
}

}  // namespace

Section standing_section(const TournamentView& view) {
  Section out("standing", "Standing");
  for (const study::Pairing& pairing : view.course.calendar().pairings()) {
    if (!study::equal_teams(view.plan, pairing)) continue;
    out.line(Sentence("A/A: ") << named(view.shown(pairing.first)) << " and " << named(view.shown(pairing.second))
                               << " are equal, so every pair is a draw by construction",
             Readers::terminal);
  }
  if (is_without_verdict(view.plan, view.course)) return out;
  if (view.plan.teams.size() == 2) {
    out.note(Sentence("All numbers are from the point of view of ")
                 << named(view.shown(0)) << ", against " << named(view.shown(1)) << ".",
             Readers::page);
    out.table(teams_table(view, ranking(view.plan, view.course)), Readers::page);
    add_meeting(view, out);
    return out;
  }
  add_ranking(view, out);
  out.figures({"ranking"});
  add_cross_table(view, out);
  out.table(pairings_table(view));
  if (view.course.meetings().size() > most_pairings) out.note("regista report --json has the others.");
  out.note(
      fmt::format(
          "Elo of the ranking: Bradley and Terry, sum 0. Its margins count pairs and draws. A team has no margin if "
          "fewer than 10 of its pairs were uneven, or if it won or lost all. {}Goals: mean of the pairs, with the 95 % "
          "interval of Student's t for that pairing alone. p: exact sign flips of the pairs' goal differences, "
          "corrected by Holm for the number of pairings.",
          !ranking(view.plan, view.course).front().nash
              ? ""
              : "Nash share: probability of the team in the Nash equilibrium. "),
      Readers::page);
  return out;
}

Section rounds_section(const TournamentView& view) {
  Section out("rounds", "Rounds");
  if (view.plan.rounds() == 0) return out;
  const bool knock_out = view.plan.asked.format == config::Tournament::Format::knock_out;
  Table table{{{"Round"}, {"Meeting", Column::words}, {"Points"}, {"Goals"}}};
  if (knock_out) table.headings.push_back({"Goes on", Column::words});
  std::size_t number = 0;
  for (const std::vector<std::size_t>& round : view.course.calendar().drawn()) {
    ++number;
    for (const std::size_t pairing : round) {
      const Meeting& meeting = view.course.meetings()[pairing];
      const double won = points(meeting.games);
      std::vector<Cell> cells{number, who_of(view, meeting),
                              fmt::format("{:.1f}:{:.1f}", won, static_cast<double>(total(meeting.games)) - won),
                              fmt::format("{}:{}", meeting.goals[0], meeting.goals[1])};
      if (knock_out) {
        const bool decided = view.course.complete() || number < view.course.calendar().drawn().size();
        cells.push_back(decided ? named(view.shown(view.course.winner(meeting))) : Sentence("–"));
      }
      table.row(std::move(cells));
    }
  }
  out.table(std::move(table));
  out.note(knock_out
               ? "A meeting is won by points, then by goals. If both are equal, the team that is named first goes on."
               : "Teams with about as many points meet (Monrad), and nobody meets the same team again while another "
                 "is left. A team without an opponent gets the points of a won meeting.",
           Readers::page);
  return out;
}

std::string standing_text(const TournamentView& view) {
  Section out("standing", "");
  if (is_without_verdict(view.plan, view.course)) return {};
  if (view.plan.teams.size() == 2)
    add_meeting(view, out);
  else
    add_ranking(view, out);
  return section_text(out);
}

Section curves_section(const TournamentView& view) {
  Section out("curves", "Course of the tournament");
  if (is_without_verdict(view.plan, view.course)) return out;
  out.figures({"elo", "llr", "value"}, Figures::Style::beside);
  const std::optional<Strength> known = strength(view.course, view.course.meetings().front());
  if (view.plan.teams.size() == 2 && known && !std::isfinite(known->elo.value))
    out.note("One team took every point of every pair, so its Elo is infinite.", Readers::page);
  return out;
}

Section variance_section(const TournamentView& view) {
  Section out("variance", "Variance ratio of pairing");
  Table table{{{"Pairing", Column::words}, {"of scores"}, {"of goals"}}};
  for (const Meeting& meeting : view.course.meetings()) {
    const std::optional<Strength> known = strength(view.course, meeting);
    if (!known || table.rows.size() == most_pairings) continue;
    table.row({who_of(view, meeting), or_none(known->score_ratio), or_none(known->goals_ratio)});
  }
  if (table.rows.empty()) return out;
  out.line(
      "A pair is two matches with the same seed and scene, the sides swapped. The ratio compares the number of matches "
      "that are needed with pairs and with independent matches: at 0.5 pairs need half as many, at 1 as many, above 1 "
      "more.",
      Readers::page);
  if (table.rows.size() > most_open_pairings) table.summary = fmt::format("{} pairings", table.rows.size());
  out.table(std::move(table), Readers::page);
  return out;
}

}  // namespace regista::report
