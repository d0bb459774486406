// SPDX-License-Identifier: MIT
// Reference texts for people and programs: the numbers of a match (match/metric_table.hpp), the tables (not the prose)
// of docs/metrics.md, the words for numbers in figures, and the declaration of a plugin.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "match/metric_table.hpp"
#include "plugin/description.hpp"
#include "texts/json.hpp"

namespace regista::report {

// metrics_text() has one line for each metric: path, unit, meaning.
std::string metrics_text(std::span<const match::MetricRow> table);
std::string metrics_json(std::span<const match::MetricRow> table);

// Returns the Markdown page `page` with new tables: behind each line <!-- metrics: PART --> the table of PART. Throws
// std::invalid_argument if the parts of the page differ from match::metric_parts.
std::string with_metric_tables(std::string_view page, std::span<const match::MetricRow> table);

std::string spaced(std::string_view name);        // "ball lost" for "ball_lost"
std::string name_of_role(std::string_view role);  // "wing left" for "playing.wing_left"

// Words that figures use for a measure of an experiment or a tuning. Tables and documents use the path of the measure.
std::string measure_words(std::string_view measure);  // "striker held twice" for "striker.overlap_seconds"
// Returns words and unit of a measure, for an axis: "changes of holder, per match". Cut after `longest` characters.
std::string measure_axis(std::string_view measure, std::size_t longest = 60);

// Returns a plugin's declaration as JSON for programs.
nlohmann::ordered_json plugin_json(const plugin::Found& plugin);

}  // namespace regista::report
