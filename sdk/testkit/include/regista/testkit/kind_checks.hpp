// SPDX-License-Identifier: MIT
// The contract of each kind of plugin, as <regista/abi.h> writes it: the scenarios that a plugin of the kind is played
// through, and the checks that are the kind's own. checks.hpp makes the list of all named checks of it.
#pragma once

#include <cstdint>
#include <vector>

#include <regista/abi.h>
#include <regista/testkit/findings.hpp>
#include <regista/testkit/loaded.hpp>
#include <regista/testkit/options.hpp>
#include <regista/testkit/scenario.hpp>

namespace regista::testkit {

Findings check_descriptor(const Loaded& plugin);

// --- Scenarios of a kind

std::vector<Scenario> assigner_scenarios(const Options& options);
std::vector<Scenario> behaviour_scenarios(const Options& options);
std::vector<Scenario> context_scenarios(const Options& options);
std::vector<Scenario> positioner_scenarios(const Options& options);
std::vector<Scenario> sender_scenarios(const Options& options);
std::vector<Scenario> utility_scenarios(const Options& options);
// For every subject that the plugin declares.
std::vector<Scenario> predictor_scenarios(const Loaded& plugin, const Options& options);

// --- Positioners

// With hardly any room a positioner may fail or place less, but it writes no further than it may.
Findings check_small_capacity(const Loaded& plugin, const Options& options);

// --- Utilities

// The same scores, but for rounding, when the opponents stand in another order. Not every utility promises it.
Findings check_order_of_opponents(const Loaded& plugin, const Options& options);

// --- Predictors

namespace detail {

// The subjects that a plugin declares, as bits; 0 when it is no predictor.
std::uint32_t subjects_of(const Loaded& plugin);

// Whether it is a predictor with the optional call track_at.
bool tells_track_at(const Loaded& plugin);

}  // namespace detail

// While nothing is measured the own pose does not become surer: not standing, and not walking straight ahead after it
// was placed. (Elsewhere a walk back along a known error may make the position, but not the pose, surer.)
Findings check_uncertainty_grows(const Loaded& plugin, const Options& options);

// Two opponents that stand still, four metres apart and seen at every tick, keep their labels.
Findings check_labels_are_stable(const Loaded& plugin, const Options& options);

// Of a teammate that was told of, track_at gives what a model holds that absorbs it and then predicts; and it leaves
// the model alone.
Findings check_track_at(const Loaded& plugin, const Options& options);

// --- Checks of what regista_track promises, whatever the predictor

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

// --- Plugins of any kind that receive messages: regista_mailbox

// Segments of any content may arrive (another version of the plugin may have written them). To refuse one is sound; to
// break the rules of every call is not. What it says of bytes, if anything, is one line that ends, and always the same.
Findings check_mailbox(const Loaded& plugin, const Options& options, std::uint32_t subject);

// The same messages, each on pages of its own, with default parameters. A plugin that goes beyond them ends the
// process, as in check_memory().
void play_messages_guarded(const Loaded& plugin, const Options& options, std::uint32_t subject = 0);

// --- Negotiation

namespace detail {

// Whether an assigner's table has the flag; false of what is no assigner.
bool says_it_negotiates(const Loaded& plugin);

}  // namespace detail

// Robots that negotiate come to agree: rehearsals of a small and a whole team, in which none, 30 % and 60 % of the
// packets are lost. With the plugin's default parameters and what Options::base sets.
Findings check_rehearsal(const Loaded& plugin, const Options& options);

}  // namespace regista::testkit
