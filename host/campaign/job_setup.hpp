// SPDX-License-Identifier: MIT
// A match of a campaign, set up from files again: what `regista match` is asked for, and whether the files still hold
// what the campaign played.
#pragma once

#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "plugin/catalogue.hpp"

namespace regista::campaign {

MatchRequest request_of(const Job& job);

// The hash of one of the inputs that both teams share; empty when the job has none of this name.
std::string input_of(const Job& job, const std::string& name);

// What the files hold now of all that a match is a function of.
struct FoundInputs {
  std::vector<Input> home, away, common;
};

// root: see team_inputs().
FoundInputs inputs_of(const MatchSetup& prepared, const plugin::Catalogue& catalogue, const std::string& program,
                      const std::string& mathematics, const std::string& root = {});

// Everything that differs from what the job was, in words; empty when nothing does.
std::string what_changed(const Job& job, const FoundInputs& now);
std::string what_changed(const Job& job, const MatchSetup& prepared, const plugin::Catalogue& catalogue,
                         const std::string& program, const std::string& mathematics, const std::string& root = {});

// The other way round; without what is to be found in the files.
Job job_of(const MatchRequest& request, const std::vector<std::string>& plugins);

// The line of the shell that plays this match, whatever the program was called and asked to write: "regista match ...".
std::string plain_command(const Job& job);

}  // namespace regista::campaign
