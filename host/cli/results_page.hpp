// SPDX-License-Identifier: MIT
// The page of a tournament (report/tournament_page.hpp) from its file of results, and its figures as files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "campaign/store.hpp"
#include "cli/replaced_file.hpp"
#include "study/tournament_plan.hpp"

namespace regista::cli {

struct StoredResults {
  std::filesystem::path file;
  const campaign::Store& store;
  const study::TournamentPlan& plan;
};

struct PageWishes {
  std::optional<std::filesystem::path> page;     // the file
  std::optional<std::filesystem::path> figures;  // a folder, which is made where it is missing
  bool png = false;
  Existing existing = Existing::refused;
};

// Complains in one line where figures cannot be drawn, or results are missing. Throws BadInput and WriteError.
void write_page(const StoredResults& results, const PageWishes& wishes);

// After a tournament: its page beside the results (study/recording_place.hpp), in the place of an older page of ours,
// never of another file. What goes wrong is a complaint in one line and no more: the results are safe. Returns where it
// stands; nothing where it does not.
std::optional<std::filesystem::path> write_page_beside(const StoredResults& results);

}  // namespace regista::cli
