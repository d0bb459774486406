// SPDX-License-Identifier: MIT
#include "report/match_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "report/html_table.hpp"
#include "report/page_parts.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

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
  return fmt::format("match {}: {}; nothing came of it in this match", first.match + 1, texts::visible(first.text));
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

std::string doubts_text(const study::MatchRemarks& remarks) {
  std::string out;
  for (const Doubt& doubt : doubts_of(remarks)) {
    for (const study::MatchRemark& each : doubt.list.listed())
      out += fmt::format("{}: match {}: {}\n", doubt.words, each.match + 1, texts::visible(each.text));
    if (doubt.list.unlisted() > 0)
      out += fmt::format("{}: {} more\n", doubt.words, matches_in_words(doubt.list.unlisted()));
  }
  return out;
}

std::string unplayed_text(const study::MatchRemarks& remarks) {
  std::string out;
  const study::RemarkList& list = remarks.unplayed();
  for (const study::MatchRemark& each : list.listed()) {
    out += fmt::format("  match {}: {}\n", each.match + 1, texts::visible(each.text));
  }
  if (list.unlisted() > 0) out += fmt::format("  and {} more\n", matches_in_words(list.unlisted()));
  return out;
}

std::string notes_text(const study::MatchRemarks& remarks) {
  std::string out = remarks.kept().count() == 0 ? std::string() : kept_sentence(remarks) + '\n';
  return remarks.written_count() == 0 ? out : out + written_sentence(remarks) + '\n';
}

void add_doubts(const study::MatchRemarks& remarks, Json& out) {
  for (const Doubt& doubt : doubts_of(remarks))
    out[doubt.key] = {{"matches", doubt.list.count()}, {"listed", listed(doubt.list)}};
}

Json unplayed_json(std::uint64_t pairs, const study::MatchRemarks& remarks) {
  return {{"pairs", pairs}, {"matches", remarks.unplayed().count()}, {"listed", listed(remarks.unplayed())}};
}

void add_notes(const study::MatchRemarks& remarks, Json& out) {
  out["kept_outside"] = {{"matches", remarks.kept().count()}, {"listed", listed(remarks.kept())}};
  Json matches = Json::array();
  for (const std::uint64_t each : remarks.written()) matches.push_back(each + 1);
  out["standard_error"] = {{"matches", remarks.written_count()}, {"listed", matches}};
}

Html doubts_note(const study::MatchRemarks& remarks) {
  Html out;
  for (const Doubt& doubt : doubts_of(remarks)) {
    if (doubt.list.count() == 0) continue;
    std::string words = doubt.words, id = doubt.key;
    words.front() = static_cast<char>(std::toupper(words.front()));
    std::ranges::replace(id, '_', '-');
    out << "<div id=\""_html << text(id) << "\">\n"_html;
    for (const study::MatchRemark& each : doubt.list.listed()) {
      out << "<p><strong>"_html << text(words) << ":</strong> "_html
          << text(fmt::format("match {}: {}", each.match + 1, each.text)) << "</p>\n"_html;
    }
    if (doubt.list.unlisted() > 0) {
      out << "<p>"_html << text(fmt::format("And {} more.", matches_in_words(doubt.list.unlisted()))) << "</p>\n"_html;
    }
    out << "</div>\n"_html;
  }
  return out;
}

Html unplayed_section(std::uint64_t pairs, const study::MatchRemarks& remarks) {
  const study::RemarkList& list = remarks.unplayed();
  if (list.count() == 0) return {};
  HtmlTable table({{"Match"_html}, {"What happened"_html, Column::words}});
  for (const study::MatchRemark& each : list.listed()) {
    table.row({text(fmt::format("{}", each.match + 1)), text(each.text)});
  }
  Html out = "<p>"_html;
  out << text(fmt::format("{} left out of every number, with both matches.",
                          texts::counted(pairs, "pair is", "pairs are")))
      << "</p>\n<div class=\"values\">"_html << table.html() << "</div>\n"_html;
  if (list.unlisted() > 0) {
    out << "<p>"_html << text(fmt::format("And {} more.", matches_in_words(list.unlisted()))) << "</p>\n"_html;
  }
  return section("unplayed", "Matches that could not be played"_html, out);
}

Html remarks_note(const study::MatchRemarks& remarks) {
  Html out;
  const auto add = [&out](const char* id, std::string sentence) {
    sentence.front() = static_cast<char>(std::toupper(sentence.front()));
    out << "<p class=\"note\" id=\""_html << text(id) << "\">"_html << text(sentence) << "</p>\n"_html;
  };
  if (remarks.kept().count() > 0) add("kept-outside", kept_sentence(remarks));
  if (remarks.written_count() > 0) add("standard-error", written_sentence(remarks));
  return out;
}

}  // namespace regista::report
