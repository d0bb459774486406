// SPDX-License-Identifier: MIT
// Sections about the matches of a tournament: goal differences, coordination of the teams, packets, and recordings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recording/recording_metadata.hpp"
#include "report/metric_reference.hpp"
#include "report/number.hpp"
#include "report/tournament_report.hpp"
#include "study/study.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_teams = 40;  // largest number of teams whose roles the report shows

// Returns the number of decimals of a value: `digits`, or at most 1 from a value of 100 on.
int digits_of(double value, int digits) { return std::abs(value) < 100.0 ? digits : std::min(digits, 1); }

Cell mean_of(const statistics::Moments* moments, int digits) {
  if (moments == nullptr || moments->count() == 0) return "–";
  return fixed(moments->mean(), digits_of(moments->mean(), digits));
}

// Returns a cell with first team minus second team. The cell is emphasised if the interval does not contain zero.
Cell difference_of(const study::MetricDifference* difference, int digits) {
  if (difference == nullptr) return "–";
  const statistics::Estimate estimate = difference->estimate();
  digits = digits_of(estimate.value, digits);
  if (!estimate.interval.bounded()) return with_sign(estimate.value, digits);
  digits = digits_of(estimate.margin(), digits);
  Cell out = fmt::format("{} ± {}", with_sign(estimate.value, digits), fixed(estimate.margin(), digits));
  out.stressed = !estimate.interval.contains(0.0);
  return out;
}

struct Measure {
  std::string title, path;
  int digits = 2;
};

// Returns a table with the numbers of two teams beside each other.
Table compared(const TournamentView& view, const MatchNumbers& numbers, const char* title,
               const std::vector<Measure>& measures) {
  Table out{{{title, Column::words}, {named(view.shown(0))}, {named(view.shown(1))}, {"difference"}}};
  for (const auto& [name, path, digits] : measures) {
    out.row({name, mean_of(numbers.find(0, path), digits), mean_of(numbers.find(1, path), digits),
             difference_of(numbers.difference(path), digits)});
  }
  return out;
}

// Rows::teams: a table has teams in rows and measures in columns. Rows::measures: the other way round.
enum class Rows { teams, measures };
Table means_of(const TournamentView& view, const MatchNumbers& numbers, std::size_t teams, Rows rows, const char* title,
               const std::vector<Measure>& measures) {
  Table out{{{title, Column::words}}};
  const bool by_team = rows == Rows::teams;
  const auto name = [&](bool of_team, std::size_t i) {
    return of_team ? named(view.shown(i)) : by_team ? Sentence(measures[i].title) : named(measures[i].title);
  };
  const std::size_t columns = by_team ? measures.size() : teams;
  for (std::size_t i = 0; i < columns; ++i) out.headings.push_back({name(!by_team, i)});
  for (std::size_t row = 0; row < (by_team ? teams : measures.size()); ++row) {
    std::vector<Cell> cells{name(by_team, row)};
    for (std::size_t i = 0; i < columns; ++i) {
      const Measure& measure = measures[by_team ? i : row];
      cells.push_back(mean_of(numbers.find(by_team ? row : i, measure.path), measure.digits));
    }
    out.row(std::move(cells));
  }
  return out;
}

Sentence mark(const char* team) { return {Sentence::Kind::mark, team}; }

Table roles_of_two(const MatchNumbers& numbers, const std::vector<std::string>& roles) {
  Table out{{{"Role", Column::words}}};
  for (const char* title : {"overlap, s: ", "uncovered, s: ", "switches: "}) {
    out.headings.insert(out.headings.end(), {{Sentence(title) << mark("first")}, {mark("second")}, {"difference"}});
  }
  const auto add = [&](Cell title, const std::string& prefix) {
    std::vector<Cell> cells{std::move(title)};
    for (const char* measure : role_measures) {
      const std::string path = prefix + measure;
      cells.insert(cells.end(), {mean_of(numbers.find(0, path), 2), mean_of(numbers.find(1, path), 2),
                                 difference_of(numbers.difference(path), 2)});
    }
    out.row(std::move(cells));
  };
  for (const std::string& role : roles) add(named(role), role + '.');
  add(strong("all roles"), "");
  out.style = Table::Style::tight;
  return out;
}

void add_roles_of_several(const TournamentView& view, const MatchNumbers& numbers,
                          const std::vector<std::string>& roles, std::size_t teams, Section& out) {
  out.table(means_of(view, numbers, teams, Rows::teams, "All roles together, per match",
                     {{"overlap, s", role_measures[0], 1},
                      {"uncovered, s", role_measures[1], 1},
                      {"switches", role_measures[2], 1},
                      {"agreement, share of time", "agreement", 3}}));
  constexpr std::array<const char*, role_measures.size()> titles{"Overlap, s per match", "Uncovered, s per match",
                                                                 "Switches per match"};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    std::vector<Measure> measures;
    for (const std::string& role : roles) measures.push_back({role, role + '.' + role_measures[i], 1});
    Table table = means_of(view, numbers, teams, Rows::measures, "Role", measures);
    table.summary = fmt::format("{}, by role", titles[i]);
    out.table(std::move(table));
  }
}

// Returns a table with teams in rows and goal differences in columns.
Table goals_of_several(const TournamentView& view, const TournamentHistory& record) {
  constexpr int shown = 5;
  Table out{{{"Matches by goal difference", Column::words}}};
  for (int difference = -shown; difference <= shown; ++difference) {
    const char* const sign = std::abs(difference) < shown ? "" : difference < 0 ? "≤ " : "≥ ";
    out.headings.push_back({fmt::format("{}{}{}", sign, difference > 0 ? "+" : "", difference)});
  }
  out.style = Table::Style::heat;
  out.file = "goal_differences.csv";
  out.csv = "team,goal_difference,played,forfeited\n";
  for (std::size_t team = 0; team < view.plan.teams.size(); ++team) {
    const GoalDifferences& counts = record.goals_of(team);
    std::array<std::uint64_t, 2 * shown + 1> columns{};
    std::uint64_t all = 0;
    for (int difference = -GoalDifferences::largest; difference <= GoalDifferences::largest; ++difference) {
      const auto at = static_cast<std::size_t>(difference + GoalDifferences::largest);
      const std::uint64_t matches = counts.played[at] + counts.forfeited[at];
      columns[static_cast<std::size_t>(std::clamp(difference, -shown, shown) + shown)] += matches;
      all += matches;
      out.csv += fmt::format("{},{},{},{}\n", csv_field(texts::visible(view.label(team))), difference,
                             counts.played[at], counts.forfeited[at]);
    }
    if (team >= most_teams) continue;
    std::vector<Cell> cells{named(view.shown(team))};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      Cell& cell = cells.emplace_back(columns[i]);
      cell.series = i < shown ? 2 : i == shown ? 8 : 1;
      cell.ground = all == 0 ? 0.0 : 45.0 * static_cast<double>(columns[i]) / static_cast<double>(all);
    }
    out.row(std::move(cells));
  }
  return out;
}

// Adds packets and share of the budget of each team, if the games are short but have the budget of a whole match.
void add_share_of_packets(const TournamentView& view, Section& out) {
  bool above = false;
  for (std::size_t team = 0; team < view.plan.teams.size(); ++team) {
    const study::PacketsSpent packets = view.course.packets(team);
    const std::string clause = packets_clause(packets);
    if (!clause.empty()) out.line(named(view.shown(team)) << ' ' + clause + '.');
    above = above || (packets.games() > 0 && packets.above_share());
  }
  if (above) {
    out.line(
        "Each of these games has the packets of a whole match. A team above its share sends more often than it could "
        "all through a whole match. With --set rules.messages.short_games=share a short game has its share of them.");
  }
}

}  // namespace

Section goals_section(const TournamentView& view, const TournamentHistory& record) {
  Section out("goals", "Goal differences");
  if (view.course.matches() == 0) return out;
  if (view.plan.teams.size() == 2)
    out.figures({"goal_differences"});
  else
    out.table(goals_of_several(view, record), Readers::page);
  return out;
}

Section roles_section(const TournamentView& view, const TournamentHistory& record,
                      std::span<const match::MetricRow> metrics) {
  Section out("roles", "Coordination");
  const std::size_t teams = std::min(view.plan.teams.size(), most_teams);
  const MatchNumbers& numbers = record.numbers();
  const std::vector<std::string> roles = role_names(numbers, teams);
  if (roles.empty()) return out;
  out.line(
      "Overlap: two robots hold the role at once. Uncovered: no robot holds the role although it is wanted. Switches: "
      "a robot takes a role that it did not hold. The numbers are means of the matches played to their end.");
  if (teams > 2) {
    add_roles_of_several(view, numbers, roles, teams, out);
    return out;
  }
  out.figures({"roles"});
  out.note(mark("first") << named(view.shown(0)) << "   " << mark("second") << named(view.shown(1)));
  out.table(roles_of_two(numbers, roles));
  std::vector<Measure> others;
  for (const match::MetricRow& row : metrics) {
    if (!row.title.empty() && numbers.find(0, row.name) != nullptr) others.push_back({row.title, row.name, row.digits});
  }
  out.table(compared(view, numbers, "Of a match", others));
  out.note(
      "± is half of an anytime-valid 95 % interval, for many pairs. Bold: the interval leaves out 0. With so many "
      "numbers some do by chance.");
  return out;
}

Section packets_section(const TournamentView& view, const TournamentHistory* record) {
  Section out("packets", "Packets");
  if (record != nullptr) {
    const std::size_t teams = std::min(view.plan.teams.size(), most_teams);
    const MatchNumbers& numbers = record->numbers();
    std::vector<std::string> reasons = packet_reasons(numbers, teams);
    const auto without = std::erase_if(
        reasons, [&](const std::string& reason) { return all_zero(numbers, teams, packets_prefix + reason); });
    std::vector<Measure> measures;
    for (const std::string& reason : reasons) measures.push_back({spaced(reason), packets_prefix + reason, 2});
    measures.push_back({"all", "packets", 2});
    if (!reasons.empty() || without > 0) {
      if (teams == 2) {
        out.figures({"packets"});
        out.table(compared(view, numbers, "Packets per match", measures));
      } else {
        for (Measure& each : measures) each.digits = 1;
        out.table(means_of(view, numbers, teams, Rows::teams, "Packets per match", measures));
      }
      if (without > 0) out.note(fmt::format("{} other events caused no packet.", without));
    }
  }
  add_share_of_packets(view, out);
  return out;
}

Section plugins_section(const TournamentView& view, const TournamentHistory& record) {
  Section out("plugins", "Numbers of plugins");
  const std::size_t teams = std::min(view.plan.teams.size(), most_teams);
  const MatchNumbers& numbers = record.numbers();
  std::vector<Measure> measures;
  for (const std::string& path : plugin_metrics(numbers, teams)) {
    std::string title = path.substr(path.find('.') + 1);  // for example "count_crossings: crossings"
    title.replace(title.find('.'), 1, ": ");
    measures.push_back({title, path, 3});
  }
  if (measures.empty()) return out;
  out.line(Sentence("Plugins count these themselves; ") << code("regista plugin info ID") << " says what they mean.");
  out.table(teams == 2 ? compared(view, numbers, "Mean of the matches", measures)
                       : means_of(view, numbers, teams, Rows::measures, "Mean of the matches", measures));
  return out;
}

PageRecordings page_recordings(const TournamentView& view, const TournamentHistory& record,
                               const std::filesystem::path& results) {
  constexpr std::string_view kind = "opening ";  // beginning of the name of an opening among the inputs
  PageRecordings out;
  out.not_read = record.recorded_matches() - record.recorded().size();
  for (const RecordedRow& each : record.recorded()) {
    const study::Fixture fixture = view.course.calendar().at(each.index);
    recording::RecordingIdentity match{
        fixture.seed, {view.plan.teams[fixture.home].label, view.plan.teams[fixture.away].label}, "", {}, {}};
    if (!view.plan.openings.empty()) {
      const std::string& input = view.plan.openings[fixture.opening].input.name;
      match.opening = input.starts_with(kind) ? input.substr(kind.size()) : input;
    }
    if (!each.forfeited) {
      match.score = each.score;
      match.packets = each.packets;
    }
    if (recording::is_recording_of(study::recording_file(results, static_cast<std::int64_t>(each.index) + 1), match)) {
      out.fitting.push_back(each);
    }
  }
  return out;
}

Section recordings_section(const TournamentView& view, const PageRecordings& recordings,
                           const std::function<RecordingLink(std::uint64_t match)>& link_to) {
  Section out("recordings", "Recorded matches");
  Table table{{{"Row"},
               {"Match", Column::words},
               {"Score"},
               {"Seed"},
               {"Opening", Column::words},
               {"Recording", Column::words},
               {"Command that shows it", Column::words}}};
  for (const RecordedRow& each : recordings.fitting) {
    const study::Fixture fixture = view.course.calendar().at(each.index);
    const RecordingLink link = link_to(each.index);
    const std::string scene = scene_name(view.plan.openings, fixture.opening);
    Sentence who = named(view.shown(fixture.home)) << " – " << named(view.shown(fixture.away));
    if (each.forfeited) who << " (forfeit, as far as it was played)";
    table.row({each.index + 1, who, fmt::format("{}:{}", each.score[0], each.score[1]), fixture.seed,
               scene.empty() ? "–" : scene, Sentence(Sentence::Kind::link, link.path), code(link.command)});
  }
  if (!table.rows.empty()) out.line("Run the commands in the folder of this page.");
  out.table(std::move(table));
  if (recordings.not_read > 0)
    out.note(fmt::format("{} not read.", texts::plural(recordings.not_read, "more file", "more files")));
  return out;
}

}  // namespace regista::report
