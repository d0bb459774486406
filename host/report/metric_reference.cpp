// SPDX-License-Identifier: MIT
#include "report/metric_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "texts/json.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view marker = "<!-- metrics: ", end_of_marker = " -->";

const char* of_what(const match::MetricRow& row) {
  switch (row.of) {
    case match::MetricRow::Of::match:
      return "match";
    case match::MetricRow::Of::team:
      break;
    case match::MetricRow::Of::role:
      return "role";
    case match::MetricRow::Of::event:
      return "event";
    case match::MetricRow::Of::plugin_total:
    case match::MetricRow::Of::plugin_value:
      return "plugin";
  }
  return "team";
}

std::string meaning(const match::MetricRow& row) { return (row.is_list() ? "list, " : "") + row.meaning; }

std::string markdown_table(std::string_view part, std::span<const match::MetricRow> table) {
  std::string out = "| Path | Unit | Meaning |\n|---|---|---|\n";
  for (const match::MetricRow& row : table) {
    if (row.part != part) continue;
    out +=
        fmt::format("| `{}` |{}| {} |\n", row.pattern(), row.unit.empty() ? " " : ' ' + row.unit + ' ', meaning(row));
  }
  return out;
}

// Of the first line; the rest begins after its end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

}  // namespace

std::string metrics_text(std::span<const match::MetricRow> table) {
  std::size_t width = 0;
  for (const match::MetricRow& row : table) width = std::max(width, row.pattern().size());
  std::string out;
  for (const match::MetricRow& row : table) {
    out += fmt::format("{:{}}  {:7}  {}\n", row.pattern(), width, row.unit, meaning(row));
  }
  return out;
}

std::string metrics_json(std::span<const match::MetricRow> table) {
  Json out = Json::array();
  for (const match::MetricRow& row : table) {
    out.push_back({{"path", row.pattern()},
                   {"of", of_what(row)},
                   {"unit", row.unit},
                   {"total", row.total == match::MetricRow::Total::sum ? "sum" : "mean"},
                   {"list", row.is_list()},
                   {"part", row.part},
                   {"meaning", row.meaning}});
  }
  return out.dump(2) + '\n';
}

std::string with_metric_tables(std::string_view page, std::span<const match::MetricRow> table) {
  std::string out;
  std::vector<std::string_view> missing(match::metric_parts.begin(), match::metric_parts.end());
  while (!page.empty()) {
    const std::string_view line = take_line(page);
    out.append(line) += '\n';
    if (!line.starts_with(marker) || !line.ends_with(end_of_marker)) continue;
    const std::string_view part = line.substr(marker.size(), line.size() - marker.size() - end_of_marker.size());
    if (std::erase(missing, part) == 0) {
      throw std::invalid_argument(fmt::format("\"{}\" is no part of the metrics, or stands there twice", part));
    }
    out += '\n' + markdown_table(part, table);
    // The table that stood there.
    while (page.starts_with('\n')) take_line(page);
    while (page.starts_with('|')) take_line(page);
    if (!page.empty() && !page.starts_with('\n')) out += '\n';
  }
  if (missing.empty()) return out;
  throw std::invalid_argument(fmt::format("there is no line \"{}{}{}\"", marker, missing.front(), end_of_marker));
}

}  // namespace regista::report
