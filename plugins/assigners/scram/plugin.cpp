// SPDX-License-Identifier: MIT
// Assigner plugin around from_frame.hpp: each robot decides alone. With a vote on the result: ../scram_vote.
#include <vector>

#include <regista/assigner.hpp>

#include "from_frame.hpp"

namespace {

struct Scram {
  static constexpr auto id = "scram", version = "2.0.0",
                        summary = "Least longest walk, then the next longest or the least sum of squares (SCRAM)";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  scram::Settings settings;
  static constexpr std::tuple parameters{regista::within(&Scram::settings, scram::parameters)};

  scram::FrameSolver solver;
  std::vector<std::int32_t> assigned;

  void setup(const regista::Environment& environment) {
    solver.reserve(environment->team_size, environment.roles().size());
    assigned.reserve(environment->team_size);
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    assigned.resize(out.size());
    solver.assign(settings, frame, utilities, assigned);
    for (std::size_t row = 0; row < out.size(); ++row) out[row] = assigned[row];
  }
};

}  // namespace

REGISTA_PLUGIN(Scram, regista::assigner)
