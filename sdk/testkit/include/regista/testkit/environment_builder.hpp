// SPDX-License-Identifier: MIT
// The facts that an instance is created with. Defaults: the field and budget of the SPL rule book 2023, and a NAO.
//
//   const Setting setting = EnvironmentBuilder{}.team_size(5).own(2).roles({"goalkeeper", "striker"}).build();
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <regista/frame.hpp>
#include <regista/testkit/storage.hpp>

namespace regista::testkit {

// Roles that scenes refer to by name when a test names none of its own: more than any team has robots.
const std::vector<std::string>& usual_roles();

// Owns an environment. Copies share the storage.
class Setting {
 public:
  const regista_environment& raw() const;
  regista::Environment environment() const;
  // Everything but the roles ends with create(): called after it, this finds plugins that kept a pointer.
  void end_of_create() const;

 private:
  friend class EnvironmentBuilder;
  struct Stored;
  std::shared_ptr<Stored> stored_;
};

class EnvironmentBuilder {
 public:
  EnvironmentBuilder();
  EnvironmentBuilder& team_size(unsigned robots) { return e_.team_size = robots, *this; }
  EnvironmentBuilder& own(int number) { return e_.own_number = number, *this; }
  EnvironmentBuilder& subject(unsigned bit) { return e_.subject = bit, *this; }
  EnvironmentBuilder& field(double length, double width, double border_strip);
  EnvironmentBuilder& walk(double forward, double sideways, double backward, double turn_rate);
  EnvironmentBuilder& packets(unsigned size, unsigned budget);
  EnvironmentBuilder& decision_period(double seconds) { return e_.decision_period = seconds, *this; }
  // Replaces the table of roles: any robot may take each, in order of importance, list "playing".
  EnvironmentBuilder& roles(const std::vector<std::string>& names);
  // Adds a row to the table of roles. `robot`: shirt number that alone may take it, 0 = any.
  EnvironmentBuilder& role(std::string name, int robot = 0, std::string list = "playing");
  EnvironmentBuilder& no_landmarks();
  EnvironmentBuilder& no_kicks() { return kicks_.clear(), *this; }
  // Adds a kind of kick: how far the ball rolls, when it leaves and when the robot walks again, with a NAO's errors.
  EnvironmentBuilder& kick(std::string name, double minimum_distance, double maximum_distance, double duration,
                           double impact);
  // For what no function above names.
  regista_environment& raw() { return e_; }

  Setting build(const Layout& layout = {}) const;

 private:
  struct RoleRow {
    std::string name, list;
    int priority, robot;
  };
  struct KickRow {
    std::string name;
    regista_kick kick;  // without its name
  };

  // Every landmark that the field's measures give. The centres of goal posts are their radius beyond the inner width.
  std::vector<regista_landmark> landmarks() const;

  regista_environment e_{};
  std::vector<RoleRow> roles_;
  std::vector<KickRow> kicks_;
  bool landmarks_ = true;
};

}  // namespace regista::testkit
