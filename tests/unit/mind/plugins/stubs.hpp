// SPDX-License-Identifier: MIT
// The simplest plugins that keep every promise of abi.h: minds need plugins, and these have nothing of their own that
// could hide what a mind does. None of them allocates.
#pragma once

#include <regista/assigner.hpp>
#include <regista/behaviour.hpp>
#include <regista/budget.hpp>
#include <regista/context.hpp>
#include <regista/log.hpp>
#include <regista/positioner.hpp>
#include <regista/predictor.hpp>
#include <regista/roles.hpp>
#include <regista/sender.hpp>
#include <regista/told.hpp>
#include <regista/utility.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>

namespace stubs {

// Believes what it was told last. Its own pose is counted in steps; balls and teammates go on at their velocities.
struct Still {
  static constexpr auto id = "still", version = "1.0.0", summary = "Believes what it was told last";
  static constexpr unsigned subjects =
      REGISTA_SUBJECT_SELF | REGISTA_SUBJECT_BALL | REGISTA_SUBJECT_OPPONENTS | REGISTA_SUBJECT_TEAMMATES;

  void setup(const regista::Environment& environment) {
    subject_ = environment->subject;
    own_number_ = environment->own_number;
  }

  void reset(std::uint64_t) {
    count_ = 0;
    if (subject_ == REGISTA_SUBJECT_SELF) add(own_number_, 0.0, 0.0);
  }

  void predict(double dt, const regista::Motion* motion, const regista::Frame*) {
    if (subject_ == REGISTA_SUBJECT_SELF) {
      regista::Track& self = tracks_[0];
      const double c = std::cos(self.pose.heading), s = std::sin(self.pose.heading);
      self.x += c * motion->x - s * motion->y;
      self.y += s * motion->x + c * motion->y;
      self.pose.heading = std::remainder(self.pose.heading + motion->heading, 2.0 * std::numbers::pi);
      return;
    }
    for (std::size_t i = 0; i < count_; ++i) carry(tracks_[i], dt);
  }

  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea&) {
    if (subject_ != REGISTA_SUBJECT_SELF && !measurements.empty()) count_ = 0;
    for (const regista::Measurement& seen : measurements) {
      if (seen.kind == REGISTA_MEASURED_LANDMARK) continue;
      if (subject_ == REGISTA_SUBJECT_SELF || (subject_ == REGISTA_SUBJECT_BALL && count_ > 0)) count_ = 0;
      const int label = subject_ == REGISTA_SUBJECT_SELF ? own_number_ : static_cast<int>(count_) + 1;
      regista::Track& track = add(label, seen.position[0], seen.position[1]);
      if (subject_ == REGISTA_SUBJECT_SELF) {
        track.pose.heading = seen.heading;
        track.pose.heading_variance = seen.covariance[5];
      }
      for (int i = 0; i < 3; ++i) track.covariance[i] = seen.covariance[i];
    }
  }

  void absorb(regista::Span<regista::Track> told, double age) {
    if (subject_ != REGISTA_SUBJECT_TEAMMATES) count_ = 0;
    for (const regista::Track& each : told) {
      std::size_t at = 0;
      while (at < count_ && tracks_[at].label < each.label) ++at;
      if (at == count_ || tracks_[at].label != each.label) {
        for (std::size_t i = count_++; i > at; --i) tracks_[i] = tracks_[i - 1];
      }
      tracks_[at] = each;
      carry(tracks_[at], age);
    }
  }

  void tracks(regista::Tracks out) const {
    for (std::size_t i = 0; i < count_; ++i) out.add(tracks_[i]);
  }
  std::size_t size() const { return count_; }
  const regista::Track& operator[](std::size_t i) const { return tracks_[i]; }

 private:
  regista::Track& add(int label, double x, double y) {
    regista::Track& track = tracks_[count_++];
    track = {};
    track.label = label;
    track.x = x;
    track.y = y;
    track.weight = 1.0;
    track.covariance[0] = track.covariance[2] = 0.01;
    if (subject_ == REGISTA_SUBJECT_SELF) {
      track.pose.velocity_variance = 0.01;
    } else {
      track.motion[4] = track.motion[6] = 0.01;
    }
    return track;
  }
  static void carry(regista::Track& track, double dt) {
    track.x += track.vx * dt;
    track.y += track.vy * dt;
    track.age += dt;
  }

  unsigned subject_ = 0;
  int own_number_ = 0;
  std::size_t count_ = 0;
  std::array<regista::Track, 32> tracks_{};
};

// A Still whose luck shows: every track is off by a length that hangs on the seed alone.
struct Lucky : Still {
  static constexpr auto id = "lucky", summary = "Off by its luck";
  void reset(std::uint64_t seed) {
    Still::reset(seed);
    off_ = 1e-6 * static_cast<double>(seed % 1000000);
  }
  void tracks(regista::Tracks out) const {
    for (std::size_t i = 0; i < size(); ++i) {
      regista::Track track = (*this)[i];
      track.x += off_;
      out.add(track);
    }
  }

 private:
  double off_ = 0.0;
};

// Holds in [from, to).
struct Window {
  static constexpr auto id = "window", version = "1.0.0", summary = "Holds for a while";
  double from = 0.0, to = 1e6;
  static constexpr std::tuple parameters{regista::real("from", &Window::from, {0.0, 1e6}, "s", "First time"),
                                         regista::real("to", &Window::to, {0.0, 1e6}, "s", "First time after")};
  bool holds(const regista::Frame& frame) { return frame.time() >= from && frame.time() < to; }
};

// Holds in a set play of this number, in phases up to this one, of this side.
struct InSetPlay {
  static constexpr auto id = "in_set_play", version = "1.0.0", summary = "Holds in set plays";
  int set_play = 0, last_phase = REGISTA_PHASE_PLAYING, own_kick = -1;
  static constexpr std::tuple parameters{
      regista::integer("set_play", &InSetPlay::set_play, {0, 6}, "1", "0: any"),
      regista::integer("last_phase", &InSetPlay::last_phase, {1, 3}, "1", "As in the ABI"),
      regista::integer("own_kick", &InSetPlay::own_kick, {-1, 1}, "1", "As in the ABI; -1: any")};
  bool holds(const regista::Frame& frame) {
    const regista::Game& game = frame.world().game();
    return game.set_play != REGISTA_SET_PLAY_NONE && (set_play == 0 || game.set_play == set_play) &&
           game.phase <= last_phase && (own_kick < 0 || game.own_kick == own_kick);
  }
};

// A triangle of waypoints, joined.
struct Triangle {
  static constexpr auto id = "triangle", version = "1.0.0", summary = "Three points";
  void place(const regista::Frame&, regista::Placement out) {
    const auto a = out.point(1.0, 0.0), b = out.point(-1.0, 1.0), c = out.point(-1.0, -1.0);
    out.edge(a, b);
    out.edge(b, c);
    out.edge(c, a);
  }
};

struct Nearness {
  static constexpr auto id = "nearness", version = "1.0.0", summary = "Falls with the distance";
  void score(const regista::Frame& frame, regista::Utilities out) {
    const auto active = frame.world().active();
    for (std::size_t i = 0; i < out.rows(); ++i) {
      const regista::Robot& robot = frame.world().robot(active[i]);
      for (std::size_t j = 0; j < out.columns(); ++j) {
        const double x = frame.tasks()[j].after[0] - robot.pose[0], y = frame.tasks()[j].after[1] - robot.pose[1];
        out(i, j) = 1.0 / (1.0 + std::sqrt(x * x + y * y));
      }
    }
  }
};

// Of tasks alone, as Flat, but nothing without waypoints.
struct NearPoints {
  static constexpr auto id = "near_points", version = "1.0.0",
                        summary = "Falls with the distance from the first waypoint";
  void score(const regista::Frame& frame, regista::Utilities out) {
    if (frame.waypoints().empty()) return;
    const regista::Waypoint& point = frame.waypoints()[0];
    for (std::size_t i = 0; i < out.rows(); ++i) {
      for (std::size_t j = 0; j < out.columns(); ++j) {
        out(i, j) = 1.0 / (1.0 + std::abs(frame.tasks()[j].after[0] - point.x));
      }
    }
  }
};

// Holds once somebody has said so.
struct Rumour {
  static constexpr auto id = "rumour", version = "1.0.0", summary = "Holds once it has heard anything";
  void setup(const regista::Environment&, regista::Mailbox) {}
  void reset(std::uint64_t) { heard_ = false; }
  bool holds(const regista::Frame&) { return heard_; }
  void receive(const regista::Message&) { heard_ = true; }

 private:
  bool heard_ = false;
};

// Tasks in their order, each to its best robot that is still free.
struct InOrder {
  static constexpr auto id = "in_order", version = "1.0.0", summary = "Best free robot per task";
  void assign(const regista::Frame&, regista::UtilityMatrix utilities, regista::Assignment out) {
    for (std::size_t j = 0; j < utilities.columns(); ++j) {
      std::size_t best = utilities.rows();
      for (std::size_t i = 0; i < utilities.rows(); ++i) {
        if (out[i] != regista::Assignment::no_task || !(utilities(i, j) >= 0.0)) continue;
        if (best == utilities.rows() || utilities(i, j) > utilities(best, j)) best = i;
      }
      if (best < utilities.rows()) out[best] = static_cast<std::int32_t>(j);
    }
  }
};

// The same number for all robots.
struct Flat {
  static constexpr auto id = "flat", version = "1.0.0", summary = "Says something of tasks alone";
  void score(const regista::Frame& frame, regista::Utilities out) {
    for (std::size_t i = 0; i < out.rows(); ++i) {
      for (std::size_t j = 0; j < out.columns(); ++j) out(i, j) = std::abs(frame.tasks()[j].after[1]);
    }
  }
};

// Begins with the largest number of all, and goes on with those that are left.
struct LargestFirst {
  static constexpr auto id = "largest_first", version = "1.0.0", summary = "Largest number first";
  void assign(const regista::Frame&, regista::UtilityMatrix utilities, regista::Assignment out) {
    std::array<bool, 256> taken{};
    for (std::size_t k = 0; k < utilities.columns(); ++k) {
      double most = -1.0;
      std::size_t row = 0, column = 0;
      for (std::size_t i = 0; i < utilities.rows(); ++i) {
        for (std::size_t j = 0; j < utilities.columns(); ++j) {
          if (taken[j] || out[i] != regista::Assignment::no_task || !(utilities(i, j) > most)) continue;
          most = utilities(i, j);
          row = i;
          column = j;
        }
      }
      if (most < 0.0) return;
      out[row] = static_cast<std::int32_t>(column);
      taken[column] = true;
    }
  }
};

// Every so often, with all offers.
struct Steady {
  static constexpr auto id = "steady", version = "1.0.0", summary = "Sends every so often";
  double period = 1.0;
  static constexpr std::tuple parameters{
      regista::real("period", &Steady::period, {0.0, 1e6}, "s", "Time between two packets")};
  void reset(std::uint64_t) { last_ = -1e9; }
  std::optional<int> decide(const regista::Frame& frame, const regista::SendQuery& query, regista::Grants out) {
    if (frame.time() - last_ < period - 1e-9) return std::nullopt;
    last_ = frame.time();
    for (const regista::Offer& offer : query.offers) out.grant(offer);
    return REGISTA_EVENT_PERIOD;
  }

 private:
  double last_ = -1e9;
};

// Sends while the team has spent no more than its share, and time for it is left.
struct Even {
  static constexpr auto id = "even", version = "1.0.0", summary = "Sends while no more than an even share is spent";
  std::uint32_t budget = 0;
  void setup(const regista::Environment& environment) { budget = environment->packet_budget; }
  void reset(std::uint64_t) {}
  std::optional<int> decide(const regista::Frame&, const regista::SendQuery& query, regista::Grants) {
    const regista::Budget& now = query.budget;
    if (now.packets_left > static_cast<int>(budget) || now.match_time_left <= 0.0) return std::nullopt;
    return now.packets_left >= now.line ? std::optional(REGISTA_EVENT_PERIOD) : std::nullopt;
  }
};

// Walks to its task's place, looks half to the left, and tells of another target where it is asked to.
struct Walks {
  static constexpr auto id = "walks", version = "1.0.0", summary = "Walks to its task";
  double tells_x = 0.0;
  bool tells = false;
  static constexpr std::tuple parameters{
      regista::real("tells_x", &Walks::tells_x, {-10.0, 10.0}, "m", "x of the target that it tells of"),
      regista::boolean("tells", &Walks::tells, "Tells of a target")};
  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    out.gaze = 0.5;
    if (tells) {
      out.flags = REGISTA_ACTION_TARGET;
      out.target[0] = tells_x;
    }
    const regista::Task* task = body.task(frame);
    if (task == nullptr || frame.mine().game().phase != REGISTA_PHASE_PLAYING) return;
    out.motion = REGISTA_MOTION_WALK_TO;
    for (int i = 0; i < 3; ++i) out.pose[i] = task->after[i];
  }
};

// Does nothing; that it searches is all there is to it.
struct Seeks {
  static constexpr auto id = "seeks", version = "1.0.0", summary = "Searches, they say";
  static constexpr unsigned purposes = REGISTA_BEHAVIOUR_SEARCHES;
  void act(const regista::Frame&, const regista::Body&, regista::Action&) {}
};

// Offers its number whenever its last offer is gone; scores everything by the sum of what it received.
struct Gossip {
  static constexpr auto id = "gossip", version = "1.0.0", summary = "Tells its number, scores by what it heard";
  int length = 1;
  static constexpr std::tuple parameters{
      regista::integer("length", &Gossip::length, {1, 1000}, "bytes", "How often it tells it at once")};
  void setup(const regista::Environment& environment, regista::Mailbox mailbox) {
    own_number_ = environment->own_number;
    mailbox_ = mailbox;
  }
  void reset(std::uint64_t) { sum_ = 0.0, handle_ = 0; }
  void score(const regista::Frame& frame, regista::Utilities out) {
    std::array<std::uint8_t, 1000> bytes;
    bytes.fill(static_cast<std::uint8_t>(own_number_));
    if (handle_ == 0)
      handle_ = mailbox_.offer(std::span(bytes).first(static_cast<std::size_t>(length)), 0.5, frame.time() + 0.35);
    for (std::size_t i = 0; i < out.rows(); ++i) {
      for (std::size_t j = 0; j < out.columns(); ++j) out(i, j) = sum_;
    }
  }
  void receive(const regista::Message& message) {
    for (const std::uint8_t byte : message.bytes()) sum_ += byte == message.sender() ? byte : 1000;
  }
  void transmitted(std::uint64_t handle) { gone(handle); }
  void dropped(std::uint64_t handle) { gone(handle); }

 private:
  void gone(std::uint64_t handle) {
    if (handle == handle_) handle_ = 0;
  }
  regista::Mailbox mailbox_;
  int own_number_ = 0;
  std::uint64_t handle_ = 0;
  double sum_ = 0.0;
};

// Logs what robot 3 said last, and what is left.
struct Asker {
  static constexpr auto id = "asker", version = "1.0.0", summary = "Logs what was told";
  void setup(const regista::Environment&, const regista::Host& host) {
    told_ = regista::Told(host);
    budget_ = regista::BudgetNow(host);
    log_ = regista::Log(host);
    if (told_.packet(3)) log_.error("told before anybody has spoken");
    const regista::Roles roles(host);
    const auto first = roles.role(0), second = roles.role(1);
    log_.info("roles: " + std::to_string(first->group) + ' ' + std::to_string(first->moves) + ' ' + first->behaviour +
              ", " + std::to_string(second->group) + ' ' + std::to_string(second->moves) +
              (roles.role(99) ? ", and 99" : ""));
  }
  void score(const regista::Frame&, regista::Utilities) {
    const auto packet = told_.packet(3);
    const auto budget = budget_.read();
    log_.info(
        (packet ? "3 at " + std::to_string(packet->pose[0]) + " sent " + std::to_string(packet->time_sent) : "none") +
        (*told_.sees_ball() ? ", sees" : ", blind") + ", left " + std::to_string(budget->packets_left));
  }

 private:
  regista::Told told_;
  regista::BudgetNow budget_;
  regista::Log log_;
};

}  // namespace stubs
