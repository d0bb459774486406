// SPDX-License-Identifier: MIT
// Robots that negotiate come to agree: rehearsals of a small and a whole team, in which none, 30 % and 60 % of the
// packets are lost. With the plugin's default parameters and what Options::base sets.
#pragma once

#include <regista/testkit/findings.hpp>
#include <regista/testkit/loaded.hpp>
#include <regista/testkit/options.hpp>

namespace regista::testkit {

namespace detail {

// Whether an assigner's table has the flag; false of what is no assigner.
bool says_it_negotiates(const Loaded& plugin);

}  // namespace detail

Findings check_rehearsal(const Loaded& plugin, const Options& options);

}  // namespace regista::testkit
