// SPDX-License-Identifier: MIT
// The numbers of a match in few bytes, as a file of results keeps them. docs/results.md says the format byte by byte.
//
// - names: a JSON array of objects, {"side": "home", "role": "striker", "name": "switches", "place": 1}, where what a
//   number has not is left out; one text for all matches that have the same numbers
// - numbers: in the order of the names, one unsigned LEB128 number each: 0 for none; 1 for one that follows as the
// eight
//   bytes of an IEEE 754 double, least significant first; n + 2 for a millionth of the number that zigzag coding makes
//   of n (0, -1, 1, -2 ... for 0, 1, 2, 3 ...). All together they are one frame of Zstandard.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "match/metric_numbers.hpp"

namespace regista::campaign {

std::string names_text(const match::MetricNames& names);
// Throws std::invalid_argument for what names_text() did not write.
std::shared_ptr<const match::MetricNames> names_of(const std::string& text);

std::string number_bytes(std::span<const double> values);
// Throws std::invalid_argument unless it is exactly so many numbers.
std::vector<double> numbers_of(std::string_view bytes, std::size_t count);

}  // namespace regista::campaign
