// SPDX-License-Identifier: MIT
#include "match/metrics_coordination.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "match/metrics.hpp"
#include "match/physics_world.hpp"

namespace regista::match {
namespace {

constexpr std::size_t bits = 64;  // number of tasks in one word of a set of tasks

// Whether same(robot, first) is true for every active robot; first: lowest active robot. active: bit n - 1 for robot n.
template <class Same>
bool all_as_the_first(std::uint32_t active, Same same) {
  const int first = std::countr_zero(active);
  return those(active, [&](int robot) { return !same(robot, first); }) == 0;
}

}  // namespace

std::vector<std::string> role_names(const std::vector<Role>& roles) {
  std::vector<std::string> names;
  for (const Role& role : roles) {
    const bool unique = std::ranges::count(roles, role.name, &Role::name) == 1;
    names.push_back(unique ? role.name : role.list + '.' + role.name);
  }
  return names;
}

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
  if (robots >= 2) {
    ++now_.compared;
    if (agree(active)) ++now_.agreed;
  }
  if (roles_.empty()) return;
  std::ranges::fill(holders_, 0);
  std::ranges::fill(list_holders_, 0);
  for (const int robot : Members(active)) {
    const int role = held_[at(robot)];
    if (role < 0) continue;
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
    const Role& row = roles_[role];
    const bool can_be_taken = row.robots.empty() || std::ranges::any_of(row.robots, [active, this](int number) {
                                return number <= team_size_ && (active >> (number - 1) & 1u) != 0;
                              });
    const bool wanted = list_[role] == in_force && row.priority < robots && row.least_in_play <= robots && can_be_taken;
    if (wanted) ++count.uncovered;
  }
}

bool RoleMeasures::agree(std::uint32_t active) const {
  return all_as_the_first(active, [this](int robot, int first) {
    const auto row = assignment_.begin() + robot * team_size_;
    return std::equal(row, row + team_size_, assignment_.begin() + first * team_size_);
  });
}

void RoleMeasures::count_votes(std::uint32_t active) {
  std::ranges::fill(votes_, 0);
  std::ranges::fill(last_voter_, -1);
  for (const int robot : Members(active)) {
    for (int other = 0; other < team_size_; ++other) {
      const int role = assignment_[at(robot * team_size_ + other)];
      // A negotiated assignment may give one role to two robots, but each robot has only one vote for a role.
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
  constexpr double rounding = 1e-6;  // s; tolerance, because sums of physics steps are not exact
  const Sums& before = end - last_packet_ > silence_after + rounding ? at_last_packet_ : now_;
  CoordinationMetrics out;
  for (std::size_t role = 0; role < roles_.size(); ++role) {
    const Count &all = now_.roles[role], &early = before.roles[role];
    RoleMetrics metrics{told(all, {}), told(early, {}), told(all, early), {}};
    for (int robot = 0; robot < team_size_; ++robot) {
      metrics.robot_seconds.push_back(seconds(robot_samples_[role * at(team_size_) + at(robot)]));
    }
    out.roles.push_back(std::move(metrics));
  }
  out.agreement = share(now_.agreed, now_.compared);
  out.agreement_before_silence = share(before.agreed, before.compared);
  out.agreement_after_silence = share(now_.agreed - before.agreed, now_.compared - before.compared);
  out.silent_seconds = seconds(now_.samples - before.samples);
  return out;
}

AgreementMeasures::AgreementMeasures(int team_size, std::size_t roles)
    : words_((roles + bits - 1) / bits), context_(at(team_size), -1), kept_(at(team_size) * words_) {}

void AgreementMeasures::decided(int number, int context, std::span<const int> kept) {
  context_[at(number - 1)] = context;
  const std::span<std::uint64_t> set = std::span(kept_).subspan(at(number - 1) * words_, words_);
  std::ranges::fill(set, 0);
  for (const int task : kept) set[at(task) / bits] |= std::uint64_t{1} << (at(task) % bits);
}

void AgreementMeasures::sample(std::uint32_t active, bool same_assignment) {
  if (std::popcount(active) < 2) return;
  ++samples_;
  const auto same_context = [this](int robot, int first) { return context_[at(robot)] == context_[at(first)]; };
  if (all_as_the_first(active, same_context)) ++same_context_;
  const auto kept = [this](int robot) { return std::span(kept_).subspan(at(robot) * words_, words_); };
  const auto same_tasks = [&](int robot, int first) { return std::ranges::equal(kept(robot), kept(first)); };
  if (!all_as_the_first(active, same_tasks)) return;
  ++same_tasks_;
  if (same_assignment) ++same_assignment_;
}

AgreementMetrics AgreementMeasures::result() const {
  return {share(same_context_, samples_), share(same_tasks_, samples_), share(same_assignment_, same_tasks_)};
}

TenureMeasures::TenureMeasures(int team_size, double longest) : held_(at(team_size)) {
  finished_.reserve(static_cast<std::size_t>(longest / physics_step) + 1);
}

void TenureMeasures::decided(int number, int role, double time, bool plays) {
  Held& held = held_[at(number - 1)];
  if (!plays) {
    held.role = -1;
    return;
  }
  if (role == held.role) return;
  if (held.role >= 0) {
    const auto steps = static_cast<std::size_t>(std::lround((time - held.since) / physics_step));
    if (steps >= finished_.size()) finished_.resize(steps + 1);
    ++finished_[steps];
    ++count_;
  }
  held = {role, time};
}

double TenureMeasures::shortest_but(std::size_t rank) const {
  std::size_t steps = 0;
  for (std::size_t before = finished_[0]; before <= rank; before += finished_[steps]) ++steps;
  return static_cast<double>(steps) * physics_step;
}

double TenureMeasures::quantile(double probability) const {
  const double place = probability * static_cast<double>(count_ - 1);
  const auto below = static_cast<std::size_t>(place);
  const double lower = shortest_but(below), upper = shortest_but(std::min(below + 1, count_ - 1));
  return lower + (place - static_cast<double>(below)) * (upper - lower);
}

TenureMetrics TenureMeasures::result() const {
  if (count_ == 0) return {};
  return {quantile(0.5), quantile(0.1)};
}

TargetMeasures::TargetMeasures(int team_size) : targets_(at(team_size)) { now_.reserve(at(team_size)); }

void TargetMeasures::sample(std::uint32_t active) {
  now_.clear();
  for (const int robot : Members(active)) {
    if (targets_[at(robot)]) now_.push_back(*targets_[at(robot)]);
  }
  if (now_.size() < 2) return;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < now_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = length(now_[i] - now_[j]);
      all_ += distance;
      least = std::min(least, distance);
      ++pairs_;
    }
  }
  least_ += least;
  ++samples_;
}

TargetMetrics TargetMeasures::result() const { return {mean(all_, pairs_), mean(least_, samples_)}; }

}  // namespace regista::match
