// SPDX-License-Identifier: MIT
// The page of a study from its file of results, and its figures as files.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "campaign/store.hpp"
#include "output/figure_folder.hpp"
#include "results/study_kind.hpp"

namespace regista::results {

struct PageWishes {
  std::optional<std::filesystem::path> page;  // the file
  output::FigureWishes figures;               // what it says of existing files goes for the page, too
};

// What is read for it.
struct StoredResults {
  std::filesystem::path file;
  const campaign::Store& store;
  std::span<const StudyKind> kinds;
};

// Complains in one line where results are missing. Throws BadInput and output::WriteError.
void write_page(const StoredResults& results, const PageWishes& wishes);

// After a study: its page beside the results (study/recording_place.hpp), in the place of an older page of ours,
// never of another file. What goes wrong is a complaint in one line and no more: the results are safe. Returns where it
// stands; nothing where it does not.
// figures: also as files, in the folder NAME.figures.
std::optional<std::filesystem::path> write_page_beside(const StoredResults& results, bool figures);

}  // namespace regista::results
