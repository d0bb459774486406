// SPDX-License-Identifier: MIT
// A plugin of each of the seven kinds in C++.
#include <regista/assigner.hpp>
#include <regista/behaviour.hpp>
#include <regista/context.hpp>
#include <regista/positioner.hpp>
#include <regista/predictor.hpp>
#include <regista/sender.hpp>
#include <regista/utility.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

namespace {

constexpr auto release = "1.0.0", about = "One of seven kinds, in C++";
double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

// Everything is where it was last seen or said to be.
struct Predictor {
  static constexpr auto id = BUILT_AS "predictor", version = release, summary = about;
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr unsigned subjects =
      REGISTA_SUBJECT_SELF | REGISTA_SUBJECT_BALL | REGISTA_SUBJECT_OPPONENTS | REGISTA_SUBJECT_TEAMMATES;
  unsigned subject = 0;
  int number = 0;
  std::map<int, regista::Track> known;

  void setup(const regista::Environment& environment) {
    subject = environment->subject;
    number = environment->own_number;
  }
  void reset(std::uint64_t) {
    known.clear();
    if (subject == REGISTA_SUBJECT_SELF) see(number, 0.0, 0.0, 1.0);
  }
  void predict(double dt, const regista::Motion* motion, const regista::Frame*) {
    for (auto& [label, track] : known) {
      track.age += dt;
      track.covariance[0] += 0.05 * dt;
      track.covariance[2] += 0.05 * dt;
    }
    if (subject != REGISTA_SUBJECT_SELF || motion == nullptr) return;
    regista::Track& own = known.at(number);
    const double c = std::cos(own.pose.heading), s = std::sin(own.pose.heading);
    own.x += c * motion->x - s * motion->y;
    own.y += s * motion->x + c * motion->y;
    own.pose.heading = wrapped(own.pose.heading + motion->heading);
  }
  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea&) {
    for (const regista::Measurement& seen : measurements) {
      if (seen.kind == REGISTA_MEASURED_POSE) {
        see(number, seen.position[0], seen.position[1], 0.01).pose.heading = seen.heading;
      } else if (seen.kind == REGISTA_MEASURED_BALL) {
        see(1, seen.position[0], seen.position[1], 0.01);
      }
    }
  }
  void absorb(regista::Span<regista::Track> tracks, double age) {
    if (subject != REGISTA_SUBJECT_TEAMMATES) known.clear();
    for (const regista::Track& told : tracks) (known[told.label] = told).age += age;
  }
  void tracks(regista::Tracks out) const {
    for (const auto& [label, track] : known) out.add(track);
  }
  regista::Track& see(int label, double x, double y, double variance) {
    regista::Track& track = known[label];
    track = {};
    track.label = label;
    track.x = x;
    track.y = y;
    track.covariance[0] = track.covariance[2] = variance;
    track.weight = 1.0;
    return track;
  }
};

struct Context {
  static constexpr auto id = BUILT_AS "context", version = release, summary = about;
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  bool holds(const regista::Frame& frame) { return frame.world().game().half >= 1; }
};

struct Positioner {
  static constexpr auto id = BUILT_AS "positioner", version = release, summary = about;
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  void place(const regista::Frame&, regista::Placement out) {
    const auto a = out.point(-1.0, -1.0), b = out.point(0.0, 1.0), c = out.point(1.0, -1.0);
    out.edge(a, b);
    out.edge(b, c);
  }
};

struct Utility {
  static constexpr auto id = BUILT_AS "utility", version = release, summary = about;
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  void score(const regista::Frame& frame, regista::Utilities out) {
    for (std::size_t i = 0; i < out.rows(); ++i) {
      const regista::Robot& robot = frame.world().robot(frame.world().active()[i]);
      for (std::size_t j = 0; j < out.columns(); ++j) {
        const regista::Task& task = frame.tasks()[j];
        out(i, j) = 1.0 / (1.0 + std::hypot(task.after[0] - robot.pose[0], task.after[1] - robot.pose[1]));
      }
    }
  }
};

struct Assigner {
  static constexpr auto id = BUILT_AS "assigner", version = release, summary = about;
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  void assign(const regista::Frame&, regista::UtilityMatrix utilities, regista::Assignment out) {
    for (std::size_t j = 0; j < utilities.columns(); ++j) {
      std::optional<std::size_t> best;
      for (std::size_t i = 0; i < utilities.rows(); ++i) {
        if (out[i] != regista::Assignment::no_task || utilities(i, j) == regista::UtilityMatrix::forbidden) continue;
        if (!best || utilities(i, j) > utilities(*best, j)) best = i;
      }
      if (best) out[*best] = static_cast<std::int32_t>(j);
    }
  }
};

struct Behaviour {
  static constexpr auto id = BUILT_AS "behaviour", version = release, summary = about;
  static constexpr unsigned reads = REGISTA_READS_FACINGS, purposes = REGISTA_BEHAVIOUR_PLAYS_BALL;
  double reach = 0.0;
  std::optional<double> roll;

  void setup(const regista::Environment& environment) {
    reach = environment->kick_reach;
    for (const regista::Kick& kick : environment.kicks()) {
      if (!roll) roll = 0.5 * (kick.minimum_distance + kick.maximum_distance);
    }
  }
  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    const int phase = frame.mine().game().phase;
    const regista::Task* task = body.task(frame);
    if (task == nullptr || (phase != REGISTA_PHASE_READY && phase != REGISTA_PHASE_PLAYING)) return;
    const regista::Ball& ball = frame.mine().ball();
    const double distance = std::hypot(ball.position[0] - body->pose[0], ball.position[1] - body->pose[1]);
    if (roll && phase == REGISTA_PHASE_PLAYING && body.is(REGISTA_BODY_SEES_BALL) && distance < reach) {
      out.kick = 0;
      out.kick_direction = wrapped(-body->pose[2]);
      out.kick_distance = *roll;
      return;
    }
    out.motion = REGISTA_MOTION_WALK_TO;
    for (int i = 0; i < 3; ++i) out.pose[i] = task->after[i];
  }
};

struct Sender {
  static constexpr auto id = BUILT_AS "sender", version = release, summary = about;
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr std::array<const char*, 1> reasons{"two_seconds"};
  std::optional<int> decide(const regista::Frame&, const regista::SendQuery& query, regista::Grants) {
    if (query.budget.packets_left <= 20 || query.budget.since_own < 2.0) return std::nullopt;
    return regista::own_reason(0);
  }
};

}  // namespace

REGISTA_PLUGINS(regista::Plugin<Predictor, regista::predictor>, regista::Plugin<Context, regista::context>,
                regista::Plugin<Positioner, regista::positioner>, regista::Plugin<Utility, regista::utility>,
                regista::Plugin<Assigner, regista::assigner>, regista::Plugin<Behaviour, regista::behaviour>,
                regista::Plugin<Sender, regista::sender>)
