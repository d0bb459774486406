// SPDX-License-Identifier: MIT
// TeamPlan has what all robots of a team share: the team's document, its plugins and the checked parameters.
#pragma once

#include <regista/abi.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/errors.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"
#include "mind/extensions/plugin_log.hpp"
#include "plugin/catalogue.hpp"
#include "plugin/parameters.hpp"

namespace regista::mind {

// Returns the landmarks of a field, which cameras can recognise and plugins know. The set is the same in the field
// frames of the two teams. Field frame, metres. Order: goal posts, centre, penalty marks, corners, T junctions.
inline std::vector<regista_landmark> landmarks(const config::FieldSize& field) {
  const double goal_line = field.length / 2.0, touch_line = field.width / 2.0;
  const double post = (field.goal_width + field.post_diameter) / 2.0;
  std::vector<regista_landmark> out;
  const auto add = [&out](int kind, double x, double y) { out.push_back({kind, 0, x, y}); };
  const auto add_mirrored = [&add](int kind, double x, double y) {
    add(kind, x, y);
    add(kind, x, -y);
    add(kind, -x, y);
    add(kind, -x, -y);
  };
  add_mirrored(REGISTA_LANDMARK_GOAL_POST, goal_line, post);
  add(REGISTA_LANDMARK_CENTRE, 0.0, 0.0);
  add(REGISTA_LANDMARK_PENALTY_MARK, goal_line - field.penalty_mark_distance, 0.0);
  add(REGISTA_LANDMARK_PENALTY_MARK, -(goal_line - field.penalty_mark_distance), 0.0);
  add_mirrored(REGISTA_LANDMARK_CORNER, goal_line, touch_line);
  add(REGISTA_LANDMARK_T_JUNCTION, 0.0, touch_line);
  add(REGISTA_LANDMARK_T_JUNCTION, 0.0, -touch_line);
  add_mirrored(REGISTA_LANDMARK_T_JUNCTION, goal_line, field.goal_area_width / 2.0);
  add_mirrored(REGISTA_LANDMARK_T_JUNCTION, goal_line, field.penalty_area_width / 2.0);
  return out;
}

struct Part {  // One use of a plugin with the values of its parameters.
  const plugin::Found* found = nullptr;
  plugin::Parameters parameters;
  config::PluginUse use;  // the plugin's entry in the team's document
};

struct TermPart {  // a term of a context's utility
  std::string name;
  double weight = 1.0;
  Part part;
};

struct ContextPlan {
  Part condition;
  std::optional<Part> positioner;  // empty: no waypoints, so no filter by waypoints and no offset
  Part assigner, sender;
  std::vector<TermPart> terms;
  std::vector<int> own_reasons;  // reasons to send of the sender plugin: indices into TeamPlan::reasons()
};

struct BehaviourPlan {
  std::string name;
  Part part;
};

// A row of the table of roles. The table has the roles of all lists. The row's index is the id of role and task.
struct RoleRow {
  const config::Role* role = nullptr;
  int list = 0;               // index into Team::role_lists
  int priority = 0;           // position in the list; 0 = most important
  std::size_t behaviour = 0;  // index into TeamPlan::behaviours()
};

// The frame parts that a plugin of the team declares to read (REGISTA_READS_*). plugin/call_inputs.hpp checks this.
struct FrameParts {
  bool common_opponents = true, times = true;
  bool facings = true;               // facings of the kept tasks
  bool facings_of_all_tasks = true;  // facings of all tasks of the context, which only a positioner sees

  // read: REGISTA_READS_* of all plugins together; read_by_positioners: REGISTA_READS_* of the positioners alone.
  static FrameParts of(std::uint32_t read, std::uint32_t read_by_positioners) {
    return {(read & REGISTA_READS_OPPONENTS_COMMON) != 0, (read & REGISTA_READS_TIMES) != 0,
            (read & REGISTA_READS_FACINGS) != 0, (read_by_positioners & REGISTA_READS_FACINGS) != 0};
  }
};

class TeamPlan {
 public:
  // Throws config::Error, with the place in the team's document, for a plugin that is missing, refused or of the wrong
  // kind, or has wrong parameters. `catalogue` must outlive the plan.
  TeamPlan(config::Team team, config::Rules rules, config::Robot robot, const plugin::Catalogue& catalogue,
           config::Mistakes&& mistakes = config::Mistakes(config::Mistakes::After::stop));

  // Adds every mistake to `mistakes` and does not throw at the first mistake. A plan with a mistake must not be played.
  TeamPlan(config::Team team, config::Rules rules, config::Robot robot, const plugin::Catalogue& catalogue,
           config::Mistakes& mistakes);

  // Not copyable, because rows of the table of roles point into team_.
  TeamPlan(const TeamPlan&) = delete;
  TeamPlan& operator=(const TeamPlan&) = delete;

  const config::Team& team() const { return team_; }
  const config::Rules& rules() const { return rules_; }
  const config::Robot& robot() const { return robot_; }

  const Part& self() const { return self_; }
  const Part& ball() const { return ball_; }
  const Part& opponents() const { return opponents_; }
  const Part& teammates() const { return teammates_; }
  // In the order of Team::contexts: the highest priority comes first.
  const std::vector<ContextPlan>& contexts() const { return contexts_; }

  // The behaviours of roles, each once, in the order of the table of roles, then the team's other behaviours.
  const std::vector<BehaviourPlan>& behaviours() const { return behaviours_; }
  // Index into behaviours(): the behaviour of a robot without a role.
  std::size_t behaviour_without_role() const { return behaviour_without_role_; }
  // Returns the purposes (REGISTA_BEHAVIOUR_*) of a role's behaviour. role: row of the table of roles.
  std::uint32_t purposes(int role) const {
    return behaviours_[roles_[static_cast<std::size_t>(role)].behaviour].part.found->description->purposes();
  }

  // Returns all parts of the team in a fixed order. Several parts may use the same plugin.
  std::vector<const Part*> parts() const;

  const FrameParts& frame_parts() const { return frame_parts_; }

  // Names of the reasons to send packets: first the events of abi.h by number, then the reasons of the team's senders.
  const std::vector<std::string>& reasons() const { return reasons_; }
  const std::string& reason(int of_packet) const { return reasons_.at(static_cast<std::size_t>(of_packet)); }

  // metrics(): all metrics of the team's plugins. metrics_of(): one plugin's metrics, as indices into metrics().
  const std::vector<TeamMetric>& metrics() const { return metrics_; }
  std::span<const int> metrics_of(const plugin::Found& plugin) const;

  const std::vector<RoleRow>& roles() const { return roles_; }
  // Returns the row of the first role of a role list.
  int first_role(int list) const { return first_role_[static_cast<std::size_t>(list)]; }

  // Returns the environment for a plugin in robot `number`. The plan owns the memory. subject: of a predictor; else 0.
  regista_environment environment(int number, unsigned subject = 0) const;

 private:
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
  FrameParts frame_parts_;
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
