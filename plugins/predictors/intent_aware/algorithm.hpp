// SPDX-License-Identifier: MIT
// Where a silent teammate is by now, if it does what the team's known rule tells it: it walks straight to the target it
// last sent, and once the rule has given it another task, to the place of that task; there it stands. The older the
// news, the less of that is certain: beyond `trusted_for` the walk slows down linearly and after `fades_for` more it
// ends, where the teammate is then held.
//
// Source: the rule for silent teammates of B-Human (Roefer et al., team reports 2022 and 2023: towards the sent target
// at half the sent speed, without overshoot), with the target replaced by that of the known rule: all robots compute
// the same assignment (Affinita et al., the paper), so each can say what the others are about to do.
//
// Between two changes of the target the walk is a closed form of the time, so that its steps do not matter; over
// changes it depends on when this robot decided.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace intent_aware {

struct Parameters {
  double walk_speed = 0.125;    // m/s, of a silent teammate
  double trusted_for = 10.0;    // s: until then it is taken to walk
  double fades_for = 20.0;      // s: so long the walk takes to end
  double moved = 0.5;           // m: a task whose place is farther than this from where it was is another target
  double position_noise = 0.1;  // m/s: the deviation of the place grows by this each second
  double heading_noise = 0.2;   // rad/s
};

// As sent.
struct Packet {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double heading = 0.0;
  bool has_target = false;
  Eigen::Vector2d target = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of position
  double heading_variance = 0.0;
  double weight = 1.0;
  double age = 0.0;  // s, of the news at the time it was sent
};

constexpr int no_task = -1;

// What the rule says now of one robot.
struct Answer {
  int task = no_task;
  bool placed = false;  // the place of the task is known
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  bool claimed = false;  // the robot itself said that it has this task
};

// Seconds of walking at full speed between two ages, a <= b.
inline double full_seconds(double a, double b, const Parameters& p) {
  const auto until = [&p](double age) {
    if (age <= p.trusted_for) return age;
    if (p.fades_for <= 0.0) return p.trusted_for;
    const double faded = std::min(age - p.trusted_for, p.fades_for);
    return p.trusted_for + faded - 0.5 * faded * faded / p.fades_for;
  };
  return until(b) - until(a);
}

class Teammate {
 public:
  Teammate(int number, const Packet& packet, double ago, const Parameters& parameters)
      : number_(number), packet_(packet), parameters_(parameters), position_(packet.position) {
    goal_ = packet.has_target ? packet.target : packet.position;
    if (ago > 0.0) walk(ago, 0.0);
  }

  // The rule's answer at a decision that knew the packet; the first one is that to which later ones are compared.
  void hear_rule(const Answer& answer) {
    if (!compared_) {
      compared_ = true;
      first_ = answer;
      return;
    }
    if (!follows_) {
      const bool other = answer.task != first_.task;
      const bool displaced = answer.task != no_task && answer.claimed && answer.placed && first_.placed &&
                             (answer.place - first_.place).squaredNorm() > parameters_.moved * parameters_.moved;
      if (!other && !displaced) return;
      follows_ = true;
    }
    if (answer.task == no_task) {
      goal_ = position_;
    } else if (answer.placed) {
      goal_ = answer.place;
    }
  }

  // `kept`: of the dt seconds, those during which it cannot walk (fallen, penalised), at the beginning.
  void walk(double dt, double kept) {
    const double from = age() + std::clamp(kept, 0.0, dt);
    elapsed_ += dt;
    const Eigen::Vector2d way = goal_ - position_;
    const double length = std::sqrt(way.squaredNorm());
    const double reach = parameters_.walk_speed * full_seconds(std::min(from, age()), age(), parameters_);
    if (length <= reach) {
      position_ = goal_;
    } else {
      position_ += (reach / length) * way;
    }
    stays_ = kept >= dt;
  }

  const Eigen::Vector2d& position() const { return position_; }
  const Eigen::Vector2d& goal() const { return goal_; }
  bool follows_rule() const { return follows_; }
  double age() const { return packet_.age + elapsed_; }
  Eigen::Vector2d velocity() const {
    const Eigen::Vector2d way = goal_ - position_;
    const double length = std::sqrt(way.squaredNorm());
    if (length == 0.0 || stays_) return Eigen::Vector2d::Zero();
    const double fading = age() <= parameters_.trusted_for ? 1.0
                          : parameters_.fades_for <= 0.0
                              ? 0.0
                              : std::max(0.0, 1.0 - (age() - parameters_.trusted_for) / parameters_.fades_for);
    return (parameters_.walk_speed * fading / length) * way;
  }
  // An unknown error of the velocity that stays the same: its share of the place grows with the time.
  double velocity_variance() const { return parameters_.position_noise * parameters_.position_noise; }
  double cross() const { return velocity_variance() * elapsed_; }
  Eigen::Matrix2d position_covariance() const {
    Eigen::Matrix2d out = packet_.covariance;
    out.diagonal().array() += velocity_variance() * elapsed_ * elapsed_;
    return out;
  }
  double heading_variance() const {
    const double turned = parameters_.heading_noise * elapsed_;
    return packet_.heading_variance + turned * turned;
  }

  int number() const { return number_; }
  const Packet& packet() const { return packet_; }

 private:
  int number_;
  Packet packet_;
  Parameters parameters_;
  Eigen::Vector2d position_, goal_ = Eigen::Vector2d::Zero();
  double elapsed_ = 0.0;  // s since the packet was sent
  bool compared_ = false, follows_ = false, stays_ = false;
  Answer first_;
};

}  // namespace intent_aware
