// SPDX-License-Identifier: MIT
#include "match/penalty_box.hpp"

#include <bit>

namespace regista::match {

bool counts(Offence offence) {
  return offence == Offence::illegal_position || offence == Offence::ball_holding || offence == Offence::pushing ||
         offence == Offence::leaving_the_field;
}

bool on_the_spot(Offence offence) { return offence == Offence::motion_in_set; }

PenaltyBox::PenaltyBox(const config::Penalties& penalties, Roster roster)
    : penalties_(penalties),
      roster_(roster),
      remaining_(static_cast<std::size_t>(roster.count())),
      why_(static_cast<std::size_t>(roster.count()), Offence::none) {}

void PenaltyBox::send(int id, Offence offence) {
  double lasts = penalties_.removal;
  if (offence == Offence::illegal_position_in_set) lasts = penalties_.illegal_position_in_set;
  if (offence == Offence::motion_in_set) lasts = penalties_.motion_in_set;
  if (counts(offence)) lasts += penalties_.removal_growth * counted_[index(roster_.side(id))]++;
  inside_ |= only(id);
  remaining_[static_cast<std::size_t>(id)] = lasts;
  why_[static_cast<std::size_t>(id)] = offence;
}

void PenaltyBox::pass(double seconds) {
  for (RobotSet rest = inside_; rest != 0; rest &= rest - 1) {
    remaining_[static_cast<std::size_t>(std::countr_zero(rest))] -= seconds;
  }
}

void PenaltyBox::release(int id) { inside_ &= ~only(id); }
void PenaltyBox::empty() { inside_ = 0; }

}  // namespace regista::match
