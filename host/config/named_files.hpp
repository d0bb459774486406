// SPDX-License-Identifier: MIT
// Every file that a document leads to: those it extends, teams and openings of a study, files of parameters, pinned
// plugins. Found without knowing what the document means, so that nothing that is added to it later can be forgotten:
// any value that is the name of a file counts, and so do the values of that file when it is a document.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "config/load.hpp"

namespace regista::config {

// The files themselves and all they lead to, each name once (a file that links lead to has several, eight at most), in
// the order found; a folder stands for the .yaml files in it.
// overrides: their values may name files, too. What cannot be read leads to nothing; never throws for it.
std::vector<std::filesystem::path> named_files(std::span<const std::filesystem::path> documents,
                                               const Overrides& overrides = {});

}  // namespace regista::config
