// SPDX-License-Identifier: MIT
// Who is penalised, for what, and for how long still. RoboCup SPL rule book 2023, section 4.2: a standard removal lasts
// longer for each earlier offence of the team; offences in Set and incapable robots neither count nor grow.
#pragma once

#include <array>
#include <vector>

#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/side.hpp"

namespace regista::match {

// Standard removal penalties grow, and let the later ones grow.
bool counts(Offence offence);

// The robot stays where it is, and must not move; others leave the field.
bool on_the_spot(Offence offence);

class PenaltyBox {
 public:
  PenaltyBox(const config::Penalties& penalties, Roster roster);

  void send(int id, Offence offence);
  void pass(double seconds);  // the clock of penalties, which runs in Ready and Playing
  void release(int id);
  void empty();  // a half is over; offences stay counted

  RobotSet inside() const { return inside_; }
  bool served(int id) const { return remaining(id) <= 1e-6; }
  double remaining(int id) const { return remaining_[static_cast<std::size_t>(id)]; }
  Offence offence(int id) const { return why_[static_cast<std::size_t>(id)]; }

 private:
  config::Penalties penalties_;
  Roster roster_;
  RobotSet inside_ = 0;
  std::vector<double> remaining_;
  std::vector<Offence> why_;
  std::array<int, 2> counted_{};
};

}  // namespace regista::match
