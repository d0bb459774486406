// SPDX-License-Identifier: MIT
// The tuned team as the text of a file: what differs from the base team, below a comment that says where it comes from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "study/tuning/tuning.hpp"

namespace regista::report {

// By which it is known again.
inline constexpr std::string_view tuned_file_begin = "# Tuned by Regista";

// file: that it is to be, for it names the base team as seen from there. program: version that searched. fingerprint:
// of the results. record.tuned() has a value.
std::string tuned_file_text(const std::filesystem::path& file, const study::TuningPlan& plan,
                            const study::TuningRecord& record, const std::string& program,
                            const std::string& fingerprint);

}  // namespace regista::report
