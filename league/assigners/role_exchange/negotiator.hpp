// SPDX-License-Identifier: MIT
// One robot's part in the exchange of roles of CS Freiburg (Weigel, Gutmann, Dietl, Kleiner and Nebel, IEEE T-RA 18(5),
// 2002). Every robot tells its utilities for the roles, the role that it plays and the one that it wishes for: the one
// that it has in the permutation with the largest sum. Roles change when all who are concerned wish for it
// (agreement.hpp).
//
// The publication had a few packets a second of each robot, and four robots. What follows is decided here:
//   - What a robot has said binds it until it says something else: it changes roles by the wish that it sent last, also
//     when it has another one by now. Otherwise one of two robots would change alone.
//   - A role that nobody holds needs nobody's consent: who wishes for it takes it at once.
//   - Who made no statement, or none for `lapse` seconds, or has claimed one of the tasks by other ways since, holds
//     what it claims that way, if anything, and stays. Its utilities are estimated by the receiver. What a robot said
//     before it last left the game is void.
//   - A role that a robot does not name among its utilities it cannot play. A statement that names none of the own
//     tasks is about another situation, and its utilities do not count.
//   - Two robots with one role: the lower utility yields, of equal ones the higher number. The utility that was sent
//     counts, so that both compare the same.
//   - A robot without a role takes the most important free one that the permutation gives to nobody; when there are
//     only others for `patience` seconds, one of these.
//   - A utility that changed by no more than `dead_band` is told as before.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "../negotiation/bids.hpp"
#include "agreement.hpp"
#include "best_permutation.hpp"
#include "message.hpp"

namespace role_exchange {

struct Settings {
  double keep_bonus = 0.05;  // of the utility of the role that the robot has
  double largest = 1.0;      // utility that can be told; larger ones count as this, > 0
  double dead_band = 0.015;
  double lapse = 25.0;    // s
  double patience = 5.0;  // s
};

// What a robot knows at a decision. Robots are named by number, 1 to the team's size; tasks by their row in the table
// of roles.
struct Situation {
  double time;                            // s
  std::span<const std::int32_t> members;  // who plays, ascending
  std::span<const std::int32_t> tasks;    // each once
  std::span<const std::uint32_t> choice;  // columns of tasks: which are done when not all can be
  std::span<const std::uint32_t> order;   // columns of tasks: ties
  Matrix utilities;                       // members x tasks; finite and >= 0, or `forbidden`
  // By number - 1: the role that a robot claims by other ways, or no_role, and when it did, s.
  std::span<const std::int32_t> claims;
  std::span<const double> claimed;
  // The first decision, or others were made by somebody else since the last one: then the own role is own_role if that
  // is one of the tasks, else still what it was, unless that is longer ago than `lapse`.
  bool begins;
  std::int32_t own_role;
};

class Negotiator {
 public:
  // Allocates all that is ever needed. own: number.
  void reserve(const Settings& settings, int own, std::size_t robots, std::size_t roles) {
    settings_ = settings;
    own_ = own;
    roles_ = roles;
    said_.resize(robots);
    table_.resize(robots);
    trial_.reserve(robots);
    for (Heard& each : said_) each.statement.utilities.reserve(roles);
    for (Statement* each : {&incoming_, &outgoing_, &sent_}) each->utilities.reserve(roles);
    base_.reserve(roles);
    permutation_.reserve(robots);
    values_.reserve(robots * roles);
    bytes_.reserve(message_bytes(roles, std::min(robots, roles)));
    best_.reserve(robots, roles);
    agreement_.reserve(robots);
    forget();
  }
  // Back to the beginning of a match.
  void forget() {
    for (Heard& each : said_) {
      each.known = false;
      each.sent = each.away = -1.0;
      each.statement.forget(roles_);
    }
    std::fill(table_.begin(), table_.end(), Holding{});
    base_.assign(roles_, cannot);
    has_sent_ = false;
    role_ = wish_ = no_role;
    last_time_ = waits_since_ = -1.0;
    playing_ = completes_ = false;
  }

  // A teammate's statement. Any bytes of anybody; s.
  void hear(int sender, std::span<const std::uint8_t> bytes, double time_sent) {
    if (sender < 1 || sender > static_cast<int>(said_.size()) || sender == own_) return;
    Heard& from = said_[static_cast<std::size_t>(sender - 1)];
    if (time_sent <= from.sent || !read_statement(bytes, roles_, incoming_)) return;
    from.sent = time_sent;
    from.known = true;
    std::swap(from.statement, incoming_);
    table_[static_cast<std::size_t>(sender - 1)] = {from.statement.role, from.statement.wish};
  }
  // The own statement left: bytes of message().
  void sent(std::span<const std::uint8_t> bytes) { has_sent_ = read_statement(bytes, roles_, sent_); }

  void decide(const Situation& now) {
    if (now.begins) begin(now);
    last_time_ = now.time;
    look_at_teammates(now);
    own_row_ = static_cast<std::size_t>(std::find(now.members.begin(), now.members.end(), own_) - now.members.begin());
    playing_ = own_row_ < now.members.size();
    if (!playing_) {
      role_ = wish_ = no_role;
      has_sent_ = completes_ = false;
      mine() = {};
      find_permutation(now);  // for what the others are taken to do; that of before was of other members
      return;
    }
    if (column_of(now, role_) == now.tasks.size()) role_ = no_role;
    look_at_myself(now);
    find_permutation(now);
    exchange(now);
    take_free_role(now);
    mine().role = role_;
    state(now);
    completes_ = wish_is_news() && would_change(now);
  }

  // Whether the robot plays and so has something to say; then message() says it.
  bool speaks() const { return playing_; }
  std::span<const std::uint8_t> message() const { return bytes_; }

  std::int32_t role() const { return role_; }
  std::int32_t wish() const { return wish_; }
  // Whether the wish for another role waits for others to hear of it.
  bool wish_is_news() const {
    return playing_ && wish_ != role_ && (!has_sent_ || sent_.wish != wish_ || sent_.role != role_);
  }
  // Whether the others concerned have told their wishes, so that the own statement completes a change.
  bool completes_change() const { return completes_; }
  // Which of the tasks a teammate plays as far as this robot knows, or no_role. Who has told nothing about these tasks
  // plays what the permutation gives it, if nobody else does. `row`: of the teammate among the members.
  std::int32_t role_of(const Situation& now, std::size_t row) const {
    const auto robot = static_cast<std::size_t>(now.members[row] - 1);
    if (column_of(now, table_[robot].role) < now.tasks.size()) return table_[robot].role;
    const std::int32_t column = permutation_[row];
    if (column == nobody || counts(now, said_[robot])) return no_role;
    const std::int32_t guess = now.tasks[static_cast<std::size_t>(column)];
    return is_free(guess) ? guess : no_role;
  }

 private:
  struct Heard {
    bool known = false;
    double sent = -1.0, away = -1.0;  // s; away: when it last did not play
    Statement statement;
  };

  static constexpr double later = 0.05;      // s: a claim that is newer than a statement came without one
  static constexpr double on_the_way = 2.0;  // s: so old may news be of a robot that has just come back

  Holding& mine() { return table_[static_cast<std::size_t>(own_ - 1)]; }
  static std::size_t column_of(const Situation& now, std::int32_t role) {
    return static_cast<std::size_t>(std::find(now.tasks.begin(), now.tasks.end(), role) - now.tasks.begin());
  }
  std::uint32_t in_steps(double utility) const {
    return negotiation::in_steps(utility, settings_.largest / most_steps, most_steps);
  }
  std::uint32_t with_bonus(std::uint32_t steps) const {
    return std::min(most_steps, steps + in_steps(settings_.keep_bonus));
  }

  void begin(const Situation& now) {
    if (column_of(now, now.own_role) < now.tasks.size() || now.time - last_time_ > settings_.lapse) {
      role_ = now.own_role;
      has_sent_ = false;
    }
    waits_since_ = -1.0;
  }

  void look_at_teammates(const Situation& now) {
    for (std::size_t robot = 0; robot < said_.size(); ++robot) {
      if (static_cast<int>(robot) + 1 == own_) continue;
      Heard& each = said_[robot];
      const bool plays =
          std::binary_search(now.members.begin(), now.members.end(), static_cast<std::int32_t>(robot) + 1);
      if (!plays) {
        each.away = now.time;
        each.known = false;
      }
      const double back = each.away - on_the_way;
      const bool claims = plays && now.claimed[robot] > back && now.time - now.claimed[robot] <= settings_.lapse &&
                          column_of(now, now.claims[robot]) < now.tasks.size();
      if (each.sent <= back || now.time - each.sent > settings_.lapse) each.known = false;
      if (claims && now.claimed[robot] > each.sent + later) each.known = false;
      if (each.known) continue;
      const std::int32_t claim = claims ? now.claims[robot] : no_role;
      table_[robot] = {claim, claim};
    }
  }

  // The own utilities without the bonus, by role.
  void look_at_myself(const Situation& now) {
    const auto band = static_cast<std::int32_t>(in_steps(settings_.dead_band));
    incoming_.utilities.assign(roles_, cannot);  // scratch
    for (std::size_t column = 0; column < now.tasks.size(); ++column) {
      const double utility = now.utilities(own_row_, column);
      if (utility == forbidden) continue;
      const auto role = static_cast<std::size_t>(now.tasks[column]);
      const auto steps = static_cast<std::int16_t>(in_steps(utility));
      const bool as_before = base_[role] != cannot && std::abs(steps - base_[role]) <= band;
      incoming_.utilities[role] = as_before ? base_[role] : steps;
    }
    std::swap(base_, incoming_.utilities);
  }
  std::int16_t own_utility(std::int32_t role) const {
    const std::int16_t steps = base_[static_cast<std::size_t>(role)];
    return steps == cannot || role != role_ ? steps
                                            : static_cast<std::int16_t>(with_bonus(static_cast<std::uint32_t>(steps)));
  }

  // Whether what this robot has told is about the tasks that there are now.
  bool counts(const Situation& now, const Heard& each) const {
    return each.known && std::any_of(now.tasks.begin(), now.tasks.end(), [&](std::int32_t task) {
             return each.statement.utilities[static_cast<std::size_t>(task)] != cannot;
           });
  }

  // Fills values_, members x tasks, and finds the permutation and the own wish in it.
  void find_permutation(const Situation& now) {
    const std::size_t rows = now.members.size(), columns = now.tasks.size();
    values_.resize(rows * columns);
    for (std::size_t row = 0; row < rows; ++row) {
      const auto robot = static_cast<std::size_t>(now.members[row] - 1);
      const bool told = row != own_row_ && counts(now, said_[robot]);
      for (std::size_t column = 0; column < columns; ++column) {
        const double believed = now.utilities(row, column);
        double& value = values_[row * columns + column];
        value = forbidden;
        if (believed == forbidden) continue;
        const std::int32_t task = now.tasks[column];
        if (row == own_row_) {
          value = own_utility(task);
        } else if (told) {
          const std::int16_t steps = said_[robot].statement.utilities[static_cast<std::size_t>(task)];
          if (steps != cannot) value = steps;
        } else {
          const std::uint32_t steps = in_steps(believed);
          value = table_[robot].role == task ? with_bonus(steps) : steps;
        }
      }
    }
    permutation_.resize(rows);
    best_.find({values_.data(), rows, columns, columns}, now.choice, now.order, permutation_);
    if (own_row_ == rows) return;
    const std::int32_t own = permutation_[own_row_];
    wish_ = own == nobody ? no_role : now.tasks[static_cast<std::size_t>(own)];
  }

  // For comparisons between robots: the own as it was sent, so that others compare the same.
  double compared(const Situation& now, std::size_t robot, std::int32_t role) const {
    const auto index = static_cast<std::size_t>(role);
    if (static_cast<int>(robot) + 1 == own_) {
      const bool was_told = has_sent_ && sent_.utilities[index] != cannot;
      return was_told ? sent_.utilities[index] : own_utility(role);
    }
    if (said_[robot].known) return said_[robot].statement.utilities[index];
    const std::size_t column = column_of(now, role);
    const auto row = static_cast<std::size_t>(
        std::find(now.members.begin(), now.members.end(), static_cast<std::int32_t>(robot) + 1) - now.members.begin());
    if (column == now.tasks.size() || row == now.members.size()) return cannot;
    return values_[row * now.tasks.size() + column];
  }

  void exchange(const Situation& now) {
    const auto utility = [&](std::size_t robot, std::int32_t role) { return compared(now, robot, role); };
    mine() = {role_, has_sent_ ? sent_.wish : role_};
    agreement_.settle(table_, utility);
    role_ = mine().role;
    if (role_ == no_role) return;
    const std::size_t first = Agreement::holder(table_, role_, utility);
    const std::size_t column = column_of(now, role_);
    const bool can = column < now.tasks.size() && now.utilities(own_row_, column) != forbidden;
    if (static_cast<int>(first) + 1 != own_ || !can) role_ = mine().role = no_role;
  }

  bool would_change(const Situation& now) {
    trial_.assign(table_.begin(), table_.end());
    trial_[static_cast<std::size_t>(own_ - 1)].wish = wish_;
    agreement_.settle(trial_, [&](std::size_t robot, std::int32_t role) { return compared(now, robot, role); });
    return trial_[static_cast<std::size_t>(own_ - 1)].role != role_;
  }

  bool is_free(std::int32_t role) const {
    return std::none_of(table_.begin(), table_.end(), [&](const Holding& each) { return each.role == role; });
  }

  void take_free_role(const Situation& now) {
    if (wish_ != no_role && wish_ != role_ && is_free(wish_)) role_ = wish_;
    std::int32_t first = no_role;
    for (const std::uint32_t column : now.choice) {
      const std::int32_t task = now.tasks[column];
      if (role_ != no_role) break;
      if (now.utilities(own_row_, column) == forbidden || !is_free(task)) continue;
      const bool given =
          std::find(permutation_.begin(), permutation_.end(), static_cast<std::int32_t>(column)) != permutation_.end();
      if (!given) role_ = task;
      if (first == no_role) first = task;
    }
    if (role_ != no_role || first == no_role) {
      waits_since_ = -1.0;
      return;
    }
    if (waits_since_ < 0.0) waits_since_ = now.time;
    if (now.time - waits_since_ >= settings_.patience) role_ = first;
  }

  // Of utilities it tells those of as many tasks as robots play: more are never done.
  void state(const Situation& now) {
    outgoing_.forget(roles_);
    outgoing_.role = role_;
    outgoing_.wish = wish_;
    std::size_t left = now.members.size();
    for (const std::uint32_t column : now.choice) {
      if (left == 0) break;
      const std::int32_t task = now.tasks[column];
      const std::int16_t steps = own_utility(task);
      if (steps == cannot) continue;
      outgoing_.utilities[static_cast<std::size_t>(task)] = steps;
      --left;
    }
    write_statement(outgoing_, bytes_);
  }

  Settings settings_;
  int own_ = 1;
  std::size_t roles_ = 0, own_row_ = 0;
  bool playing_ = false, has_sent_ = false, completes_ = false;
  std::int32_t role_ = no_role, wish_ = no_role;
  double last_time_ = -1.0;
  double waits_since_ = -1.0;           // with no role, and one free that others were given; < 0: not
  std::vector<Heard> said_;             // by number - 1, also of the own one, which is never known
  std::vector<Holding> table_, trial_;  // by number - 1
  Statement incoming_, outgoing_, sent_;
  std::vector<std::int16_t> base_;
  std::vector<std::int32_t> permutation_;  // by row: column, or nobody
  std::vector<double> values_;
  std::vector<std::uint8_t> bytes_;
  BestPermutation best_;
  Agreement agreement_;
};

}  // namespace role_exchange
