// SPDX-License-Identifier: MIT
// Who stands where: the table of teams, of two teams the block of numbers that users of the test frames of chess
// engines know, of more the table of all pairings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "report/elo_interval.hpp"
#include "report/estimate_text.hpp"
#include "report/few_uneven.hpp"
#include "report/number.hpp"
#include "report/page_sections.hpp"
#include "report/standing.hpp"

namespace regista::report {
namespace {

using study::Meeting;

constexpr std::size_t most_crossed = 24;        // teams that a table of all against all has room for
constexpr std::size_t most_open_pairings = 15;  // pairings that are shown without being asked for
constexpr std::size_t most_listed = 2000;       // pairings at all

Html count(std::uint64_t number) { return text(fmt::format("{}", number)); }

bool fixed_number_is_played(const PageSource& source) {
  return std::holds_alternative<study::FixedNumber>(source.view.plan.objective()) && source.view.course.complete();
}

Html teams_table(const PageSource& source) {
  const bool several = source.view.plan.teams.size() > 2;
  std::vector<Heading> headings{{"Team"_html, Column::words}};
  if (several) headings.insert(headings.begin(), Heading{"Rank"_html});
  if (several) headings.insert(headings.end(), {{"Elo"_html}, {"Nash share"_html}});
  for (const Markup each :
       {"Matches"_html, "Won"_html, "Drawn"_html, "Lost"_html, "Points"_html, "Goals"_html, "Forfeits"_html}) {
    headings.push_back({each});
  }
  HtmlTable table(headings);
  std::vector<Ranked> ranks = ranking(source.view.plan, source.view.course);
  if (!several) std::ranges::sort(ranks, {}, &Ranked::team);
  std::uint64_t rank = 0;
  for (const Ranked& each : ranks) {
    std::vector<Html> cells;
    if (several) cells.push_back(count(++rank));
    Html who = several          ? Html()
               : each.team == 0 ? Html("<i class=\"key first\"></i>"_html)
                                : Html("<i class=\"key second\"></i>"_html);
    cells.push_back(who << team_name(source, each.team));
    if (several) {
      cells.push_back(text(each.elo
                               ? each.elo->interval.bounded()
                                     ? fmt::format("{} ± {:.1f}", with_sign(each.elo->value, 1), each.elo->margin())
                                     : with_sign(each.elo->value, 1)
                               : "–"));
      cells.push_back(text(fixed(each.nash, 2)));
    }
    for (const std::uint64_t number : {each.matches, each.wins, each.draws, each.losses})
      cells.push_back(count(number));
    cells.push_back(text(fmt::format("{:.1f}", each.points)));
    cells.push_back(text(fmt::format("{}:{}", each.scored, each.conceded)));
    cells.push_back(count(each.failures));
    table.row(cells);
  }
  return table.html();
}

void add_test(HtmlTable& table, const Meeting& meeting, const PageSource& source) {
  if (meeting.score_test) {
    const auto& test = *meeting.score_test;
    const auto& design = test.design();
    table.row({"Log-likelihood ratio (LLR)"_html,
               text(fmt::format("{} of ({:.2f}, {:.2f})", with_sign(test.ratio().value, 2), test.bounds().lower,
                                test.bounds().upper)),
               text(fmt::format("H0: {}, H1: {} {} Elo; stops at {} or {}{}", design.hypotheses.elo0,
                                design.hypotheses.elo1, statistics::name(design.model), fixed(test.stopping().lower, 2),
                                fixed(test.stopping().upper, 2),
                                test.ratio().method == statistics::Method::closed_form ? "; approximate" : ""))});
  }
  if (!meeting.metric) return;
  const auto test = std::get<study::ValueTest>(source.view.plan.objective());
  const study::MetricDifference& metric = *meeting.metric;
  const statistics::Estimate estimate = metric.estimate();
  Html what = "Difference of "_html;
  table.row(
      {what << text(test.value), text(fmt::format("{:+.4g}", estimate.value)),
       text(fmt::format("means {:.4g} and {:.4g}; interval [{:.4g}, {:.4g}], for many pairs", metric.first().mean(),
                        metric.second().mean(), estimate.interval.low, estimate.interval.high))});
  const auto& [less, equal, more] = metric.signs();
  table.row(
      {"Pairs with less, as much, more of it"_html, text(fmt::format("{}, {}, {}", less, equal, more)),
       text(fmt::format("p at any time {:.2g}; {} without it", metric.test().p(), meeting.pairs_without_metric))});
}

Html pairing_table(const PageSource& source) {
  const Meeting& meeting = source.view.course.meetings().front();
  const std::optional<Strength> known = strength(source.view.course, meeting);
  if (!known) return {};
  HtmlTable table({{"Number"_html, Column::words}, {"Value"_html}, {"What it says"_html, Column::words}});
  table.row({"Elo"_html, text(signed_text(known->elo, 1)),
             enough_for_interval(meeting.pairs)
                 ? "strength: 400 Elo mean odds of ten to one"_html
                 : "strength: 400 Elo mean odds of ten to one. Too few pairs for a reliable interval"_html});
  Html divided = "strength divided by the spread of a match: how soon a test sees it"_html;
  if (const std::string why = why_no_interval(known->law); !why.empty()) divided << text(". " + why);
  table.row({"Normalised Elo"_html, text(signed_text(known->normalized_elo, 1)), divided});
  table.row({"Pairs by points"_html, text(fmt::format("{}", fmt::join(meeting.pairs.seen, " · "))),
             "both lost · lost and drawn · even · won and drawn · both won"_html});
  table.row({"Pairs won to lost"_html, text(known->pair_ratio ? fixed(*known->pair_ratio, 2) : "–"),
             text(fmt::format("{:.1f} % of pairs ended even", 100.0 * known->draw_ratio))});
  const bool played = fixed_number_is_played(source);
  if (played) {
    table.row({"Sign-flip test"_html, text(fmt::format("p {:.2g}", p_values(source.view.course).single.front())),
               meeting.unplayed_pairs == 0
                   ? "probability of a result as clear as this if the teams were equal"_html
                   : "the same; pairs that could not be played are counted for the team that makes p larger"_html});
  }
  table.row({"Goal difference of a match"_html,
             text(fmt::format("{} {}", with_sign(meeting.goals_of_pairs.mean(), 3),
                              signed_interval_text(meeting.goals_sequence.interval(), 3))),
             "anytime-valid interval"_html});
  if (played && known->goals_t && meeting.unplayed_pairs == 0) {
    table.row({"The same, for this number of pairs"_html, text(signed_interval_text(known->goals_t->interval, 3)),
               text(fmt::format("t test: p {:.2g}", known->goals_t->p))});
  }
  add_test(table, meeting, source);
  return table.html();
}

// Share of the points of the row's team against that of the column.
Html cross_table(const PageSource& source) {
  const std::vector<Ranked> ranks = ranking(source.view.plan, source.view.course);
  if (ranks.size() > most_crossed || source.view.plan.asked.format == config::Tournament::Format::gauntlet) return {};
  const statistics::SquareTable won = points_won(source.view.plan, source.view.course);
  std::vector<Heading> headings{{"Share of points, %"_html, Column::words}};
  for (std::size_t i = 0; i < ranks.size(); ++i) headings.push_back({text(fmt::format("{}", i + 1))});
  HtmlTable table(headings);
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    Html who = text(fmt::format("{} ", i + 1));
    std::vector<Html> cells{who << team_name(source, ranks[i].team)};
    for (const Ranked& other : ranks) {
      const double mine = won.at(ranks[i].team, other.team), all = mine + won.at(other.team, ranks[i].team);
      if (all == 0.0 || other.team == ranks[i].team) {
        cells.push_back("–"_html);
        continue;
      }
      const double share = 100.0 * mine / all;
      // A ground of the first or the second colour, the stronger the farther from one half.
      Html cell = "<span style=\"background:color-mix(in srgb,var(--series-"_html;
      cells.push_back(cell << (share >= 50.0 ? "1"_html : "2"_html)
                           << text(fmt::format(") {:.0f}%,transparent)", std::abs(share - 50.0) * 0.9)) << "\">"_html
                           << text(fmt::format("{:.0f}", share)) << "</span>"_html);
    }
    table.row(cells);
  }
  Html out = "<h3>All against all</h3>\n<div class=\"heat\">"_html;
  return out << table.html() << "</div>\n"_html;
}

Html pairings_table(const PageSource& source) {
  const bool with_p = fixed_number_is_played(source);
  std::vector<Heading> headings{
      {"Pairing"_html, Column::words}, {"Won – drawn – lost"_html}, {"Goals"_html}, {"Elo"_html}};
  const bool with_unplayed = source.view.course.unplayed_pairs() > 0;
  if (with_unplayed) headings.push_back({"Pairs not played"_html});
  if (with_p) headings.push_back({"p (Holm)"_html});
  HtmlTable table(headings);
  const std::vector<double> p = p_values(source.view.course).adjusted;
  for (std::size_t i = 0; i < std::min(p.size(), most_listed); ++i) {
    const Meeting& meeting = source.view.course.meetings()[i];
    const auto& [losses, draws, wins] = meeting.games.seen;
    const std::optional<Strength> known = strength(source.view.course, meeting);
    Html who = team_name(source, meeting.pairing.first);
    std::vector<Html> cells{who << " – "_html << team_name(source, meeting.pairing.second),
                            text(fmt::format("{} – {} – {}", wins, draws, losses)),
                            text(fmt::format("{}:{}", meeting.goals[0], meeting.goals[1])),
                            text(known ? signed_text(known->elo, 1) : "–")};
    if (with_unplayed) cells.push_back(count(meeting.unplayed_pairs));
    if (with_p) cells.push_back(text(fmt::format("{:.2g}", p[i])));
    table.row(cells);
  }
  Html out;
  out << (p.size() > most_open_pairings ? "<details><summary>"_html : "<details open><summary>"_html)
      << text(fmt::format("{} pairings, from the point of view of the team named first", p.size()))
      << "</summary>\n"_html << table.html();
  if (p.size() > most_listed) out << "<p class=\"note\">regista report --json has the others.</p>\n"_html;
  return out << "</details>\n"_html;
}

}  // namespace

Html standing_section(const PageSource& source) {
  if (is_without_verdict(source.view.plan, source.view.course)) return {};
  Html out = teams_table(source);
  if (source.view.plan.teams.size() == 2) {
    out << pairing_table(source);
  } else {
    out << figure(source, "ranking") << cross_table(source) << pairings_table(source)
        << "<p class=\"note\">Elo of the ranking: Bradley and Terry, sum 0. Its margins count pairs and draws, and so do the intervals of the pairings. A team has no margin if fewer than 10 of its pairs were uneven, or if it won or lost all. These are rough where fewer than 10 pairs were not even. Nash share: probability of the team in the Nash equilibrium. p: two-sided sign-flip test, corrected by Holm for the number of pairings.</p>\n"_html;
  }
  return section("standing", "Standing"_html, out);
}

Html curves_section(const PageSource& source) {
  if (is_without_verdict(source.view.plan, source.view.course)) return {};
  const Html elo = figure(source, "elo"), llr = figure(source, "llr"), value = figure(source, "value");
  if (elo.empty() && llr.empty() && value.empty()) return {};
  Html out;
  if (source.view.plan.teams.size() == 2) {
    out << "<div class=\"two\">\n"_html << elo << llr << value << "</div>\n"_html;
    if (elo.empty()) {
      out << "<p class=\"note\">One team took every point of every pair, so its Elo is infinite.</p>\n"_html;
    }
  } else {
    out << elo;
  }
  return section("curves", "Course of the tournament"_html, out);
}

Html variance_section(const PageSource& source) {
  HtmlTable table({{"Pairing"_html, Column::words}, {"of scores"_html}, {"of goals"_html}});
  const auto ratio = [](const std::optional<double>& value) { return text(value ? fixed(*value, 2) : "–"); };
  std::size_t listed = 0;
  for (const Meeting& meeting : source.view.course.meetings()) {
    const std::optional<Strength> known = strength(source.view.course, meeting);
    if (!known || ++listed > most_listed) continue;
    Html who = team_name(source, meeting.pairing.first);
    table.row({who << " – "_html << team_name(source, meeting.pairing.second), ratio(known->score_ratio),
               ratio(known->goals_ratio)});
  }
  if (table.empty()) return {};
  Html out =
      "<p>A pair is two matches with the same seed and scene, the sides swapped. The ratio compares the number of matches that are needed with pairs and with independent matches: at 0.5 pairs need half as many, at 1 as many, above 1 more.</p>\n"_html;
  if (listed > most_open_pairings) {
    out << "<details><summary>"_html << text(fmt::format("{} pairings", listed)) << "</summary>\n"_html << table.html()
        << "</details>\n"_html;
  } else {
    out << table.html();
  }
  return section("variance", "Variance ratio of pairing"_html, out);
}

}  // namespace regista::report
