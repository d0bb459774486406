// SPDX-License-Identifier: MIT
// The contract of predictors: regista_predictor in <regista/abi.h>, for every subject that the plugin declares.
#pragma once

#include <cstdint>
#include <vector>

#include <regista/testkit/check_tracks.hpp>
#include <regista/testkit/course.hpp>

namespace regista::testkit {

namespace detail {

// The subjects that a plugin declares, as bits; 0 when it is no predictor.
std::uint32_t subjects_of(const Loaded& plugin);

// Whether it is a predictor with the optional call track_at.
bool tells_track_at(const Loaded& plugin);

}  // namespace detail

std::vector<Course> predictor_courses(const Loaded& plugin, const Options& options);

// While nothing is measured the own pose does not become surer: not standing, and not walking straight ahead after it
// was placed. (Elsewhere a walk back along a known error may make the position, but not the pose, surer.)
Findings check_uncertainty_grows(const Loaded& plugin, const Options& options);

// Two opponents that stand still, four metres apart and seen at every tick, keep their labels.
Findings check_labels_are_stable(const Loaded& plugin, const Options& options);

// Of a teammate that was told of, track_at gives what a model holds that absorbs it and then predicts; and it leaves
// the model alone.
Findings check_track_at(const Loaded& plugin, const Options& options);

}  // namespace regista::testkit
