// SPDX-License-Identifier: MIT
// Who forfeited matches of a study, and why: each reason once, with the first match and how many there were.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "campaign/job.hpp"

namespace regista::study {

// Forfeits for the same reason.
struct Forfeits {
  std::size_t team = 0;  // as the study counts them
  campaign::Failure failure;
  std::uint64_t first_match = 0, count = 0;
};

class ForfeitList {
 public:
  explicit ForfeitList(std::size_t teams) : of_team_(teams, 0) {}

  void add(std::size_t team, const campaign::Failure& failure, std::uint64_t match);
  // Precondition: the last that was added.
  void take_back(std::size_t team, const campaign::Failure& failure);

  const std::vector<Forfeits>& listed() const { return listed_; }  // by first match; all but place and time differ
  std::uint64_t unlisted() const { return unlisted_; }             // of kinds beyond the first hundred
  const std::vector<std::uint64_t>& of_team() const { return of_team_; }

 private:
  std::vector<Forfeits>::iterator find(std::size_t team, const campaign::Failure& failure);

  std::vector<Forfeits> listed_;
  std::vector<std::uint64_t> of_team_;
  std::uint64_t unlisted_ = 0;
};

}  // namespace regista::study
