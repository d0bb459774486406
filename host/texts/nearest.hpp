// SPDX-License-Identifier: MIT
// "Did you mean": the known name that is least edits away from one that is not known. The distance is the optimal
// string alignment distance: insertions, deletions, substitutions and swaps of neighbours, the slips that Damerau
// counted (A technique for computer detection and correction of spelling errors, Communications of the ACM 7(3), 1964).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace regista::texts {

// Number of edits from one text to the other; upper and lower case of ASCII letters count as equal.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The known name nearest to `asked`, the first of several; empty when none is near enough to be meant (more than a
// third of its letters differ, and more than one). The result views the element of `known`.
std::string_view nearest(std::string_view asked, std::span<const std::string_view> known);
std::string_view nearest(std::string_view asked, std::span<const std::string> known);

}  // namespace regista::texts
