// SPDX-License-Identifier: MIT
#include "report/match_remarks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <optional>

#include "report/number.hpp"
#include "statistics/paired_tests.hpp"
#include "statistics/rating.hpp"
#include "study/paired_estimates.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

std::string matches_in_words(std::uint64_t count) { return texts::plural(count, "match", "matches"); }

Json listed(const study::RemarkList& list) {
  Json out = Json::array();
  for (const study::MatchRemark& each : list.listed()) out.push_back({{"match", each.match + 1}, {"what", each.text}});
  return out;
}

// A kind of doubt about matches, with its words for text and JSON. doubts_of() returns the most serious kind first.
struct Doubt {
  const study::RemarkList& list;
  const char *words, *key;
};
std::array<Doubt, 4> doubts_of(const study::MatchRemarks& remarks) {
  return {{{remarks.shared, "robots do not decide alone", "not_alone"},
           {remarks.broken, "a plugin breaks a promise", "broken_promises"},
           {remarks.irreproducible, "not reproducible", "not_reproducible"},
           {remarks.unproven, "not proven that robots decide alone", "not_proven"}}};
}

// Returns a sentence if there are too few pairs for a verdict. what: word for the tested things, such as "pairings".
std::string too_few(std::uint64_t pairs, const statistics::PowerDesign& design, const char* what) {
  const auto needed = static_cast<std::uint64_t>(statistics::smallest_pairs(design));
  if (pairs >= needed) return {};
  return fmt::format("{} cannot give a verdict: at least {} are needed{}", pairs_in_words(pairs), needed,
                     design.family == 1 ? std::string() : fmt::format(" with {} {}", design.family, what));
}

// chosen: whether results may have decided the number, because the user went on after a look, or by a sequential test.
std::string stopped(std::optional<std::uint64_t> after, const std::string& of, bool chosen) {
  if (!after) return {};
  return fmt::format(
      "The clock stopped it after {}{} {}{}.", *after, of, *after == 1 && of.empty() ? "pair" : "pairs",
      chosen ? "" : ", a number that counts as fixed beforehand, unless the clock was set anew after a look");
}

std::string number(std::optional<std::uint64_t> after, std::uint64_t planned, std::string_view open_end) {
  if (!after)
    return open_end.empty() ? pairs_in_words(planned) : fmt::format("pairs until {} ends the study", open_end);
  return pairs_in_words(*after) + ", where the clock stopped it" +
         (open_end.empty() ? fmt::format(" ({} {} planned)", planned, planned == 1 ? "was" : "were") : "");
}

struct Words {
  const char *one, *more;
};

Words words_of(const statistics::ScoreLaw& law) {
  return law.unit == statistics::Unit::pair ? Words{"pair", "pairs"} : Words{"game", "games"};
}

std::uint64_t units_of(const statistics::ScoreLaw& law) {
  return static_cast<std::uint64_t>(std::accumulate(law.seen.begin(), law.seen.end(), statistics::Count{0}));
}

// Returns the beginning of a sentence about all games or all pairs: "The only game was", "All 30 pairs were".
std::string all_of(const statistics::ScoreLaw& law) {
  const auto [one, more] = words_of(law);
  const std::uint64_t units = units_of(law);
  return units == 1 ? fmt::format("The only {} was", one) : fmt::format("All {} {} were", units, more);
}

}  // namespace

std::string pairs_in_words(std::uint64_t count) { return texts::plural(count, "pair", "pairs"); }

std::string pairs_text(const std::optional<std::int64_t>& pairs) {
  return pairs ? std::to_string(*pairs) : fmt::format("above {}", statistics::most_pairs_asked);
}

std::string prevented_headline(std::uint64_t pairs) {
  return fmt::format("No verdict: {} could not be played", pairs_in_words(pairs));
}

std::string unplayed_sentence(std::uint64_t pairs) {
  if (pairs == 0) return {};
  return fmt::format(
      "{} could not be played and {} left out of every number: no team can be blamed for the crashes in {}. What is "
      "found holds for whichever team {} counted.",
      pairs_in_words(pairs), pairs == 1 ? "is" : "are", pairs == 1 ? "it" : "them", pairs == 1 ? "it is" : "they are");
}

std::string caution(const study::MatchRemarks& remarks, const campaign::Limits& limits) {
  if (limits.allow_shared_memory) return "Robots of a team may share memory here: ";
  return remarks.shared.count() > 0 ? "Not a result of robots that decide alone: " : "";
}

Section doubts(const study::MatchRemarks& remarks) {
  Section out("doubts", "");
  for (const Doubt& doubt : doubts_of(remarks)) {
    for (const study::MatchRemark& each : doubt.list.listed())
      out.line(strong(fmt::format("{}:", doubt.words)) << fmt::format(" match {}: {}", each.match + 1, each.text));
    if (doubt.list.unlisted() > 0)
      out.line(strong(fmt::format("{}:", doubt.words))
               << fmt::format(" {} more", matches_in_words(doubt.list.unlisted())));
  }
  return out;
}

Section unplayed_section(std::uint64_t pairs, const study::MatchRemarks& remarks) {
  Section out("unplayed", "Matches that could not be played");
  const study::RemarkList& list = remarks.unplayed;
  if (list.count() == 0) return out;
  out.line(fmt::format("{} left out of every number, with both matches; no team can be blamed.",
                       texts::plural(pairs, "pair is", "pairs are")));
  std::vector<Sentence> lines;
  for (const study::MatchRemark& each : list.listed())
    lines.push_back(fmt::format("match {}: {}", each.match + 1, each.text));
  if (list.unlisted() > 0) lines.push_back(fmt::format("and {} more", matches_in_words(list.unlisted())));
  out.list(std::move(lines));
  return out;
}

Section notes_on(const study::MatchRemarks& remarks) {
  Section out("remarks", "");
  if (remarks.kept.count() > 0) {
    const study::MatchRemark& first = remarks.kept.listed().front();
    out.note(fmt::format("match {}: {}; nothing came of it in this match", first.match + 1, first.text));
  }
  if (remarks.written_count > 0) {
    out.note(fmt::format(
        "plugins wrote to standard error in {0}, first in match {1}; see: regista report FILE --standard-error {1}",
        matches_in_words(remarks.written_count), remarks.written.front() + 1));
  }
  return out;
}

std::string forfeit_text(const std::string& label, const campaign::Failure& failure) {
  const std::string plugin = failure.plugin.empty() ? "a plugin of " + label : "plugin " + failure.plugin;
  std::string out = fmt::format("forfeited by {}: {}", label, plugin);
  if (!failure.call.empty()) out += ", " + failure.call;
  return texts::one_line(out + ": " + failure.what);
}

std::string how_it_ended(const campaign::MatchResult& decided, const std::array<std::string, 2>& sides) {
  if (decided.set_aside()) return ", could not be played: " + texts::one_line(decided.why_set_aside);
  if (!decided.failure) return {};
  return ", " + forfeit_text(sides[static_cast<std::size_t>(decided.failure->side)], *decided.failure);
}

Section forfeits_section(const study::ForfeitList& forfeits, const ForfeitWords& words) {
  Section out("failures", "Forfeits");
  if (forfeits.listed().empty()) return out;
  out.line(words.how_they_count);
  std::vector<Sentence> lines;
  for (const study::Forfeits& each : forfeits.listed()) {
    const std::string label = words.label(each.team);
    Sentence line = matches_in_words(each.count) + " forfeited by ";
    line << named(label) << ": "
         << (each.failure.plugin.empty() ? Sentence("a plugin of ") << named(label)
                                         : Sentence("plugin " + each.failure.plugin));
    if (!each.failure.call.empty()) line << ", " + each.failure.call;
    line << ": " + each.failure.what;
    if (words.again)
      line << "; the first again: " << code(words.again(each.first_match));
    else
      line << fmt::format("; first in match {}", each.first_match + 1);
    lines.push_back(std::move(line));
  }
  if (const std::uint64_t more = forfeits.unlisted(); more > 0)
    lines.push_back(texts::plural(more, "more match", "more matches") + " forfeited for other reasons");
  out.list(std::move(lines));
  return out;
}

Json forfeits_json(const study::ForfeitList& forfeits, const ForfeitWords& words, const char* who) {
  Json out = Json::array();
  for (const study::Forfeits& each : forfeits.listed()) {
    out.push_back({{who, words.label(each.team)},
                   {"plugin", each.failure.plugin},
                   {"call", each.failure.call},
                   {"what", each.failure.what},
                   {"matches", each.count},
                   {"first_match", each.first_match + 1}});
    if (words.again) out.back()["again"] = words.again(each.first_match);
  }
  return out;
}

Json unplayed_json(std::uint64_t pairs, const study::MatchRemarks& remarks) {
  return {{"pairs", pairs}, {"matches", remarks.unplayed.count()}, {"listed", listed(remarks.unplayed)}};
}

void add_remarks(const study::MatchRemarks& remarks, Json& out) {
  for (const Doubt& doubt : doubts_of(remarks))
    out[doubt.key] = {{"matches", doubt.list.count()}, {"listed", listed(doubt.list)}};
  out["kept_outside"] = {{"matches", remarks.kept.count()}, {"listed", listed(remarks.kept)}};
  Json matches = Json::array();
  for (const std::uint64_t each : remarks.written) matches.push_back(each + 1);
  out["standard_error"] = {{"matches", remarks.written_count}, {"listed", matches}};
}

std::string packets_clause(const study::PacketsSpent& packets) {
  if (packets.games() == 0) return {};
  return fmt::format("spent {:.4g} packets per match{} the share of the budget for this length{} {:.4g}",
                     packets.spent(), packets.above_share() ? ", more than" : ";", packets.above_share() ? ":" : " is",
                     packets.share());
}

nlohmann::ordered_json packets_json(const study::PacketsSpent& packets) {
  if (packets.games() == 0) return nullptr;
  return {{"per_match", packets.spent()}, {"share", packets.share()}, {"above_share", packets.above_share()}};
}

std::string too_few_pairs(const study::TournamentPlan& plan) {
  // A tournament in rounds ranks its teams, and does not test each meeting.
  return plan.asked.test || plan.rounds() > 0 ? std::string()
                                              : too_few(plan.pairs_to_its_end(), study::design_of(plan), "pairings");
}

std::string too_few_pairs(const study::ExperimentPlan& plan) {
  if (plan.primary().empty() || plan.comparisons().empty()) return {};
  return too_few(plan.pairs_to_its_end(), study::design_of(plan), "comparisons");
}

std::string number_of_pairs(const study::TournamentPlan& plan) {
  return number(plan.ended_after, plan.pairs(), plan.open_end());
}

std::string number_of_pairs(const study::ExperimentPlan& plan) { return number(plan.ended_after, plan.pairs, {}); }

std::string stopped_sentence(const study::TournamentPlan& plan) {
  return stopped(plan.ended_after, plan.open_end().empty() ? fmt::format(" of {}", plan.pairs()) : std::string(),
                 plan.asked.test || !plan.pairs_before.empty());
}

std::string stopped_sentence(const study::ExperimentPlan& plan) {
  return stopped(plan.ended_after, fmt::format(" of {}", plan.pairs), !plan.pairs_before.empty());
}

std::string more_pairs_sentence(const std::string& before) {
  return fmt::format(
      "Before it was given more it had so many pairs: {}. A p value and an interval hold for a number that was fixed "
      "beforehand: adding pairs until the result pleases finds differences that do not exist.",
      before);
}

std::string why_no_interval(const statistics::ScoreLaw& law) {
  if (law.uneven() == 0) return all_of(law) + " even, so there is no interval.";
  const auto [one, more] = words_of(law);
  const auto [low, high] = statistics::score_interval(law);
  std::string out;
  if (low > 0.0 && high == 1.0) out = fmt::format("At least {:.0f} %", std::floor(100.0 * low));
  if (low == 0.0 && high < 1.0) out = fmt::format("At most {:.0f} %", std::ceil(100.0 * high));
  if (!out.empty()) out += " of the points, with 97.5 % confidence: Elo has this bound alone.";
  switch (statistics::few_for_spread(law)) {
    case statistics::FewForSpread::no:
      break;
    case statistics::FewForSpread::won:
      return fmt::format("{}{}One team won every {}, so nElo has no interval.", out, out.empty() ? "" : " ", one);
    case statistics::FewForSpread::uneven:
      if (out.empty())
        return fmt::format("Fewer than {} {} were uneven, so Elo and nElo have no interval, and LOS is not known.",
                           statistics::fewest_uneven, more);
      return fmt::format("{} Fewer than {} {} were uneven, so nElo has no interval.", out, statistics::fewest_uneven,
                         more);
  }
  return out;
}

std::string what_the_test_rests_on(const statistics::ScoreLaw& law) {
  if (law.uneven() == 0) return all_of(law) + " even: the test takes this for equal strength.";
  if (law.uneven() >= statistics::fewest_uneven) return "";
  return fmt::format("The test rests on {} of {} that {} uneven.", law.uneven(),
                     texts::plural(units_of(law), words_of(law).one, words_of(law).more),
                     law.uneven() == 1 ? "was" : "were");
}

std::string no_margin_of_team() {
  return fmt::format("No margin: fewer than {} pairs of the team were uneven, or it won or lost all.",
                     statistics::fewest_uneven);
}

}  // namespace regista::report
