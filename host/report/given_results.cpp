// SPDX-License-Identifier: MIT
#include "report/given_results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/outline.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

const char* sprt_name(statistics::Verdict verdict) {
  return verdict == statistics::Verdict::accept_h0   ? "H0"
         : verdict == statistics::Verdict::accept_h1 ? "H1"
                                                     : "INCONCLUSIVE";
}

using Team = RankedResults::Team;

double share(const Team& team) { return team.games == 0 ? 0.5 : team.points / static_cast<double>(team.games); }

std::string elo_text(const Team& team) {
  if (!team.elo) return "-";
  const std::string value = fixed(team.elo->value, 1);
  return team.elo->interval.bounded() ? fmt::format("{} +/- {:.1f}", value, team.elo->margin()) : value;
}

std::uint64_t unsigned_count(statistics::Count count) { return static_cast<std::uint64_t>(count); }

std::string basis(const RankedResults& ranking) {
  if (ranking.pairs == 0) return "Margins hold with 95 % if all games are independent: the results name no pairs.\n";
  if (2 * ranking.pairs == ranking.games) return "Margins hold with 95 % and count pairs.\n";
  return "Margins hold with 95 % and count pairs, and games without a pair as independent.\n";
}

constexpr std::size_t most_listed = 20;  // largest number of comparisons that a terminal lists

struct Answer {
  std::array<double, 2> deviation{};                    // interval of the standard deviation
  std::array<std::optional<std::int64_t>, 3> needed{};  // number of pairs, and its interval
  std::optional<double> found{};
};

Answer answer(const study::ComparedPairs& pairs, const PowerQuestion& question) {
  const statistics::Spread spread(pairs.differences);
  const auto [low, high] = statistics::spread_interval(spread, pairs.differences.count());
  Answer out{{low.deviation, high.deviation}};
  const std::array<statistics::Spread, 3> spreads{spread, low, high};
  for (std::size_t i = 0; question.difference && i < spreads.size(); ++i)
    out.needed[i] = statistics::pairs_needed(*question.difference, spreads[i], question.design);
  if (question.pairs) out.found = statistics::difference_found(*question.pairs, spread, question.design);
  return out;
}

std::string number(double value) { return fmt::format("{:.3g}", value); }

// Returns the mean as text. Rounding may make a mean of 0 slightly different from 0; the text is then "0".
std::string mean_text(const statistics::Moments& values) {
  const double mean = values.mean();
  return number(std::abs(mean) < 1e-9 * values.standard_deviation() ? 0.0 : mean);
}

std::string test_line(const PowerQuestion& question) {
  const bool flips = question.design.test == statistics::PairedTest::sign_flip;
  std::string out = fmt::format("{} at {:.4g} %, two-sided", flips ? "Sign-flip test" : "Student's t test of pairs",
                                100.0 * question.design.alpha);
  if (question.design.family > 1) out += fmt::format(", by Holm for {} {}", question.design.family, question.several);
  return out + fmt::format(". It finds nothing with fewer than {} {}pairs.",
                           statistics::smallest_pairs(question.design), flips ? "uneven " : "");
}

Json or_null(const std::optional<std::int64_t>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

SequentialTestOfCounts test_counts(const std::vector<statistics::Count>& counts,
                                   const statistics::SequentialDesign& design) {
  SequentialTestOfCounts result{};
  result.counts = counts;
  result.design = design;
  const auto take = [&](auto units) {
    std::ranges::copy(counts, units.seen.begin());
    result.law = score_law(units);
    return units;
  };
  if (counts.size() == 5)
    result.pair_ratio = pair_ratio(take(statistics::PairCounts()));
  else
    take(statistics::GameCounts());
  result.bounds = sequential_bounds(design.rates);
  result.ratio = log_likelihood_ratio(result.law, design.model, design.hypotheses);
  result.elo = elo(result.law);
  result.normalized_elo = normalized_elo(result.law);
  result.superiority = likelihood_of_superiority(result.law);
  return result;
}

std::string counts_text(const SequentialTestOfCounts& result) {
  const bool of_pairs = result.law.unit == statistics::Unit::pair;
  std::string out = of_pairs ? "Pairs (LL, LD, WL+DD, WD, WW): " : "Games (L, D, W): ";
  out += fmt::format("{}\n", fmt::join(result.counts, ", "));
  out += fmt::format("Elo: {}, nElo: {}\n", with_margin(result.elo), with_margin(result.normalized_elo));
  out += result.superiority ? fmt::format("LOS: {:.2f} %", 100.0 * *result.superiority) : "LOS: -";
  if (result.pair_ratio) out += fmt::format(", pair ratio: {:.2f}", *result.pair_ratio);
  out += fmt::format("\nLLR: {:.3f} ({:.3f}, {:.3f}) [{}, {}] {}\n", result.ratio.value, result.bounds.lower,
                     result.bounds.upper, result.design.hypotheses.elo0, result.design.hypotheses.elo1,
                     name(result.design.model));
  if (result.ratio.method == statistics::Method::closed_form) {
    out += "The bounds are out of reach of such scores: the LLR is an approximation.\n";
  }
  // If all pairs or games are even, the sentence of what_the_test_rests_on() already says why there is no interval.
  const std::string why = result.law.uneven() > 0 ? why_no_interval(result.law) : "";
  for (const std::string& sentence : {why, what_the_test_rests_on(result.law)}) {
    if (!sentence.empty()) out += sentence + '\n';
  }
  out += fmt::format("Verdict: {}\n", sprt_name(verdict_on(result.ratio, result.bounds)));
  return out;
}

std::string counts_json(const SequentialTestOfCounts& result) {
  return text_of({{"unit", result.law.unit == statistics::Unit::pair ? "pairs" : "games"},
                  {"counts", result.counts},
                  {"model", name(result.design.model)},
                  {"elo0", result.design.hypotheses.elo0},
                  {"elo1", result.design.hypotheses.elo1},
                  {"alpha", result.design.rates.alpha},
                  {"beta", result.design.rates.beta},
                  {"llr", result.ratio.value},
                  {"llr_bounds", {result.bounds.lower, result.bounds.upper}},
                  {"llr_method", result.ratio.method == statistics::Method::exact ? "exact" : "closed_form"},
                  {"elo", result.elo.value},
                  {"elo_interval", json_of(result.elo.interval)},
                  {"nelo", result.normalized_elo.value},
                  {"nelo_interval", json_of(result.normalized_elo.interval)},
                  {"los", json_or_null(result.superiority)},
                  {"pair_ratio", json_or_null(result.pair_ratio)},
                  {"verdict", sprt_name(verdict_on(result.ratio, result.bounds))}});
}

RankedResults ranked(const study::ResultsOfTeams& results) {
  RankedResults out;
  out.remarks = results.remarks;
  for (const std::string& name : results.teams) out.teams.push_back({name, std::nullopt, 0.0, 0, 0});
  for (const statistics::Encounter& each : results.encounters) {
    const statistics::Count games = each.games_played();
    out.teams[each.first].points += each.points();
    out.teams[each.second].points += static_cast<double>(games) - each.points();
    out.teams[each.first].games += games;
    out.teams[each.second].games += games;
    out.games += games;
    out.pairs += total(each.pairs);
  }
  const std::vector<std::size_t> group = statistics::groups_that_met(out.teams.size(), results.encounters);
  for (std::size_t first = 0, groups = 0; first < group.size(); ++first) {
    if (group[first] != first) continue;
    std::vector<std::size_t> members, place(group.size());  // place of a team in the group
    for (std::size_t i = first; i < group.size(); ++i) {
      if (group[i] != first) continue;
      place[i] = members.size();
      members.push_back(i);
    }
    std::vector<statistics::Encounter> met;
    for (const statistics::Encounter& each : results.encounters) {
      if (group[each.first] == first && group[each.second] == first)
        met.push_back({place[each.first], place[each.second], each.pairs, each.games});
    }
    const auto elo = members.size() > 1 ? statistics::bradley_terry(members.size(), met) : std::nullopt;
    for (const std::size_t i : members) {
      out.teams[i].group = groups;
      if (elo) out.teams[i].elo = (*elo)[place[i]];
    }
    ++groups;
  }
  std::ranges::stable_sort(out.teams, [](const Team& x, const Team& y) {
    if (x.group != y.group) return x.group < y.group;
    return x.elo && y.elo && x.elo->value != y.elo->value ? x.elo->value > y.elo->value : share(x) > share(y);
  });
  return out;
}

std::string ranking_text(const RankedResults& ranking) {
  std::size_t widest = 4;
  for (const Team& each : ranking.teams) widest = std::max(widest, texts::one_line(each.name).size());
  std::string out = fmt::format("Ranking of {} by {}", texts::plural(ranking.teams.size(), "team", "teams"),
                                texts::plural(unsigned_count(ranking.games), "game", "games"));
  if (ranking.pairs > 0) out += fmt::format(", {}", texts::plural(unsigned_count(ranking.pairs), "pair", "pairs"));
  const std::size_t groups = ranking.teams.back().group + 1;
  if (groups > 1) out += fmt::format(", in {} groups that never met each other", groups);
  out += fmt::format(":\n{:>4}  {:{}}  {:>16}  {:>10}  {:>11}  {:>7}\n", "rank", "team", widest, "Elo", "games",
                     "points", "share");
  int rank = 0;
  std::size_t group = 0, with_elo = 0;
  bool without = false;
  for (const Team& each : ranking.teams) {
    if (each.group != group) {
      out += '\n';
      rank = 0;
      group = each.group;
    }
    out += fmt::format("{:>4}  {:{}}  {:>16}  {:>10}  {:>11.1f}  {:>5.1f} %\n", ++rank, texts::one_line(each.name),
                       widest, elo_text(each), each.games, each.points, 100.0 * share(each));
    without = without || (each.elo && !each.elo->interval.bounded());
    with_elo += each.elo ? 1 : 0;
  }
  if (with_elo < ranking.teams.size()) {
    out +=
        "The results do not determine all strengths: some teams have no game, took no point from the others, or "
        "lost none to them.\n";
  }
  if (with_elo > 0)
    out += fmt::format("Elo: Bradley and Terry, sum 0{}. {}", groups > 1 ? " in each group" : "", basis(ranking));
  if (without) out += no_margin_of_team() + '\n';
  for (const std::string& each : ranking.remarks) out += each + '\n';
  return out;
}

std::string ranking_json(const RankedResults& ranking) {
  Json teams = Json::array();
  for (const Team& each : ranking.teams) {
    teams.push_back({{"team", each.name},
                     {"group", each.group + 1},
                     {"elo", each.elo ? json_number(each.elo->value) : nullptr},
                     {"elo_interval", each.elo ? json_of(each.elo->interval) : nullptr},
                     {"games", each.games},
                     {"points", each.points}});
  }
  return text_of(
      {{"games", ranking.games}, {"pairs", ranking.pairs}, {"ranking", teams}, {"remarks", ranking.remarks}});
}

bool has_spread(const study::ComparedPairs& pairs) { return pairs.differences.standard_deviation() > 0.0; }

std::string power_text(const study::PairDifferences& study, const PowerQuestion& question) {
  Section out("power", "");
  out.line(fmt::format("{}, difference of pairs of matches, {}", study.measure, study.unit));
  out.line(test_line(question));
  Table table{{{question.what, Column::words}, {"Pairs"}, {"Uneven"}, {"Mean"}, {"Standard deviation"}}};
  if (question.difference) {
    table.headings.push_back({fmt::format("Pairs for {}", number(*question.difference))});
    table.headings.push_back({"95 %"});
  }
  if (question.pairs) table.headings.push_back({fmt::format("{} pairs find", *question.pairs)});
  std::optional<std::int64_t> most_needed;
  for (const study::ComparedPairs& each : study.compared) {
    std::vector<Cell> cells{named(each.first) << " – " << named(each.second), each.differences.count(),
                            each.differences.uneven(), mean_text(each.differences),
                            number(each.differences.standard_deviation())};
    if (has_spread(each)) {
      const Answer answers = answer(each, question);
      if (question.difference) {
        const auto& [needed, least, most] = answers.needed;
        cells.emplace_back(pairs_text(needed));
        most_needed = std::max(most_needed, std::optional(needed.value_or(statistics::most_pairs_asked)));
        cells.emplace_back(pairs_text(least) + " – " + pairs_text(most));
      }
      if (question.pairs) cells.emplace_back(answers.found ? number(*answers.found) : std::string("nothing"));
    } else {
      while (cells.size() < table.headings.size()) cells.emplace_back(each.equal ? "equal" : "–");
    }
    if (table.rows.size() < most_listed) table.row(std::move(cells));
  }
  out.table(std::move(table));
  if (study.compared.size() > most_listed)
    out.note(fmt::format("and {} more: --json", study.compared.size() - most_listed));
  if (most_needed && study.compared.size() > 1)
    out.note(
        fmt::format("{} pairs are enough for each of {} {}.", *most_needed, study.compared.size(), question.several));
  const std::string chance = fmt::format("with a probability of {:.4g} %", 100.0 * question.design.power);
  if (!question.origin.empty()) out.note(question.origin);
  if (question.difference) {
    out.note(
        fmt::format("So many pairs find a mean difference of {} {} {}. 95 %: what that number may be, as so few "
                    "pairs show the standard deviation.",
                    number(*question.difference), study.unit, chance));
  } else {
    out.note("--difference says which difference matters; then it prints how many pairs find it.");
  }
  if (question.pairs && *question.pairs >= statistics::smallest_pairs(question.design))
    out.note(
        fmt::format("{} pairs find a mean difference of the size in the last column {}.", *question.pairs, chance));
  if (question.design.test == statistics::PairedTest::sign_flip)
    out.note(
        "Sign flips do not count even pairs. The numbers assume the share of uneven pairs that these results have, or "
        "the share that the difference needs.");
  if (question.sequential)
    out.note("The study's own test is sequential and ends by itself. These numbers are of a fixed number of pairs.");
  return section_text(out);
}

std::string power_json(const study::PairDifferences& study, const PowerQuestion& question) {
  const statistics::PowerDesign& design = question.design;
  Json compared = Json::array();
  for (const study::ComparedPairs& each : study.compared) {
    const bool known = has_spread(each);
    const Answer answers = known ? answer(each, question) : Answer();
    const Json interval{or_null(answers.needed[1]), or_null(answers.needed[2])};
    compared.push_back({{"first", each.first},
                        {"second", each.second},
                        {"equal_by_construction", each.equal},
                        {"pairs", each.differences.count()},
                        {"even_pairs", each.differences.count() - each.differences.uneven()},
                        {"mean", each.differences.mean()},
                        {"standard_deviation", each.differences.standard_deviation()},
                        {"standard_deviation_interval", known ? Json(answers.deviation) : Json()},
                        {"pairs_needed", or_null(answers.needed[0])},
                        {"pairs_needed_interval", known && question.difference ? interval : Json()},
                        {"difference_found", json_or_null(answers.found)}});
  }
  const Json out{{"measure", study.measure},
                 {"unit", study.unit},
                 {"test", design.test == statistics::PairedTest::sign_flip ? "sign_flip" : "paired_t"},
                 {"alpha", design.alpha},
                 {"family", design.family},
                 {"smallest_pairs", statistics::smallest_pairs(design)},
                 {"power", design.power},
                 {"difference", json_or_null(question.difference)},
                 {"pairs", or_null(question.pairs)},
                 {"own_test_is_sequential", question.sequential},
                 {"comparisons", compared}};
  return text_of(out, 2);
}

}  // namespace regista::report
