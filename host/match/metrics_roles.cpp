// SPDX-License-Identifier: MIT
#include "match/metrics_roles.hpp"

#include <algorithm>
#include <bit>

#include "match/sampling.hpp"

namespace regista::match {
RoleMeasures::RoleMeasures(int team_size, std::span<const Role> roles)
    : team_size_(team_size),
      roles_(roles.begin(), roles.end()),
      held_(at(team_size), -1),
      assignment_(at(team_size * team_size), -1),
      holders_(roles.size()),
      votes_(roles.size()),
      last_voter_(roles.size()),
      robot_samples_(roles.size() * at(team_size)) {
  std::vector<std::string> lists;
  for (const Role& role : roles) {
    const auto found = std::find(lists.begin(), lists.end(), role.list);
    list_.push_back(static_cast<int>(found - lists.begin()));
    if (found == lists.end()) lists.push_back(role.list);
  }
  list_holders_.resize(lists.size());
  now_.roles.resize(roles.size());
  at_last_packet_ = now_;
}

void RoleMeasures::decided(int number, int role, std::span<const int> assignment, bool counts) {
  int& held = held_[at(number - 1)];
  if (counts && role >= 0 && role != held) ++now_.roles[at(role)].switches;
  held = role;
  const auto row = assignment_.begin() + (number - 1) * team_size_;
  for (int i = 0; i < team_size_; ++i) row[i] = at(i) < assignment.size() ? assignment[at(i)] : -1;
}

void RoleMeasures::sent(double time) {
  last_packet_ = time;
  at_last_packet_ = now_;
}

void RoleMeasures::sample(std::uint32_t active) {
  ++now_.samples;
  const int robots = std::popcount(active);
  // Who is alone agrees with nobody.
  if (robots >= 2) {
    ++now_.compared;
    if (agree(active)) ++now_.agreed;
  }
  if (roles_.empty()) return;
  std::ranges::fill(holders_, 0);
  std::ranges::fill(list_holders_, 0);
  for (int robot = 0; robot < team_size_; ++robot) {
    const int role = held_[at(robot)];
    if ((active >> robot & 1u) == 0 || role < 0) continue;
    ++holders_[at(role)];
    ++list_holders_[at(list_[at(role)])];
    ++robot_samples_[at(role * team_size_ + robot)];
  }
  count_votes(active);
  const auto most = std::ranges::max_element(list_holders_);
  const int in_force = *most > 0 ? static_cast<int>(most - list_holders_.begin()) : -1;
  for (std::size_t role = 0; role < roles_.size(); ++role) {
    Count& count = now_.roles[role];
    if (holders_[role] >= 2) ++count.overlap;
    if (holders_[role] > 0) continue;
    if (2 * votes_[role] > robots) ++count.unplayed;
    const int bound = roles_[role].robot;
    const bool wanted =
        list_[role] == in_force && roles_[role].priority < robots && (bound == 0 || (active >> (bound - 1) & 1u) != 0);
    if (wanted) ++count.uncovered;
  }
}

bool RoleMeasures::agree(std::uint32_t active) const {
  const int* first = nullptr;
  for (int robot = 0; robot < team_size_; ++robot) {
    if ((active >> robot & 1u) == 0) continue;
    const int* row = assignment_.data() + robot * team_size_;
    if (first != nullptr && !std::equal(row, row + team_size_, first)) return false;
    first = row;
  }
  return true;
}

void RoleMeasures::count_votes(std::uint32_t active) {
  std::ranges::fill(votes_, 0);
  std::ranges::fill(last_voter_, -1);
  for (int robot = 0; robot < team_size_; ++robot) {
    if ((active >> robot & 1u) == 0) continue;
    for (int other = 0; other < team_size_; ++other) {
      const int role = assignment_[at(robot * team_size_ + other)];
      // A negotiated assignment may give a role to two.
      if (role < 0 || last_voter_[at(role)] == robot) continue;
      last_voter_[at(role)] = robot;
      ++votes_[at(role)];
    }
  }
}

RoleMetrics::Counts RoleMeasures::told(const Count& all, const Count& without) {
  return {seconds(all.overlap - without.overlap), seconds(all.uncovered - without.uncovered),
          seconds(all.unplayed - without.unplayed), all.switches - without.switches};
}

CoordinationMetrics RoleMeasures::result(double end) const {
  constexpr double rounding = 1e-6;  // s
  const Sums& before = end - last_packet_ > silence_after + rounding ? at_last_packet_ : now_;
  CoordinationMetrics out;
  for (std::size_t role = 0; role < roles_.size(); ++role) {
    const Count& all = now_.roles[role];
    RoleMetrics& metrics = out.roles.emplace_back();
    metrics.name = roles_[role].name;
    metrics.list = roles_[role].list;
    metrics.all = told(all, {});
    metrics.before_silence = told(before.roles[role], {});
    metrics.after_silence = told(all, before.roles[role]);
    for (int robot = 0; robot < team_size_; ++robot) {
      metrics.robot_seconds.push_back(seconds(robot_samples_[role * at(team_size_) + at(robot)]));
    }
  }
  out.agreement = share(now_.agreed, now_.compared);
  out.agreement_before_silence = share(before.agreed, before.compared);
  out.agreement_after_silence = share(now_.agreed - before.agreed, now_.compared - before.compared);
  out.silent_seconds = seconds(now_.samples - before.samples);
  return out;
}

}  // namespace regista::match
