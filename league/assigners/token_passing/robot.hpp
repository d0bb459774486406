// SPDX-License-Identifier: MIT
// Token passing: Farinelli, Iocchi, Nardi and Ziparo, "Task assignment with dynamic perception and constrained tasks in
// a multi-robot system" (ICRA 2005) and "Assignment of dynamically perceived tasks by token passing in multirobot
// systems" (Proceedings of the IEEE 94(7), 2006), over a broadcast radio that loses and delays. This is the state of
// one robot: what it knows of every token, and what it does with those that it holds.
//
// From the publications, as far as we remember them:
// - Who perceives a task that it does not know makes its tokens, one for each robot that the task needs, and tells.
// - Who holds a token, is able enough (capability >= the token's threshold) and free keeps it: it does the task. Else
//   it notes its visit on the token and passes it to a teammate that the token has not visited.
// - When all have been visited, the visits are cleared and the threshold falls.
// - Of two that made tokens for one task the one of lower priority deletes its token when it hears of the other.
// - Who has done a task tells, and all drop its token.
// Not there: tasks that may only be done together. Two tokens of one task are two tasks here.
// Decided here:
// - Priority is the lower number. All robots of a team perceive nearly the same roles: the lowest number makes a token
//   at once, the k-th lowest waits k times `stagger`, since it would lose to the lower one anyway.
// - The next teammate is the one whose capability, as this robot predicts it, is largest. With `foresight` teammates
//   that would refuse by that prediction count as visited: a radio of one packet a second has no time to ask them.
// - A robot has resources for one task. `takeover`: whether a busy robot counts as free for a more important task; it
//   then passes on what it did. The publications know no importance.
// - Who does a task gives its token up when its capability falls `give_up` below the threshold. The threshold rises
//   with the capability of who does the task, up to the first one, or after some minutes all would stand at 0.
// - A token that nobody takes at the last threshold rests with its holder until somebody is free. A teammate that
//   refused against the prediction is asked again after `rest`.
// - A task that is gone from what its holder perceives leaves the holder free. It is done after `gone_after`; until
//   then the holder resumes it when it comes back. Who holds a token of a task that it has never perceived passes it
//   on after `stagger`; when all have been visited it is done. Who hears that a task is done that it perceives takes it
//   that the teller does not, and does not ask it for `rest`.
//
// Under loss, where the publications assume that what is sent arrives:
// - A robot tells with every packet the tokens that it holds, and those that it has passed until it overhears that the
//   new holder knows: this is the acknowledgement. If it hears packets of the new holder that do not know after it has
//   told `repeats` times, or nothing for `patience`, it takes the token back in a new generation and tries the next
//   one. If nobody else would take it, it goes on telling.
// - A token is lost when its holder has left, when the holder has said `repeats` times what it holds and not named it
//   (it has dropped it, and that was not heard), or when nobody has answered for it for `silence`, which is longer than
//   the longest period of a sender: 20 s of the goalkeeper in the paper's team. The lowest number makes it anew in the
//   next generation, with the first threshold; the k-th lowest waits as above. It does so only if somebody could take
//   it: who is cut off from the team does not take away what others do. Who returns first listens for `stagger`.
// - A robot that does not play forgets what it holds.
// Generations are the epochs of this negotiation: each token has its own, so that news of one task unsettles no other.
//
// Bound, checked by test_network.cpp. Let q be the longest time between two packets of a robot plus the longest delay,
// 2 q <= patience and q < silence, and let members and tasks stay as they are. After the last packet that is lost,
// whatever timers have begun to run strike within `patience`, and what is told reaches all within q. So from
// patience + q on at most one robot holds a token, none holds it only while it is passed, at most q, and no generation
// begins any more. Then a token makes at most as many passes as there are robots in each of at most rounds + 1 rounds;
// the test finds all at rest within 3 q for each robot.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "situation.hpp"
#include "token.hpp"

namespace token_passing {

class Robot {
 public:
  static constexpr int none = -1;

  void reserve(int team_size, int tokens) {
    assert(team_size <= most_robots);
    team_size_ = team_size;
    known_.resize(static_cast<std::size_t>(tokens));
    busy_.resize(static_cast<std::size_t>(team_size));
    told_.reserve(static_cast<std::size_t>(tokens));
    heard_of_.resize(static_cast<std::size_t>(team_size));
    spoke_.resize(static_cast<std::size_t>(team_size));
    forget();
  }
  // Back to the beginning of a match.
  void forget() {
    std::ranges::fill(known_, Known{});
    std::ranges::fill(busy_, none);
    std::ranges::fill(heard_of_, never);
    std::ranges::fill(spoke_, never);
    told_.clear();
    members_ = 0;
    started_ = away_ = urgent_ = false;
    hold_until_ = now_ = never;
    kept_ = none;
  }

  // A packet of a teammate. Packets that were overtaken are dropped. told: ids and numbers are in range. says_all: it
  // had room for all that its sender answers for.
  void hear(int own, int sender, std::span<const Told> told, double time_sent, double now, bool says_all) {
    double& newest = heard_of_[index(sender)];
    if (time_sent <= newest) return;
    newest = time_sent;
    for (const Told& each : told) {
      Known& known = at(each.id);
      const negotiation::Order order = known.is_known ? compare(each.token, known.token) : negotiation::Order::later;
      if (order == negotiation::Order::earlier) continue;
      known.answered_for = now;
      known.unnamed = 0;
      if (order == negotiation::Order::same) {
        if (each.token.holder == sender) known.on_its_way = false;
        continue;
      }
      if (each.token.done && known.work != none) refuse(known, only(sender));
      known.is_known = true;
      known.token = each.token;
      known.teller = sender;
      known.changed_at = now;
      known.on_its_way = each.token.holder != sender && each.token.holder != own;
      known.perceived = false;
    }
    miss(own, sender, told, time_sent, says_all);
  }
  // A packet in which a teammate says nothing of tokens: it answers for none. May be one that was heard before.
  void overhear(int own, int sender, double time_sent) {
    double& newest = spoke_[index(sender)];
    if (time_sent <= newest || time_sent <= heard_of_[index(sender)]) return;
    newest = time_sent;
    miss(own, sender, {}, time_sent, true);
  }

  // To be called at every decision. Returns the index of the work that this robot does, or none.
  int decide(const Settings& settings, const Situation& situation) {
    settings_ = settings;
    situation_ = situation;
    now_ = situation.now;
    kept_ = none;
    if ((situation.members & only(situation.own)) == 0) {
      leave();
      return none;
    }
    note_members();
    for (Known& each : known_) each.work = none;
    for (int w = 0; w < works(); ++w) {
      Known& known = of(w);
      known.work = w;
      known.last_perceived = now_;
      if (is_mine(known)) known.perceived = true;
    }
    for (Known& each : known_) {
      if (each.work == none) each.missing_since = never;
    }
    note_who_is_busy();
    let_go_of_what_is_gone();
    take_back();
    make_missing();
    reconsider_own_task();
    for (int w = 0; w < works(); ++w) {
      if (is_mine(of(w)) && w != kept_) settle(w);
    }
    collect();
    situation_.work = {};  // it lives through this call only
    return kept_;
  }

  // The work that a robot does or is asked to do, or none. Of the last decision.
  int work_of(int number) const { return number == situation_.own ? kept_ : busy_[index(number)]; }
  // Whether it was ever heard of.
  bool was_heard(int number) const { return heard_of_[index(number)] != never || spoke_[index(number)] != never; }

  // What this robot answers for, what matters most first. Of the last decision.
  std::span<const Told> told() const { return told_; }
  // Worth a packet now: there is news, or somebody has not answered.
  bool is_urgent() const { return urgent_; }
  // The first `count` of told() left in a packet.
  void transmitted(std::size_t count) {
    urgent_ = false;
    for (const Told& each : std::span(told_).first(std::min(count, told_.size()))) {
      Known& known = at(each.id);
      if (known.teller != situation_.own || compare(each.token, known.token) != negotiation::Order::same) continue;
      if (known.sent == 0) known.first_sent = now_;
      if (++known.sent == settings_.repeats) known.sent_enough = now_;
    }
  }

  // As this robot knows it; null when it knows of none.
  const Token* token(int id) const {
    const Known& known = known_[static_cast<std::size_t>(id)];
    return known.is_known ? &known.token : nullptr;
  }

 private:
  static constexpr double never = -1e18;
  static constexpr double longest_delay = 1.0;  // s; who speaks later than this after a packet was sent has heard it

  struct Known {
    bool is_known = false;
    bool on_its_way = false;  // to the holder, of which nobody has heard that it knows
    bool perceived = false;   // this robot has seen the task since it holds the token
    int teller = 0;           // who told it first: the own number for what this robot has changed last
    int sent = 0;             // packets with it since then
    int told_in_vain = 0;     // 1: the new holder has spoken since and does not know; 2: in spite of all repeats
    int unnamed = 0;          // packets of the holder, one after the other, that should have named it
    int work = none;
    Robots refused = 0;  // of those that should have taken it, until `rest` is over
    double refused_at = never, answered_for = never, changed_at = never, last_perceived = never;
    double missing_since = never, first_sent = never, sent_enough = never;
    Token token;
  };

  static std::size_t index(int number) { return static_cast<std::size_t>(number - 1); }
  Known& at(int id) { return known_[static_cast<std::size_t>(id)]; }
  int works() const { return static_cast<int>(situation_.work.size()); }
  const Work& work(int w) const { return situation_.work[static_cast<std::size_t>(w)]; }
  Known& of(int w) { return at(work(w).id); }
  int capability(int number, int w) const { return work(w).capability[index(number)]; }
  bool plays(int number) const { return number > 0 && (situation_.members & only(number)) != 0; }
  bool is_mine(const Known& known) const {
    return known.is_known && !known.token.done && known.token.holder == situation_.own;
  }
  bool is_mine_to_deliver(const Known& known) const {
    return known.is_known && known.on_its_way && known.teller == situation_.own;
  }
  bool lives(const Known& known) const {
    if (!known.is_known || known.token.done || !plays(known.token.holder)) return false;
    if (known.unnamed >= settings_.repeats) return false;
    return is_mine(known) || is_mine_to_deliver(known) || now_ - known.answered_for <= settings_.silence;
  }

  // What a packet does not say. Whom this robot has passed a token, and who does not answer for it, has not heard.
  void miss(int own, int sender, std::span<const Told> told, double time_sent, bool says_all) {
    for (Known& each : known_) {
      const int id = static_cast<int>(&each - known_.data());
      const bool holds = each.is_known && !each.token.done && !each.on_its_way && each.token.holder == sender;
      if (holds && says_all && std::ranges::none_of(told, [&](const Told& other) { return other.id == id; })) {
        ++each.unnamed;
      }
    }
    for (Known& each : known_) {
      if (!each.on_its_way || each.teller != own || each.token.holder != sender || each.sent == 0) continue;
      if (time_sent <= each.first_sent + longest_delay) continue;
      if (each.told_in_vain == 0) urgent_ = true;
      each.told_in_vain = each.sent >= settings_.repeats && time_sent > each.sent_enough + longest_delay ? 2 : 1;
    }
  }

  // --- Changes of a token that this robot holds

  void changed(Known& known, bool is_news = false) {
    ++known.token.hop;
    known.teller = situation_.own;
    known.changed_at = now_;
    known.answered_for = now_;
    known.sent = known.told_in_vain = known.unnamed = 0;
    if (is_news) urgent_ = true;
  }
  void begin_generation(Known& known) {
    Token& token = known.token;
    token.generation = static_cast<std::uint8_t>(known.is_known ? token.generation + 1 : 1);
    token.hop = 0;
    token.creator = token.holder = static_cast<std::uint8_t>(situation_.own);
    token.kept = token.done = false;
    known.is_known = true;
    known.on_its_way = false;
    known.perceived = known.work != none;
    known.teller = situation_.own;
    known.changed_at = now_;
    known.answered_for = now_;
    known.sent = known.told_in_vain = known.unnamed = 0;
    urgent_ = true;
  }
  void pass(Known& known, int number, bool is_news = true) {
    known.token.visited |= only(situation_.own);
    known.token.holder = static_cast<std::uint8_t>(number);
    known.token.kept = false;
    known.on_its_way = true;
    changed(known, is_news);
    int& busy = busy_[index(number)];
    if (known.work != none && (busy == none || known.work < busy)) busy = known.work;
  }

  // --- The steps of a decision

  void leave() {
    for (Known& each : known_) {
      if (is_mine(each)) each.token.holder = 0;
      if (each.teller == situation_.own) each.teller = 0;
    }
    told_.clear();
    std::ranges::fill(busy_, none);
    urgent_ = false;
    away_ = true;
  }

  // Who returns hears first what the others do.
  void note_members() {
    const bool grown = started_ && (situation_.members & ~members_) != 0;
    if (grown || away_) hold_until_ = now_ + settings_.stagger;
    members_ = situation_.members;
    started_ = true;
    away_ = false;
  }

  void note_who_is_busy() {
    std::ranges::fill(busy_, none);
    for (int w = 0; w < works(); ++w) {
      const Known& known = of(w);
      if (!lives(known) || !(known.token.kept || known.on_its_way)) continue;
      int& task = is_mine(known) ? kept_ : busy_[index(known.token.holder)];
      if (task == none) task = w;
    }
  }

  void let_go_of_what_is_gone() {
    for (Known& each : known_) {
      if (!is_mine(each) || each.work != none) continue;
      if (each.perceived) {
        if (now_ - each.last_perceived < settings_.gone_after) continue;
      } else if (now_ - each.changed_at < settings_.stagger) {
        continue;  // it may perceive the task in a moment
      } else if (const int next = anybody_unvisited(each); next != 0) {
        pass(each, next, false);
        continue;
      }
      each.token.kept = false;
      each.token.done = true;
      changed(each);
    }
  }
  // For a task that this robot knows nothing of.
  int anybody_unvisited(const Known& known) const {
    int found = 0;
    for (int number = 1; number <= team_size_; ++number) {
      if (!plays(number) || number == situation_.own || (known.token.visited & only(number)) != 0) continue;
      if (busy_[index(number)] == none) return number;
      if (found == 0) found = number;
    }
    return found;
  }

  void take_back() {
    for (Known& each : known_) {
      if (!is_mine_to_deliver(each)) continue;
      const int asked = each.token.holder;
      const bool waits =
          each.sent < settings_.repeats || (each.told_in_vain < 2 && now_ - each.sent_enough < settings_.patience);
      if (plays(asked) && waits) continue;
      if (plays(asked) && !somebody_else_could(each)) continue;
      if (each.work != none && busy_[index(asked)] == each.work) busy_[index(asked)] = none;
      begin_generation(each);
      each.token.visited |= only(asked);
    }
  }

  // Besides the robot that does not answer. Who is in no list of work cannot judge.
  bool somebody_else_could(const Known& known) const {
    if (known.work == none) return true;
    for (int number = 1; number <= team_size_; ++number) {
      if (!plays(number) || number == known.token.holder || (known.refused & only(number)) != 0) continue;
      if (would_take(number, known.work, settings_.rounds())) return true;
    }
    return false;
  }

  void make_missing() {
    for (int w = 0; w < works(); ++w) {
      Known& known = of(w);
      if (lives(known)) {
        known.missing_since = never;
        continue;
      }
      if (known.missing_since == never) known.missing_since = now_;
      const bool lost = known.is_known && !known.token.done;
      const Robots silent = lost && known.token.holder > 0 ? only(known.token.holder) : 0;
      const Robots lower = situation_.members & (only(situation_.own) - 1) & ~silent;
      const double waits = settings_.stagger * std::popcount(lower);
      if (now_ - known.missing_since < waits || (lost && (now_ - hold_until_ < waits || !somebody_could(w)))) continue;
      begin_generation(known);
      known.token.round = 0;
      known.token.visited = 0;
      if (lost) known.refused = 0;
    }
  }
  bool somebody_could(int w) const {
    for (int number = 1; number <= team_size_; ++number) {
      if (plays(number) && would_take(number, w, settings_.rounds())) return true;
    }
    return false;
  }

  void reconsider_own_task() {
    if (kept_ == none) return;
    Known& known = of(kept_);
    const int now = capability(situation_.own, kept_);
    if (now < 0 || now < settings_.threshold_of(known.token.round) - settings_.give_up) {
      known.token.kept = false;
      known.token.visited = only(situation_.own);
      changed(known);
      kept_ = none;
    } else if (const int round = settings_.round_of(now); round < known.token.round) {
      known.token.round = static_cast<std::uint8_t>(round);
      changed(known);
    }
  }

  // Whether a robot is able enough and free, as this one believes.
  bool would_take(int number, int w, int round) const {
    const int able = capability(number, w);
    if (able < 0 || able < settings_.threshold_of(round)) return false;
    const int does = work_of(number);
    if (does == none || does == w) return true;
    if (settings_.takeover == Takeover::never) return false;
    if (settings_.takeover == Takeover::last && round < settings_.rounds()) return false;
    return work(w).importance < work(does).importance;
  }

  // The token of this work is in the hands of this robot, which does not do it.
  void settle(int w) {
    Known& known = of(w);
    const Token before = known.token;
    if (now_ - known.refused_at > settings_.rest) known.refused = 0;
    known.token.kept = false;
    note_refusals(known, w);
    for (int round = known.token.round;; ++round) {
      known.token.round = static_cast<std::uint8_t>(round);
      if (would_take(situation_.own, w, round)) return keep(w);
      if (const int next = best_unvisited(known, w); next != 0) return pass(known, next);
      if (round == settings_.rounds()) break;
      known.token.visited = 0;
    }
    if (known.token.visited != 0 && !settings_.foresight) refuse(known, known.token.visited);
    known.token.visited = 0;
    if (known.token != before) changed(known);
  }
  void note_refusals(Known& known, int w) {
    if (!settings_.foresight || known.teller == situation_.own) return;
    Robots refused = 0;
    for (int number = 1; number <= team_size_; ++number) {
      if (number == situation_.own || (known.token.visited & only(number)) == 0) continue;
      if (would_take(number, w, known.token.round)) refused |= only(number);
    }
    if (refused != 0) refuse(known, refused);
  }
  void refuse(Known& known, Robots robots) {
    known.refused |= robots;
    known.refused_at = now_;
  }
  int best_unvisited(const Known& known, int w) const {
    int best = 0, best_capability = -1;
    for (int number = 1; number <= team_size_; ++number) {
      if (!plays(number) || number == situation_.own) continue;
      if (((known.token.visited | known.refused) & only(number)) != 0) continue;
      if (capability(number, w) <= best_capability) continue;
      if (settings_.foresight && !would_take(number, w, known.token.round)) continue;
      best = number;
      best_capability = capability(number, w);
    }
    return best;
  }
  void keep(int w) {
    if (kept_ != none && kept_ != w) {  // it comes later in the order of importance, and is settled then
      Known& other = of(kept_);
      other.token.kept = false;
      other.token.visited = only(situation_.own);
      changed(other);
    }
    kept_ = w;
    Known& known = of(w);
    known.token.kept = true;
    known.token.visited = 0;
    known.token.round =
        std::min(known.token.round, static_cast<std::uint8_t>(settings_.round_of(capability(situation_.own, w))));
    changed(known);
  }

  void collect() {
    told_.clear();
    const auto add = [&](Known& each) { told_.push_back({static_cast<int>(&each - known_.data()), each.token}); };
    if (kept_ != none) add(of(kept_));
    for (Known& each : known_) {
      if (is_mine_to_deliver(each)) add(each);
    }
    for (Known& each : known_) {
      if (is_mine(each) && (each.work == none || each.work != kept_)) add(each);
    }
    for (Known& each : known_) {
      const bool said = each.teller == situation_.own && each.token.holder == situation_.own && each.token.done;
      if (each.is_known && said && each.sent < settings_.repeats) add(each);
    }
  }

  int team_size_ = 0;
  std::vector<Known> known_;      // by id
  std::vector<int> busy_;         // by number - 1: work of a teammate; that of this robot is kept_
  std::vector<double> heard_of_;  // by number - 1: when its newest packet with tokens was sent
  std::vector<double> spoke_;     // the same of packets without any, where the host tells of them
  std::vector<Told> told_;
  Settings settings_;
  Situation situation_;
  Robots members_ = 0;
  bool started_ = false, away_ = false, urgent_ = false;
  double now_ = never, hold_until_ = never;
  int kept_ = none;
};

}  // namespace token_passing
