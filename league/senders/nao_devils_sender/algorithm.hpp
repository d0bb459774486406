// SPDX-License-Identifier: MIT
// When Nao Devils spend a packet (released code, 2024): on four kinds of news, each with a rate of its own, as far as
// the budget allows.
//
//   news     sent when                                                        at most
//   map      a new map of robots to tasks is to be broadcast                  1 in 3 s, the team
//   chaser   this robot chases the ball, and its last packet does not say so  3 in 4.5 s, the team; 1 in 5 s, itself
//            or the other way round
//   ball     it sees the ball 1 m off where the team has it                   1 in 1 s, the team
//   moved    it is 1.2 m off where it last said to be; 0.5 m if it chases     1 in 1 s, itself
//            the ball or is within 1.5 m of it; 0.2 m if it is slow
//
// The budget allows a packet while the packets left are at least min(1, 0.9 + t / 900 s) of those that even spending
// would leave, t since the start of the match, or when nobody of the team has sent for 1.1 s. At five packets left the
// team falls silent.
//
// Ours: that t counts from the start, which is not told; that even spending is the host's line, by which Ready and Set
// before a half take time as well, where the released code counts the seconds of play; the order of the news; "slow" is
// below `slow_speed`; who never sent has moved; and news of the ball also while the team has heard of no sighting for
// `ball_lacked`, for it would go and search a ball that lies in sight. And robots that wait for 1.1 s of silence send
// one after the other: else all that have news send at once, and a match's packets are spent in three quarters of it.
// Each waits a little longer than the one before, and who is first goes round.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace nao_devils {

enum class News { map, chaser, ball, moved };
inline constexpr std::size_t kinds_of_news = 4;

// At most `count` packets in any `window` s; 0 s: no limit.
struct Limit {
  int count = 1;
  double window = 0.0;
};

struct Settings {
  Limit map_team{1, 3.0}, chaser_team{3, 4.5}, chaser_own{1, 5.0}, ball_team{1, 1.0}, moved_own{1, 1.0};
  double moved_far = 1.2, moved_near = 0.5, moved_slow = 0.2;  // m
  double near_ball = 1.5;                                      // m
  double slow_speed = 0.1;                                     // m/s
  double ball_off = 1.0;                                       // m
  double ball_lacked = 3.0;                                    // s
  double share_at_first = 0.9, share_grows_in = 900.0;         // s from 0 to 1
  double team_silence = 1.1, turn = 0.2;                       // s; robot after robot waits for a turn longer
  int reserve = 5;                                             // packets
};

struct Situation {
  int number = 1, team_size = 1;         // of this robot
  double time = 0.0;                     // s since the start of the match
  bool has_new_map = false;              // that this robot is to broadcast
  bool is_chaser = false;                // now
  bool said_chaser = false;              // in its last packet
  std::optional<double> ball_off;        // m; it sees the ball, so far from where the team has it
  double ball_lacked = 0.0;              // s; it sees the ball, of which the team has heard of no sighting for so long
  double x = 0.0, y = 0.0, speed = 0.0;  // of the robot, m and m/s
  std::optional<double> ball_distance;   // m from the robot, if it knows the ball
  int packets_left = 0;
  int reserve = 0;          // in this game
  double line = 0.0;        // packets that would be left if they were spent evenly
  double since_team = 0.0;  // s since any packet of the team
};

// The last times of something, as many as a limit looks at. Told in any order.
class Times {
 public:
  static constexpr int most = 8;
  void add(double time) {
    const auto place = std::find_if(times_.begin(), times_.end(), [&](double each) { return each < time; });
    if (place == times_.end()) return;
    std::copy_backward(place, times_.end() - 1, times_.end());
    *place = time;
  }
  bool allow(const Limit& limit, double now) const {
    assert(limit.count >= 1 && limit.count <= most);
    return limit.window <= 0.0 || now - times_[static_cast<std::size_t>(limit.count - 1)] >= limit.window - rounding;
  }

 private:
  static constexpr double rounding = 1e-9;  // s
  static constexpr std::array<double, most> none() {
    std::array<double, most> out{};
    out.fill(-std::numeric_limits<double>::infinity());
    return out;
  }
  std::array<double, most> times_ = none();  // the latest first
};

// The share of even spending that has to be left.
inline double share_to_be_left(const Settings& settings, double time) {
  return std::min(1.0, settings.share_at_first + time / settings.share_grows_in);
}

// For how long the team must have been silent for this robot.
inline double silence_to_wait_for(const Settings& settings, const Situation& now) {
  constexpr double first_for = 10.0;  // s
  const int round = static_cast<int>(now.time / first_for);
  return settings.team_silence + settings.turn * ((now.number + round) % now.team_size);
}

inline bool budget_allows(const Settings& settings, const Situation& now) {
  if (now.packets_left <= now.reserve) return false;
  return now.packets_left >= share_to_be_left(settings, now.time) * now.line ||
         now.since_team >= silence_to_wait_for(settings, now) - 1e-9;
}

class Sender {
 public:
  // Whether to send now, and for what. Call once per decision; a packet leaves when there is an answer.
  std::optional<News> decide(const Settings& settings, const Situation& now) {
    if (!budget_allows(settings, now)) return std::nullopt;
    for (std::size_t kind = 0; kind < kinds_of_news; ++kind) {
      const auto news = static_cast<News>(kind);
      if (!is_due(settings, now, news) || !may_tell(settings, now.time, news)) continue;
      own_[kind].add(now.time);
      told(news, now.time);
      sent_ = true;
      sent_x_ = now.x;
      sent_y_ = now.y;
      return news;
    }
    return std::nullopt;
  }
  // This robot or a teammate has told such news at this time.
  void told(News news, double time) { team_[static_cast<std::size_t>(news)].add(time); }

 private:
  bool may_tell(const Settings& settings, double time, News news) const {
    const auto kind = static_cast<std::size_t>(news);
    switch (news) {
      case News::map:
        return team_[kind].allow(settings.map_team, time);
      case News::chaser:
        return team_[kind].allow(settings.chaser_team, time) && own_[kind].allow(settings.chaser_own, time);
      case News::ball:
        return team_[kind].allow(settings.ball_team, time);
      case News::moved:
        return own_[kind].allow(settings.moved_own, time);
    }
    return false;
  }
  bool is_due(const Settings& settings, const Situation& now, News news) const {
    switch (news) {
      case News::map:
        return now.has_new_map;
      case News::chaser:
        return now.is_chaser != now.said_chaser;
      case News::ball:
        return (now.ball_off && *now.ball_off >= settings.ball_off) || now.ball_lacked >= settings.ball_lacked;
      case News::moved:
        return !sent_ || std::hypot(now.x - sent_x_, now.y - sent_y_) >= far_enough(settings, now);
    }
    return false;
  }
  static double far_enough(const Settings& settings, const Situation& now) {
    if (now.speed < settings.slow_speed) return settings.moved_slow;
    const bool is_near = now.ball_distance && *now.ball_distance < settings.near_ball;
    return now.is_chaser || is_near ? settings.moved_near : settings.moved_far;
  }

  std::array<Times, kinds_of_news> own_, team_;
  bool sent_ = false;
  double sent_x_ = 0.0, sent_y_ = 0.0;
};

}  // namespace nao_devils
