// SPDX-License-Identifier: MIT
#include "match/game_state.hpp"

#include <algorithm>

namespace regista::match {
namespace {

constexpr std::array<const char*, 4> endings{"no", "full_time", "mercy", "limit"};
constexpr std::array events{"half begins",
                            "ready",
                            "set",
                            "kick-off",
                            "goal",
                            "goal not counted",
                            "kick-in",
                            "goal kick",
                            "corner kick",
                            "pushing free kick",
                            "penalty kick",
                            "whistle",
                            "ball free",
                            "game stuck",
                            "penalty",
                            "returned",
                            "put back",
                            "too many packets",
                            "packet too long",
                            "half ends",
                            "finished",
                            "opening"};
static_assert(events.size() == static_cast<std::size_t>(EventKind::opening) + 1);
constexpr std::array<const char*, offence_count> offences{
    "none",    "illegal position", "illegal position in set", "motion in set",
    "fallen",  "inactive",         "local game stuck",        "ball holding",
    "pushing", "leaving the field"};
constexpr std::array<std::string_view, 5> phases{"initial", "ready", "set", "playing", "finished"};
constexpr std::array<std::string_view, 7> set_plays{"none",        "kick_off",          "kick_in",     "goal_kick",
                                                    "corner_kick", "pushing_free_kick", "penalty_kick"};
constexpr std::array<std::string_view, 4> play_kinds{"shot", "pass", "clearance", "duel"};
constexpr std::array<std::string_view, 9> play_outcomes{"none",        "goal", "saved", "missed",   "arrived",
                                                        "intercepted", "lost", "won",   "undecided"};

std::string one_word(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == ' ' || c == '-'; }, '_');
  return text;
}

}  // namespace

const char* name(Ended ended) { return endings[static_cast<std::size_t>(ended)]; }
const char* name(EventKind kind) { return events[static_cast<std::size_t>(kind)]; }
const char* name(Offence offence) { return offences[static_cast<std::size_t>(offence)]; }
std::string_view name(mind::Phase phase) { return phases.at(static_cast<std::size_t>(phase)); }
std::string_view name(mind::SetPlay set_play) { return set_plays.at(static_cast<std::size_t>(set_play)); }
std::string_view name(PlayKind kind) { return play_kinds.at(static_cast<std::size_t>(kind)); }
std::string_view name(PlayOutcome outcome) { return play_outcomes.at(static_cast<std::size_t>(outcome)); }

std::string word(EventKind kind) { return one_word(name(kind)); }
std::string word(Offence offence) { return one_word(name(offence)); }

using mind::Phase;
using mind::SetPlay;

GameControllerFeed::GameControllerFeed(const config::Rules& rules)
    : durations_(rules.durations), roster_{rules.team_size} {
  robots_.resize(static_cast<std::size_t>(roster_.count()));
}

void GameControllerFeed::announce(const GameState& state, double time, double delay, bool follows) {
  ++last_;
  announcements_[static_cast<std::size_t>(last_ % kept)] = {state, time, time + delay, follows};
}

// Of all announcements that have arrived, the robot adopts the one sent last. An older one may still be on its way.
void GameControllerFeed::catch_up(Robot& robot, double time) const {
  if (robot.known == last_) return;
  const std::uint64_t oldest = last_ >= kept ? last_ - kept + 1 : 1;
  for (std::uint64_t i = std::max(robot.known + 1, oldest); i <= last_; ++i) {
    if (at(i).follows ? robot.known + 1 == i : at(i).arrives <= time) robot = {.known = i};
  }
}

void GameControllerFeed::whistle(int id, double time) {
  Robot& robot = robots_[static_cast<std::size_t>(id)];
  catch_up(robot, time);
  const Phase phase = at(robot.known).state.phase;
  if (phase == Phase::set) {
    for (std::uint64_t i = robot.known + 1; i <= last_; ++i) {
      if (at(i).state.phase != Phase::playing) continue;
      robot = {.known = i};
      return;
    }
  } else if (phase == Phase::playing && !robot.ready_by_whistle) {
    robot.ready_by_whistle = true;
    robot.ready_since = time;
  }
}

void GameControllerFeed::tell(int id, const GameState& state, double time, mind::GameTold& out) {
  Robot& robot = robots_[static_cast<std::size_t>(id)];
  catch_up(robot, time);
  const Announcement& announcement = at(robot.known);
  const GameState& news = announcement.state;
  const Side side = roster_.side(id);
  out.phase = robot.ready_by_whistle ? Phase::ready : news.phase;
  out.set_play = robot.ready_by_whistle ? SetPlay::kick_off : news.set_play;
  out.own_kick = news.kicking == side;
  out.half = news.half;
  out.own_score = news.score(side);
  out.opponent_score = news.score(opposite(side));
  out.phase_time = time - (robot.ready_by_whistle ? robot.ready_since : news.phase_began);
  // The clock is computed from the known announcement, so that it reveals no kick-off that the robot has not noticed.
  const double clock = news.clock + (news.clock_runs ? time - announcement.sent : 0.0);
  out.half_time_left = durations_.half - clock;
  out.match_time_left = out.half_time_left + (durations_.halves - news.half) * durations_.half;
  out.packets_left = state.packets_left[index(side)];
  out.own_penalised = state.penalised[index(side)];
  out.opponent_penalised = state.penalised[index(opposite(side))];
}

}  // namespace regista::match
