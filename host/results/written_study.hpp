// SPDX-License-Identifier: MIT
// A stored study written down as a folder that `regista run` plays: study.yaml, and below it the teams, profiles,
// scenes and data files that it was begun with, as they stood to each other. Names in it are relative.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "campaign/stored_documents.hpp"
#include "report/what_was_played.hpp"
#include "results/study_kind.hpp"

namespace regista::results {

// documents: that the study was begun with; kinds: all studies. folder: is made, and must not be there.
// Returns what does not come along, a line each. Throws BadInput and output::WriteError.
std::vector<std::string> write_study(const report::WhatWasPlayed& played,
                                     const std::vector<campaign::Document>& documents, std::span<const StudyKind> kinds,
                                     const std::filesystem::path& folder);

}  // namespace regista::results
