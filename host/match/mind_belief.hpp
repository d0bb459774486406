// SPDX-License-Identifier: MIT
// What a mind believes, for the metrics: its world `mine`, on which most of what it decides is based.
//
// It knows the ball while its world has one that its own eyes have not refuted. It reckons with a teammate that is
// active in its world: heard of, not told to be penalised, not given up for lost.
#pragma once

#include "match/belief.hpp"
#include "mind/mind.hpp"

namespace regista::match {

void belief_of(const mind::Mind& mind, Belief& out);

}  // namespace regista::match
