// SPDX-License-Identifier: MIT
#include "match/duels.hpp"

#include <utility>

#include "match/sampling.hpp"

namespace regista::match {
namespace {

bool long_enough(const Duels::Duel& duel) { return seconds(duel.samples) >= shortest_duel; }

}  // namespace

void Duels::sample(std::span<const BodyState> bodies, RobotSet able, double time) {
  const Vector ball{bodies.back().x, bodies.back().y};
  std::array<int, 2> nearest{-1, -1};
  std::array<double, 2> least{};  // m^2
  for (int id = 0; id < roster_.count(); ++id) {
    if (!contains(able, id)) continue;
    const BodyState& body = bodies[at(id)];
    const double distance = squared_length(Vector{body.x, body.y} - ball);
    const std::size_t side = index(roster_.side(id));
    if (distance > duel_reach * duel_reach || (nearest[side] >= 0 && distance >= least[side])) continue;
    nearest[side] = id;
    least[side] = distance;
  }
  holds_ = nearest[0] >= 0 && nearest[1] >= 0;
  if (holds_) {
    if (!duel_) duel_ = {nearest, least[0] <= least[1] ? Side::home : Side::away, time, ball, 0, {}};
    ++duel_->samples;
  } else if (duel_ && !long_enough(*duel_)) {
    duel_.reset();
  }
}

std::optional<Duels::Duel> Duels::ended(std::optional<Side> won) {
  holds_ = false;
  std::optional<Duel> out = std::exchange(duel_, std::nullopt);
  if (!out || !long_enough(*out)) return std::nullopt;
  out->won = won;
  return out;
}

std::optional<Duels::Duel> Duels::touched(Side side) { return holds_ ? std::nullopt : ended(side); }

std::optional<Duels::Duel> Duels::scored(Side side) { return ended(side); }

std::optional<Duels::Duel> Duels::dead() { return ended(std::nullopt); }

}  // namespace regista::match
