// SPDX-License-Identifier: MIT
#include "output/own_kind.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <fstream>
#include <string>
#include <system_error>

#include "mcap/format.hpp"
#include "recording/decision_log.hpp"
#include "recording/roles_svg.hpp"
#include "report/match_summary.hpp"
#include "report/tuned_file.hpp"

namespace regista::output {
namespace {

using Begins = std::string_view;

constexpr std::array recording{Begins(mcap::magic.substr(0, mcap::version_in_magic))};
constexpr std::array decisions{recording::decision_log_begin};
constexpr std::array metrics{report::metrics_csv_head};
constexpr std::array match_table{Begins("row,arm")};                  // report::experiment_csv_head
constexpr std::array summary_table{Begins("measure,unit,arm")};       // report::experiment_summary_csv
constexpr std::array search_table{Begins("evaluation,pairs_from,")};  // tuning_csv
constexpr std::array tuned_team{report::tuned_file_begin};
constexpr std::array markup{Begins("<")};
constexpr Begins database = "SQLite format 3";

}  // namespace

OwnKind own_kind(Writes what) {
  switch (what) {
    case Writes::recording:
      return {.what = "recording", .begins = recording, .needs_force = true};
    case Writes::decisions:
      return {.what = "log of decisions", .begins = decisions};
    case Writes::metrics:
      return {.what = "table of metrics", .begins = metrics, .moved_to_its_place = true};
    case Writes::match_table:
      return {.what = "table of matches", .begins = match_table, .replaces_others = true};
    case Writes::summary_table:
      return {.what = "table of means", .begins = summary_table, .replaces_others = true};
    case Writes::search_table:
      return {.what = "table of a search", .begins = search_table, .replaces_others = true};
    case Writes::tuned_team:
      return {.what = "team that a tuning wrote",
              .begins = tuned_team,
              .replaces_others = true,
              .moved_to_its_place = true,
              .advice = "--output names another file"};
    case Writes::page:
      return {.what = "page or picture", .begins = markup, .needs_force = true, .moved_to_its_place = true};
    case Writes::drawing:
      return {.what = "drawing of roles",
              .begins = markup,
              .needs_force = true,
              .cheap = recording::roles_svg_begin,
              .moved_to_its_place = true};
    case Writes::results:
    case Writes::figures:
    case Writes::sources:
      break;
  }
  assert(false);
  return {};
}

bool is_database(const std::filesystem::path& file) {
  std::array<char, database.size()> begin{};
  std::ifstream in(file, std::ios::binary);
  return in.read(begin.data(), begin.size()) && Begins(begin.data(), begin.size()) == database;
}

Found found_in(const std::filesystem::path& file, const OwnKind& kind) {
  std::error_code none;
  if (std::filesystem::file_size(file, none) == 0) return Found::nothing;
  const auto longest = std::ranges::max(kind.begins, {}, &std::string_view::size).size();
  std::string beginning(std::max({longest, database.size(), kind.cheap.size()}), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  const auto begins = [&](std::string_view each) { return beginning.starts_with(each); };
  if (!kind.cheap.empty() && begins(kind.cheap)) return Found::cheap;
  if (std::ranges::any_of(kind.begins, begins)) return Found::own;
  return begins(database) ? Found::database : Found::other;
}

}  // namespace regista::output
