// SPDX-License-Identifier: MIT
// A team whose plugins have been found and whose parameters have been checked: everything that is the same for all its
// robots. From one plan come as many minds as the team has robots.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/mistakes.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"
#include "mind/extensions/metric_reports.hpp"
#include "plugin/catalogue.hpp"
#include "plugin/parameters.hpp"

namespace regista::mind {

// A plugin with the values of its parameters.
struct Part {
  const plugin::Found* found = nullptr;
  plugin::Parameters parameters;
  config::PluginUse use;  // as the team's page has it
};

struct TermPart {
  std::string name;
  double weight = 1.0;
  Part part;
};

// What is in force while a context holds.
struct ContextPlan {
  Part condition;
  std::optional<Part> positioner;  // none: no waypoints, no filter by them, no offset
  Part assigner, sender;
  std::vector<TermPart> terms;
  std::vector<int> own_reasons;  // of the sender: indices into TeamPlan::reasons()
};

struct BehaviourPlan {
  std::string name;
  Part part;
};

// A row of the table of roles: its index is the id of role and task.
struct RoleRow {
  const config::Role* role = nullptr;
  int list = 0;               // index into Team::role_lists
  int priority = 0;           // place in the list
  std::size_t behaviour = 0;  // index into TeamPlan::behaviours()
};

class TeamPlan {
 public:
  // Throws config::Error, located in the team's page, for a plugin that is missing, refused, of the wrong kind or given
  // wrong parameters. `catalogue` outlives the plan.
  TeamPlan(config::Team team, config::Rules rules, config::Robot robot, const plugin::Catalogue& catalogue);

  // The same, telling of every mistake. After one, the plan must not be played.
  TeamPlan(config::Team team, config::Rules rules, config::Robot robot, const plugin::Catalogue& catalogue,
           config::Mistakes& mistakes);

  // Rows of the table of roles point into the team.
  TeamPlan(const TeamPlan&) = delete;
  TeamPlan& operator=(const TeamPlan&) = delete;

  const config::Team& team() const { return team_; }
  const config::Rules& rules() const { return rules_; }
  const config::Robot& robot() const { return robot_; }

  const Part& self() const { return self_; }
  const Part& ball() const { return ball_; }
  const Part& opponents() const { return opponents_; }
  const Part& teammates() const { return teammates_; }
  // In the order of Team::contexts: highest priority first.
  const std::vector<ContextPlan>& contexts() const { return contexts_; }

  // Those that roles name, each once, in the order of the table of roles; then those that nobody names.
  const std::vector<BehaviourPlan>& behaviours() const { return behaviours_; }
  // Of a robot without a role.
  std::size_t behaviour_without_role() const { return behaviour_without_role_; }
  // REGISTA_BEHAVIOUR_*: what the behaviour of a row of the table of roles is for.
  std::uint32_t purposes(int role) const {
    return plugin::purposes(*behaviours_[roles_[static_cast<std::size_t>(role)].behaviour].part.found);
  }

  // All of the above, in a fixed order; a plugin may have several.
  std::vector<const Part*> parts() const;

  // REGISTA_READS_*: the parts of frames that any of these plugins reads; those of positioners alone.
  std::uint32_t reads() const { return reads_; }
  std::uint32_t positioners_read() const { return positioners_read_; }

  // What packets are sent for: the events of abi.h by their numbers, then those of the team's senders.
  const std::vector<std::string>& reasons() const { return reasons_; }
  const std::string& reason(int of_packet) const { return reasons_.at(static_cast<std::size_t>(of_packet)); }

  // The numbers that the team's plugins declare. metrics_of: those of one plugin of its parts, as indices into them.
  const std::vector<TeamMetric>& metrics() const { return metrics_; }
  std::span<const int> metrics_of(const plugin::Found& plugin) const;

  const std::vector<RoleRow>& roles() const { return roles_; }
  // Row of the first role of a list.
  int first_role(int list) const { return first_role_[static_cast<std::size_t>(list)]; }

  // The environment of robot `number`; its spans and strings live in the plan.
  regista_environment environment(int number, unsigned subject = 0) const;

 private:
  TeamPlan(config::Team team, config::Rules rules, config::Robot robot, const plugin::Catalogue& catalogue,
           config::Mistakes&& mistakes);
  void name_reasons();
  void name_metrics(config::Mistakes& mistakes);
  void collect_reads();

  config::Team team_;
  config::Rules rules_;
  config::Robot robot_;
  Part self_, ball_, opponents_, teammates_;
  std::vector<ContextPlan> contexts_;
  std::vector<BehaviourPlan> behaviours_;
  std::size_t behaviour_without_role_ = 0;
  std::uint32_t reads_ = REGISTA_READS_NOTHING, positioners_read_ = REGISTA_READS_NOTHING;
  std::vector<RoleRow> roles_;
  std::vector<int> first_role_;
  std::vector<regista_role> role_table_;
  std::vector<regista_landmark> landmarks_;
  std::vector<regista_kick> kicks_;
  std::vector<regista_event_name> events_;
  std::vector<std::string> reasons_;
  std::vector<TeamMetric> metrics_;
  struct MetricsOf {
    const plugin::Found* plugin;
    std::vector<int> indices;
  };
  std::vector<MetricsOf> metrics_of_;
};

}  // namespace regista::mind
