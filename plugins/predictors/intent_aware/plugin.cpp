// SPDX-License-Identifier: MIT
// Glue of the predictor `intent_aware`; the walk is in algorithm.hpp.
//
// What it does to the common world. Every robot carries every packet forward by this model, and the model looks at the
// rule's last answer, which is this robot's own: `previous` and `tasks` of its last frame. As long as the team computes
// its assignment on the common world (utility.knowledge: common, tasks.knowledge: common), that answer is a function of
// common data, and the common worlds of the robots stay alike but for the moments at which each decides; agreement
// holds as far as everybody's last frame was alike, and a packet ends every difference about its sender. If the
// assignment is computed on `mine`, private beliefs would leak through it into what is meant to be common. So by
// default (`only_common`) an answer counts only if it was computed on the common world, and otherwise the model is dead
// reckoning with fading; of the frame's knowledge of other robots only its common world is read (claimed role, fallen,
// penalised). The frame tells the world of the utilities, not that of the tasks: a team that sets tasks.knowledge: mine
// beside utility.knowledge: common lets its tasks' places leak.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <regista/predictor.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithm.hpp"

namespace {

using intent_aware::Answer;
using intent_aware::Packet;
using intent_aware::Parameters;
using intent_aware::Teammate;

struct IntentAware {
  static constexpr auto id = "intent_aware", version = "1.1.0",
                        summary = "Teammates: walk to the target that the team's rule gives them, then are held";
  static constexpr unsigned reads = REGISTA_READS_PREVIOUS;
  static constexpr unsigned subjects = REGISTA_SUBJECT_TEAMMATES;

  Parameters model;
  double speed_factor = 0.5;
  bool only_common = true;
  static constexpr std::tuple parameters{
      regista::real("speed_factor", &IntentAware::speed_factor, {0.0, 1.0}, "1",
                    "Share of the greatest walking speed at which a silent teammate is taken to walk; 0.5 as B-Human "
                    "takes of the sent speed, 0 holds it where it was")
          .tunable(),
      regista::within(
          &IntentAware::model,
          regista::real(
              "trusted_for", &Parameters::trusted_for, {0.0, 120.0}, "s",
              "Up to this age of its news a silent teammate is taken to walk; assumption: a few packets' silence")
              .tunable(),
          regista::real("fades_for", &Parameters::fades_for, {0.0, 120.0}, "s",
                        "After trusted_for its speed falls to zero within this time; assumption")
              .tunable(),
          regista::real(
              "moved", &Parameters::moved, {0.0, 20.0}, "m",
              "A task that a teammate said it has is followed once its place is farther than this from where it "
              "was; assumption: the radius in which a place of play is the same")
              .tunable()),
      regista::boolean(
          "only_common", &IntentAware::only_common,
          "Use the rule's answer only where it was computed on the common world, so that no private belief "
          "enters it"),
      regista::within(
          &IntentAware::model,
          regista::real("position_noise", &Parameters::position_noise, {0.0, 1.0}, "m/s",
                        "Growth of the standard deviation of a silent teammate's place; assumption: near half of the "
                        "walking speed")
              .tunable(),
          regista::real("heading_noise", &Parameters::heading_noise, {0.0, 2.0}, "rad/s",
                        "Growth of the standard deviation of a silent teammate's heading; assumption")
              .tunable())};

  void setup(const regista::Environment& environment) {
    team_size = static_cast<int>(environment->team_size);
    model.walk_speed = speed_factor * environment->walk_forward;
    mates.reserve(environment->team_size);
    first_answer.assign(environment->team_size, 0);
  }

  void reset(std::uint64_t) {
    mates.clear();
    decisions = 0;
  }

  void predict(double dt, const regista::Motion*, const regista::Frame* last) {
    if (last != nullptr) decisions = last->tick() + 1;
    const bool usable = last != nullptr && (!only_common || last->raw().knowledge == REGISTA_COMMON);
    for (Teammate& mate : mates) {
      // `previous` of a frame is the answer of the decision before it.
      if (usable && decisions > first_answer[index(mate.number())]) mate.hear_rule(answer(*last, mate.number()));
      mate.walk(dt, last != nullptr ? kept_from_walking(*last, mate.number(), dt) : 0.0);
    }
  }

  // The camera does not tell shirt numbers.
  void correct(regista::Span<regista::Measurement>, const regista::VisibleArea&) {}

  void absorb(regista::Span<regista::Track> tracks, double age) {
    for (const regista::Track& told : tracks) {
      if (told.label < 1 || told.label > team_size) {
        throw std::out_of_range("intent_aware: heard of robot " + std::to_string(told.label) + " in a team of " +
                                std::to_string(team_size));
      }
      Packet packet;
      packet.position << told.x, told.y;
      packet.heading = told.pose.heading;
      packet.has_target = (told.flags & REGISTA_TRACK_HAS_TARGET) != 0;
      if (packet.has_target) packet.target << told.pose.target[0], told.pose.target[1];
      packet.covariance << told.covariance[0], told.covariance[1], told.covariance[1], told.covariance[2];
      packet.heading_variance = told.pose.heading_variance;
      packet.weight = told.weight;
      packet.age = told.age;
      const Teammate fresh(told.label, packet, age, model);
      const auto place = std::lower_bound(mates.begin(), mates.end(), told.label,
                                          [](const Teammate& mate, int number) { return mate.number() < number; });
      if (place != mates.end() && place->number() == told.label) {
        *place = fresh;
      } else {
        mates.insert(place, fresh);
      }
      // The next decision is the first that knows the packet; the frame after that one tells its answer.
      first_answer[index(told.label)] = decisions + 1;
    }
  }

  // All are written before the first is copied: a copy right behind the writes waits for them.
  void tracks(regista::Tracks out) const {
    for (const Teammate& mate : mates) {
      const Packet& packet = mate.packet();
      const Eigen::Vector2d velocity = mate.velocity();
      const Eigen::Matrix2d place = mate.position_covariance();
      regista::Track& track = out.add();
      track.label = mate.number();
      track.flags = REGISTA_TRACK_VELOCITY;
      if (packet.has_target || mate.follows_rule()) {
        track.flags |= REGISTA_TRACK_HAS_TARGET;
        track.pose.target[0] = mate.goal().x();
        track.pose.target[1] = mate.goal().y();
      }
      track.x = mate.position().x();
      track.y = mate.position().y();
      track.pose.heading = packet.heading;
      track.vx = velocity.x();
      track.vy = velocity.y();
      track.covariance[0] = place(0, 0);
      track.covariance[1] = place(0, 1);
      track.covariance[2] = place(1, 1);
      track.pose.velocity_variance = mate.velocity_variance();
      track.pose.heading_variance = mate.heading_variance();
      track.weight = packet.weight;
      track.age = mate.age();
    }
  }

  static std::size_t index(int number) { return static_cast<std::size_t>(number - 1); }

  static Answer answer(const regista::Frame& last, int number) {
    Answer out;
    if (index(number) >= Count{last.raw().previous.count}) return out;
    out.task = std::max(last.previous_task(number), intent_aware::no_task);
    for (const regista::Task& task : last.tasks()) {
      if (task.id != out.task) continue;
      out.placed = true;
      out.place << task.after[0], task.after[1];
    }
    const auto robots = last.common().robots();
    out.claimed = index(number) < robots.size() && robots[index(number)].role == out.task;
    return out;
  }

  // Seconds of the next `dt` for which all know that it cannot walk. In Set nobody may.
  static double kept_from_walking(const regista::Frame& last, int number, double dt) {
    if (last.common().game().phase == REGISTA_PHASE_SET) return dt;
    const auto robots = last.common().robots();
    if (index(number) >= robots.size()) return 0.0;
    const regista::Robot& robot = robots[index(number)];
    if ((robot.flags & REGISTA_ROBOT_PENALISED) != 0) return dt;
    return (robot.flags & REGISTA_ROBOT_FALLEN) != 0 ? std::min(dt, robot.time_until_up) : 0.0;
  }

  using Count = std::size_t;
  int team_size = 0;
  std::uint64_t decisions = 0;              // of this robot, as far as its frames told
  std::vector<Teammate> mates;              // by number
  std::vector<std::uint64_t> first_answer;  // per robot: `decisions` beyond which answers know its packet
};

}  // namespace

REGISTA_PLUGIN(IntentAware, regista::predictor)
