// SPDX-License-Identifier: MIT
#include "match/metrics.hpp"

#include <regista/abi.h>

#include <algorithm>
#include <bit>

namespace regista::match {
namespace {

constexpr double sample_seconds = 0.1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Metrics::Metrics(int team_size, const std::array<std::vector<Role>, 2>& roles) : team_size_(team_size) {
  for (std::size_t side = 0; side < 2; ++side) {
    Team& team = teams_[side];
    TeamMetrics& result = result_.teams[side];
    team.role.assign(at(team_size), -1);
    team.assignment.assign(at(team_size * team_size), -1);
    team.holders.assign(roles[side].size(), 0);
    result.packets_by_reason.assign(REGISTA_EVENT_COUNT, 0);
    std::vector<std::string> lists;
    for (const Role& role : roles[side]) {
      const auto found = std::find(lists.begin(), lists.end(), role.list);
      team.lists.push_back(static_cast<int>(found - lists.begin()));
      if (found == lists.end()) lists.push_back(role.list);
      team.priorities.push_back(role.priority);
      team.bound.push_back(role.robot);
      result.roles.push_back({role.name, role.list, 0.0, 0.0, 0, std::vector<double>(at(team_size), 0.0)});
    }
    team.list_holders.assign(lists.size(), 0);
  }
}

void Metrics::decided(Side side, int number, int role, std::span<const int> assignment, const GameState& state) {
  Team& team = teams_[index(side)];
  int& held = team.role[at(number - 1)];
  if (state.phase == mind::Phase::playing && role >= 0 && role != held) {
    ++result_.teams[index(side)].roles[at(role)].switches;
  }
  held = role;
  const auto row = team.assignment.begin() + (number - 1) * team_size_;
  for (int i = 0; i < team_size_; ++i) row[i] = at(i) < assignment.size() ? assignment[at(i)] : -1;
}

void Metrics::sent(Side side, int reason) {
  ++result_.teams[index(side)].packets;
  ++result_.teams[index(side)].packets_by_reason[at(reason)];
}

void Metrics::touched(Side side) {
  ++result_.teams[index(side)].touches;
  last_touch_ = static_cast<int>(index(side));
}

void Metrics::sample(const GameState& state) {
  if (state.phase != mind::Phase::playing) return;
  ++samples_;
  result_.playing_seconds = samples_ * sample_seconds;
  if (state.in_play()) {
    result_.in_play_seconds += sample_seconds;
    if (last_touch_ >= 0) result_.teams[at(last_touch_)].possession_seconds += sample_seconds;
  }
  sample(Side::home, state);
  sample(Side::away, state);
}

void Metrics::sample(Side side, const GameState& state) {
  Team& team = teams_[index(side)];
  TeamMetrics& result = result_.teams[index(side)];
  const std::uint32_t active = ((1u << team_size_) - 1u) & ~state.penalised[index(side)];
  if (agree(team, active)) ++team.agreed;
  if (team.holders.empty()) return;
  std::fill(team.holders.begin(), team.holders.end(), 0);
  std::fill(team.list_holders.begin(), team.list_holders.end(), 0);
  for (int robot = 0; robot < team_size_; ++robot) {
    const int role = team.role[at(robot)];
    if ((active >> robot & 1u) == 0 || role < 0) continue;
    ++team.holders[at(role)];
    ++team.list_holders[at(team.lists[at(role)])];
    result.roles[at(role)].robot_seconds[at(robot)] += sample_seconds;
  }
  const auto most = std::max_element(team.list_holders.begin(), team.list_holders.end());
  const int in_force = *most > 0 ? static_cast<int>(most - team.list_holders.begin()) : -1;
  for (std::size_t role = 0; role < team.holders.size(); ++role) {
    if (team.holders[role] >= 2) result.roles[role].overlap_seconds += sample_seconds;
    if (team.holders[role] > 0 || team.lists[role] != in_force) continue;
    if (team.priorities[role] >= std::popcount(active)) continue;
    if (team.bound[role] > 0 && (active >> (team.bound[role] - 1) & 1u) == 0) continue;
    result.roles[role].uncovered_seconds += sample_seconds;
  }
}

bool Metrics::agree(const Team& team, std::uint32_t active) const {
  const int* first = nullptr;
  for (int robot = 0; robot < team_size_; ++robot) {
    if ((active >> robot & 1u) == 0) continue;
    const int* row = team.assignment.data() + robot * team_size_;
    if (first != nullptr && !std::equal(row, row + team_size_, first)) return false;
    first = row;
  }
  return true;
}

MatchMetrics Metrics::result() const {
  MatchMetrics result = result_;
  for (std::size_t side = 0; side < 2; ++side) {
    if (samples_ > 0) result.teams[side].agreement = static_cast<double>(teams_[side].agreed) / samples_;
  }
  return result;
}

}  // namespace regista::match
