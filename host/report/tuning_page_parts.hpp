// SPDX-License-Identifier: MIT
// Parts of the page of every study that searches the values of a team.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/html.hpp"
#include "study/forfeits.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

Html sentence_list(const std::vector<std::string>& sentences);  // empty for none
Html note_paragraph(const std::string& sentence);               // empty for none
Html whole_number(std::uint64_t value);

// The top: what the study is, what it found, whether it is at its end, and what it asked.
Html verdict_header(const std::string& title, const std::string& headline, const std::string& unfinished,
                    const std::string& question);

// What was asked for, and the parameters. sentences: of the study.
Html setup_section(const study::TuningPlan& plan, const std::vector<std::string>& sentences);

Html failures_section(const study::TuningPlan& plan, const study::ForfeitList& forfeits);

}  // namespace regista::report
