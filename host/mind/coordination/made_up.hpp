// SPDX-License-Identifier: MIT
// Scenes that nobody played, to find out what a team's plugins do.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "mind/team_plan.hpp"
#include "mind/world/distributed_world_model.hpp"

namespace regista::mind {

// Of all that is made up.
inline constexpr std::uint64_t made_up_seed = 1;

// What a plugin that talks answers hangs on teammates, which a made-up scene does not have.
inline bool talks(const Part& part) { return plugin::implements(*part.found, REGISTA_KIND_MAILBOX); }

// The standard's distributions differ between libraries, its generator does not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  double real(double low, double high) {
    const double share = static_cast<double>(random_() >> 11) * 0x1p-53;
    return low + share * (high - low);
  }
  bool chance(double share) { return real(0.0, 1.0) < share; }
  int below(int count) { return static_cast<int>(real(0.0, count)); }
  // Of every order of magnitude as many.
  double log_real(double low, double high) { return low * std::exp(real(0.0, std::log(high / low))); }
  // Sixteenths, whose sums are exact: equal sums stay equal.
  double sixteenths(double most) { return std::floor(real(0.0, 16.0 * most)) / 16.0; }

 private:
  std::mt19937_64 random_;
};

// Everybody somewhere on the field with a role of the list, everything known, in play. out_of_play: number of a robot
// that is penalised; 0: none. The caller closes the world.
void make_up(DistributedWorldModel& world, const TeamPlan& plan, int list, int scene, double time, int own,
             int out_of_play, Dice& dice);

}  // namespace regista::mind
