// SPDX-License-Identifier: MIT
// What the matches were like: goal differences, how well the teams were coordinated, what they sent.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/csv_text.hpp"
#include "report/html_table.hpp"
#include "report/number.hpp"
#include "report/packets_spent.hpp"
#include "report/page_sections.hpp"
#include "report/role_names.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_teams = 40;  // of which the roles are shown

// Hundreds need less behind the point, and have less room.
int digits_of(double value, int digits) { return std::abs(value) < 100.0 ? digits : std::min(digits, 1); }

Html mean_of(const statistics::Moments* moments, int digits) {
  if (moments == nullptr || moments->count() == 0) return "–"_html;
  return text(fixed(moments->mean(), digits_of(moments->mean(), digits)));
}

// Of first less second. Set in bold where the interval leaves nought out.
Html difference_of(const study::MetricDifference* difference, int digits) {
  if (difference == nullptr) return "–"_html;
  const statistics::Estimate estimate = difference->estimate();
  digits = digits_of(estimate.value, digits);
  if (!estimate.interval.bounded()) return text(with_sign(estimate.value, digits));
  digits = digits_of(estimate.margin(), digits);
  const Html shown = text(fmt::format("{} ± {}", with_sign(estimate.value, digits), fixed(estimate.margin(), digits)));
  if (estimate.interval.contains(0.0)) return shown;
  Html out = "<span class=\"differs\">"_html;
  return out << shown << "</span>"_html;
}

struct Row {
  std::string title, path;
  int digits = 2;
};

// Numbers of two teams beside each other.
Html compared(const PageSource& source, Markup title, const std::vector<Row>& rows) {
  HtmlTable table({{title, Column::words}, {team_name(source, 0)}, {team_name(source, 1)}, {"difference"_html}});
  const MatchNumbers& numbers = source.record.numbers();
  for (const auto& [name, path, digits] : rows) {
    table.row({text(name), mean_of(numbers.find(0, path), digits), mean_of(numbers.find(1, path), digits),
               difference_of(numbers.difference(path), digits)});
  }
  return table.html();
}

// "playing.goalkeeper", which may go on in a new line after the point, and within a word only where it is a long one.
Html role_name(std::string_view role) {
  const std::size_t point = role.find('.');
  if (point == std::string_view::npos) return name(role);
  Html out = name(role.substr(0, point + 1));
  return out << "<wbr>"_html << name(role.substr(point + 1));
}

std::string spaced(std::string words) {
  std::ranges::replace(words, '_', ' ');
  return words;
}

Html roles_of_two(const PageSource& source, const std::vector<std::string>& roles) {
  HtmlTable table({{"Role"_html, Column::words},
                   {"overlap, s: <i class=\"key first\"></i>"_html},
                   {"<i class=\"key second\"></i>"_html},
                   {"difference"_html},
                   {"uncovered, s: <i class=\"key first\"></i>"_html},
                   {"<i class=\"key second\"></i>"_html},
                   {"difference"_html},
                   {"switches: <i class=\"key first\"></i>"_html},
                   {"<i class=\"key second\"></i>"_html},
                   {"difference"_html}});
  const MatchNumbers& numbers = source.record.numbers();
  const auto add = [&](const Html& title, const std::string& prefix) {
    std::vector<Html> cells{title};
    for (const char* measure : role_measures) {
      const std::string path = prefix + measure;
      cells.push_back(mean_of(numbers.find(0, path), 2));
      cells.push_back(mean_of(numbers.find(1, path), 2));
      cells.push_back(difference_of(numbers.difference(path), 2));
    }
    table.row(cells);
  };
  for (const std::string& role : roles) add(role_name(role), role + '.');
  add("<b>all roles</b>"_html, "");
  Html out = "<div class=\"full\">\n"_html;
  return out << figure(source, "roles") << "</div>\n<p class=\"note\"><i class=\"key first\"></i>"_html
             << team_name(source, 0) << " &nbsp; <i class=\"key second\"></i>"_html << team_name(source, 1)
             << "</p>\n<div class=\"tight\">"_html << table.html() << "</div>\n"_html;
}

// A row for each team with the sums over its roles; a table for each measure with a row for each role.
Html roles_of_several(const PageSource& source, const std::vector<std::string>& roles, std::size_t teams) {
  const MatchNumbers& numbers = source.record.numbers();
  HtmlTable sums({{"All roles together, per match"_html, Column::words},
                  {"overlap, s"_html},
                  {"uncovered, s"_html},
                  {"switches"_html},
                  {"agreement, share of time"_html}});
  for (std::size_t team = 0; team < teams; ++team) {
    sums.row({team_name(source, team), mean_of(numbers.find(team, role_measures[0]), 1),
              mean_of(numbers.find(team, role_measures[1]), 1), mean_of(numbers.find(team, role_measures[2]), 1),
              mean_of(numbers.find(team, "agreement"), 3)});
  }
  Html out = sums.html();
  const std::array<Markup, role_measures.size()> titles{"Overlap, s per match"_html, "Uncovered, s per match"_html,
                                                        "Switches per match"_html};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    std::vector<Heading> headings{{"Role"_html, Column::words}};
    for (std::size_t team = 0; team < teams; ++team) headings.push_back({team_name(source, team)});
    HtmlTable table(headings);
    for (const std::string& role : roles) {
      std::vector<Html> cells{role_name(role)};
      for (std::size_t team = 0; team < teams; ++team) {
        cells.push_back(mean_of(numbers.find(team, role + '.' + role_measures[i]), 1));
      }
      table.row(cells);
    }
    out << "<details><summary>"_html << titles[i] << ", by role</summary>\n"_html << table.html()
        << "</details>\n"_html;
  }
  return out;
}

Html packets_of_several(const PageSource& source, const std::vector<std::string>& reasons, std::size_t teams) {
  std::vector<Heading> headings{{"Packets per match"_html, Column::words}, {"all"_html}};
  for (const std::string& reason : reasons) headings.push_back({text(spaced(reason))});
  HtmlTable table(headings);
  for (std::size_t team = 0; team < teams; ++team) {
    std::vector<Html> cells{team_name(source, team)};
    cells.push_back(mean_of(source.record.numbers().find(team, "packets"), 1));
    for (const std::string& reason : reasons) {
      cells.push_back(mean_of(source.record.numbers().find(team, packets_prefix + reason), 1));
    }
    table.row(cells);
  }
  return table.html();
}

// Rows of teams, columns of differences.
Html goals_of_several(const PageSource& source) {
  constexpr int shown = 5;
  std::vector<Heading> headings{{"Matches by goal difference"_html, Column::words}};
  for (int difference = -shown; difference <= shown; ++difference) {
    const char* const sign = std::abs(difference) < shown ? "" : difference < 0 ? "≤ " : "≥ ";
    headings.push_back({text(fmt::format("{}{}{}", sign, difference > 0 ? "+" : "", difference))});
  }
  HtmlTable table(headings);
  std::string csv = "team,goal_difference,played,forfeited\n";
  for (std::size_t team = 0; team < source.view.plan.teams.size(); ++team) {
    const GoalDifferences& counts = source.record.goals_of(team);
    std::array<std::uint64_t, 2 * shown + 1> columns{};
    std::uint64_t all = 0;
    for (int difference = -GoalDifferences::largest; difference <= GoalDifferences::largest; ++difference) {
      const auto at = static_cast<std::size_t>(difference + GoalDifferences::largest);
      const std::uint64_t matches = counts.played[at] + counts.forfeited[at];
      columns[static_cast<std::size_t>(std::clamp(difference, -shown, shown) + shown)] += matches;
      all += matches;
      csv += fmt::format("{},{},{},{}\n", csv_field(texts::visible(source.view.plan.teams[team].label)), difference,
                         counts.played[at], counts.forfeited[at]);
    }
    if (team >= most_teams) continue;
    std::vector<Html> cells{team_name(source, team)};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double share = all == 0 ? 0.0 : static_cast<double>(columns[i]) / static_cast<double>(all);
      Html cell = "<span style=\"background:color-mix(in srgb,var(--series-"_html;
      cells.push_back(cell << (i < shown    ? "2"_html
                               : i == shown ? "8"_html
                                            : "1"_html)
                           << text(fmt::format(") {:.0f}%,transparent)", 45.0 * share)) << "\">"_html
                           << text(fmt::format("{}", columns[i])) << "</span>"_html);
    }
    table.row(cells);
  }
  Html out = "<div class=\"heat\">"_html;
  return out << table.html() << "</div>\n<p class=\"note\">"_html << table_link("goal_differences.csv", csv)
             << "</p>\n"_html;
}

}  // namespace

Html goals_section(const PageSource& source) {
  if (source.view.course.matches() == 0) return {};
  return section("goals", "Goal differences"_html,
                 source.view.plan.teams.size() == 2 ? figure(source, "goal_differences") : goals_of_several(source));
}

Html roles_section(const PageSource& source) {
  const std::size_t teams = std::min(source.view.plan.teams.size(), most_teams);
  const std::vector<std::string> roles = role_names(source.record.numbers(), teams);
  if (roles.empty()) return {};
  Html out =
      "<p>Overlap: two robots hold the role at once. Uncovered: no robot holds the role although it is wanted. Switches: a robot takes a role that it did not hold. The numbers are means of the matches played to their end.</p>\n"_html;
  if (teams > 2) return section("roles", "Coordination"_html, out << roles_of_several(source, roles, teams));
  out << roles_of_two(source, roles);
  std::vector<Row> others;
  for (const match::MetricRow& row : source.metrics) {
    if (row.title.empty() || source.record.numbers().find(0, row.name) == nullptr) continue;
    others.push_back({row.title, row.name, row.digits});
  }
  if (!others.empty()) out << compared(source, "Of a match"_html, others);
  out << "<p class=\"note\">± is half of an anytime-valid 95 % interval, for many pairs. Bold: the interval leaves out 0. With so many numbers some do by chance.</p>\n"_html;
  return section("roles", "Coordination"_html, out);
}

// Of games that are shorter than a match, whose budget is that of a whole one.
static Html share_note(const PageSource& source, std::size_t teams) {
  Html out;
  for (std::size_t team = 0; team < teams; ++team) {
    const std::string clause = packets_clause(source.view.course.packets(team), OverspentMark::quiet);
    if (clause.empty()) continue;
    out << "<p class=\"note\">"_html << team_name(source, team) << text(' ' + clause + '.') << "</p>\n"_html;
  }
  return out;
}

Html packets_section(const PageSource& source) {
  const std::size_t teams = std::min(source.view.plan.teams.size(), most_teams);
  std::vector<std::string> reasons = packet_reasons(source.record.numbers(), teams);
  if (reasons.empty()) return {};
  const auto without = std::erase_if(
      reasons, [&](const std::string& reason) { return sent_none(source.record.numbers(), teams, reason); });
  const Html rest = without == 0 ? Html() : text(fmt::format("{} other events caused no packet.", without));
  if (teams > 2)
    return section("packets", "Packets by event"_html,
                   packets_of_several(source, reasons, teams)
                       << share_note(source, teams) << "<p class=\"note\">"_html << rest << "</p>\n"_html);
  std::vector<Row> rows;
  for (const std::string& reason : reasons) rows.push_back({spaced(reason), packets_prefix + reason, 2});
  rows.push_back({"all", "packets", 2});
  Html out = "<div class=\"two\">\n"_html;
  out << figure(source, "packets") << "<div>"_html << compared(source, "Packets per match"_html, rows)
      << share_note(source, teams) << "<p class=\"note\">"_html << rest << "</p></div>\n</div>\n"_html;
  return section("packets", "Packets by event"_html, out);
}

Html plugins_section(const PageSource& source) {
  const std::size_t teams = std::min(source.view.plan.teams.size(), most_teams);
  const MatchNumbers& numbers = source.record.numbers();
  const std::vector<std::string> paths = plugin_metrics(numbers, teams);
  if (paths.empty()) return {};
  // "count_crossings: crossings"
  const auto title = [](std::string_view path) {
    std::string out(path.substr(path.find('.') + 1));
    return out.replace(out.find('.'), 1, ": ");
  };
  Html out = "<p>Plugins count these themselves; <code>regista plugin info ID</code> says what they mean.</p>\n"_html;
  if (teams == 2) {
    std::vector<Row> rows;
    for (const std::string& path : paths) rows.push_back({title(path), path, 3});
    return section("plugins", "Numbers of plugins"_html, out << compared(source, "Mean of the matches"_html, rows));
  }
  std::vector<Heading> headings{{"Mean of the matches"_html, Column::words}};
  for (std::size_t team = 0; team < teams; ++team) headings.push_back({team_name(source, team)});
  HtmlTable table(headings);
  for (const std::string& path : paths) {
    std::vector<Html> cells{name(title(path))};
    for (std::size_t team = 0; team < teams; ++team) cells.push_back(mean_of(numbers.find(team, path), 3));
    table.row(cells);
  }
  return section("plugins", "Numbers of plugins"_html, out << table.html());
}

}  // namespace regista::report
