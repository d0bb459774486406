// SPDX-License-Identifier: MIT
// What the reports of all studies say of single matches besides their results: those in which robots did not decide
// alone, and those that came out otherwise when they were played a second time, stand at the top; those that could not
// be played beside the verdict, those in which plugins wrote to standard error at the end. Matches are counted from 1.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "campaign/limits.hpp"
#include "report/html.hpp"
#include "study/match_remarks.hpp"

namespace regista::report {

std::string pairs_in_words(std::uint64_t count);  // "1 pair", "2 pairs"

// "No verdict: 3 pairs could not be played"
std::string prevented_headline(std::uint64_t pairs);

// "1 pair could not be played and counts nowhere: ..."; empty without one. In one sentence.
std::string unplayed_sentence(std::uint64_t pairs);

// What stands before the headline where robots did not decide alone, or need not: "Not a result of robots that decide
// alone: ". Mostly empty.
std::string caution(const study::MatchRemarks& remarks, const campaign::Limits& limits);

// Lines, each ended; empty where there is nothing to report.
std::string doubts_text(const study::MatchRemarks& remarks);    // "not reproducible: match 1: ..."
std::string unplayed_text(const study::MatchRemarks& remarks);  // "  match 5: ..."
std::string notes_text(const study::MatchRemarks& remarks);     // where plugins wrote to standard error, ...

// Adds "not_alone", "not_reproducible" and "not_proven", each {"matches", "listed": [{"match", "what"}]}.
void add_doubts(const study::MatchRemarks& remarks, nlohmann::ordered_json& out);
// The same, with "pairs".
nlohmann::ordered_json unplayed_json(std::uint64_t pairs, const study::MatchRemarks& remarks);
// Adds "kept_outside", as those of add_doubts, and "standard_error", {"matches", "listed": [1, 2]}.
void add_notes(const study::MatchRemarks& remarks, nlohmann::ordered_json& out);

// The same for a page; empty where there is nothing to report.
Html doubts_note(const study::MatchRemarks& remarks);
Html unplayed_section(std::uint64_t pairs, const study::MatchRemarks& remarks);
Html remarks_note(const study::MatchRemarks& remarks);

}  // namespace regista::report
