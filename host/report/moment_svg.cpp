// SPDX-License-Identifier: MIT
#include "report/moment_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/html_text.hpp"
#include "report/visible_text.hpp"

namespace regista::report {
namespace {

constexpr double width = 1280.0, panel_width = 430.0, margin = 20.0, head = 64.0;

// Numbers and literals of this file alone.
template <class... Numbers>
Html drawn(fmt::format_string<Numbers...> format, Numbers... numbers) {
  return Html::made_by_us(fmt::vformat(format, fmt::make_format_args(numbers...)));
}

Html label(double x, double y, const char* classes, std::string_view words) {
  Html out = drawn(R"(<text x="{:.1f}" y="{:.1f}" class="{}">)", x, y, classes);
  return out << text(words) << "</text>"_html;
}

// "7:42.3", as in the viewer.
std::string time_text(double seconds) {
  const auto tenths = std::llround(10.0 * std::clamp(seconds, 0.0, 1e6));
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

std::string role_name(const RecordedTeam& team, int row) {
  if (row == -1) return "no role";
  if (row == -2) return "not known yet";
  const auto index = static_cast<std::size_t>(row);
  return row >= 0 && index < team.roles.size() ? team.roles[index] : fmt::format("role {}", row);
}

std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

// From metres of the world frame, y up, to the picture, y down.
struct Scale {
  double left, top, per_metre;
  double half_length, half_width;  // with the border

  double x(double metres) const { return left + (metres + half_length) * per_metre; }
  double y(double metres) const { return top + (half_width - metres) * per_metre; }
};

Html field_lines(const config::FieldSize& field, const Scale& to) {
  Html out;
  const auto box = [&](double x0, double y0, double x1, double y1) {
    out << drawn(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", to.x(std::min(x0, x1)),
                 to.y(std::max(y0, y1)), std::abs(x1 - x0) * to.per_metre, std::abs(y1 - y0) * to.per_metre);
  };
  const double x = field.length / 2.0, y = field.width / 2.0;
  out << drawn(R"(<rect class="grass" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", to.left, to.top,
               2.0 * to.half_length * to.per_metre, 2.0 * to.half_width * to.per_metre);
  out << R"(<g class="line">)"_html;
  box(-x, -y, x, y);
  for (const double side : {-1.0, 1.0}) {
    box(side * x, -field.goal_area_width / 2.0, side * (x - field.goal_area_length), field.goal_area_width / 2.0);
    box(side * x, -field.penalty_area_width / 2.0, side * (x - field.penalty_area_length),
        field.penalty_area_width / 2.0);
    box(side * x, -field.goal_width / 2.0, side * (x + field.goal_depth), field.goal_width / 2.0);
    out << drawn(R"(<circle cx="{:.1f}" cy="{:.1f}" r="1.5"/>)", to.x(side * (x - field.penalty_mark_distance)),
                 to.y(0.0));
  }
  out << drawn(R"(<path d="M{:.1f} {:.1f}V{:.1f}"/><circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", to.x(0.0), to.y(y),
               to.y(-y), to.x(0.0), to.y(0.0), field.centre_circle_diameter / 2.0 * to.per_metre);
  return out << "</g>"_html;
}

// Two standard deviations.
Html ellipse(const RecordedCovariance& c, double x, double y, const Scale& to) {
  const double mean = (c.xx + c.yy) / 2.0, apart = std::hypot((c.xx - c.yy) / 2.0, c.xy);
  const double angle = 0.5 * std::atan2(2.0 * c.xy, c.xx - c.yy);
  const double longer = 2.0 * std::sqrt(std::max(mean + apart, 0.0)),
               shorter = 2.0 * std::sqrt(std::max(mean - apart, 0.0));
  return drawn(R"(<ellipse class="spread" cx="{0:.1f}" cy="{1:.1f}" rx="{2:.1f}" ry="{3:.1f}" )"
               R"x(transform="rotate({4:.1f} {0:.1f} {1:.1f})"/>)x",
               to.x(x), to.y(y), longer * to.per_metre, shorter * to.per_metre, -angle * 180.0 / std::numbers::pi);
}

// `kind`: a class of the style sheet.
Html robot_shape(const RecordedPose& pose, double radius, int number, const char* kind, const Scale& to) {
  const double x = to.x(pose.x), y = to.y(pose.y), r = radius * to.per_metre;
  return drawn(
      R"(<g class="{0}"><circle cx="{1:.1f}" cy="{2:.1f}" r="{3:.1f}"/><path d="M{1:.1f} {2:.1f}L{4:.1f} {5:.1f}"/>)"
      R"(<text x="{1:.1f}" y="{6:.1f}">{7}</text></g>)",
      kind, x, y, r, x + 1.5 * r * std::cos(pose.heading), y - 1.5 * r * std::sin(pose.heading), y + 4.5, number);
}

Html truth(const RecordedMatch& match, const RecordedGame& game, const std::optional<RobotName>& chosen,
           const Scale& to) {
  Html out;
  for (const std::size_t side : {0u, 1u}) {
    const RecordedTeam& team = match.teams()[side];
    for (std::size_t i = 0; i < game.robots[side].size(); ++i) {
      const int number = static_cast<int>(i) + 1;
      const RecordedPose& pose = game.robots[side][i];
      const bool away = std::ranges::find(game.penalised[side], number) != game.penalised[side].end();
      const bool is_chosen = chosen && static_cast<std::size_t>(chosen->side) == side && chosen->number == number;
      if (is_chosen) {
        out << drawn(R"(<circle class="chosen" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", to.x(pose.x), to.y(pose.y),
                     (team.robot_radius + 0.12) * to.per_metre);
      }
      out << robot_shape(pose, team.robot_radius, number,
                         away        ? (side == 0 ? "robot home penalised" : "robot away penalised")
                         : side == 0 ? "robot home"
                                     : "robot away",
                         to);
      if (!away && game.roles[side][i] >= 0) {
        out << label(to.x(pose.x), to.y(pose.y) + (team.robot_radius + 0.2) * to.per_metre, "role",
                     visible_at_most(role_name(team, game.roles[side][i]), 24));
      }
    }
  }
  return out << drawn(R"(<circle class="ball" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", to.x(game.ball[0]),
                      to.y(game.ball[1]), std::max(4.0, match.ball_radius() * to.per_metre));
}

Html believed(const RecordedWorld& world, const RecordedTeam& team, const RobotName& robot, const Scale& to) {
  Html out = robot.side == 0 ? R"(<g class="of-home">)"_html : R"(<g class="of-away">)"_html;
  for (const RecordedTeammate& mate : world.teammates) {
    if (mate.number == robot.number) continue;
    out << ellipse(mate.covariance, mate.pose.x, mate.pose.y, to)
        << robot_shape(mate.pose, team.robot_radius, mate.number, "ghost mate", to)
        << label(to.x(mate.pose.x), to.y(mate.pose.y) - (team.robot_radius + 0.08) * to.per_metre, "age",
                 fmt::format("{:.1f} s", mate.age));
  }
  for (const RecordedObject& opponent : world.opponents) {
    out << ellipse(opponent.covariance, opponent.x, opponent.y, to)
        << drawn(R"(<circle class="ghost other" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", to.x(opponent.x),
                 to.y(opponent.y), team.robot_radius * to.per_metre)
        << label(to.x(opponent.x), to.y(opponent.y) + 4.0, "age", fmt::format("{:.1f} s", opponent.age));
  }
  if (world.ball) {
    out << ellipse(world.ball->covariance, world.ball->x, world.ball->y, to)
        << drawn(R"(<circle class="ghost believed-ball" cx="{:.1f}" cy="{:.1f}" r="6"/>)", to.x(world.ball->x),
                 to.y(world.ball->y))
        << label(to.x(world.ball->x), to.y(world.ball->y) - 9.0, "age", fmt::format("ball, {:.1f} s", world.ball->age));
  }
  return out << "</g>"_html;
}

Html planned(const RecordedDecision& decision, const RecordedTeam& team, const Scale& to) {
  Html out;
  for (const auto& [from, end] : decision.edges) {
    const auto count = static_cast<int>(decision.waypoints.size());
    if (from < 0 || end < 0 || from >= count || end >= count) continue;
    const auto& a = decision.waypoints[static_cast<std::size_t>(from)];
    const auto& b = decision.waypoints[static_cast<std::size_t>(end)];
    out << drawn(R"(<path class="edge" d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", to.x(a[0]), to.y(a[1]), to.x(b[0]),
                 to.y(b[1]));
  }
  for (const auto& point : decision.waypoints) {
    out << drawn(R"(<path class="waypoint" d="M{:.1f} {:.1f}l5 5l-5 5l-5 -5z"/>)", to.x(point[0]),
                 to.y(point[1]) - 5.0);
  }
  for (const RecordedTask& task : decision.tasks) {
    if (!task.after) continue;
    const bool own = task.role == decision.role;
    out << drawn(R"(<path class="offset" d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", to.x(task.before.x), to.y(task.before.y),
                 to.x(task.after->x), to.y(task.after->y))
        << drawn(R"(<circle class="before" cx="{:.1f}" cy="{:.1f}" r="3"/>)", to.x(task.before.x), to.y(task.before.y))
        << drawn(R"(<rect class="{}" x="{:.1f}" y="{:.1f}" width="9" height="9"/>)", own ? "task own" : "task",
                 to.x(task.after->x) - 4.5, to.y(task.after->y) - 4.5)
        << label(to.x(task.after->x) + 8.0, to.y(task.after->y) + 4.0, "task-name",
                 visible_at_most(role_name(team, task.role), 20));
  }
  return out;
}

// White for the smallest, blue for the largest; ink that can be read on it.
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
    out << drawn(R"x(<text class="column" transform="translate({:.1f} {:.1f}) rotate(-55)">)x", x, table.top - 6.0)
        << text(visible_at_most(role_name(team, decision.columns[j]), 16)) << "</text>"_html;
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

// The terms behind the own row.
Html own_terms(const RecordedDecision& decision, const RecordedTeam& team, int own_number, Table table) {
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

Html panel(const RecordedMatch& match, const RecordedMoment& moment, const RobotName& robot, double left) {
  const RecordedTeam& team = match.teams()[static_cast<std::size_t>(robot.side)];
  Html out;
  double y = head + 14.0;
  const auto line = [&](const char* classes, const std::string& words) {
    out << label(left, y, classes, visible_at_most(words, 66));
    y += 19.0;
  };
  const auto context_lines = [&](const RecordedContext& context, const char* how) {
    line("small", fmt::format("context {}: {} {}", context.name, context.plugin, how));
    if (!context.parameters.empty()) line("small", "    " + context.parameters);
  };
  if (!moment.decision) {
    line("title", fmt::format("{} {}", team.name, robot.number));
    line("small", "had decided nothing yet");
    return out;
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
  line("small", fmt::format("decided {:.2f} s before; utilities of what it knows {}",
                            std::max(moment.game.time - decision.time, 0.0),
                            decision.knowledge == "common" ? "in common with the others" : "itself"));
  if (decision.columns.empty()) return out;
  const double columns = static_cast<double>(decision.columns.size());
  Table table{left + 22.0, y + 112.0, std::min(52.0, (panel_width - 22.0 - 60.0) / columns), 25.0};
  out << label(left, y + 6.0, "heading", "Utility estimation matrix: robots × tasks")
      << matrix(decision, team, robot.number, table);
  table.top += 25.0 * static_cast<double>(decision.rows.size()) + 34.0;
  out << label(left, table.top, "heading", fmt::format("Terms behind the row of robot {}", robot.number));
  table.top += 22.0;
  return out << own_terms(decision, team, robot.number, table);
}

constexpr Markup style = R"(<style>
text{font-family:"Helvetica Neue",Arial,"DejaVu Sans",sans-serif;font-size:12px;fill:#1b1f24}
.head{font-size:22px;font-weight:600}.small{fill:#4a545e;white-space:pre}.title{font-size:17px;font-weight:600}.heading{font-weight:600}
.grass{fill:#eef4ee}.line *{fill:none;stroke:#7d8a80;stroke-width:1.5}
.robot text,.ghost text{text-anchor:middle;font-size:12.5px;font-weight:600}
.robot circle{stroke:#fff;stroke-width:1}.robot path{stroke:#1b1f24;stroke-width:2}
.home circle{fill:#0072b2}.away circle{fill:#d55e00}.home text,.away text{fill:#fff}.penalised{opacity:.3}
.chosen{fill:none;stroke:#1b1f24;stroke-width:2.5}.ball{fill:#1b1f24;stroke:#fff;stroke-width:1.5}
.role{text-anchor:middle;font-size:10.5px;fill:#4a545e}
.ghost circle,circle.ghost{fill:none;stroke-width:1.4;stroke-dasharray:4 3}.ghost path{stroke-width:1.2}
.of-home .mate *,.of-away .other{stroke:#0072b2}.of-away .mate *,.of-home .other{stroke:#d55e00}
.of-home .mate text{fill:#0072b2;stroke:#fff}.of-away .mate text{fill:#b34f00;stroke:#fff}.believed-ball{stroke:#1b1f24}
.role,.age,.task-name,.mate text{paint-order:stroke;stroke:#fff;stroke-width:2.5px;stroke-linejoin:round}
.spread{fill:#5b6670;fill-opacity:.07;stroke:#5b6670;stroke-opacity:.45;stroke-width:.8}
.age{text-anchor:middle;font-size:9.5px;fill:#4a545e}
.edge{stroke:#009e73;stroke-opacity:.45;fill:none}.waypoint{fill:#009e73}
.offset{stroke:#a04a86;fill:none}.before{fill:#fff;stroke:#a04a86}.task{fill:#cc79a7}.own{stroke:#1b1f24;stroke-width:1.8}
.task-name{font-size:10.5px;fill:#8a3a70}
.cell{stroke:#fff}.forbidden{fill:#e9ebee}.taken{fill:none;stroke:#d55e00;stroke-width:2.5}
.value{text-anchor:middle;font-size:11.5px}.light{fill:#fff}.row{text-anchor:end}.own-row{font-weight:700}.column{font-size:11px}
.term{font-size:11.5px;fill:#4a545e}
</style>)"_html;

}  // namespace

std::string moment_svg(const RecordedMatch& match, const RecordedMoment& moment,
                       const std::optional<RobotName>& robot) {
  const config::FieldSize& field = match.field();
  Scale to{margin, head, 0.0, field.length / 2.0 + field.border_strip, field.width / 2.0 + field.border_strip};
  const double room = width - 2.0 * margin - (robot ? panel_width + margin : 0.0);
  to.per_metre = room / (2.0 * to.half_length);
  const double bottom = to.top + 2.0 * to.half_width * to.per_metre;
  const std::size_t rows = moment.decision ? moment.decision->rows.size() : 0;
  const double height = std::max(bottom, robot ? 420.0 + 25.0 * static_cast<double>(rows) : 0.0) + 36.0;

  const RecordedGame& game = moment.game;
  Html out = drawn(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" )"
                   R"(height="{1:.0f}"><rect width="100%" height="100%" fill="#fff"/>)",
                   width, height);
  out << style;
  out << label(margin, 32.0, "head",
               fmt::format("{} {} : {} {}", visible_at_most(match.teams()[0].name, 32), game.score[0], game.score[1],
                           visible_at_most(match.teams()[1].name, 32)));
  out << label(margin, 52.0, "small",
               fmt::format("{}   half {}, clock {}   {}{}   packets left {} : {}", time_text(game.time), game.half,
                           time_text(game.clock), words_of(game.phase),
                           game.set_play == "none" ? std::string()
                                                   : fmt::format(", {} of {}", words_of(game.set_play), game.kicking),
                           game.packets_left[0], game.packets_left[1]));
  out << field_lines(field, to);
  if (robot) {
    const RecordedTeam& team = match.teams()[static_cast<std::size_t>(robot->side)];
    if (moment.decision) out << planned(*moment.decision, team, to);
    out << truth(match, game, robot, to);
    const bool common = moment.decision && moment.decision->knowledge == "common";
    if (moment.belief) {
      const RecordedWorld& world = common && moment.belief->common ? *moment.belief->common : moment.belief->mine;
      out << believed(world, team, *robot, to);
    }
    out << panel(match, moment, *robot, width - panel_width);
    out << label(margin, bottom + 20.0, "small",
                 "filled: the truth; dashed: what the robot believes, with the age of the news and two standard "
                 "deviations; green: waypoints; purple: tasks before and after the offset");
  } else {
    out << truth(match, game, robot, to);
  }
  return (out << "</svg>\n"_html).str();
}

}  // namespace regista::report
