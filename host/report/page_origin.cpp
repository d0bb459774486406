// SPDX-License-Identifier: MIT
// Where the numbers come from: matches to be looked at or played again, the teams' documents, versions and hashes.
#include <fmt/format.h>

#include <algorithm>

#include "report/html_table.hpp"
#include "report/page_sections.hpp"
#include "texts/message.hpp"

namespace regista::report {
Html failures_section(const PageSource& source) {
  const study::Tournament& course = source.view.course;
  if (course.forfeits().empty()) return {};
  HtmlTable table({{"Team"_html, Column::words},
                   {"Matches"_html},
                   {"Plugin"_html, Column::words},
                   {"Call"_html, Column::words},
                   {"Reason"_html, Column::words},
                   {"Command that plays the first again"_html, Column::words}});
  for (const study::Forfeits& each : course.forfeits()) {
    table.row({team_name(source, each.team), text(fmt::format("{}", each.count)),
               each.failure.plugin.empty() ? plugin_cell(team_name(source, each.team)) : text(each.failure.plugin),
               text(each.failure.call), text(each.failure.what), code(source.view.again(each.first_match))});
  }
  Html out = "<div class=\"values\">"_html;
  out << table.html() << "</div>\n"_html;
  if (course.unlisted_forfeits() > 0) {
    out << "<p>"_html
        << text(texts::counted(course.unlisted_forfeits(), "more match was", "more matches were") +
                " forfeited for other reasons.")
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
                     {"Command that shows it"_html, Column::words}});
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
    out << "<p>Run the commands in the folder of this page.</p>\n"_html << table.html();
  }
  const auto note = [&out](const std::string& line) {
    out << "<p class=\"note\">"_html << text(line) << "</p>\n"_html;
  };
  if (found.not_read > 0) {
    note(fmt::format("{} not read.", texts::counted(found.not_read, "more file", "more files")));
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
  std::vector<std::string> names;
  for (const study::Entrant& team : source.view.plan.teams) names.push_back(team.label);
  const Html out = differing_documents(names, documents, source.played.teams);
  return section("configuration", "Where the teams differ"_html, out);
}

}  // namespace regista::report
