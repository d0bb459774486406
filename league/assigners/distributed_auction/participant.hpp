// SPDX-License-Identifier: MIT
// One robot's part in an auction over a radio that loses packets: it keeps the table of bids, merges what it hears, and
// bids by a rule (algorithm.hpp has that of a task for each robot). Plain input and output; the radio and its bytes are
// the caller's.
//
// Decided by us, since the publication has values that rest, robots that stay, and no packet lost:
//   Unsent     What a robot bids or gives up counts when it has been sent. Until then it is thought over at every
//              decision, or prices would rise that nobody has heard of.
//   Values     A robot bids on values as they were when it last looked. It looks again when one of them has changed by
//              more than a threshold. It keeps its task if that is still within epsilon of the best at present prices;
//              else it gives it up at its price, and bids. With as many tasks as robots that is sound, for all tasks
//              get a robot and only differences of prices matter.
//   Epochs     Prices only rise, and a task that was given up keeps its price. So a robot that would take a task which
//              nobody holds, if only its price were 0, begins a new epoch: all bids are void, and robots look at their
//              values again. So does who sees that the robots in the game are others.
//   Lists      Roles of another list than the present one are another auction, which rests until its list comes back.
//   Void bids  The bid of a robot that is not active is nobody's. So is the bid of one of which nothing was heard for
//              long. Its price stands.
//   No row     A robot that does not play gives up what it holds, and bids for nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../negotiation/epoch.hpp"
#include "algorithm.hpp"
#include "price_table.hpp"

namespace auction {

struct Conduct {
  std::int32_t threshold = 0;  // steps: changes of a value up to this are none
  double lapse = 25.0;         // s: the bid of a robot that is unheard for longer is void
};

// What a robot knows at a decision. Owned by the caller.
struct Situation {
  double now = 0.0;                      // s
  bool plays = false;                    // it is among the active robots
  std::span<const char> is_active;       // by shirt number
  std::size_t robots = 0;                // that are active
  std::span<const std::uint32_t> tasks;  // ids, ascending
  std::span<const std::int32_t> values;  // of this robot for each of them: steps of utility, or may_not
  std::span<const std::int32_t> groups;  // of each of them
  std::span<const char> is_listed;       // by id: it stands in the present list of roles
  negotiation::Subject subject;          // who is in the game
};

template <class Rule>
class Participant {
 public:
  void setup(std::int32_t own, std::size_t team_size, std::size_t tasks) {
    own_ = own;
    entries_.resize(tasks);
    table_.resize(tasks);
    heard_.resize(team_size + 1);
    prices_.reserve(tasks);
    values_.reserve(tasks);
    mine_.reserve(tasks);
    bids_.reserve(tasks);
    reset();
  }
  void reset() {
    epoch_.forget();
    restarts_ = 0;
    std::ranges::fill(heard_, long_ago);
    clear(long_ago);
  }

  void decide(const Situation& situation, const Conduct& conduct, const Rule& rule) {
    take_back_what_is_unsent();
    begin_epoch_if_changed(situation);
    if (!situation.plays) {
      for (std::size_t task = 0; task < table_.size(); ++task) {
        if (table_[task].bidder == own_) give_up(task);
      }
      return;
    }
    look(situation, conduct, rule);
    bid(situation, rule);
    if (!misses_a_task(situation, conduct, rule)) return;
    ++restarts_;
    begin_epoch_if_changed(situation);
    look(situation, conduct, rule);
    bid(situation, rule);
  }

  // The table, as decide() has left it, was sent, but for these tasks. What was heard since then still counts.
  void sent(std::span<const std::size_t> untold = {}) {
    for (std::size_t task = 0; task < table_.size(); ++task) {
      Entry& entry = entries_[task];
      if (!entry.is_unsent || std::ranges::find(untold, task) != untold.end()) continue;
      entry.is_unsent = false;
      merge(table_[task], entry.before);
    }
    if (!has_unsent()) is_restless_ = false;
  }
  bool has_unsent() const {
    return std::ranges::any_of(entries_, [](const Entry& each) { return each.is_unsent; });
  }
  bool is_unsent(std::size_t task) const { return entries_[task].is_unsent; }

  // A message of a teammate arrived at `now`; its ids and bidders have been checked.
  void hear(std::int32_t sender, std::uint8_t epoch, std::span<const Told> told, double now) {
    double& heard = heard_[static_cast<std::size_t>(sender)];
    heard = std::max(heard, now);
    const auto [joined, counts] = epoch_.hear(epoch);
    if (joined) clear(now);
    if (!counts) return;
    for (const Told& each : told) {
      Entry& entry = entries_[each.task];
      if (merge(entry.is_unsent ? entry.before : table_[each.task], each.bid)) entry.learned = now;
      if (each.done) entry.is_done = true;
    }
  }

  std::uint8_t epoch() const { return epoch_.number(); }
  std::span<const Bid> table() const { return table_; }
  bool is_done(std::size_t task) const { return entries_[task].is_done; }
  void set_done(std::size_t task) { entries_[task].is_done = true; }
  // Whether somebody holds the task who can do it, as far as this robot knows. Its own bids count.
  bool is_held(std::size_t task, const Situation& situation, const Conduct& conduct) const {
    const Bid bid = table_[task];
    if (bid.bidder == nobody) return false;
    if (bid.bidder == own_) return true;
    const auto bidder = static_cast<std::size_t>(bid.bidder);
    const double known_for = situation.now - entries_[task].learned;
    if (std::min(known_for, situation.now - heard_[bidder]) > conduct.lapse) return false;
    return situation.is_active[bidder] != 0 || known_for <= pause;
  }

 private:
  static constexpr double long_ago = -1e9;
  // s: bids of robots that are not active count for so long after they were heard of, for these may be on their way
  // back; and so long an epoch lasts at least, or robots that know different things would begin one after the other.
  static constexpr double pause = 3.0;
  static constexpr std::int32_t not_looked_at = -2;

  // What goes with a bid of the table.
  struct Entry {
    double learned = long_ago;               // when it was heard of
    std::int32_t looked_at = not_looked_at;  // own value that this robot bids on
    Bid before;                              // what stood there before the own change that is unsent
    bool is_unsent = false;
    bool is_done = false;
  };

  void clear(double now) {
    std::ranges::fill(table_, Bid{});
    std::ranges::fill(entries_, Entry{});
    began_ = now;
    is_restless_ = false;
  }

  void begin_epoch_if_changed(const Situation& situation) {
    negotiation::Subject subject = situation.subject;
    subject.add_round(restarts_);
    if (epoch_.about(subject)) clear(situation.now);
  }

  void take_back_what_is_unsent() {
    for (std::size_t task = 0; task < table_.size(); ++task) {
      if (!entries_[task].is_unsent) continue;
      table_[task] = entries_[task].before;
      entries_[task].is_unsent = false;
    }
  }
  void change(std::size_t task, Bid to) {
    if (!entries_[task].is_unsent) entries_[task].before = table_[task];
    entries_[task].is_unsent = true;
    table_[task] = to;
  }
  void give_up(std::size_t task) { change(task, {table_[task].price, nobody}); }

  Market market(const Situation& situation) {
    values_.clear();
    prices_.clear();
    mine_.clear();
    for (const std::uint32_t task : situation.tasks) {
      values_.push_back(entries_[task].looked_at);
      prices_.push_back(table_[task].price);
      mine_.push_back(table_[task].bidder == own_ ? 1 : 0);
    }
    return {values_, prices_, situation.groups, mine_};
  }

  // Takes the present values where they have changed, and gives up what it should not hold.
  void look(const Situation& situation, const Conduct& conduct, const Rule& rule) {
    bool changed = false;
    for (std::size_t column = 0; column < situation.tasks.size(); ++column) {
      const std::int32_t value = situation.values[column];
      std::int32_t& looked_at = entries_[situation.tasks[column]].looked_at;
      if (looked_at == not_looked_at) looked_at = value;
      const std::int32_t change = value > looked_at ? value - looked_at : looked_at - value;
      if (change > conduct.threshold || (value == may_not) != (looked_at == may_not)) changed = true;
    }
    if (changed) {
      for (std::size_t column = 0; column < situation.tasks.size(); ++column) {
        entries_[situation.tasks[column]].looked_at = situation.values[column];
      }
      is_restless_ = true;
    }
    for (std::size_t task = 0, column = 0; task < table_.size(); ++task) {
      const bool known = column < situation.tasks.size() && situation.tasks[column] == task;
      const bool allowed = known && situation.values[column] != may_not;
      if (table_[task].bidder == own_ && situation.is_listed[task] && !allowed) give_up(task);
      if (known) ++column;
    }
    bool keeps_all = true;
    Market now = market(situation);
    for (std::size_t column = 0; column < situation.tasks.size(); ++column) {
      if (!now.mine[column]) continue;
      if (rule.is_one_too_many(now, column) || (is_restless_ && rule.is_no_longer_best(now, column))) {
        give_up(situation.tasks[column]);
        now = market(situation);
        keeps_all = false;
      }
    }
    if (keeps_all) is_restless_ = false;
  }

  void bid(const Situation& situation, const Rule& rule) {
    rule.bids(market(situation), bids_);
    for (const NewBid& each : bids_) change(situation.tasks[each.column], {each.price, own_});
  }

  bool misses_a_task(const Situation& situation, const Conduct& conduct, const Rule& rule) {
    if (situation.now - began_ < pause) return false;
    const Market now = market(situation);
    for (std::size_t column = 0; column < now.size(); ++column) {
      if (now.prices[column] == 0 || is_held(situation.tasks[column], situation, conduct)) continue;
      if (rule.misses(now, column, situation.robots)) return true;
    }
    return false;
  }

  std::int32_t own_ = 0;
  negotiation::Epoch epoch_;
  int restarts_ = 0;  // epochs that this robot has begun because of a price
  double began_ = long_ago;
  bool is_restless_ = false;          // has looked again, and what it holds is not within epsilon of the best
  std::vector<Bid> table_;            // by id of task
  std::vector<Entry> entries_;        // the same
  std::vector<double> heard_;         // by shirt number
  std::vector<std::int32_t> values_;  // by column, as all below
  std::vector<std::uint32_t> prices_;
  std::vector<char> mine_;
  std::vector<NewBid> bids_;
};

}  // namespace auction
