// SPDX-License-Identifier: MIT
#include "match/indirect_kick.hpp"

namespace regista::match {
namespace {

constexpr double touch_is_over = 0.5;  // s without contact, after which another touch is a second one
constexpr double dribbles = 0.3;       // s of touches; a ball bounces off in a few steps

}  // namespace

void IndirectKick::touched(int id, Side side, bool kicked, Vector ball, double time) {
  if (kind_ == Kind::none) return;
  if (taker_ < 0 && side == side_) taker_ = id;
  if (id != taker_) {
    if (kind_ == Kind::penalty_kick) {
      over();
    } else {
      played_by_another(id, kicked, time);
    }
    return;
  }
  if (kind_ == Kind::free_kick && played_on_ && kicked) over();
  if (kind_ == Kind::penalty_kick && touched_ > 0.0 && time - touched_ > touch_is_over) played_on_ = true;
  left_at_ = ball;
  touched_ = time;
}

void IndirectKick::played_by_another(int id, bool kicked, double time) {
  if (id != other_ || time - until_ > touch_is_over) since_ = time;
  other_ = id;
  until_ = time;
  if (kicked || until_ - since_ >= dribbles) over();
}

void IndirectKick::ball_at(Vector ball) {
  if (kind_ == Kind::free_kick && taker_ >= 0 && squared_length(ball - left_at_) > circle_ * circle_) played_on_ = true;
}

bool IndirectKick::may_score(Side side) const {
  if (kind_ == Kind::none || side != side_) return true;
  return kind_ == Kind::penalty_kick && !played_on_;
}

}  // namespace regista::match
