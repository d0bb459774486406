// SPDX-License-Identifier: MIT
// A scene that matches of a study start from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "campaign/input.hpp"
#include "campaign/job.hpp"

namespace regista::study {

struct Opening {
  std::string file;
  campaign::Input input;
};

// The match starts from this scene.
inline void start_from(const Opening& opening, campaign::Job& job) {
  job.opening = opening.file;
  job.common_inputs.push_back(opening.input);
}

// Which of so many openings, one or more, a seed plays: a test that may stop at any pair must not see them in an order
// that somebody chose. Philox: J. K. Salmon et al., "Parallel Random Numbers: As Easy as 1, 2, 3", 2011.
std::size_t drawn_opening(std::uint64_t seed, std::size_t openings);

}  // namespace regista::study
