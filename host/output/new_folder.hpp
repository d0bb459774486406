// SPDX-License-Identifier: MIT
// A folder that is there whole or not at all: made beside its place under another name, then moved there. Nothing that
// stands there already is touched.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace regista::output {

struct NewFile {
  std::string name;  // in the folder, or below it: "teams/a.yaml"
  std::string bytes;
};

// Throws BadInput when there is something at `folder`, or its parent is not there or may not be written to; WriteError
// when the files cannot be kept, as on a full disk.
void write_new_folder(const std::filesystem::path& folder, std::span<const NewFile> files);

}  // namespace regista::output
