// SPDX-License-Identifier: MIT
#include "match/indirect_kick.hpp"

namespace regista::match {
namespace {

constexpr double touch_is_over = 0.5;  // s without contact, after which another touch is a second one

}  // namespace

void IndirectKick::touched(int id, Side side, bool kicked, double time) {
  if (kind_ == Kind::none) return;
  if (taker_ < 0 && side == side_) {
    taker_ = id;
  } else if (kind_ == Kind::free_kick) {
    if (kicked && (id != taker_ || played_on_)) over();
  } else if (id != taker_) {
    over();
  } else if (time - touched_ > touch_is_over) {
    played_on_ = true;
  }
  if (id == taker_) touched_ = time;
}

void IndirectKick::ball_at(Vector ball) {
  if (kind_ == Kind::free_kick && squared_length(ball - spot_) > circle_ * circle_) played_on_ = true;
}

bool IndirectKick::may_score(Side side) const {
  if (kind_ == Kind::none || side != side_) return true;
  return kind_ == Kind::penalty_kick && !played_on_;
}

}  // namespace regista::match
