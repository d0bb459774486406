// SPDX-License-Identifier: MIT
#include "report/match_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

std::string matches_in_words(std::uint64_t count) { return texts::counted(count, "match", "matches"); }

std::string written_sentence(const study::MatchRemarks& remarks) {
  const std::uint64_t first = remarks.written().front() + 1;
  return fmt::format(
      "plugins wrote to standard error in {}, first in match {}; see: regista report FILE --standard-error {}",
      matches_in_words(remarks.written_count()), first, first);
}

std::string kept_sentence(const study::MatchRemarks& remarks) {
  const study::MatchRemark& first = remarks.kept().listed().front();
  return fmt::format("match {}: {}; nothing came of it in this match", first.match + 1, first.text);
}

Json listed(const study::RemarkList& list) {
  Json out = Json::array();
  for (const study::MatchRemark& each : list.listed()) out.push_back({{"match", each.match + 1}, {"what", each.text}});
  return out;
}

// What is held against the matches of a study, the gravest first.
struct Doubt {
  const study::RemarkList& list;
  const char *words, *key;
};
std::array<Doubt, 4> doubts_of(const study::MatchRemarks& remarks) {
  return {{{remarks.shared(), "robots do not decide alone", "not_alone"},
           {remarks.broken(), "a plugin breaks a promise", "broken_promises"},
           {remarks.irreproducible(), "not reproducible", "not_reproducible"},
           {remarks.unproven(), "not proven that robots decide alone", "not_proven"}}};
}

}  // namespace

std::string pairs_in_words(std::uint64_t count) { return texts::counted(count, "pair", "pairs"); }

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
  return remarks.shared().count() > 0 ? "Not a result of robots that decide alone: " : "";
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
  const study::RemarkList& list = remarks.unplayed();
  if (list.count() == 0) return out;
  out.line(fmt::format("{} left out of every number, with both matches; no team can be blamed.",
                       texts::counted(pairs, "pair is", "pairs are")));
  std::vector<Sentence> lines;
  for (const study::MatchRemark& each : list.listed())
    lines.push_back(fmt::format("match {}: {}", each.match + 1, each.text));
  if (list.unlisted() > 0) lines.push_back(fmt::format("and {} more", matches_in_words(list.unlisted())));
  out.list(std::move(lines));
  return out;
}

Section notes_on(const study::MatchRemarks& remarks) {
  Section out("remarks", "");
  if (remarks.kept().count() > 0) out.note(kept_sentence(remarks));
  if (remarks.written_count() > 0) out.note(written_sentence(remarks));
  return out;
}

std::string plugin_text(const std::string& plugin, const std::string& team) {
  return plugin.empty() ? "a plugin of " + team : "plugin " + plugin;
}

std::string forfeit_text(const std::string& label, const campaign::Failure& failure) {
  std::string out = fmt::format("forfeited by {}: {}", label, plugin_text(failure.plugin, label));
  if (!failure.call.empty()) out += ", " + failure.call;
  return texts::one_line(out + ": " + failure.what);
}

Section forfeits_section(const study::ForfeitList& forfeits, const ForfeitWords& words) {
  Section out("failures", "Forfeits");
  if (forfeits.listed().empty()) return out;
  out.line(words.how_they_count);
  std::vector<Sentence> lines;
  for (const study::Forfeits& each : forfeits.listed()) {
    const std::string label = words.label(each.team);
    Sentence line = texts::counted(each.count, "match", "matches") + " forfeited by ";
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
    lines.push_back(texts::counted(more, "more match", "more matches") + " forfeited for other reasons");
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
  return {{"pairs", pairs}, {"matches", remarks.unplayed().count()}, {"listed", listed(remarks.unplayed())}};
}

void add_remarks(const study::MatchRemarks& remarks, Json& out) {
  for (const Doubt& doubt : doubts_of(remarks))
    out[doubt.key] = {{"matches", doubt.list.count()}, {"listed", listed(doubt.list)}};
  out["kept_outside"] = {{"matches", remarks.kept().count()}, {"listed", listed(remarks.kept())}};
  Json matches = Json::array();
  for (const std::uint64_t each : remarks.written()) matches.push_back(each + 1);
  out["standard_error"] = {{"matches", remarks.written_count()}, {"listed", matches}};
}

}  // namespace regista::report
