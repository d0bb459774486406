// SPDX-License-Identifier: MIT
// How well a team was coordinated, and what it cost: the measures of Affinita et al., "Multi-Agent Coordination for a
// Partially Observable and Dynamic Robot Soccer Environment with Limited Communication", 2023, and what explains them.
// A function of the course of the match alone. Sampled at 10 Hz in the phase Playing; each sample counts 0.1 s.
//
// Active: not penalised (a fallen robot keeps its role). In each sample, per team and role:
// - overlap: two or more active robots hold the role.
// - uncovered: no active robot holds the role although it was wanted. Wanted are the roles of the list in force whose
//   priority (place in its list, from 0) is below the number of active robots; a role bound to one robot only while
//   that robot is active. In force is the list in which most active robots hold a role (of equals, the one that comes
//   first in the table); while no robot holds any role, no list is in force and nothing is uncovered.
// - agreement: all active robots last decided on the same assignment of the whole team.
// Switches count each time a robot takes a role that it did not hold at its last decision in play.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "match/game_state.hpp"

namespace regista::match {

// A row of a team's table of roles, in its order.
struct Role {
  std::string name;
  std::string list = "playing";  // the role list it stands in
  int priority = 0;
  int robot = 0;  // number of the robot that alone may take it; 0 = any
};

struct RoleMetrics {
  std::string name, list;
  double overlap_seconds = 0.0, uncovered_seconds = 0.0;
  int switches = 0;
  std::vector<double> robot_seconds;  // by robot (n - 1): time it held the role
};

struct TeamMetrics {
  std::vector<RoleMetrics> roles;      // as in the table
  double agreement = 1.0;              // share of the samples; 1 where there are none
  double possession_seconds = 0.0;     // ball in play and last touched by this team
  int packets = 0;                     // sent, charged or not delivered as too long
  std::vector<int> packets_by_reason;  // REGISTA_EVENT_*
  int falls = 0, penalties = 0, kicks = 0, touches = 0;
};

struct MatchMetrics {
  std::array<TeamMetrics, 2> teams;  // by side
  double playing_seconds = 0.0;      // phase Playing
  double in_play_seconds = 0.0;      // without set plays
};

class Metrics {
 public:
  Metrics(int team_size, const std::array<std::vector<Role>, 2>& roles);

  // Robot `number` has decided. role: row or -1; assignment: per robot row, -1, -2, or empty.
  void decided(Side side, int number, int role, std::span<const int> assignment, const GameState& state);
  void sent(Side side, int reason);
  void fell(Side side) { ++result_.teams[index(side)].falls; }
  void kicked(Side side) { ++result_.teams[index(side)].kicks; }
  void penalised(Side side) { ++result_.teams[index(side)].penalties; }
  void touched(Side side);  // the ball, in a physics step

  // To be called ten times in a second of match time.
  void sample(const GameState& state);

  MatchMetrics result() const;

 private:
  struct Team {
    std::vector<int> role;               // by robot: held now
    std::vector<int> assignment;         // team_size x team_size, row of robot n - 1 at n - 1
    std::vector<int> lists;              // by role: number of its list
    std::vector<int> priorities, bound;  // by role
    std::vector<int> holders;            // by role, in this sample
    std::vector<int> list_holders;       // by list
    int agreed = 0;
  };
  void sample(Side side, const GameState& state);
  bool agree(const Team& team, std::uint32_t active) const;

  int team_size_;
  std::array<Team, 2> teams_;
  MatchMetrics result_;
  int samples_ = 0;
  int last_touch_ = -1;  // index of the side
};

}  // namespace regista::match
