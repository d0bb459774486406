// SPDX-License-Identifier: MIT
// What plugins of auctions have in common, whatever their rule of bidding: from frames and messages to a Participant,
// and from its table to an assignment. Glue.
//
// Which task a robot plays: the one that it holds. But a robot that has given its task up goes on with it while nobody
// else holds it, until the new bid has been on the air for `patience`: the new task may still be another's.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/host.hpp>
#include <regista/mailbox.hpp>

#include "../negotiation/bids.hpp"
#include "../negotiation/reserve.hpp"
#include "../negotiation/standing_offer.hpp"
#include "participant.hpp"
#include "price_table.hpp"

namespace auction {

// The default epsilon is what a team of seven needs to settle in the 16 s of a rehearsal without losses, at a packet
// per second and robot: in 20 to 40 rehearsals the longest act took 10 s with 0.1, 12 s with 0.05, and some acts did
// not settle with 0.02. In the paper's utility 0.1 is 1.6 m of walking for each task, at most.
struct Settings {
  double step = 0.001;
  double largest = 2.0;
  double epsilon = 0.1;
  double threshold = 0.05;
  double lapse = 25.0;
  double patience = 2.0;
  double urgency = 1.0;
  double urgent_every = 6.0;
  double done_within = 0.0;  // m; 0: tasks are never done
  int stop_negotiating_at = negotiation::usual_reserve;

  std::uint32_t steps(double utility) const {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(utility / step)));
  }
  // Having a task is worth a step more than having none, whatever the utility: no task stays open for want of value.
  std::uint32_t highest_value() const { return 1 + steps(largest); }
};

inline constexpr std::tuple shared_parameters{
    regista::real("step", &Settings::step, {0.0001, 1.0}, "1",
                  "Utility that a robot tells as one step of a price; smaller differences are ties (assumption)")
        .log_scale(),
    regista::real("largest", &Settings::largest, {0.1, 1000.0}, "1",
                  "Utilities above this count as this: messages have room for prices up to it (assumption)")
        .log_scale(),
    regista::real("epsilon", &Settings::epsilon, {0.0001, 10.0}, "1",
                  "Utility by which a bid exceeds what the task is worth to its bidder beyond the next best one: a "
                  "large one settles soon and loses up to so much for each task (Bertsekas 1979; the number is our "
                  "assumption)")
        .tunable()
        .log_scale(),
    regista::real("threshold", &Settings::threshold, {0.0, 10.0}, "1",
                  "Change of utility below which a robot does not bid anew, or auctions never rest (assumption)")
        .tunable(),
    regista::real("lapse", &Settings::lapse, {1.0, 3600.0}, "s",
                  "A bid ends when its robot was not heard for so long (assumption)"),
    regista::real("patience", &Settings::patience, {0.0, 60.0}, "s",
                  "A robot goes on with the task that it gave up until its new bid has been on the air for so long "
                  "(assumption)")
        .tunable(),
    regista::real("urgency", &Settings::urgency, {0.0, 1.0}, "1",
                  "Urgency of a new bid; 1 asks for a packet of its own (assumption)"),
    regista::real("urgent_every", &Settings::urgent_every, {0.0, 120.0}, "s",
                  "Least time since the last packet of this robot after which a bid is urgent, or the budget does not "
                  "last (assumption)")
        .tunable(),
    negotiation::stop_negotiating_at(&Settings::stop_negotiating_at)};

template <class Rule>
class Auctioneer {
 public:
  void setup(const regista::Environment& environment, const regista::Host& host, const Settings& settings) {
    // Of a packet, beside what is always in it and other plugins' offers. All robots of a team have the same room.
    constexpr std::uint32_t usual_bytes = 60, least_bytes = 8;
    const std::size_t most_bytes = std::clamp(host.mailbox().bytes_free(), least_bytes, usual_bytes);
    settings_ = settings;
    own_ = environment->own_number;
    const std::size_t tasks = environment.roles().size(), robots = environment->team_size;
    epsilon_ = settings.steps(settings.epsilon);
    conduct_ = {static_cast<std::int32_t>(std::round(settings.threshold / settings.step)), settings.lapse};
    format_ = Format::fitting(static_cast<std::int32_t>(robots), tasks, settings.highest_value() + epsilon_,
                              settings.done_within > 0.0, most_bytes);
    participant_.setup(own_, robots, tasks);
    offer_.setup(host.mailbox(), most_bytes);
    reserve_.setup(environment, host, settings.stop_negotiating_at);
    names_.clear();
    list_of_.clear();
    for (const regista::Role& role : environment.roles()) {
      names_.push_back(role.name);
      std::size_t first = 0;
      while (std::strcmp(environment.roles()[first].list, role.list) != 0) ++first;
      list_of_.push_back(static_cast<int>(first));
    }
    is_active_.resize(robots + 1);
    is_listed_.resize(tasks);
    for (auto* each : {&values_, &groups_}) each->reserve(tasks);
    for (auto* each : {&columns_, &tasks_}) each->reserve(tasks);
    told_.reserve(tasks);
    heard_.reserve(tasks);
    untold_.reserve(tasks);
    bytes_.reserve(most_bytes);
    reset();
  }
  void reset() {
    participant_.reset();
    offer_.forget();
    played_ = wanted_ = none;
    is_sent_ = false;
    sent_since_ = never;
    has_spoken_ = false;
    spoke_ = -never;
    turn_ = 0;
    list_ = no_list;
  }

  std::uint32_t epsilon() const { return epsilon_; }

  void assign(const regista::Frame& frame, const regista::UtilityMatrix& utilities, const regista::Assignment& out,
              const Rule& rule) {
    const bool is_static = reserve_.is_reached();
    if (frame.tasks().empty() || is_static) {  // nothing to bid for
      played_ = wanted_ = none;
      if (is_static) reserve_.assign_by_rank(frame, utilities, out);
      return offer_.withdraw();
    }
    const Situation situation = read(frame, utilities);
    participant_.decide(situation, conduct_, rule);
    const std::size_t own_row = negotiation::row_of(frame.world().active(), own_);
    if (settings_.done_within > 0.0) note_done(frame);
    if (own_row < out.size()) {
      play(situation);
      out[own_row] = played_ == wanted_ ? column_of(wanted_) : regista::Assignment::unknown_task;
    } else {
      played_ = wanted_ = none;
    }
    for (std::size_t row = 0; row < out.size(); ++row) {
      if (row != own_row) out[row] = shown(frame.world().active()[row], utilities, row);
    }
    say(frame.time());
  }

  void receive(const regista::Message& message) {
    if (message.sender() < 1 || message.sender() > format_.team_size || message.sender() == own_) return;
    std::uint8_t epoch = 0;
    if (!read_message(format_, message.bytes(), epoch, heard_)) return;
    participant_.hear(message.sender(), epoch, heard_, message.time_heard());
  }
  void transmitted(std::uint64_t handle) {
    if (!offer_.gone(handle)) return;
    participant_.sent(untold_);
    is_sent_ = has_spoken_ = true;
    ++turn_;
  }
  void dropped(std::uint64_t handle) { offer_.gone(handle); }

  // "epoch 3: striker 2 for 0.831, jolly given up at 0.204"
  std::string describe(std::span<const std::uint8_t> bytes) const {
    std::uint8_t epoch = 0;
    std::vector<Told> told;
    if (!read_message(format_, bytes, epoch, told)) return "no bids of this team";
    std::string out = "epoch " + std::to_string(epoch) + (told.empty() ? ": no bids" : ":");
    for (std::size_t k = 0; k < told.size(); ++k) {
      const Told& each = told[k];
      char price[32];
      std::snprintf(price, sizeof price, "%.3f", settings_.step * static_cast<double>(each.bid.price));
      out += (k == 0 ? " " : ", ") + std::string(names_[each.task]);
      out += each.bid.bidder == nobody ? " given up at " : ' ' + std::to_string(each.bid.bidder) + " for ";
      out += price;
      if (each.done) out += " (done)";
    }
    return out;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr int no_list = -1;
  static constexpr double never = std::numeric_limits<double>::infinity();

  Situation read(const regista::Frame& frame, const regista::UtilityMatrix& utilities) {
    const regista::World world = frame.world();
    const regista::Span<regista::Task> tasks = frame.tasks();
    Situation out;
    out.now = frame.time();
    std::ranges::fill(is_active_, 0);
    for (const std::int32_t number : world.active()) is_active_[static_cast<std::size_t>(number)] = 1;
    out.is_active = is_active_;
    out.robots = world.active().size();
    for (const regista::Robot& robot : world.robots()) {
      if ((robot.flags & REGISTA_ROBOT_PENALISED) == 0) out.subject.add_robot(robot.number);
    }
    enter_list(list_of_[static_cast<std::size_t>(tasks[0].id)]);
    out.is_listed = is_listed_;
    columns_.clear();
    for (std::uint32_t column = 0; column < tasks.size(); ++column) {
      columns_.push_back(column);
      for (std::size_t k = columns_.size() - 1; k > 0 && tasks[columns_[k - 1]].id > tasks[columns_[k]].id; --k) {
        std::swap(columns_[k - 1], columns_[k]);
      }
    }
    const std::size_t row = negotiation::row_of(world.active(), own_);
    out.plays = row < world.active().size();
    tasks_.clear();
    values_.clear();
    groups_.clear();
    for (const std::uint32_t column : columns_) {
      const regista::Task& task = tasks[column];
      tasks_.push_back(static_cast<std::uint32_t>(task.id));
      groups_.push_back(task.group < 0 ? std::numeric_limits<std::int32_t>::max() : task.group);
      const bool allowed = out.plays && utilities(row, column) != regista::UtilityMatrix::forbidden;
      values_.push_back(allowed ? value_of(utilities(row, column)) : may_not);
    }
    out.tasks = tasks_;
    out.values = values_;
    out.groups = groups_;
    return out;
  }

  void enter_list(int list) {
    if (list == list_) return;
    list_ = list;
    for (std::size_t task = 0; task < list_of_.size(); ++task) is_listed_[task] = list_of_[task] == list ? 1 : 0;
  }

  std::int32_t value_of(double utility) const {
    return static_cast<std::int32_t>(1 + negotiation::in_steps(utility, settings_.step, settings_.highest_value() - 1));
  }

  std::int32_t column_of(std::size_t task) const {
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      if (tasks_[k] == task) return static_cast<std::int32_t>(columns_[k]);
    }
    return regista::Assignment::no_task;
  }

  // The task that a robot is to play now of those that it holds: that of the first group, and of a later one when all
  // tasks before it are done.
  std::size_t current_task_of(std::int32_t number) const {
    std::size_t out = none;
    std::int32_t group = 0;
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      if (participant_.table()[tasks_[k]].bidder != number) continue;
      const bool better = out == none || (groups_[k] < group ? !may_begin(group) : may_begin(groups_[k]));
      if (!better) continue;
      out = tasks_[k];
      group = groups_[k];
    }
    return out;
  }
  bool may_begin(std::int32_t group) const {
    if (settings_.done_within <= 0.0) return false;
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      if (groups_[k] < group && !participant_.is_done(tasks_[k])) return false;
    }
    return true;
  }
  void note_done(const regista::Frame& frame) {
    if (played_ == none || participant_.table()[played_].bidder != own_) return;
    const std::int32_t column = column_of(played_);
    if (column < 0) return;
    const double* place = frame.tasks()[static_cast<std::size_t>(column)].after;
    const double* pose = frame.world().robot(own_).pose;
    const double dx = place[0] - pose[0], dy = place[1] - pose[1];
    if (dx * dx + dy * dy <= settings_.done_within * settings_.done_within) participant_.set_done(played_);
  }

  void play(const Situation& situation) {
    const std::size_t wanted = current_task_of(own_);
    if (wanted != wanted_) {
      wanted_ = wanted;
      is_sent_ = false;
      sent_since_ = never;
    }
    if (is_sent_ && sent_since_ == never) sent_since_ = situation.now;
    if (played_ == wanted_) return;
    const bool settled = wanted_ != none && situation.now - sent_since_ >= settings_.patience;
    if (played_ == none || settled || !may_go_on(situation)) played_ = wanted_;
  }
  bool may_go_on(const Situation& situation) const {
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      if (tasks_[k] != played_) continue;
      const bool is_anothers =
          participant_.table()[played_].bidder != own_ && participant_.is_held(played_, situation, conduct_);
      return values_[k] != may_not && !is_anothers;
    }
    return false;
  }

  // What a teammate does as far as the table tells.
  std::int32_t shown(std::int32_t number, const regista::UtilityMatrix& utilities, std::size_t row) const {
    const std::size_t task = current_task_of(number);
    if (task == none) return regista::Assignment::unknown_task;
    const std::int32_t column = column_of(task);
    const bool allowed = utilities(row, static_cast<std::size_t>(column)) != regista::UtilityMatrix::forbidden;
    return allowed ? column : regista::Assignment::unknown_task;
  }

  // Own bids first, then what this robot has just given up, then the bids of others beginning at another one each time,
  // if a message has no room for all; other tasks that were given up at last.
  void say(double now) {
    const std::span<const Bid> table = participant_.table();
    told_.clear();
    untold_.clear();
    const auto take = [&](const auto& wanted) {
      for (std::size_t k = 0; k < table.size(); ++k) {
        const std::size_t task = (k + turn_) % table.size();
        if (!is_listed_[task] || table[task].price == 0 || !wanted(task, table[task].bidder)) continue;
        if (told_.size() < format_.most_told) {
          told_.push_back({task, table[task], participant_.is_done(task)});
        } else {
          untold_.push_back(task);
        }
      }
    };
    const auto gave_up = [&](std::size_t task) { return participant_.is_unsent(task); };
    take([&](std::size_t, int bidder) { return bidder == own_; });
    take([&](std::size_t task, int bidder) { return bidder == nobody && gave_up(task); });
    take([&](std::size_t, int bidder) { return bidder != own_ && bidder != nobody; });
    take([&](std::size_t task, int bidder) { return bidder == nobody && !gave_up(task); });
    std::ranges::sort(told_, {}, &Told::task);
    write_message(format_, participant_.epoch(), told_, bytes_);
    if (std::exchange(has_spoken_, false)) spoke_ = now;
    const bool is_urgent = participant_.has_unsent() && now - spoke_ >= settings_.urgent_every;
    offer_.say(bytes_, now, is_urgent ? settings_.urgency : 0.0);
  }

  Settings settings_;
  Conduct conduct_;
  Format format_;
  std::uint32_t epsilon_ = 1;
  std::int32_t own_ = 0;
  Participant<Rule> participant_;
  negotiation::StandingOffer offer_;
  negotiation::Reserve reserve_;
  std::vector<const char*> names_;  // of roles; they live as long as the instance
  std::vector<int> list_of_;        // by id: first role of the list that it stands in
  std::vector<char> is_listed_;     // by id: it stands in list_
  int list_ = no_list;
  std::size_t played_ = none, wanted_ = none;
  bool is_sent_ = false;  // since wanted_ is what it is
  double sent_since_ = never;
  bool has_spoken_ = false;  // since the last decision
  double spoke_ = -never;
  std::size_t turn_ = 0;  // grows with every packet
  std::vector<char> is_active_;
  std::vector<std::int32_t> values_, groups_;
  std::vector<std::uint32_t> columns_, tasks_;  // ascending ids
  std::vector<Told> told_, heard_;
  std::vector<std::size_t> untold_;  // tasks that the message has no room for
  std::vector<std::uint8_t> bytes_;
};

}  // namespace auction
