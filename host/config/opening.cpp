// SPDX-License-Identifier: MIT
#include "config/opening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/read.hpp"
#include "config/team.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

using Point = std::array<double, 2>;

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

std::string text(const Point& point) { return fmt::format("({}, {})", point[0], point[1]); }

std::string rounded(double value) { return fmt::format("{:.4g}", value); }

// Returns the distance from `point` to the nearest part of either goal: the posts, and the sides and back of the net.
double to_goal_frame(const Point& point, const FieldSize& field) {
  const double line = field.length / 2.0, back = line + field.goal_depth;
  const double post = (field.goal_width + field.post_diameter) / 2.0;
  // The field is symmetric, so one quadrant represents all.
  const Point at{std::fabs(point[0]), std::fabs(point[1])};
  const Point on_side{std::clamp(at[0], line, back), post}, on_back{back, std::clamp(at[1], 0.0, post)};
  const double to_post = std::max(distance(at, {line, post}) - field.post_diameter / 2.0, 0.0);
  return std::min({to_post, distance(at, on_side), distance(at, on_back)});
}

// A robot that plays from the opening.
struct Standing {
  std::string path, name;  // for messages: "home.0.at", "home 1"
  Point at;
  double radius;
};

std::vector<Standing> standing(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots) {
  std::vector<Standing> all;
  for (const std::size_t side : {0u, 1u}) {
    const char* const name = side == 0 ? "home" : "away";
    const std::vector<Opening::Player>& players = side == 0 ? opening.home : opening.away;
    for (std::size_t i = 0; i < std::min(players.size(), static_cast<std::size_t>(rules.team_size)); ++i) {
      all.push_back({fmt::format("{}.{}.at", name, i), fmt::format("{} {}", name, i + 1), players[i].at,
                     robots[side].body.radius});
    }
  }
  return all;
}

}  // namespace

static Map declare(Opening::Ball& ball) {
  return {{
      required(numbers("at", ball.at, coordinates, "m", "where it is: x, y")),
      numbers("velocity", ball.velocity, {-20, 20}, "m/s", "how it moves: along x, along y"),
  }};
}

static Map declare(Opening::Player& player) {
  return {{
      required(numbers("at", player.at, coordinates, "m", "where it stands: x, y")),
      degrees("heading_deg", player.heading, {-360, 360}, "deg",
              "0 looks along x, 90 along y; without it the robot looks at the ball"),
  }};
}

Map declare(Opening& opening) {
  return {{
      required(name("opening", opening.name, "name of this opening")),
      line("summary", opening.summary, "what is going on, in one line"),
      required(real("length", opening.length, {0.1, 3600}, "s", "of play, then the game ends")),
      required(section("ball", opening.ball, "the ball; world frame, in which home attacks along x")),
      required(
          list("home", opening.home, 1, 22, "robots number 1, 2, ... of home; a smaller team uses the first ones")),
      required(list("away", opening.away, 1, 22, "the same of away, in the same frame")),
  }};
}

double heading(const Opening& opening, const Opening::Player& player) {
  if (player.heading) return *player.heading;
  return std::atan2(opening.ball.at[1] - player.at[1], opening.ball.at[0] - player.at[0]);
}

std::vector<Misfit> misfits(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots) {
  std::vector<Misfit> out;
  const auto found = [&](std::string path, const std::string& reason, std::string other = {}) {
    out.push_back({std::move(path), fmt::format("opening {}: {}", opening.name, reason), std::move(other)});
  };
  for (const auto& [side, players] : {std::pair{"home", &opening.home}, {"away", &opening.away}}) {
    if (players->size() < static_cast<std::size_t>(rules.team_size)) {
      found(side, fmt::format("{} has {}, a team has {} robots", side,
                              texts::plural(players->size(), "place", "places"), rules.team_size));
    }
  }
  const FieldSize& field = rules.field;
  const Point& ball = opening.ball.at;
  const double ball_radius = rules.ball.diameter / 2.0;
  const double x = field.length / 2.0, y = field.width / 2.0;
  if (std::fabs(ball[0]) > x || std::fabs(ball[1]) > y) {
    found("ball.at", fmt::format("the ball at {} is off the field, which ends at x = {} and y = {} m", text(ball),
                                 rounded(x), rounded(y)));
  } else if (to_goal_frame(ball, field) < ball_radius) {
    found("ball.at", fmt::format("the ball at {} is on a goal post", text(ball)));
  }
  const std::vector<Standing> all = standing(opening, rules, robots);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Standing& robot = all[i];
    const std::string who = fmt::format("{} at {}", robot.name, text(robot.at));
    const double end_x = x + field.border_strip - robot.radius, end_y = y + field.border_strip - robot.radius;
    if (std::fabs(robot.at[0]) > end_x || std::fabs(robot.at[1]) > end_y) {
      found(robot.path, fmt::format("{} is off the carpet, which has room up to x = {} and y = {} m", who,
                                    rounded(end_x), rounded(end_y)));
      continue;
    }
    if (to_goal_frame(robot.at, field) < robot.radius) {
      found(robot.path, who + " stands in a goal's frame");
      continue;
    }
    const double to_ball = distance(robot.at, ball), on_ball = robot.radius + ball_radius;
    if (to_ball < on_ball) {
      found(robot.path,
            fmt::format("{} stands on the ball at {}: {} m apart, they need {} m", who, text(ball), rounded(to_ball),
                        rounded(on_ball)),
            "ball.at");
    }
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = distance(robot.at, all[j].at), bodies = robot.radius + all[j].radius;
      if (apart >= bodies) continue;
      found(robot.path,
            fmt::format("{} and {} at {} overlap: {} m apart, they need {} m", who, all[j].name, text(all[j].at),
                        rounded(apart), rounded(bodies)),
            all[j].path);
    }
  }
  return out;
}

void check(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots, const Node& document,
           Mistakes& mistakes) {
  for (const Misfit& each : misfits(opening, rules, robots)) {
    // If the list has too few places, this is reported even if an element of the list is wrong or unknown.
    const bool of_places = each.path == "home" || each.path == "away";
    if (of_places ? mistakes.mistaken(each.path) : mistakes.doubtful(each.path)) continue;
    if (!each.other.empty() && mistakes.doubtful(each.other)) continue;
    mistakes.attempt(each.path, [&] { refuse(document, {each.path}, each.reason); });
  }
}

std::optional<Misfit> misfit(const Opening& opening, const Rules& rules, const std::array<Robot, 2>& robots) {
  const std::vector<Misfit> all = misfits(opening, rules, robots);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

}  // namespace regista::config
