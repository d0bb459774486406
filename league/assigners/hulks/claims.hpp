// SPDX-License-Identifier: MIT
// Who is the striker, as the HULKs decide it (their released code of 2024, role assignment): whoever plays the ball
// says so with the time that it needs to the ball. Who hears that and needs less becomes the striker and says so;
// everybody else takes it that the sender is the striker. A striker that has lost the ball says that, too, and is a
// "loser" until it sees the ball again. Who has heard no striker for the time-out, or a loser, becomes the striker when
// it sees the ball. A word that is lost leaves two strikers until the next one is heard, as published.
//
// Decided here, where that code says nothing or is for another machine:
// - Equal times: the lower number is the striker. There both would give way.
// - Of several words of one decision the best claim counts, not the last one; a claim that was sent before the one that
//   is followed does not count.
// - While nobody's claim stands, the highest number that can is the striker, as it is there in Ready and Set. A claim
//   falls when its robot no longer plays or has said nothing for `lapse`; there only the time-out is known, after which
//   a robot does not know who is the striker.
// - After the whistle robots wait for the first word for the time-out; there whoever sees the ball claims at once.
// - The loser keeps the place at the ball until somebody claims; that others search meanwhile is the team's context.
// - A keeper that has lost the ball is a loser like others; there it returns to its goal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace hulks {

inline constexpr int nobody = 0, no_task = -1;
inline constexpr unsigned time_bits = 21;
inline constexpr std::uint32_t never = (std::uint32_t{1} << time_bits) - 1;  // ms; the longest time that can be told

// What a robot says: that it is the striker, or that it is no more, for it has lost the ball.
struct Word {
  bool claims = false;
  std::uint32_t time = 0;  // ms to the ball; of a claim
  int task = no_task;      // id of the claimed task
};

// s. The published values, but for those that are ours.
struct Settings {
  double memory = 3.0;    // since the own eyes saw the ball until a robot does not see it any more; ours
  double trust = 1.0;     // age up to which the striker trusts in the ball of a teammate
  double time_out = 3.0;  // without a claim until a robot does not know who the striker is
  double lapse = 25.0;    // without a claim until the highest number is the striker; ours
};

struct Now {
  double time = 0.0;            // s
  int number = 1;               // of this robot
  bool playing = true;          // the phase; in others no claim stands and none is made
  bool takes_part = true;       // false: penalised; it listens and is nothing
  std::uint32_t reach = never;  // ms that this robot needs to the ball; never: it cannot be the striker
  bool sees_ball = false;       // has seen it itself, within `memory`
  bool trusts_ball = false;     // sees it, or a teammate has within `trust`
  int first = nobody;           // who is the striker while no claim stands; may be this robot
};

enum class Part { follower, striker, loser };

class Claims {
 public:
  static constexpr std::uint32_t viable = 1'200'000;  // ms; slower robots do not claim

  void reserve(int team_size) { heard_.resize(static_cast<std::size_t>(team_size)); }
  // The beginning of a match.
  void forget() {
    for (Heard& each : heard_) each = {};
    rest();
    last_claim_ = unset;
  }

  // A teammate's word. Those of robots that do not exist, that were overtaken or come twice count for nothing.
  void hear(int sender, const Word& word, double time_sent, double time_heard) {
    if (sender < 1 || static_cast<std::size_t>(sender) > heard_.size()) return;
    Heard& heard = heard_[static_cast<std::size_t>(sender - 1)];
    if (time_sent <= heard.sent) return;
    heard = {word, time_sent, time_heard, true};
  }

  // Once at each decision. plays(number): whether this robot takes part, as far as is known.
  template <class Plays>
  void decide(const Settings& settings, const Now& now, const Plays& plays) {
    if (!now.playing) {
      for (Heard& each : heard_) each.is_new = false;
      rest();
      last_claim_ = now.time;
      return;
    }
    if (last_claim_ == unset) last_claim_ = now.time;
    if (!now.takes_part && part_ != Part::follower) rest();
    listen(now, plays);
    if (part_ == Part::follower) {
      follow(settings, now, plays);
    } else if (part_ == Part::striker) {
      if (!now.trusts_ball || now.reach == never) lose();
    } else if (now.reach == never) {
      if (!news_) rest();
    } else if (now.sees_ball) {
      claim();
    }
  }

  Part part() const { return part_; }
  // Whose claim stands: this robot's (`own`), a teammate's, or nobody's.
  int striker(int own) const { return part_ == Part::follower ? followed_ : own; }
  // Which task the teammate has claimed whose claim stands.
  int claimed_task() const { return followed_task_; }
  // Something has to be said at once: what, the part tells.
  bool has_news() const { return news_; }
  void has_told() { news_ = false; }

 private:
  struct Heard {
    Word word;
    double sent = -std::numeric_limits<double>::infinity(), heard = 0.0;
    bool is_new = false;
  };
  static constexpr double unset = -std::numeric_limits<double>::infinity();

  static bool beats(std::uint32_t time, int number, std::uint32_t other_time, int other) {
    return time != other_time ? time < other_time : number < other;
  }

  template <class Plays>
  void listen(const Now& now, const Plays& plays) {
    int best = nobody;
    for (std::size_t i = 0; i < heard_.size(); ++i) {
      Heard& heard = heard_[i];
      const int sender = static_cast<int>(i) + 1;
      if (!heard.is_new) continue;
      heard.is_new = false;
      if (sender == now.number || !plays(sender)) continue;
      if (!heard.word.claims) {
        seeks_ = true;
        continue;
      }
      const bool is_past = part_ == Part::follower && followed_ != nobody && followed_ != sender &&
                           heard.sent < heard_[static_cast<std::size_t>(followed_ - 1)].sent;
      if (is_past) continue;
      if (best == nobody || beats(heard.word.time, sender, time_of(best), best)) best = sender;
    }
    if (best == nobody) return;
    last_claim_ = now.time;
    seeks_ = false;
    if (now.reach < viable && beats(now.reach, now.number, time_of(best), best)) {
      if (part_ != Part::striker) claim();
      return;
    }
    rest();
    followed_ = best;
    followed_task_ = heard_[static_cast<std::size_t>(best - 1)].word.task;
  }

  template <class Plays>
  void follow(const Settings& settings, const Now& now, const Plays& plays) {
    if (now.time - last_claim_ > settings.time_out) seeks_ = true;
    if (followed_ != nobody &&
        (!plays(followed_) || now.time - heard_[static_cast<std::size_t>(followed_ - 1)].heard > settings.lapse)) {
      followed_ = nobody;
      followed_task_ = no_task;
    }
    if (now.reach >= viable) return;
    if (seeks_ && now.sees_ball) return claim();
    if (followed_ != nobody || now.first != now.number) return;
    if (now.trusts_ball) return claim();
    rest();
    part_ = Part::loser;  // it was no striker, so there is nothing to say
  }

  void claim() {
    rest();
    part_ = Part::striker;
    news_ = true;
  }
  void lose() {
    rest();
    part_ = Part::loser;
    news_ = true;
  }
  void rest() {
    part_ = Part::follower;
    followed_ = nobody;
    followed_task_ = no_task;
    seeks_ = news_ = false;
  }
  std::uint32_t time_of(int number) const { return heard_[static_cast<std::size_t>(number - 1)].word.time; }

  std::vector<Heard> heard_;  // by number - 1
  Part part_ = Part::follower;
  int followed_ = nobody, followed_task_ = no_task;
  double last_claim_ = unset;  // when this robot last heard one
  bool seeks_ = false;         // does not know who is the striker, or that one has lost the ball
  bool news_ = false;
};

}  // namespace hulks
