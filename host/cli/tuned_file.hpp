// SPDX-License-Identifier: MIT
// The tuned team as a file: what differs from the base team, below a comment that says where it comes from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "campaign/store.hpp"
#include "study/tuning/tuning.hpp"

namespace regista::cli {

// Where it is written unless asked otherwise: NAME.tuned.yaml beside the results NAME.db.
std::filesystem::path tuned_file_beside(const std::filesystem::path& results);

// By which it is known again.
inline constexpr std::string_view tuned_file_begin = "# Tuned by Regista";

// Replaces an older one. fingerprint: of the results. record.tuned() has a value.
void write_tuned_file(const std::filesystem::path& file, const study::TuningPlan& plan,
                      const study::TuningRecord& record, const std::string& fingerprint);

}  // namespace regista::cli
