// SPDX-License-Identifier: MIT
// The usual field, and how an environment is laid out in the memory that a plugin reads.
#include <regista/testkit/environment_builder.hpp>

#include <cstdint>
#include <numbers>
#include <utility>

namespace regista::testkit {

const std::vector<std::string>& usual_roles() {
  static const std::vector<std::string> names{"goalkeeper", "striker", "supporter",  "defender_left", "defender_right",
                                              "jolly",      "libero",  "midfielder", "wing_left",     "wing_right",
                                              "sweeper",    "stopper", "search_1",   "search_2"};
  return names;
}

namespace {

constexpr regista_event_name usual_events[] = {{REGISTA_EVENT_PERIOD, 0, "period"},
                                               {REGISTA_EVENT_WHISTLE, 0, "whistle"},
                                               {REGISTA_EVENT_BALL_FOUND, 0, "ball_found"},
                                               {REGISTA_EVENT_GOALKEEPER_SAW_BALL, 0, "goalkeeper_saw_ball"},
                                               {REGISTA_EVENT_BALL_KNOWN_AGAIN, 0, "ball_known_again"},
                                               {REGISTA_EVENT_ROLE_CHANGED, 0, "role_changed"},
                                               {REGISTA_EVENT_BALL_MOVED, 0, "ball_moved"},
                                               {REGISTA_EVENT_POSE_MOVED, 0, "pose_moved"},
                                               {REGISTA_EVENT_FELL, 0, "fell"},
                                               {REGISTA_EVENT_GOT_UP, 0, "got_up"},
                                               {REGISTA_EVENT_PHASE_CHANGED, 0, "phase_changed"},
                                               {REGISTA_EVENT_CONTEXT_CHANGED, 0, "context_changed"},
                                               {REGISTA_EVENT_RETURNED, 0, "returned"},
                                               {REGISTA_EVENT_OFFER, 0, "offer"}};

}  // namespace

struct Setting::Stored {
  std::vector<std::string> names, lists, kick_names;
  Strided<regista_landmark> landmarks;
  Strided<regista_role> roles;
  Strided<regista_kick> kicks;
  Strided<regista_event_name> events;
  Grown<regista_environment> environment;
};

const regista_environment& Setting::raw() const { return stored_->environment.get(); }

regista::Environment Setting::environment() const { return regista::Environment(raw()); }

void Setting::end_of_create() const {
  stored_->landmarks.scribble();
  stored_->kicks.scribble();
  stored_->events.scribble();
  stored_->environment.scribble();
}

EnvironmentBuilder::EnvironmentBuilder() {
  e_.team_size = 7;
  e_.own_number = 2;
  e_.field_length = 9.0;
  e_.field_width = 6.0;
  e_.border_strip = 0.7;
  e_.goal_width = 1.5;
  e_.goal_depth = 0.5;
  e_.goal_area_length = 0.6;
  e_.goal_area_width = 2.2;
  e_.penalty_area_length = 1.65;
  e_.penalty_area_width = 4.0;
  e_.penalty_mark_distance = 1.3;
  e_.centre_circle_radius = 0.75;
  e_.ball_radius = 0.05;
  e_.robot_radius = 0.15;
  e_.walk_forward = 0.25;
  e_.walk_sideways = 0.18;
  e_.walk_backward = 0.20;
  e_.turn_rate = 1.5707963267948966;
  e_.decision_period = 0.1;
  e_.packet_size = 128;
  e_.packet_budget = 1200;
  e_.goal_post_radius = 0.05;
  e_.ball_deceleration = 0.32;
  e_.halves = 2;
  e_.half_length = 600.0;
  e_.set_play_distance = 0.75;
  constexpr double degree = std::numbers::pi / 180.0;
  e_.kick_reach = 0.22;
  e_.kick_reach_angle = 60.0 * degree;
  e_.camera_half_angle = 27.35 * degree;
  e_.camera_ball_range = 5.0;
  e_.camera_robot_range = 4.0;
  e_.head_yaw = 90.0 * degree;
  e_.head_speed = 115.0 * degree;
  kick("fast", 1.6, 4.5, 1.6, 0.65).kick("long", 5.4, 5.4, 1.65, 0.65).kick("in_walk", 0.4, 1.0, 0.5, 0.25);
  roles(usual_roles());
  roles_.front().robot = 1;  // the goalkeeper is number 1
}

EnvironmentBuilder& EnvironmentBuilder::field(double length, double width, double border_strip) {
  e_.field_length = length;
  e_.field_width = width;
  e_.border_strip = border_strip;
  return *this;
}

EnvironmentBuilder& EnvironmentBuilder::walk(double forward, double sideways, double backward, double turn_rate) {
  e_.walk_forward = forward;
  e_.walk_sideways = sideways;
  e_.walk_backward = backward;
  e_.turn_rate = turn_rate;
  return *this;
}

EnvironmentBuilder& EnvironmentBuilder::packets(unsigned size, unsigned budget) {
  e_.packet_size = size;
  e_.packet_budget = budget;
  return *this;
}

EnvironmentBuilder& EnvironmentBuilder::roles(const std::vector<std::string>& names) {
  roles_.clear();
  for (const std::string& name : names) role(name);
  return *this;
}

EnvironmentBuilder& EnvironmentBuilder::role(std::string name, int robot, std::string list) {
  int priority = 0;
  for (const RoleRow& row : roles_) priority += row.list == list ? 1 : 0;
  roles_.push_back({std::move(name), std::move(list), priority, robot});
  return *this;
}

EnvironmentBuilder& EnvironmentBuilder::kick(std::string name, double minimum_distance, double maximum_distance,
                                             double duration, double impact) {
  constexpr double distance_error = 0.07, direction_error = 7.0 * std::numbers::pi / 180.0;
  kicks_.push_back({std::move(name),
                    {nullptr, minimum_distance, maximum_distance, duration, impact, distance_error, direction_error}});
  return *this;
}

EnvironmentBuilder& EnvironmentBuilder::no_landmarks() { return landmarks_ = false, *this; }

Setting EnvironmentBuilder::build(const Layout& layout) const {
  Setting setting;
  setting.stored_ = std::make_shared<Setting::Stored>();
  Setting::Stored& s = *setting.stored_;
  s.names.reserve(roles_.size());
  s.lists.reserve(roles_.size());
  std::vector<regista_role> roles;
  for (const RoleRow& row : roles_) {
    s.names.push_back(row.name);
    s.lists.push_back(row.list);
    roles.push_back({s.names.back().c_str(), s.lists.back().c_str(), row.priority, row.robot});
  }
  s.roles = Strided<regista_role>(roles, layout);
  s.landmarks = Strided<regista_landmark>(landmarks_ ? landmarks() : std::vector<regista_landmark>{}, layout);
  s.kick_names.reserve(kicks_.size());
  std::vector<regista_kick> kicks;
  for (const KickRow& row : kicks_) {
    s.kick_names.push_back(row.name);
    kicks.push_back(row.kick);
    kicks.back().name = s.kick_names.back().c_str();
  }
  s.kicks = Strided<regista_kick>(kicks, layout);
  s.events = Strided<regista_event_name>(usual_events, layout);
  regista_environment e = e_;
  e.kicks = s.kicks.span();
  e.events = s.events.span();
  e.roles = s.roles.span();
  e.landmarks = s.landmarks.span();
  s.environment = Grown<regista_environment>(e, layout);
  s.environment.make_read_only();
  return setting;
}

std::vector<regista_landmark> EnvironmentBuilder::landmarks() const {
  const double x = e_.field_length / 2, y = e_.field_width / 2;
  std::vector<regista_landmark> out{{REGISTA_LANDMARK_CENTRE, 0, 0.0, 0.0}};
  const auto four = [&](std::int32_t kind, double px, double py) {
    for (const double sx : {-1.0, 1.0}) {
      for (const double sy : {-1.0, 1.0}) out.push_back({kind, 0, sx * px, sy * py});
    }
  };
  four(REGISTA_LANDMARK_GOAL_POST, x, e_.goal_width / 2 + e_.goal_post_radius);
  out.push_back({REGISTA_LANDMARK_PENALTY_MARK, 0, -(x - e_.penalty_mark_distance), 0.0});
  out.push_back({REGISTA_LANDMARK_PENALTY_MARK, 0, x - e_.penalty_mark_distance, 0.0});
  four(REGISTA_LANDMARK_CORNER, x, y);
  out.push_back({REGISTA_LANDMARK_T_JUNCTION, 0, 0.0, -y});
  out.push_back({REGISTA_LANDMARK_T_JUNCTION, 0, 0.0, y});
  four(REGISTA_LANDMARK_T_JUNCTION, x, e_.goal_area_width / 2);
  four(REGISTA_LANDMARK_T_JUNCTION, x, e_.penalty_area_width / 2);
  return out;
}

}  // namespace regista::testkit
