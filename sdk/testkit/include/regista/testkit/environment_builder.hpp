// SPDX-License-Identifier: MIT
// The facts that an instance is created with. Defaults: the field, robot and budget of the SPL rule book 2023.
//
//   const Setting setting = EnvironmentBuilder{}.team_size(5).own(2).roles({"goalkeeper", "striker"}).build();
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <regista/frame.hpp>
#include <regista/testkit/storage.hpp>

namespace regista::testkit {

// Roles that scenes refer to by name when a test names none of its own: more than any team has robots.
inline const std::vector<std::string>& usual_roles() {
  static const std::vector<std::string> names{"goalkeeper", "striker", "supporter",  "defender_left", "defender_right",
                                              "jolly",      "libero",  "midfielder", "wing_left",     "wing_right",
                                              "sweeper",    "stopper", "search_1",   "search_2"};
  return names;
}

// Owns an environment. Copies share the storage.
class Setting {
 public:
  const regista_environment& raw() const { return stored_->environment.get(); }
  regista::Environment environment() const { return regista::Environment(raw()); }
  // Everything but the roles ends with create(): called after it, this finds plugins that kept a pointer.
  void end_of_create() const {
    stored_->landmarks.scribble();
    stored_->environment.scribble();
  }

 private:
  friend class EnvironmentBuilder;
  struct Stored {
    std::vector<std::string> names, lists;
    Strided<regista_landmark> landmarks;
    Strided<regista_role> roles;
    Grown<regista_environment> environment;
  };
  std::shared_ptr<Stored> stored_;
};

class EnvironmentBuilder {
 public:
  EnvironmentBuilder() {
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
    roles(usual_roles());
    roles_.front().robot = 1;  // the goalkeeper is number 1
  }
  EnvironmentBuilder& team_size(unsigned robots) { return e_.team_size = robots, *this; }
  EnvironmentBuilder& own(int number) { return e_.own_number = number, *this; }
  EnvironmentBuilder& subject(unsigned bit) { return e_.subject = bit, *this; }
  EnvironmentBuilder& field(double length, double width, double border_strip) {
    e_.field_length = length;
    e_.field_width = width;
    e_.border_strip = border_strip;
    return *this;
  }
  EnvironmentBuilder& walk(double forward, double sideways, double backward, double turn_rate) {
    e_.walk_forward = forward;
    e_.walk_sideways = sideways;
    e_.walk_backward = backward;
    e_.turn_rate = turn_rate;
    return *this;
  }
  EnvironmentBuilder& packets(unsigned size, unsigned budget) {
    e_.packet_size = size;
    e_.packet_budget = budget;
    return *this;
  }
  EnvironmentBuilder& decision_period(double seconds) { return e_.decision_period = seconds, *this; }
  // Replaces the table of roles: any robot may take each, in order of importance, list "playing".
  EnvironmentBuilder& roles(const std::vector<std::string>& names) {
    roles_.clear();
    for (const std::string& name : names) role(name);
    return *this;
  }
  // Adds a row to the table of roles. `robot`: shirt number that alone may take it, 0 = any.
  EnvironmentBuilder& role(std::string name, int robot = 0, std::string list = "playing") {
    int priority = 0;
    for (const RoleRow& row : roles_) priority += row.list == list ? 1 : 0;
    roles_.push_back({std::move(name), std::move(list), priority, robot});
    return *this;
  }
  EnvironmentBuilder& no_landmarks() { return landmarks_ = false, *this; }
  // For what no function above names.
  regista_environment& raw() { return e_; }

  Setting build(Growth growth = {}) const {
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
    s.roles = Strided<regista_role>(roles, growth);
    s.landmarks = Strided<regista_landmark>(landmarks_ ? landmarks() : std::vector<regista_landmark>{}, growth);
    regista_environment e = e_;
    e.roles = s.roles.span();
    e.landmarks = s.landmarks.span();
    s.environment = Grown<regista_environment>(e, growth);
    return setting;
  }

 private:
  struct RoleRow {
    std::string name, list;
    int priority, robot;
  };

  // Every landmark that the field's measures give. Goal posts are 0.1 thick: centres 0.05 beyond the inner width.
  std::vector<regista_landmark> landmarks() const {
    const double x = e_.field_length / 2, y = e_.field_width / 2;
    std::vector<regista_landmark> out{{REGISTA_LANDMARK_CENTRE, 0, 0.0, 0.0}};
    const auto four = [&](std::int32_t kind, double px, double py) {
      for (const double sx : {-1.0, 1.0}) {
        for (const double sy : {-1.0, 1.0}) out.push_back({kind, 0, sx * px, sy * py});
      }
    };
    four(REGISTA_LANDMARK_GOAL_POST, x, e_.goal_width / 2 + 0.05);
    out.push_back({REGISTA_LANDMARK_PENALTY_MARK, 0, -(x - e_.penalty_mark_distance), 0.0});
    out.push_back({REGISTA_LANDMARK_PENALTY_MARK, 0, x - e_.penalty_mark_distance, 0.0});
    four(REGISTA_LANDMARK_CORNER, x, y);
    out.push_back({REGISTA_LANDMARK_T_JUNCTION, 0, 0.0, -y});
    out.push_back({REGISTA_LANDMARK_T_JUNCTION, 0, 0.0, y});
    four(REGISTA_LANDMARK_T_JUNCTION, x, e_.goal_area_width / 2);
    four(REGISTA_LANDMARK_T_JUNCTION, x, e_.penalty_area_width / 2);
    return out;
  }

  regista_environment e_{};
  std::vector<RoleRow> roles_;
  bool landmarks_ = true;
};

}  // namespace regista::testkit
