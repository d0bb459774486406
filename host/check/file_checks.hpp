// SPDX-License-Identifier: MIT
// What is asked of a plugin's file: of the object, without running it, and of what happens when it is opened.
#pragma once

#include <cstdint>
#include <filesystem>

#include "check/child.hpp"
#include "check/object_file.hpp"

namespace regista::check {

Outcome exports_of(const ObjectFile& object);
Outcome relocations_of(const ObjectFile& object);
// Libraries that are not on every machine are a warning each. `file` is where the object lies.
Outcome needs_of(const ObjectFile& object, const std::filesystem::path& file);
// Calls that no sound plugin needs are a warning each.
Outcome imports_of(const ObjectFile& object);

// These open the file, and so run its code: in a child only.

// Every version of a host gets the same descriptors, and none beyond the `plugins` that there are.
Outcome shake_hands(const std::filesystem::path& file, std::uint32_t plugins);
// For a process that is to end after that: see Ending.
Outcome open_and_no_more(const std::filesystem::path& file);

}  // namespace regista::check
