// SPDX-License-Identifier: MIT
// What stored results say, read once: figures, and the page around them, whatever the study.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/store.hpp"
#include "cli/results_file.hpp"
#include "report/figure.hpp"
#include "report/page_parts.hpp"

namespace regista::cli {

struct StoredResults {
  std::filesystem::path file;
  const campaign::Store& store;
  const StudyPlan& plan;
};

struct ToldStudy {
  std::string incomplete;  // a line for a study that is not at its end, else empty
  std::vector<report::Figure> figures;
  std::function<std::string(const std::filesystem::path& page, std::vector<report::PageFigure> figures)> page;
};

// `results` must outlive what they return. Throw campaign::StoreError, std::invalid_argument for damaged metrics.
ToldStudy told_study(const StoredResults& results);
ToldStudy told_tournament(const StoredResults& results);
ToldStudy told_experiment(const StoredResults& results);
ToldStudy told_tuning(const StoredResults& results);

std::string not_at_its_end(const StoredResults& results, const char* study, std::uint64_t matches, std::uint64_t of);

}  // namespace regista::cli
