// SPDX-License-Identifier: MIT
// A match of a campaign, set up from files again: what `regista match` is asked for, and whether the files still hold
// what the campaign played.
#pragma once

#include <string>

#include "campaign/job.hpp"
#include "cli/match_setup.hpp"
#include "plugin/catalogue.hpp"

namespace regista::cli {

MatchRequest request_of(const campaign::Job& job);

// The hash of one of the inputs that both teams share; empty when the job has none of this name.
std::string input_of(const campaign::Job& job, const std::string& name);

// Everything that differs from what the job was, in words; empty when nothing does.
std::string what_changed(const campaign::Job& job, const MatchSetup& prepared, const plugin::Catalogue& catalogue,
                         const std::string& program, const std::string& mathematics);

}  // namespace regista::cli
