// SPDX-License-Identifier: MIT
// How well one team was coordinated: the measures of Affinita et al., "Multi-Agent Coordination for a Partially
// Observable and Dynamic Robot Soccer Environment with Limited Communication", 2023, and what explains them. Sampled at
// 10 Hz in the phase Playing; each sample counts 0.1 s. docs/metrics.md has the formulas.
//
// Active: not penalised (a fallen robot keeps its role). In each sample, per role:
// - overlap: two or more active robots hold the role.
// - uncovered: no active robot holds the role although it was wanted. Wanted are the roles of the list in force whose
//   priority (place in its list, from 0) is below the number of active robots; a role bound to one robot only while
//   that robot is active. In force is the list in which most active robots hold a role (of equals, the one that comes
//   first in the table); while no robot holds any role, no list is in force and nothing is uncovered.
// - unplayed: no active robot holds the role although more than half of the active robots last decided that somebody
//   does. Other than `uncovered` it says the same of teams that filter their tasks.
// - agreement: all active robots, two or more of them, last decided on the same assignment of the whole team.
// Switches count each time a robot takes a role that it did not hold at its last decision in play.
//
// The silence of a team begins with its last packet of the match, if no other follows for more than silence_after until
// the end; a team that never sends is silent from the beginning. Before and after are added up as the match goes on: at
// each packet everything so far belongs to the time before.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace regista::match {

// s of match time: as long as a teammate is reckoned with that is not heard (forget_teammate_after of a team's page).
// No sender of the shipped teams waits so long between packets while it may send.
constexpr double silence_after = 25.0;

// A row of a team's table of roles, in its order.
struct Role {
  std::string name;
  std::string list = "playing";  // the role list it stands in
  int priority = 0;
  int robot = 0;            // number of the robot that alone may take it; 0 = any
  bool plays_ball = false;  // whoever holds it goes to the ball and kicks it
};

struct RoleMetrics {
  // In a span of the match: seconds, and how often.
  struct Counts {
    double overlap_seconds = 0.0, uncovered_seconds = 0.0, unplayed_seconds = 0.0;
    int switches = 0;
  };
  std::string name, list;
  Counts all, before_silence, after_silence;
  std::vector<double> robot_seconds;  // by robot (n - 1): time it held the role
};

struct CoordinationMetrics {
  std::vector<RoleMetrics> roles;  // as in the table
  // Shares of the samples with two active robots or more; nothing where there are none.
  std::optional<double> agreement, agreement_before_silence, agreement_after_silence;
  double silent_seconds = 0.0;  // of Playing, after the last packet
};

class RoleMeasures {
 public:
  RoleMeasures(int team_size, std::span<const Role> roles);

  // Robot `number` has decided. role: row or -1; assignment: per robot row, -1, -2, or empty. counts: in play.
  void decided(int number, int role, std::span<const int> assignment, bool counts);

  void sent(double time);  // s of match time

  // A sample; active: bit n - 1 for robot n.
  void sample(std::uint32_t active);

  // All active robots last decided on the same assignment of the whole team.
  bool agree(std::uint32_t active) const;

  CoordinationMetrics result(double end) const;  // s of match time

 private:
  struct Count {
    int overlap = 0, uncovered = 0, unplayed = 0, switches = 0;  // samples; times
  };
  // Everything that is split by the silence.
  struct Sums {
    int samples = 0, compared = 0, agreed = 0;  // compared: with two active robots or more
    std::vector<Count> roles;
  };
  static RoleMetrics::Counts told(const Count& all, const Count& without);
  void count_votes(std::uint32_t active);

  int team_size_;
  std::vector<Role> roles_;
  std::vector<int> list_;           // by role: number of its list
  std::vector<int> held_;           // by robot: role held now
  std::vector<int> assignment_;     // team_size x team_size, row of robot n - 1 at n - 1
  std::vector<int> holders_;        // by role, in this sample
  std::vector<int> list_holders_;   // by list, in this sample
  std::vector<int> votes_;          // by role: robots that believe somebody holds it
  std::vector<int> last_voter_;     // by role
  std::vector<int> robot_samples_;  // roles x robots
  Sums now_, at_last_packet_;
  double last_packet_ = 0.0;
};

}  // namespace regista::match
