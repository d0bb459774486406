// SPDX-License-Identifier: MIT
// Where the numbers come from: matches to be looked at or played again, the teams' documents, versions and hashes.
#include <fmt/format.h>

#include <algorithm>

#include "config/node.hpp"
#include "report/configuration_difference.hpp"
#include "report/html_table.hpp"
#include "report/page_sections.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_compared = 8;    // teams whose documents stand beside each other
constexpr std::size_t most_documents = 40;  // that are shown in full
constexpr std::size_t most_rows = 1000;

Html code(std::string_view words) {
  Html out = "<code>"_html;
  return out << text(words) << "</code>"_html;
}

Html block(std::string_view content) {
  Html out = "<pre>"_html;
  return out << lines(content) << "</pre>\n"_html;
}

Html differences_table(const PageSource& source, std::span<const std::string> documents) {
  const std::vector<DifferingValue> rows = differing_values(documents);
  if (rows.empty()) return "<p>The resolved documents are the same.</p>\n"_html;
  std::vector<Heading> headings{{"Value"_html, Column::words}};
  for (std::size_t team = 0; team < documents.size(); ++team)
    headings.push_back({team_name(source, team), Column::words});
  HtmlTable table(headings);
  for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
    std::vector<Html> cells{code(rows[i].path)};
    for (const auto& value : rows[i].values) cells.push_back(value ? code(*value) : Html("–"_html));
    table.row(cells);
  }
  Html out = "<div class=\"values\">"_html;
  out << table.html() << "</div>\n"_html;
  if (rows.size() > most_rows) out << text(fmt::format("{} more values differ.", rows.size() - most_rows));
  return out;
}

Html hashes_table(const PageSource& source) {
  HtmlTable table({{"Input"_html, Column::words}, {"Hash of its content"_html, Column::words}});
  const auto add = [&](const campaign::Input& input) { table.row({text(input.name), code(input.hash)}); };
  const study::TournamentPlan& plan = source.view.plan;
  std::vector<campaign::Input> known;
  const auto add_all = [&](const std::vector<campaign::Input>& inputs) {
    for (const campaign::Input& input : inputs) {
      if (std::ranges::find(known, input) != known.end()) continue;
      known.push_back(input);
      add(input);
    }
  };
  add_all(plan.common_inputs);
  for (const study::Entrant& team : plan.teams) add_all(team.inputs);
  for (const study::Opening& opening : plan.openings) add_all({opening.input});
  return table.html();
}

}  // namespace

Html failures_section(const PageSource& source) {
  const study::Tournament& course = source.view.course;
  if (course.forfeits().empty()) return {};
  HtmlTable table({{"Team"_html, Column::words},
                   {"Matches"_html},
                   {"Plugin"_html, Column::words},
                   {"Call"_html, Column::words},
                   {"Reason"_html, Column::words},
                   {"Plays the first of them again"_html, Column::words}});
  for (const study::Forfeits& each : course.forfeits()) {
    table.row({team_name(source, each.team), text(fmt::format("{}", each.count)), text(each.failure.plugin),
               text(each.failure.call), text(each.failure.what), code(source.view.again(each.first_match))});
  }
  Html out = "<div class=\"values\">"_html;
  out << table.html() << "</div>\n"_html;
  if (course.unlisted_forfeits() > 0) {
    out << "<p>"_html
        << text(fmt::format("{} more matches were forfeited for other reasons.", course.unlisted_forfeits()))
        << "</p>\n"_html;
  }
  return section("failures", "Failures"_html, out);
}

Html recordings_section(const PageSource& source) {
  const PageRecordings& found = source.recordings;
  Html out;
  if (!found.fitting.empty()) {
    HtmlTable table({{"Row"_html},
                     {"Match"_html, Column::words},
                     {"Score"_html},
                     {"Seed"_html},
                     {"Opening"_html, Column::words},
                     {"Recording"_html, Column::words},
                     {"Shows it"_html, Column::words}});
    const study::TournamentPlan& plan = source.view.plan;
    for (const RecordedRow& each : found.fitting) {
      const study::Fixture fixture = source.view.course.calendar().at(each.index);
      const RecordingLink link = source.recording(each.index);
      Html who = team_name(source, fixture.home);
      who << " – "_html << team_name(source, fixture.away);
      if (each.forfeited) who << " (forfeit, as far as it was played)"_html;
      Html file = "<a href=\""_html;
      file << path_address(link.path) << "\">"_html << text(link.path) << "</a>"_html;
      table.row({text(fmt::format("{}", each.index + 1)), who, text(fmt::format("{}:{}", each.score[0], each.score[1])),
                 text(fmt::format("{}", fixture.seed)),
                 plan.openings.empty()
                     ? Html("–"_html)
                     : text(std::filesystem::path(plan.openings[fixture.opening].file).stem().string()),
                 file, code(link.command)});
    }
    out << "<p>The commands are for the folder in which this page stands.</p>\n"_html << table.html();
  }
  const auto note = [&out](const std::string& line) {
    out << "<p class=\"note\">"_html << text(line) << "</p>\n"_html;
  };
  if (found.others > 0) {
    const bool one = found.others == 1;
    note(fmt::format("{} {} there {} to other matches, or {} cut off, and {} left out.", found.others,
                     one ? "file" : "files", one ? "belongs" : "belong", one ? "was" : "were", one ? "is" : "are"));
  }
  if (found.not_read > 0) {
    note(fmt::format("And {} more {}, not looked into.", found.not_read, found.not_read == 1 ? "file" : "files"));
  }
  return section("recordings", "Recorded matches"_html, out);
}

Html configuration_section(const PageSource& source) {
  const std::vector<std::string>& documents = source.documents;
  if (documents.empty()) {
    return section(
        "configuration", "Where the teams differ"_html,
        "<p>These results do not hold the teams' documents: they were begun by an older Regista.</p>\n"_html);
  }
  const std::size_t compared = std::min(documents.size(), most_compared);
  Html out;
  try {
    out = differences_table(source, std::span(documents).first(compared));
  } catch (const config::Error& error) {
    out << "<p>The documents cannot be compared: "_html << text(error.what()) << "</p>\n"_html;
  }
  if (compared < documents.size()) {
    out << "<p class=\"note\">"_html << text(fmt::format("Of the first {} teams.", compared)) << "</p>\n"_html;
  }
  for (std::size_t team = 0; team < std::min(documents.size(), most_documents); ++team) {
    out << "<details><summary>All of "_html << team_name(source, team) << "</summary>\n"_html << block(documents[team])
        << "</details>\n"_html;
  }
  return section("configuration", "Where the teams differ"_html, out);
}

Html reproduction_section(const PageSource& source) {
  Html out = "<p>In the folder "_html;
  out << code(source.view.plan.folder) << ", with the program and the files that have these hashes:</p>\n"_html
      << block(source.command) << "<p class=\"note\">Regista "_html << text(source.program)
      << " began these results. Fingerprint of all matches, equal where the same were played with the same course: "_html
      << code(source.record.fingerprint().empty() ? "–" : source.record.fingerprint())
      << "</p>\n<details><summary>Hashes of everything the matches are a function of</summary>\n"_html
      << hashes_table(source) << "</details>\n"_html;
  return section("reproduction", "Playing it again"_html, out);
}

}  // namespace regista::report
