// SPDX-License-Identifier: MIT
// The own body as a behaviour is shown it: stands at the centre, sees nothing and has no task until something else is
// said.
//
//   const BodyBuilder body = BodyBuilder{}.at(-0.2, 0).heading(0.1).task(0).sees_ball();
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <regista/abi.h>

namespace regista::testkit {

class BodyBuilder {
 public:
  BodyBuilder() {
    body_.size = sizeof body_;
    body_.task = -1;
  }
  BodyBuilder& at(double x, double y) { return body_.pose[0] = x, body_.pose[1] = y, *this; }
  BodyBuilder& heading(double angle) { return body_.pose[2] = angle, *this; }
  // Index into the frame's tasks.
  BodyBuilder& task(int index) { return body_.task = index, *this; }
  BodyBuilder& sees_ball() { return flag(REGISTA_BODY_SEES_BALL); }
  BodyBuilder& ball_refuted() { return flag(REGISTA_BODY_BALL_REFUTED); }
  BodyBuilder& fallen(double seconds_until_up) {
    body_.time_until_up = seconds_until_up;
    return flag(REGISTA_BODY_FALLEN);
  }
  BodyBuilder& penalised() { return flag(REGISTA_BODY_PENALISED); }
  BodyBuilder& kicking() { return flag(REGISTA_BODY_KICKING); }
  BodyBuilder& touched(double bearing) { return body_.contact = bearing, flag(REGISTA_BODY_TOUCHED); }
  BodyBuilder& head_yaw(double angle) { return body_.head_yaw = angle, *this; }
  // Since the last decision.
  BodyBuilder& moved(double ahead, double left, double turn);
  BodyBuilder& robot_near(double x, double y) { return near_.push_back({x, y}), *this; }

  // Without the robots that are near.
  const regista_body& raw() const { return body_; }
  std::span<const regista_point> near() const { return near_; }

 private:
  BodyBuilder& flag(std::uint32_t bit) { return body_.flags |= bit, *this; }

  regista_body body_{};
  std::vector<regista_point> near_;
};

inline BodyBuilder& BodyBuilder::moved(double ahead, double left, double turn) {
  body_.motion[0] = ahead;
  body_.motion[1] = left;
  return body_.motion[2] = turn, *this;
}

}  // namespace regista::testkit
