// SPDX-License-Identifier: MIT
// Measures of how well the robots of one team were coordinated: roles, agreement, tenure of roles, distances of
// targets. Samples are taken at 10 Hz in the phase Playing; each sample counts 0.1 s. docs/metrics.md has the formulas.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "match/side.hpp"

namespace regista::match {

// --- Roles: the measures of Affinita et al., "Multi-Agent Coordination for a Partially Observable and Dynamic Robot
// Soccer Environment with Limited Communication", 2023, and related ones.
//
// A robot is active while it is not penalised. A fallen robot is active and keeps its role. metric_table.cpp defines
// each number. The role list in force is the list whose roles most active robots hold; if several lists are equal, the
// first of these lists in the table. For teams that filter tasks, `unplayed` replaces `uncovered`.
//
// A team is silent from its last packet of the match to the end, if this time is longer than silence_after. A team that
// never sends is silent from the beginning. No time before a packet counts as silent.

// A longer time without a packet of the team counts as silence, s of match time: the usual forget_teammate_after. The
// senders of the shipped teams wait less between two packets, as long as the rules allow packets.
constexpr double silence_after = 25.0;

// A row of a team's table of roles.
struct Role {
  std::string name;
  std::string list = "playing";  // name of the role list that contains the role
  int priority = 0;              // place in the role list; 0 = most important
  std::vector<int> robots = {};  // shirt numbers of the only robots that may take the role; empty: any robot
  int least_in_play = 1;         // the role is open only while at least this many robots are active
  bool plays_ball = false;       // the robot with this role goes to the ball and kicks it
};

// Returns one name for each role of a team's table: the role's name, or "list.name" if several lists contain this name.
std::vector<std::string> role_names(const std::vector<Role>& roles);

struct RoleMetrics {
  struct Counts {
    double overlap_seconds = 0.0, uncovered_seconds = 0.0, unplayed_seconds = 0.0;
    int switches = 0;
  };
  Counts all, before_silence, after_silence;  // counts of the whole match, before the team's silence and during it
  std::vector<double> robot_seconds;          // by robot (n - 1): time in this role, s
};

struct CoordinationMetrics {
  std::vector<RoleMetrics> roles;  // in the order of the table
  // Shares of agreement in the samples with at least two active robots; nothing without such samples.
  std::optional<double> agreement, agreement_before_silence, agreement_after_silence;
  double silent_seconds = 0.0;  // time in Playing during the silence
};

class RoleMeasures {
 public:
  RoleMeasures(int team_size, std::span<const Role> roles);

  // The caller calls this after each decision. role, and assignment for each robot: row of the table of roles, -1 =
  // none, -2 = unknown. An empty assignment gives each robot -1. counts: whether the phase is Playing.
  void decided(int number, int role, std::span<const int> assignment, bool counts);

  void sent(double time);  // a packet was charged at match time `time`, s

  void sample(std::uint32_t active);  // Takes a sample. active: bit n - 1 for robot n.

  // Returns whether the last decisions of all active robots contain the same assignment of the whole team.
  bool agree(std::uint32_t active) const;

  CoordinationMetrics result(double end) const;  // end: match time of the end, s

 private:
  struct Count {
    int overlap = 0, uncovered = 0, unplayed = 0, switches = 0;  // in samples; switches: number of role switches
  };
  // The counts up to a moment. at_last_packet_ has the counts before the silence.
  struct Sums {
    int samples = 0, compared = 0, agreed = 0;  // compared: samples with at least two active robots
    std::vector<Count> roles;
  };
  static RoleMetrics::Counts told(const Count& all, const Count& without);
  void count_votes(std::uint32_t active);

  int team_size_;
  std::vector<Role> roles_;
  std::vector<int> list_;           // by role: index of its list
  std::vector<int> held_;           // by robot: present role
  std::vector<int> assignment_;     // team_size x team_size, row of robot n - 1 at n - 1
  std::vector<int> holders_;        // by role: number of robots with this role in this sample
  std::vector<int> list_holders_;   // by list: number of robots with a role of this list in this sample
  std::vector<int> votes_;          // by role: number of robots whose assignment gives the role to a robot
  std::vector<int> last_voter_;     // by role: the last robot that count_votes() counted
  std::vector<int> robot_samples_;  // roles x robots: number of samples
  Sums now_, at_last_packet_;
  double last_packet_ = 0.0;
};

// --- Agreement of the robots on the steps of a decision (docs/architecture.md): on the context, on the tasks that the
// filter keeps, and on the assignment in samples with equal tasks. A sample compares the last decisions of all active
// robots, if at least two robots are active. `agreement` of CoordinationMetrics compares only the assignments.

struct AgreementMetrics {  // Shares of the compared samples; nothing without such samples.
  std::optional<double> context, kept_tasks;
  std::optional<double> assignment_given_tasks;  // among the samples with agreement on the tasks
};

class AgreementMeasures {
 public:
  AgreementMeasures(int team_size, std::size_t roles);  // roles: number of rows of the table of roles

  // The caller calls this after each decision. context: -1 = none. kept: rows of the table of roles, in any order.
  void decided(int number, int context, std::span<const int> kept);

  // Takes a sample. active: bit n - 1 for robot n. same_assignment: all active robots agree on the assignment.
  void sample(std::uint32_t active, bool same_assignment);

  AgreementMetrics result() const;

 private:
  std::size_t words_;                // 64-bit words of a set of tasks
  std::vector<int> context_;         // by robot
  std::vector<std::uint64_t> kept_;  // team_size x words: bit t for task t
  int samples_ = 0, same_context_ = 0, same_tasks_ = 0, same_assignment_ = 0;
};

// --- Tenures: a tenure is the time for which a robot holds a role before it takes another role.
//
// A robot plays while the phase is Playing and the robot is not penalised. A tenure begins when a playing robot decides
// on the role. A tenure is finished when the playing robot decides on another role or on no role. A tenure that ends
// with Playing, with the match, by a penalty or by a crash does not count. A set play or a fall does not end a tenure.

// Quantiles of type 7 (as in statistics/moments.hpp) of all finished tenures of all robots; nothing without a tenure.
// R. J. Hyndman and Y. Fan, "Sample Quantiles in Statistical Packages", The American Statistician 50, 1996.
struct TenureMetrics {
  std::optional<double> median_seconds, tenth_seconds;  // tenth: the 0.1 quantile
};

class TenureMeasures {
 public:
  // longest: expected longest tenure, s. A longer tenure allocates memory during the match.
  TenureMeasures(int team_size, double longest);

  // Robot `number` has decided at match time `time` (s). role: -1 = none. plays: in Playing, and not penalised.
  void decided(int number, int role, double time, bool plays);
  void crashed(int number) { held_[at(number - 1)].role = -1; }  // drops the robot's tenure

  TenureMetrics result() const;

 private:
  struct Held {  // the current tenure of a robot
    int role = -1;
    double since = 0.0;  // match time at which the tenure began, s
  };
  double quantile(double probability) const;
  double shortest_but(std::size_t rank) const;  // length of the finished tenure with this rank, s; 0: shortest

  std::vector<Held> held_;               // by robot
  std::vector<std::uint32_t> finished_;  // by length in physics steps: number of finished tenures
  std::size_t count_ = 0;                // number of all finished tenures
};

// --- Distances between the targets of two active robots with a task, by their last decisions, goalkeepers included.

// Nothing if no two robots ever had a target at the same time.
struct TargetMetrics {
  std::optional<double> mean_metres;   // over all pairs of all samples
  std::optional<double> least_metres;  // mean over samples of the distance of the nearest pair
};

class TargetMeasures {
 public:
  explicit TargetMeasures(int team_size);

  // The caller calls this after each decision. target: m, in the same frame for all robots of the team.
  void decided(int number, std::optional<Vector> target) { targets_[at(number - 1)] = target; }

  void sample(std::uint32_t active);  // Takes a sample. active: bit n - 1 for robot n.

  TargetMetrics result() const;

 private:
  std::vector<std::optional<Vector>> targets_;  // by robot
  std::vector<Vector> now_;                     // targets of the active robots in this sample
  int samples_ = 0, pairs_ = 0;
  double all_ = 0.0, least_ = 0.0;  // m; all_: sum over pairs; least_: sum over samples
};

}  // namespace regista::match
