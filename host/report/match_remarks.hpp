// SPDX-License-Identifier: MIT
// Texts that the reports of all studies share. Some texts are about single matches, which are counted from 1. At the
// top of a report: matches in which robots did not decide alone, or whose replay ended differently. Beside the verdict:
// matches that were forfeited or could not be played. At the end: matches in which plugins wrote to standard error.
// Other texts are about the packets of games shorter than a match, and about the number of pairs.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "report/outline.hpp"
#include "statistics/counts.hpp"
#include "study/experiment_plan.hpp"
#include "study/measure.hpp"
#include "study/tournament_plan.hpp"

namespace regista::report {

std::string pairs_in_words(std::uint64_t count);  // "1 pair", "2 pairs"
// "120"; "above 1000000000" for nothing, as statistics::pairs_needed() returns it.
std::string pairs_text(const std::optional<std::int64_t>& pairs);

// Returns a headline: "No verdict: 3 pairs could not be played"
std::string prevented_headline(std::uint64_t pairs);

// Returns the sentence "1 pair could not be played and counts nowhere: ..."; empty if all pairs were played.
std::string unplayed_sentence(std::uint64_t pairs);

// Returns the beginning of the headline if robots shared memory or were allowed to share memory; otherwise "".
std::string caution(const study::MatchRemarks& remarks, const campaign::Limits& limits);

// These functions return an empty section if no match has a remark of this kind.
Section doubts(const study::MatchRemarks& remarks);  // lines such as "not reproducible: match 1: ..."
Section unplayed_section(std::uint64_t pairs, const study::MatchRemarks& remarks);
Section notes_on(const study::MatchRemarks& remarks);  // lines about plugins that wrote to standard error

// Describes a forfeit: "forfeited by small: plugin hangs, holds: used more than 5 s of processor time"
std::string forfeit_text(const std::string& label, const campaign::Failure& failure);
// Returns ", could not be played: ..." or ", forfeited by small: ..."; empty for a match that was played to its end.
std::string how_it_ended(const campaign::MatchResult& decided, const std::array<std::string, 2>& sides);

struct ForfeitWords {
  std::function<std::string(std::size_t team)> label;     // returns the name of a team
  std::function<std::string(std::uint64_t match)> again;  // makes the command that plays a single match; may be empty
  std::string how_they_count;                             // sentence that says how forfeits count; may be empty
};
Section forfeits_section(const study::ForfeitList& forfeits, const ForfeitWords& words);
// who: JSON key for the name of the team.
nlohmann::ordered_json forfeits_json(const study::ForfeitList& forfeits, const ForfeitWords& words, const char* who);

// Returns {"pairs", "matches", "listed": [{"match", "what"}]}.
nlohmann::ordered_json unplayed_json(std::uint64_t pairs, const study::MatchRemarks& remarks);
// Adds the keys "not_alone", "broken_promises", "not_reproducible", "not_proven" and "kept_outside", each with
// {"matches", "listed": [{"match", "what"}]}, and "standard_error" with {"matches", "listed": [1, 2]}.
void add_remarks(const study::MatchRemarks& remarks, nlohmann::ordered_json& out);

// --- The packets of games shorter than a match, compared with the share of the budget for such a length. Each game
// allows the budget of a whole match; a team counts as above its share if it spent more than 105 % of this share.

// "spent 45 packets per match, more than the share of the budget for this length: 30". Empty without shorter games.
std::string packets_clause(const study::PacketsSpent& packets);

// Returns {"per_match", "share", "above_share"}; null without shorter games.
nlohmann::ordered_json packets_json(const study::PacketsSpent& packets);

// --- Sentences about the number of pairs: too few pairs for a verdict, a time limit (--until, --minutes) that ended
// the study, pairs that a user added after seeing the results. A test of scores needs uneven pairs: pairs in which one
// team has more points.

// "5 pairs cannot give a verdict: at least 6 are needed"; empty for enough pairs and for a sequential test.
std::string too_few_pairs(const study::TournamentPlan& plan);
std::string too_few_pairs(const study::ExperimentPlan& plan);

// "37 pairs, where the clock stopped it (100 were planned)"; "100 pairs" if no time limit has stopped the study.
std::string number_of_pairs(const study::TournamentPlan& plan);
std::string number_of_pairs(const study::ExperimentPlan& plan);

// "The clock stopped it after 37 of 100 pairs, a number that counts as fixed beforehand, unless ..."; otherwise "".
std::string stopped_sentence(const study::TournamentPlan& plan);
std::string stopped_sentence(const study::ExperimentPlan& plan);

// Adds notes for a user who continues the study: there are too few pairs for a verdict, or a time limit has ended it.
template <class Plan>
void add_notes_on_pairs(const Plan& plan, std::vector<std::string>& notes) {
  if (const std::string few = too_few_pairs(plan); !few.empty()) notes.push_back(few);
  if (plan.ended_after)
    notes.push_back(stopped_sentence(plan) + " It is complete; --pairs, --until or --minutes go on with it.");
}

// Returns a sentence about pairs that a user added. before: the earlier numbers of pairs, in the form of the plan.
std::string more_pairs_sentence(const std::string& before);

// Returns sentences that say why Elo lacks an interval or a bound, or why normalised Elo lacks an interval; else "".
std::string why_no_interval(const statistics::ScoreLaw& law);

// Returns a warning if a test of scores has fewer uneven pairs than statistics::fewest_uneven; otherwise "".
std::string what_the_test_rests_on(const statistics::ScoreLaw& law);

// Returns a sentence that says why a team of a ranking may have an Elo without a margin.
std::string no_margin_of_team();

}  // namespace regista::report
