// SPDX-License-Identifier: MIT
// What the numbers of a match are (match/metric_table.hpp), for people and programs, and the tables of
// docs/metrics.md, whose prose is written by hand.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "match/metric_table.hpp"

namespace regista::report {

// A line for each: path, unit, meaning.
std::string metrics_text(std::span<const match::MetricRow> table);
std::string metrics_json(std::span<const match::MetricRow> table);

// A page of Markdown in which each line <!-- metrics: PART --> is followed by the table of that part: with the tables
// as they are now. Throws std::invalid_argument for a part that is not in match::metric_parts, and for one of those
// that the page has not.
std::string with_metric_tables(std::string_view page, std::span<const match::MetricRow> table);

}  // namespace regista::report
