// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>

#include "recording/moment_svg.hpp"
#include "texts/message.hpp"

namespace regista::recording::moment {
namespace {

// Returns a fill colour between white (share 0) and blue (share 1).
Html heat(double share) {
  const auto mix = [&](double light, double dark) { return static_cast<int>(light + share * (dark - light)); };
  return drawn(R"( fill="#{:02x}{:02x}{:02x}")", mix(246, 0), mix(249, 90), mix(252, 156));
}

struct Table {
  double left, top, cell_width, cell_height;
};

Html matrix(const RecordedDecision& decision, const RecordedTeam& team, int own_number, const Table& table) {
  Html out;
  double least = INFINITY, most = -INFINITY;
  for (const auto& row : decision.utility) {
    for (const auto& value : row) {
      if (!value) continue;
      least = std::min(least, *value);
      most = std::max(most, *value);
    }
  }
  for (std::size_t j = 0; j < decision.columns.size(); ++j) {
    const double x = table.left + (static_cast<double>(j) + 0.62) * table.cell_width;
    out << turned_label(x, table.top - 6.0, -55.0, "class", "column",
                        visible_at_most(role_name(team, decision.columns[j]), 16));
  }
  for (std::size_t i = 0; i < decision.rows.size(); ++i) {
    const double y = table.top + static_cast<double>(i) * table.cell_height;
    const int number = decision.rows[i];
    out << label(table.left - 8.0, y + table.cell_height / 2.0 + 4.0, number == own_number ? "row own-row" : "row",
                 std::to_string(number));
    for (std::size_t j = 0; j < decision.columns.size(); ++j) {
      const double x = table.left + static_cast<double>(j) * table.cell_width;
      const std::optional<double>& value = decision.utility[i][j];
      const auto robot = static_cast<std::size_t>(number - 1);
      const bool assigned =
          number >= 1 && robot < decision.assigned.size() && decision.assigned[robot] == decision.columns[j];
      const double share = !value ? 0.0 : most > least ? (*value - least) / (most - least) : 1.0;
      out << drawn(R"(<rect class="{}" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}")",
                   value ? "cell" : "cell forbidden", x, y, table.cell_width, table.cell_height)
          << (value ? heat(share) : Html()) << "/>"_html
          << label(x + table.cell_width / 2.0, y + table.cell_height / 2.0 + 4.0,
                   share > 0.55 ? "value light" : "value", value ? fmt::format("{:.2f}", *value) : "–");
      if (assigned) {
        out << drawn(R"(<rect class="taken" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", x + 1.5, y + 1.5,
                     table.cell_width - 3.0, table.cell_height - 3.0);
      }
    }
  }
  return out;
}

Html own_terms(const RecordedDecision& decision, const RecordedTeam& team, int own_number, Table& table) {
  const auto own = std::ranges::find(decision.rows, own_number);
  const auto context = static_cast<std::size_t>(decision.context);
  if (own == decision.rows.end() || decision.context < 0 || context >= team.contexts.size()) return {};
  const auto row = static_cast<std::size_t>(own - decision.rows.begin());
  const std::vector<RecordedTerm>& names = team.contexts[context].terms;
  Html out;
  for (std::size_t k = 0; k < std::min(names.size(), decision.terms.size()); ++k) {
    out << label(table.left, table.top + 4.0, "term",
                 visible_at_most(fmt::format("{} × {:g}", names[k].name, names[k].weight), 40));
    table.top += 9.0;
    for (std::size_t j = 0; j < decision.columns.size(); ++j) {
      const std::optional<double>& value = decision.terms[k][row][j];
      out << label(table.left + (static_cast<double>(j) + 0.5) * table.cell_width, table.top + 12.0, "value",
                   value ? fmt::format("{:.2f}", *value) : "–");
    }
    table.top += 30.0;
  }
  return out;
}

// Returns the text in one line, cut to at most `columns` columns of a fixed-width font.
std::string fitting(const std::string& words, std::size_t columns) {
  const std::string seen = visible(words);
  const auto begins = [&](std::size_t i) { return (static_cast<unsigned char>(seen[i]) & 0xc0) != 0x80; };
  // Most characters from U+3000 on take two columns.
  const auto width = [&](std::size_t i) { return static_cast<unsigned char>(seen[i]) >= 0xe3 ? 2u : 1u; };
  constexpr std::size_t dots = 3;
  std::size_t used = 0, end = 0;  // end: bytes that fit before the dots
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!begins(i)) continue;
    if (used + dots <= columns) end = i;
    used += width(i);
    if (used > columns) return seen.substr(0, end) + "...";
  }
  return seen;
}

// Draws the lines of the log. Words mark warnings and errors, because some readers see no colours.
Panel log_lines(const std::vector<RecordedLogLine>& lines, double left, double top) {
  constexpr std::size_t columns = 62;  // columns of 6.6 px
  Panel out{{}, top};
  if (lines.empty()) return out;
  out.drawing << label(left, out.bottom, "heading", "Log of its plugins");
  for (const RecordedLogLine& line : lines) {
    out.bottom += 17.0;
    const bool marked = line.level == "warning" || line.level == "error";
    const std::string time = time_text(line.time) + ' ',
                      level = line.level == "info" ? "" : fitting(line.level, 10) + ' ';
    const std::string rest = fitting(fmt::format("{}: {}", visible_at_most(line.plugin, 24), line.text),
                                     columns - time.size() - level.size());
    out.drawing << label(left, out.bottom, marked ? "log marked" : "log", time + level + rest);
  }
  out.bottom += 17.0;
  return out;
}

Panel why(const RecordedMatch& match, const RecordedMoment& moment, const RobotName& robot, double left, double top) {
  const RecordedTeam& team = match.teams()[static_cast<std::size_t>(robot.side)];
  Html out;
  double y = top + 14.0;
  const auto line = [&](const char* classes, const std::string& words) {
    out << label(left, y, classes, visible_at_most(words, 66));
    y += 19.0;
  };
  const auto context_lines = [&](const RecordedContext& context, const char* how) {
    line("small", fmt::format("context {}: {} {}", context.name, context.plugin, how));
    // What is off comes last, because a long line is cut.
    std::string on, off;
    std::istringstream words(context.parameters);
    for (std::string word; words >> word;) (word.ends_with("=false") ? off : on) += ' ' + word;
    if (!context.parameters.empty()) line("small", "   " + on + off);
  };
  if (!moment.decision) {
    line("title", fmt::format("{} {}", team.name, robot.number));
    line("small", "had decided nothing yet");
    return {out, y};
  }
  const RecordedDecision& decision = *moment.decision;
  line("title", fmt::format("{} {}: {}", team.name, robot.number, role_name(team, decision.role)));
  const auto context = static_cast<std::size_t>(decision.context);
  if (decision.context >= 0 && context < team.contexts.size()) {
    for (std::size_t i = 0; i < context; ++i) context_lines(team.contexts[i], "does not hold");
    context_lines(team.contexts[context], "holds");
  } else {
    line("small", "no context holds");
  }
  line("small",
       fmt::format("decided {:.2f} s before; utilities of what {}", std::max(moment.game.time - decision.time, 0.0),
                   decision.knowledge == "common" ? "all can know" : "it knows itself"));
  if (decision.columns.empty()) return {out, y};
  const double columns = static_cast<double>(decision.columns.size());
  Table table{left + 22.0, y + 112.0, std::min(52.0, (panel_width - 22.0 - 60.0) / columns), 25.0};
  out << label(left, y + 6.0, "heading", "Utility estimation matrix: robots × tasks")
      << matrix(decision, team, robot.number, table);
  table.top += 25.0 * static_cast<double>(decision.rows.size()) + 34.0;
  out << label(left, table.top, "heading", fmt::format("Terms behind the row of robot {}", robot.number));
  table.top += 22.0;
  out << own_terms(decision, team, robot.number, table);
  return {out, table.top};
}

}  // namespace

Panel panel(const RecordedMatch& match, const RecordedMoment& moment, const RobotName& robot, double left, double top) {
  Panel out = why(match, moment, robot, left, top);
  const Panel log = log_lines(moment.log, left, out.bottom + 12.0);
  return {out.drawing << log.drawing, moment.log.empty() ? out.bottom : log.bottom};
}

}  // namespace regista::recording::moment
