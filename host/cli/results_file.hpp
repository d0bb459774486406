// SPDX-License-Identifier: MIT
// The results of a study as a file that can be continued: the file holds what was planned, and is continued only by the
// same plan. Everything that differs is named; nothing is mixed.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "campaign/store.hpp"
#include "study/experiment_plan.hpp"
#include "study/tournament_plan.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::cli {

using StudyPlan = std::variant<study::TournamentPlan, study::ExperimentPlan, study::TuningPlan>;

// Opens the file of results for this plan. documents: of the teams, resolved, which the file keeps for its readers.
// Throws BadInput: it exists and is not to be continued, or the other way round, holds something else, or cannot be
// used.
campaign::Store open_results(const std::string& file, bool resume, const StudyPlan& plan,
                             const std::vector<std::string>& documents);

// The documents that a file keeps, by team; none in files of older programs. Throws campaign::StoreError.
std::vector<std::string> stored_documents(const campaign::Store& store);

// A file of results to be read, and what was planned. Throws BadInput.
struct StoredStudy {
  campaign::Store store;
  StudyPlan plan;
};
StoredStudy read_results(const std::string& file);

// What every plan has.
std::uint64_t matches(const StudyPlan& plan);
const std::string& folder(const StudyPlan& plan);
const campaign::Limits& limits(const StudyPlan& plan);

// The match in a row of the file, from 1; nothing when it has not been played. Throws campaign::StoreError.
std::optional<campaign::Store::Row> stored_match(const StoredStudy& study, std::uint64_t row);

// What is to be said when study::metric cannot read what is stored.
std::string damaged_metrics(const std::string& file, const std::invalid_argument& error);

}  // namespace regista::cli
