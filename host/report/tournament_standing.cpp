// SPDX-License-Identifier: MIT
// Where the teams stand: the table of teams; of two teams the block of numbers that users of the test frames of chess
// engines know; of more the table of all pairings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "report/elo_interval.hpp"
#include "report/estimate_text.hpp"
#include "report/few_uneven.hpp"
#include "report/number.hpp"
#include "report/standing.hpp"
#include "report/tournament_outline.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using study::Meeting;

constexpr std::size_t most_crossed = 24;        // teams that a table of all against all has room for
constexpr std::size_t most_open_pairings = 15;  // pairings that a page shows without being asked for
constexpr std::size_t most_listed = 2000;       // pairings at all

std::string or_none(const std::optional<double>& number) { return number ? fixed(*number, 2) : "-"; }

double percent(double part, double whole) { return whole == 0.0 ? 0.0 : 100.0 * part / whole; }

// What holds only for a number of pairs that nobody chose by looking may be said; of a pairing only where all of them
// could be played.
bool fixed_number_is_played(const TournamentView& view) {
  return std::holds_alternative<study::FixedNumber>(view.plan.objective()) && view.course.complete();
}

Sentence who_of(const TournamentView& view, const Meeting& meeting, const char* between = " – ") {
  return named(view.label(meeting.pairing.first)) << between << named(view.label(meeting.pairing.second));
}

// Of two teams on a page alone: its lines below say the same.
Table teams_table(const TournamentView& view, std::vector<Ranked> ranks) {
  const bool several = view.plan.teams.size() > 2;
  std::vector<Heading> headings{{"Team", Column::words}};
  if (several) headings = {{"Rank"}, {"Team", Column::words}, {"Elo"}, {"Nash share"}};
  for (const char* each : {"Matches", "Won", "Drawn", "Lost", "Points", "Goals", "Forfeits"})
    headings.push_back({each});
  Table out(headings);
  if (!several) std::ranges::sort(ranks, {}, &Ranked::team);
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const Ranked& each = ranks[i];
    std::vector<Cell> cells;
    if (several) {
      cells = {i + 1, named(view.label(each.team)),
               !each.elo ? std::string("–")
               : each.elo->interval.bounded()
                   ? fmt::format("{} ± {:.1f}", with_sign(each.elo->value, 1), each.elo->margin())
                   : with_sign(each.elo->value, 1),
               fixed(each.nash, 2)};
    } else {
      cells.push_back(Sentence(Sentence::Kind::mark, each.team == 0 ? "first" : "second")
                      << named(view.label(each.team)));
    }
    cells.insert(cells.end(), {each.matches, each.wins, each.draws, each.losses, fmt::format("{:.1f}", each.points),
                               fmt::format("{}:{}", each.scored, each.conceded), each.failures});
    out.row(std::move(cells));
  }
  return out;
}

// --- Of two teams
// ------------------------------------------------------------------------------------------------------

void add_score_test(const statistics::SequentialTest<statistics::PairCounts>& test,
                    const std::optional<Strength>& known, Section& lines, Table& table) {
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
  lines.line(named(view.label(meeting.pairing.first))
                 << fmt::format(" has less in {}, as much in {}, more in {} pairs, p at any time {:.2g}", less, equal,
                                more, metric.test().p()),
             Readers::terminal);
  if (meeting.pairs_without_metric > 0) {
    lines.line(fmt::format("{} without it: a match was forfeited, or has no such number",
                           texts::counted(meeting.pairs_without_metric, "pair", "pairs")),
               Readers::terminal);
  }
  table.row({"Difference of " + test.value, fmt::format("{:+.4g}", estimate.value),
             fmt::format("means {:.4g} and {:.4g}; interval {}, for many pairs", metric.first().mean(),
                         metric.second().mean(), interval)});
  table.row({"Pairs with less, as much, more of it", fmt::format("{}, {}, {}", less, equal, more),
             fmt::format("p at any time {:.2g}; {} without it", metric.test().p(), meeting.pairs_without_metric)});
}

void add_goals(const TournamentView& view, const Meeting& meeting, const std::optional<Strength>& known, Section& lines,
               Table& table) {
  std::string goals = fmt::format("Goals: {}:{}", meeting.goals[0], meeting.goals[1]);
  if (!known) {
    lines.line(goals, Readers::terminal);
    return;
  }
  const bool fixed_number = fixed_number_is_played(view);
  const bool with_t = fixed_number && known->goals_t && meeting.unplayed_pairs == 0;
  const statistics::Interval interval = meeting.goals_sequence.interval();
  goals += fmt::format(", per match {} {} at any time", with_sign(meeting.goals_of_pairs.mean(), 3),
                       interval_text(interval, 3));
  if (with_t) {
    goals += fmt::format(", {} for this number of pairs (t test: p {:.2g})", interval_text(known->goals_t->interval, 3),
                         known->goals_t->p);
  }
  lines.line(goals, Readers::terminal);
  lines.line(fmt::format("Variance ratio of pairing: {} of scores, {} of goals", or_none(known->score_ratio),
                         or_none(known->goals_ratio)),
             Readers::terminal);
  if (fixed_number) {
    table.row({"Sign-flip test", fmt::format("p {:.2g}", p_values(view.course).single.front()),
               meeting.unplayed_pairs == 0
                   ? "probability of a result as clear as this if the teams were equal"
                   : "the same; pairs that could not be played are counted for the team that makes p larger"});
  }
  table.row({"Goal difference of a match",
             fmt::format("{} {}", with_sign(meeting.goals_of_pairs.mean(), 3), signed_interval_text(interval, 3)),
             "anytime-valid interval"});
  if (with_t) {
    table.row({"The same, for this number of pairs", signed_interval_text(known->goals_t->interval, 3),
               fmt::format("t test: p {:.2g}", known->goals_t->p)});
  }
}

void add_strength(const Meeting& meeting, const Strength& known, Section& lines, Table& table) {
  lines.line(fmt::format("Elo: {}, nElo: {}", with_margin(known.elo), with_margin(known.normalized_elo)),
             Readers::terminal);
  lines.line(fmt::format("LOS: {:.2f} %, DrawRatio: {:.2f} %, PairsRatio: {}", 100.0 * known.superiority,
                         100.0 * known.draw_ratio, or_none(known.pair_ratio)),
             Readers::terminal);
  const std::string few = enough_for_interval(meeting.pairs) ? "" : ". Too few pairs for a reliable interval";
  table.row({"Elo", signed_text(known.elo, 1), "strength: 400 Elo mean odds of ten to one" + few});
  const std::string why = why_no_interval(known.law);
  table.row({"Normalised Elo", signed_text(known.normalized_elo, 1),
             "strength divided by the spread of a match: how soon a test sees it" + (why.empty() ? why : ". " + why)});
  table.row({"Pairs by points", fmt::format("{}", fmt::join(meeting.pairs.seen, " · ")),
             "both lost · lost and drawn · even · won and drawn · both won"});
  table.row({"Pairs won to lost", or_none(known.pair_ratio),
             fmt::format("{:.1f} % of pairs ended even", 100.0 * known.draw_ratio)});
}

// A terminal gets the lines of fastchess, a page the same with what each number says.
void add_meeting(const TournamentView& view, Section& out) {
  const Meeting& meeting = view.course.meetings().front();
  const std::optional<Strength> known = strength(view.course, meeting);
  Table table{{{"Number", Column::words}, {"Value"}, {"What it says", Column::words}}};
  if (known) add_strength(meeting, *known, out, table);
  const auto& [losses, draws, wins] = meeting.games.seen;
  out.line(fmt::format("Games: {}, Wins: {}, Losses: {}, Draws: {}, Points: {:.1f} ({:.2f} %)", meeting.matches(), wins,
                       losses, draws, points(meeting.games),
                       percent(points(meeting.games), static_cast<double>(meeting.matches()))),
           Readers::terminal);
  out.line(fmt::format("Ptnml(0-2): [{}]", fmt::join(meeting.pairs.seen, ", ")), Readers::terminal);
  if (meeting.score_test) add_score_test(*meeting.score_test, known, out, table);
  add_goals(view, meeting, known, out, table);
  if (meeting.metric) add_metric(view, meeting, out, table);
  if (known) out.table(std::move(table), Readers::page);
}

// --- Of more
// -----------------------------------------------------------------------------------------------------------

void add_ranking(const TournamentView& view, Section& out) {
  const std::vector<Ranked> ranks = ranking(view.plan, view.course);
  out.table(teams_table(view, ranks));
  if (std::ranges::any_of(ranks, [](const Ranked& each) { return each.elo && !each.elo->interval.bounded(); }))
    out.line(no_margin_of_team(), Readers::terminal);
}

// Share of the points of the row's team against that of the column.
void add_cross_table(const TournamentView& view, Section& out) {
  const std::vector<Ranked> ranks = ranking(view.plan, view.course);
  if (ranks.size() > most_crossed || view.plan.asked.format == config::Tournament::Format::gauntlet) return;
  const statistics::SquareTable won = points_won(view.plan, view.course);
  Table table{{{"Share of points, %", Column::words}}};
  table.look = Table::Look::heat;
  for (std::size_t i = 0; i < ranks.size(); ++i) table.headings.push_back({std::to_string(i + 1)});
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    std::vector<Cell> cells{Sentence(std::to_string(i + 1) + ' ') << named(view.label(ranks[i].team))};
    for (const Ranked& other : ranks) {
      const double mine = won.at(ranks[i].team, other.team), all = mine + won.at(other.team, ranks[i].team);
      const bool played = all > 0.0 && other.team != ranks[i].team;
      const double share = played ? 100.0 * mine / all : 50.0;
      Cell& cell = cells.emplace_back(played ? fmt::format("{:.0f}", share) : "–");
      // The first or the second colour, the stronger the farther from one half.
      cell.series = share > 50.0 ? 1 : share < 50.0 ? 2 : 0;
      cell.ground = std::abs(share - 50.0) * 0.9;
    }
    table.row(std::move(cells));
  }
  out.items.push_back({Lines{{"All against all"}, Lines::Look::heading}, Readers::page});
  out.table(std::move(table), Readers::page);
}

Table pairings_table(const TournamentView& view) {
  const bool with_p = fixed_number_is_played(view), with_unplayed = view.course.unplayed_pairs() > 0;
  Table out{{{"Pairing", Column::words}, {"Won – drawn – lost"}, {"Goals"}, {"Elo"}}};
  if (with_unplayed) out.headings.push_back({"Pairs not played"});
  if (with_p) out.headings.push_back({"p (Holm)"});
  const PValues p = p_values(view.course);
  for (std::size_t i = 0; i < std::min(p.adjusted.size(), most_listed); ++i) {
    const Meeting& meeting = view.course.meetings()[i];
    const auto& [losses, draws, wins] = meeting.games.seen;
    const std::optional<Strength> known = strength(view.course, meeting);
    std::vector<Cell> cells{who_of(view, meeting), fmt::format("{} – {} – {}", wins, draws, losses),
                            fmt::format("{}:{}", meeting.goals[0], meeting.goals[1]),
                            known ? signed_text(known->elo, 1) : "–"};
    if (with_unplayed) cells.emplace_back(meeting.unplayed_pairs);
    if (with_p) cells.emplace_back(fmt::format("{:.2g}{}", p.adjusted[i], p.prevented[i] ? ": no verdict" : ""));
    out.row(std::move(cells));
  }
  out.summary = fmt::format("{} pairings, from the point of view of the team named first{}", p.adjusted.size(),
                            with_p ? "; p: two-sided sign-flip test, corrected by Holm" : "");
  out.open = p.adjusted.size() <= most_open_pairings;
  return out;
}

}  // namespace

Section standing_section(const TournamentView& view) {
  Section out("standing", "Standing");
  for (const study::Pairing& pairing : view.course.calendar().pairings()) {
    if (!study::equal_teams(view.plan, pairing)) continue;
    out.line(Sentence("A/A: ") << named(view.label(pairing.first)) << " and " << named(view.label(pairing.second))
                               << " are equal, so every pair is a draw by construction",
             Readers::terminal);
  }
  if (is_without_verdict(view.plan, view.course)) return out;
  if (view.plan.teams.size() == 2) {
    out.note(Sentence("All numbers are from the point of view of ")
                 << named(view.label(0)) << ", against " << named(view.label(1)) << ".",
             Readers::page);
    out.table(teams_table(view, ranking(view.plan, view.course)), Readers::page);
    add_meeting(view, out);
    return out;
  }
  add_ranking(view, out);
  out.figures({"ranking"});
  add_cross_table(view, out);
  out.table(pairings_table(view));
  if (view.course.meetings().size() > most_listed) out.note("regista report --json has the others.");
  out.note(
      "Elo of the ranking: Bradley and Terry, sum 0. Its margins count pairs and draws, and so do the intervals of the "
      "pairings. A team has no margin if fewer than 10 of its pairs were uneven, or if it won or lost all. These are "
      "rough where fewer than 10 pairs were not even. Nash share: probability of the team in the Nash equilibrium. p: "
      "two-sided sign-flip test, corrected by Holm for the number of pairings.",
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
  out.figures({"elo", "llr", "value"}, Figures::Look::beside);
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
    if (!known || table.rows.size() == most_listed) continue;
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
