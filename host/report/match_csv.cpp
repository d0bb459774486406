// SPDX-License-Identifier: MIT
// The numbers of a match as a table: a line for each.
#include <fmt/format.h>

#include "report/csv_text.hpp"
#include "report/match_summary.hpp"

namespace regista::report {

std::string metrics_csv(const campaign::PlayedMatch& match, std::span<const match::MetricRow> table) {
  std::string out = fmt::format("{},seed,{}\n", metrics_csv_head, match.seed);
  const match::MetricNumbers numbers = campaign::numbers_of(match, table);
  for (std::size_t i = 0; i < numbers.names().size(); ++i) {
    const auto side = numbers.names()[i].side;
    out += fmt::format("{},{},", side ? match::name(*side) : "", csv_field(numbers.names().path(i)));
    if (const auto value = numbers.at(i)) out += fmt::format("{}", *value);
    out += '\n';
  }
  return out;
}

}  // namespace regista::report
