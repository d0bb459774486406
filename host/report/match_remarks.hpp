// SPDX-License-Identifier: MIT
// What the reports of all studies say of single matches besides their results: at the top those in which robots did not
// decide alone and those that came out otherwise when they were played a second time; beside the verdict those that
// could not be played and those that were forfeited; at the end those in which plugins wrote to standard error. Matches
// are counted from 1.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "campaign/limits.hpp"
#include "report/outline.hpp"
#include "study/forfeits.hpp"
#include "study/match_remarks.hpp"

namespace regista::report {

std::string pairs_in_words(std::uint64_t count);  // "1 pair", "2 pairs"

// "No verdict: 3 pairs could not be played"
std::string prevented_headline(std::uint64_t pairs);

// "1 pair could not be played and counts nowhere: ..."; empty without one. In one sentence.
std::string unplayed_sentence(std::uint64_t pairs);

// What precedes the headline where robots did not decide alone, or need not: "Not a result of robots that decide
// alone: ". Mostly empty.
std::string caution(const study::MatchRemarks& remarks, const campaign::Limits& limits);

// Each empty where there is nothing to report.
Section doubts(const study::MatchRemarks& remarks);  // "not reproducible: match 1: ..."
Section unplayed_section(std::uint64_t pairs, const study::MatchRemarks& remarks);
Section notes_on(const study::MatchRemarks& remarks);  // where plugins wrote to standard error, ...

// "plugin hangs"; where only the team is known "a plugin of small"
std::string plugin_text(const std::string& plugin, const std::string& team);
// "forfeited by small: plugin hangs, holds: used more than 5 s of processor time"
std::string forfeit_text(const std::string& label, const campaign::Failure& failure);

// How a study speaks of forfeits.
struct ForfeitWords {
  std::function<std::string(std::size_t team)> label;
  std::function<std::string(std::uint64_t match)> again;  // the command that plays a match by itself; may be empty
  std::string how_they_count;                             // a sentence; may be empty
};
Section forfeits_section(const study::ForfeitList& forfeits, const ForfeitWords& words);
// who: the key of the team.
nlohmann::ordered_json forfeits_json(const study::ForfeitList& forfeits, const ForfeitWords& words, const char* who);

// {"pairs", "matches", "listed": [{"match", "what"}]}
nlohmann::ordered_json unplayed_json(std::uint64_t pairs, const study::MatchRemarks& remarks);
// Adds "not_alone", "broken_promises", "not_reproducible", "not_proven" and "kept_outside", each {"matches", "listed":
// [{"match", "what"}]}, and "standard_error", {"matches", "listed": [1, 2]}.
void add_remarks(const study::MatchRemarks& remarks, nlohmann::ordered_json& out);

}  // namespace regista::report
