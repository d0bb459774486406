// SPDX-License-Identifier: MIT
// What becomes of a negotiation when the team's packets run short. At the reserve, at which senders fall silent, robots
// stop negotiating, and roles go by rank: the k-th of the robots in the game takes the k-th task that it may take. The
// game controller tells everybody of packets and of penalties, so that all change over within a decision or two. Until
// then news are as urgent as ever: the sender keeps the budget, and holding bids back below its even line spared no
// packet, but took 5 to 15 points of a hundred off the time in which all agree (20 matches).
//
// In the game are all that are not penalised. Of a silent team every robot is given up sooner or later, and if only
// those counted that are not, each robot would be the first. But a frame has no more tasks than robots that are not
// given up: who comes behind them then has none, unless the team's page lets nobody be given up for silence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include <plugins/assigners/task_order.hpp>
#include <regista/assigner.hpp>
#include <regista/budget.hpp>
#include <regista/sender.hpp>

#include "../static_partition/algorithm.hpp"
#include "bids.hpp"

namespace negotiation {

// The parameter for setup()'s stop_negotiating_at. 30 is the reserve that B-Human's sender and event_based keep.
inline constexpr int usual_reserve = 30;
template <class P>
constexpr auto stop_negotiating_at(int P::*member) {
  return regista::integer("stop_negotiating_at", member, {-1, 10000}, "1",
                          "Packets of the team at which robots stop negotiating and take roles by rank: the sender's "
                          "reserve; -1: they never do (assumption: at the reserve of B-Human 2022)");
}

class Reserve {
 public:
  // stop_negotiating_at: packets of a whole match; below 0: the reserve is never reached.
  void setup(const regista::Environment& environment, const regista::Host& host, int stop_negotiating_at) {
    budget_ = regista::BudgetNow(host);
    roles_ = environment.roles();
    static_at_ = stop_negotiating_at;
    const std::size_t robots = environment->team_size;
    members_.reserve(robots);
    shares_.reserve(robots);
    may_.reserve(robots * roles_.size());
    order_.reserve(roles_.size());
  }

  // Of the present decision. A host that tells no budget has no reserve.
  bool is_reached() const {
    const auto now = static_at_ < 0 ? std::nullopt : budget_.read();
    return now && now->packets_left <= regista::in_this_game(static_at_, *now);
  }
  void assign_by_rank(const regista::Frame& frame, const regista::UtilityMatrix& utilities,
                      const regista::Assignment& out) {
    const regista::Span<regista::Task> tasks = frame.tasks();
    const regista::Span<std::int32_t> active = frame.world().active();
    members_.clear();
    may_.clear();
    for (const regista::Robot& robot : frame.world().robots()) {
      const std::size_t row = row_of(active, robot.number);
      const bool has_row = row < out.size();
      if (!has_row && (robot.flags & REGISTA_ROBOT_PENALISED) != 0) continue;
      members_.push_back(row);
      const bool is_bound = !has_row && has_own_role(robot.number, tasks);
      for (std::size_t column = 0; column < tasks.size(); ++column) {
        const int only = tasks[column].robot;
        const bool may = has_row ? utilities(row, column) != regista::UtilityMatrix::forbidden
                                 : only == robot.number || (only == 0 && !is_bound);
        may_.push_back(may ? 0.0 : static_partition::forbidden);
      }
    }
    shares_.resize(members_.size());
    static_partition::moving_up({may_.data(), members_.size(), tasks.size(), tasks.size()},
                                assignment::by_importance(tasks, order_), shares_);
    for (std::size_t k = 0; k < members_.size(); ++k) {
      if (members_[k] < out.size()) out[members_[k]] = shares_[k];
    }
  }

 private:
  // In the list that these tasks are of. The role of a robot that is given up is not among the tasks.
  bool has_own_role(int number, const regista::Span<regista::Task>& tasks) const {
    if (tasks.empty()) return false;
    const char* const list = roles_[static_cast<std::size_t>(tasks[0].id)].list;
    for (const regista::Role& role : roles_) {
      if (role.robot == number && std::strcmp(role.list, list) == 0) return true;
    }
    return false;
  }

  regista::BudgetNow budget_;
  regista::Span<regista::Role> roles_;
  int static_at_ = usual_reserve;
  std::vector<std::size_t> members_;  // rows; of those that have none a number beyond
  std::vector<double> may_;           // members x tasks
  std::vector<std::uint32_t> order_;
  std::vector<std::int32_t> shares_;  // by member
};

}  // namespace negotiation
