// SPDX-License-Identifier: MIT
#include "recording/moment_svg.hpp"

#include <numbers>
#include <string_view>

#include "config/errors.hpp"
#include "config/scalar.hpp"

namespace regista::recording {
namespace {

using namespace moment;

constexpr double width = 1280.0, margin = 20.0, head = 64.0;

std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

// Draws an ellipse of two standard deviations.
Html ellipse(const RecordedCovariance& c, double x, double y, const Scale& to) {
  const double mean = (c.xx + c.yy) / 2.0, apart = std::hypot((c.xx - c.yy) / 2.0, c.xy);
  const double angle = 0.5 * std::atan2(2.0 * c.xy, c.xx - c.yy);
  const double longer = 2.0 * std::sqrt(std::max(mean + apart, 0.0)),
               shorter = 2.0 * std::sqrt(std::max(mean - apart, 0.0));
  return drawn(R"(<ellipse class="spread" cx="{0:.1f}" cy="{1:.1f}" rx="{2:.1f}" ry="{3:.1f}" )"
               R"x(transform="rotate({4:.1f} {0:.1f} {1:.1f})"/>)x",
               to.x(x), to.y(y), longer * to.per_metre, shorter * to.per_metre, -angle * 180.0 / std::numbers::pi);
}

// Labels choose their places in this order: the chosen robot, its team, its tasks, ages of its beliefs, opponents.
constexpr Labels::Style of_chosen{"role", 0, 10.5, true}, of_own_team{"role", 1, 10.5, true},
    of_tasks{"task-name", 2, 10.5, true}, of_ages{"age", 3, 9.5, false}, of_opponents{"role", 4, 10.5, false};

// Draws home robots as discs and away robots as squares. kind: a class of the style sheet.
Html robot_shape(const mind::Pose& pose, double radius, int side, int number, const char* kind, const Scale& to) {
  const double x = to.x(pose.x), y = to.y(pose.y), r = radius * to.per_metre, half = 0.9 * r;
  Html out = drawn(R"(<g class="{}">)", kind);
  if (side == 0) {
    out << drawn(R"(<circle class="body" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", x, y, r);
  } else {
    out << drawn(R"(<rect class="body" x="{0:.1f}" y="{1:.1f}" width="{2:.1f}" height="{2:.1f}" rx="2"/>)", x - half,
                 y - half, 2.0 * half);
  }
  out << drawn(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", x, y, x + 1.5 * r * std::cos(pose.heading),
               y - 1.5 * r * std::sin(pose.heading));
  if (number > 0) out << drawn(R"(<text x="{:.1f}" y="{:.1f}">{}</text>)", x, y + 4.5, number);
  return out << "</g>"_html;
}

Html truth(const RecordedMatch& match, const RecordedGame& game, const std::optional<RobotName>& chosen,
           const Scale& to, Labels& labels) {
  Html out;
  for (const std::size_t side : {0u, 1u}) {
    const RecordedTeam& team = match.teams()[side];
    for (std::size_t i = 0; i < game.robots[side].size(); ++i) {
      const int number = static_cast<int>(i) + 1;
      const mind::Pose& pose = game.robots[side][i];
      const bool away = std::ranges::find(game.penalised[side], number) != game.penalised[side].end();
      const bool is_chosen = chosen && static_cast<std::size_t>(chosen->side) == side && chosen->number == number;
      const double x = to.x(pose.x), y = to.y(pose.y), radius = team.robot_radius * to.per_metre;
      if (is_chosen) {
        out << drawn(R"(<circle class="chosen" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", x, y,
                     (team.robot_radius + 0.12) * to.per_metre);
      }
      out << robot_shape(pose, team.robot_radius, static_cast<int>(side), number,
                         away        ? (side == 0 ? "robot home penalised" : "robot away penalised")
                         : side == 0 ? "robot home"
                                     : "robot away",
                         to);
      if (std::ranges::find(game.fallen[side], number) != game.fallen[side].end()) {
        const double r = (team.robot_radius + 0.05) * to.per_metre;
        out << drawn(R"(<path class="fallen" d="M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", x - r,
                     y - r, x + r, y + r, x - r, y + r, x + r, y - r);
      }
      labels.take(x, y, radius);
      const bool opponent = chosen && static_cast<std::size_t>(chosen->side) != side;
      const std::string name = away                       ? "penalised"
                               : game.roles[side][i] >= 0 ? visible_at_most(role_name(team, game.roles[side][i]), 24)
                                                          : std::string();
      labels.add(x, y, is_chosen ? radius + 0.12 * to.per_metre : radius, name,
                 is_chosen  ? of_chosen
                 : opponent ? of_opponents
                            : of_own_team);
    }
  }
  const double x = to.x(game.ball[0]), y = to.y(game.ball[1]),
               radius = std::max(4.0, match.ball_radius() * to.per_metre);
  labels.take(x, y, radius);
  return out << drawn(R"(<circle class="ball" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", x, y, radius);
}

Html believed(const RecordedWorld& world, const mind::Pose& own, const RecordedTeam& team, const RobotName& robot,
              const Scale& to, Labels& labels) {
  const double radius = team.robot_radius * to.per_metre;
  Html out = robot.side == 0 ? R"x(<g class="of-home" clip-path="url(#field)">)x"_html
                             : R"x(<g class="of-away" clip-path="url(#field)">)x"_html;
  for (const RecordedTeammate& mate : world.teammates) {
    if (mate.number == robot.number) continue;
    out << ellipse(mate.covariance, mate.pose.x, mate.pose.y, to)
        << robot_shape(mate.pose, team.robot_radius, robot.side, mate.number, "ghost mate", to);
    labels.take(to.x(mate.pose.x), to.y(mate.pose.y), radius / 2.0);
    labels.add(to.x(mate.pose.x), to.y(mate.pose.y), radius, fmt::format("{:.1f} s", mate.age), of_ages);
  }
  for (const RecordedObject& opponent : world.opponents) {
    out << ellipse(opponent.covariance, opponent.x, opponent.y, to)
        << robot_shape({opponent.x, opponent.y, 0.0}, team.robot_radius, 1 - robot.side, 0, "ghost other", to);
    labels.add(to.x(opponent.x), to.y(opponent.y), radius, fmt::format("{:.1f} s", opponent.age), of_ages);
  }
  if (world.ball) {
    out << ellipse(world.ball->covariance, world.ball->x, world.ball->y, to)
        << drawn(R"(<circle class="ghost believed-ball" cx="{:.1f}" cy="{:.1f}" r="6"/>)", to.x(world.ball->x),
                 to.y(world.ball->y));
    labels.take(to.x(world.ball->x), to.y(world.ball->y), 6.0);
    labels.add(to.x(world.ball->x), to.y(world.ball->y), 6.0, fmt::format("ball, {:.1f} s", world.ball->age), of_ages);
  }
  // The ghost shows the robot at the pose that the robot believes it has.
  return out << robot_shape(own, team.robot_radius, robot.side, robot.number, "ghost mate itself", to) << "</g>"_html;
}

Html planned(const RecordedDecision& decision, const RecordedTeam& team, const Scale& to, Labels& labels) {
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
                 to.x(task.after->x) - 4.5, to.y(task.after->y) - 4.5);
    labels.take(to.x(task.after->x), to.y(task.after->y), 4.5);
    labels.add(to.x(task.after->x), to.y(task.after->y), 4.5, visible_at_most(role_name(team, task.role), 20),
               of_tasks);
  }
  return out;
}

// Returns how far (m, at most 1) penalised robots stand beside the carpet: the field and its strip, of this half width.
double outside_of(const RecordedMatch& match, const RecordedGame& game, double half_width) {
  constexpr double farthest = 1.0, name = 0.25;  // m; a damaged recording may have any pose; room for a label
  double out = 0.0;
  for (const std::size_t side : {0u, 1u}) {
    for (const mind::Pose& each : game.robots[side])
      out = std::max(out, std::abs(each.y) + match.teams()[side].robot_radius + name - half_width);
  }
  return std::min(out, farthest);
}

constexpr Markup style = R"(<style>
text{font-family:"Helvetica Neue",Arial,"DejaVu Sans",sans-serif;font-size:12px;fill:#1b1f24}
.head{font-size:22px;font-weight:600}.small{fill:#4a545e;white-space:pre}.title{font-size:17px;font-weight:600}.heading{font-weight:600}
.grass{fill:#eef4ee}.line *{fill:none;stroke:#7d8a80;stroke-width:1.5}
.robot text,.ghost text{text-anchor:middle;font-size:12.5px;font-weight:600}
.robot .body{stroke:#fff;stroke-width:1}.robot path{stroke:#1b1f24;stroke-width:2}.fallen{stroke:#1b1f24;stroke-width:2.5}
.home .body{fill:#0072b2}.away .body{fill:#d55e00}.home text,.away text{fill:#fff}.penalised{opacity:.3}
.chosen{fill:none;stroke:#1b1f24;stroke-width:2.5}.ball{fill:#1b1f24;stroke:#fff;stroke-width:1.5}
.lead{stroke:#4a545e;stroke-opacity:.7;fill:none}.role{text-anchor:middle;font-size:10.5px;fill:#4a545e}
.ghost .body,circle.ghost{fill:none;stroke-width:1.4;stroke-dasharray:4 3}.ghost path{stroke-width:1.2}.other path{display:none}
.of-home .mate *,.of-away .other *{stroke:#0072b2}.of-away .mate *,.of-home .other *{stroke:#d55e00}
.of-home .mate text{fill:#0072b2;stroke:#fff}.of-away .mate text{fill:#b34f00;stroke:#fff}.believed-ball{stroke:#1b1f24}
.role,.age,.task-name,.mate text{paint-order:stroke;stroke:#fff;stroke-width:2.5px;stroke-linejoin:round}
.spread{fill:#5b6670;fill-opacity:.07;stroke:#5b6670;stroke-opacity:.45;stroke-width:.8}
.age{text-anchor:middle;font-size:9.5px;fill:#4a545e}
.edge{stroke:#009e73;stroke-opacity:.45;fill:none}.waypoint{fill:#009e73}
.offset{stroke:#a04a86;fill:none}.before{fill:#fff;stroke:#a04a86}.task{fill:#cc79a7}.own{stroke:#1b1f24;stroke-width:1.8}
.task-name{text-anchor:middle;font-size:10.5px;fill:#8a3a70}
.cell{stroke:#fff}.forbidden{fill:#e9ebee}.taken{fill:none;stroke:#d55e00;stroke-width:2.5}
.value{text-anchor:middle;font-size:11.5px}.light{fill:#fff}.row{text-anchor:end}.own-row{font-weight:700}.column{font-size:11px}
.term{font-size:11.5px;fill:#4a545e}
.layer path{stroke-linejoin:round;stroke-linecap:round}.swatch{stroke:#4a545e;stroke-width:.8}
.said{font-size:11px;paint-order:stroke;stroke:#fff;stroke-width:2.5px;stroke-linejoin:round}
.light-said{stroke:#1b1f24}
.log{font-family:"DejaVu Sans Mono",Menlo,Consolas,monospace;font-size:11px}.marked{font-weight:700}
</style>)"_html;

}  // namespace

std::string moment_svg(const RecordedMatch& match, const RecordedMoment& moment,
                       const std::optional<RobotName>& robot) {
  const config::FieldSize& field = match.field();
  Scale to{margin, head, 0.0, field.length / 2.0 + field.border_strip, field.width / 2.0 + field.border_strip};
  const double room = width - 2.0 * margin - (robot ? panel_width + margin : 0.0);
  to.per_metre = room / (2.0 * to.half_length);
  const double outside = outside_of(match, moment.game, to.half_width) * to.per_metre;
  to.top += outside;
  const double below = to.top + 2.0 * to.half_width * to.per_metre, bottom = below + outside;
  const Panel beside = robot ? panel(match, moment, *robot, width - panel_width, head) : Panel{};
  const Panel legend = names_of_layers(moment.drawings, margin, bottom + 57.0);
  const double height = std::max(robot ? legend.bottom : bottom + 20.0, beside.bottom + 20.0);

  const RecordedGame& game = moment.game;
  Html out = sheet(width, height);
  out << style
      << drawn(R"(<clipPath id="field"><rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/></clipPath>)",
               to.left, to.top, 2.0 * to.half_length * to.per_metre, 2.0 * to.half_width * to.per_metre);
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
  Labels labels;
  const Area area{0.0, head - 8.0, 2.0 * margin + room, bottom + 8.0};
  if (robot) {
    const RecordedTeam& team = match.teams()[static_cast<std::size_t>(robot->side)];
    out << layers(moment.drawings, to);
    if (moment.decision) out << planned(*moment.decision, team, to, labels);
    out << truth(match, game, robot, to, labels);
    const bool common = moment.decision && moment.decision->knowledge == "common";
    if (moment.belief) {
      const RecordedWorld& world = common && moment.belief->common ? *moment.belief->common : moment.belief->mine;
      out << believed(world, moment.belief->pose, team, *robot, to, labels);
    }
    out << labels.written(area) << beside.drawing
        << label(margin, bottom + 20.0, "small",
                 "filled: the truth (home round, away square, crossed out: fallen); dashed: what the robot believes, "
                 "with "
                 "the age of")
        << label(margin, bottom + 37.0, "small",
                 "the news and two standard deviations; green: waypoints; purple: tasks before and after the offset")
        << legend.drawing;
  } else {
    out << truth(match, game, robot, to, labels) << labels.written(area);
  }
  return (out << "</svg>\n"_html).str();
}

Moment parse_moment(const std::string& typed) {
  const auto refuse = [&] {
    throw config::BadInput(
        fmt::format("--at: {}; expected the time since the match began, 7:42 or 462.3, or the clock of a half, 2/7:42",
                    texts::in_quotes(typed)));
  };
  Moment out;
  out.typed = typed;
  std::string_view rest = typed;
  if (const std::size_t slash = rest.find('/'); slash != std::string_view::npos) {
    const auto half = config::number_in<int>(rest.substr(0, slash));
    if (!half || *half < 1 || *half > 99) refuse();
    out.half = *half;
    rest.remove_prefix(slash + 1);
  }
  double minutes = 0.0;
  if (const std::size_t colon = rest.find(':'); colon != std::string_view::npos) {
    const auto whole = config::number_in<int>(rest.substr(0, colon));
    if (!whole || *whole < 0) refuse();
    minutes = *whole;
    rest.remove_prefix(colon + 1);
  }
  const auto seconds = config::typed_number(rest);
  if (!seconds || !(*seconds >= 0.0) || *seconds > 1e6) refuse();
  // The seconds need two digits, because 7:4 could mean 7:40 or 7:04.
  const bool two_digits = rest.size() == 2 || (rest.size() > 2 && rest[2] == '.');
  if (typed.find(':') != std::string::npos && (*seconds >= 60.0 || !two_digits)) refuse();
  out.seconds = 60.0 * minutes + *seconds;
  return out;
}

RobotName parse_robot(const std::string& typed, int team_size) {
  std::string_view rest = typed;
  RobotName out;
  if (rest.starts_with("home/")) {
    rest.remove_prefix(5);
  } else if (rest.starts_with("away/")) {
    out.side = 1;
    rest.remove_prefix(5);
  }
  const auto number = config::number_in<int>(rest);
  if (!number || *number < 1 || *number > team_size) {
    throw config::BadInput(fmt::format("--robot: {}; expected 1 to {}, home/1 to home/{} or away/1 to away/{}",
                                       texts::in_quotes(typed), team_size, team_size, team_size));
  }
  out.number = *number;
  return out;
}

void keep_layers(std::vector<RecordedDrawing>& drawings, const std::vector<std::string>& typed) {
  if (typed.empty()) return;
  const auto is_meant = [](const RecordedDrawing& drawing, const std::string& name) {
    return name == drawing.layer || name == drawing.name();
  };
  for (const std::string& name : typed) {
    if (std::ranges::any_of(drawings, [&](const auto& drawing) { return is_meant(drawing, name); })) continue;
    if (drawings.empty()) {
      throw config::BadInput(
          fmt::format("--layer {}: no plugin of this robot has drawn anything by then", texts::in_quotes(name)));
    }
    // Known names get the form of the typed name, "cells" or "voronoi: cells", so that the message can suggest them.
    constexpr std::size_t longest = 60;
    const bool with_plugin = name.find(": ") != std::string::npos;
    std::vector<std::string> known;
    for (const RecordedDrawing& drawing : drawings)
      texts::add_once(known, texts::visible_at_most(with_plugin ? drawing.name() : drawing.layer, longest));
    throw config::BadInput("--layer: " + texts::unknown("layer", name, "the drawings of this robot", known));
  }
  for (RecordedDrawing& drawing : drawings) {
    const bool kept = std::ranges::any_of(typed, [&](const std::string& name) { return is_meant(drawing, name); });
    if (!kept) drawing.shapes.clear();
  }
}

double time_of(const RecordedMatch& match, const Moment& moment) {
  if (moment.half == 0) {
    if (moment.seconds <= match.end() + 1e-9) return std::max(moment.seconds, match.begin());
    throw config::BadInput(fmt::format("--at {}: the recording ends at {:.1f} s", moment.typed, match.end()));
  }
  if (const auto time = match.time_of(moment.half, moment.seconds)) return *time;
  throw config::BadInput(
      fmt::format("--at {}: the clock of half {} does not show that in this recording, which ends {:.1f} s "
                  "after the match began",
                  moment.typed, moment.half, match.end()));
}

}  // namespace regista::recording
