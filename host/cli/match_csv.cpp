// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/match_report.hpp"
#include "report/csv_text.hpp"

namespace regista::cli {
namespace {

using Json = nlohmann::ordered_json;

// One line for each number below; those that there are not in this match have no value.
void write(std::string& out, std::string_view side, const std::string& path, const Json& value) {
  if (value.is_number() || value.is_null()) {
    out += fmt::format("{},{},{}\n", side, report::csv_field(path), value.is_null() ? "" : value.dump());
  } else if (value.is_object()) {
    for (const auto& [name, member] : value.items()) write(out, side, path.empty() ? name : path + '.' + name, member);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) write(out, side, fmt::format("{}.{}", path, i + 1), value[i]);
  }
}

}  // namespace

std::string metrics_csv(const campaign::PlayedMatch& match) {
  Json json = Json::parse(campaign::summary_json(match));
  json.erase("wall_seconds");  // the same match, the same table
  std::string out(metrics_csv_head);
  for (const auto& [name, member] : json.items()) {
    if (member.is_number()) write(out, "", name, member);
    if (!member.is_array() || member.size() != 2) continue;
    for (const match::Side side : match::both_sides) {
      write(out, match::name(side), name == "roles" ? std::string() : name, member[match::index(side)]);
    }
  }
  return out;
}

}  // namespace regista::cli
