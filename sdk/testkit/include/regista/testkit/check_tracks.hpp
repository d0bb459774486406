// SPDX-License-Identifier: MIT
// What regista_track promises, whatever predictor wrote it.
#pragma once

#include <cstdint>
#include <vector>

#include <regista/abi.h>
#include <regista/testkit/findings.hpp>

namespace regista::testkit {

namespace detail {

// Positive semi-definite, but for rounding; packed as abi.h has it: a place, and with the rest of it a motion. Works on
// correlations, so that units do not matter.
bool is_covariance(const double (&place)[3]);
bool is_covariance(const double (&place)[3], const double (&rest)[7]);

}  // namespace detail

void check_track(const regista_track& track, std::uint32_t subject, Findings& findings);

void check_tracks(const std::vector<regista_track>& tracks, std::uint32_t subject, int own_number, int team_size,
                  Findings& findings);

// Predicting brings no news: what is there after it was there before.
void check_no_new_labels(const std::vector<regista_track>& before, const std::vector<regista_track>& after,
                         Findings& findings);

}  // namespace regista::testkit
