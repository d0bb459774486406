// SPDX-License-Identifier: MIT
// Parts of the text of every study that searches the values of a team. Lines, each ended; empty where there is nothing
// to show.
#pragma once

#include <string>
#include <vector>

#include "study/tuning/match_tally.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

std::string paragraph(const char* title, const std::vector<std::string>& sentences);
std::string indented(const std::string& lines);

std::string parameters_table(const study::TuningPlan& plan);
std::string left_out_text(const study::MatchTally& tally);  // pairs that could not be played
std::string forfeits_text(const study::TuningPlan& plan, const study::MatchTally& tally);

}  // namespace regista::report
