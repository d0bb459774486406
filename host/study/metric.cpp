// SPDX-License-Identifier: MIT
#include "study/metric.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace regista::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view roles = "roles";

Json parsed(const std::string& metrics) {
  try {
    return Json::parse(metrics);
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

// What the side has under a top member; null when that is not by side.
const Json& of_side(const Json& member, int side) {
  static const Json nothing;
  return member.is_array() && member.size() == 2 ? member[static_cast<std::size_t>(side)] : nothing;
}

// A path, and what a match has there: a number, or null where there is none this time.
struct Place {
  std::string path;
  const Json* value;
};

void collect(const Json& value, const std::string& path, std::vector<Place>& out) {
  if (value.is_number() || value.is_null()) out.push_back({path, &value});
  if (!value.is_object()) return;
  for (const auto& [name, member] : value.items()) collect(member, path.empty() ? name : path + '.' + name, out);
}

std::vector<Place> places(const Json& metrics, int side) {
  std::vector<Place> out;
  if (!metrics.is_object()) return out;
  for (const auto& [name, member] : metrics.items()) {
    if (member.is_array() && member.size() == 2) {
      collect(member[static_cast<std::size_t>(side)], name == roles ? std::string() : name, out);
    }
  }
  return out;
}

std::vector<NamedValue> values(const Json& metrics, int side) {
  std::vector<NamedValue> out;
  for (Place& each : places(metrics, side)) {
    if (each.value->is_number()) out.push_back({std::move(each.path), each.value->get<double>()});
  }
  return out;
}

// The last part of a role's path: what all of them have.
std::vector<NamedValue> sums_over_roles(const Json& metrics, int side) {
  std::vector<NamedValue> out;
  if (!metrics.is_object() || !metrics.contains(roles)) return out;
  for (const auto& [role, numbers] : of_side(metrics.at(std::string(roles)), side).items()) {
    if (!numbers.is_object()) continue;
    for (const auto& [name, number] : numbers.items()) {
      if (!number.is_number()) continue;
      const auto known = std::ranges::find(out, name, &NamedValue::path);
      if (known == out.end())
        out.push_back({name, number.get<double>()});
      else
        known->value += number.get<double>();
    }
  }
  return out;
}

std::vector<NamedValue> all(const Json& metrics, int side) {
  std::vector<NamedValue> out = values(metrics, side);
  for (NamedValue& sum : sums_over_roles(metrics, side)) {
    if (std::ranges::find(out, sum.path, &NamedValue::path) == out.end()) out.push_back(std::move(sum));
  }
  return out;
}

}  // namespace

std::string without_roles(const std::string& path) {
  const std::string_view prefix = "roles.";
  return path.starts_with(prefix) ? path.substr(prefix.size()) : path;
}

std::optional<double> metric(const std::string& metrics, int side, const std::string& path) {
  const std::string wanted = without_roles(path);
  const std::vector<NamedValue> known = all(parsed(metrics), side);
  const auto found = std::ranges::find(known, wanted, &NamedValue::path);
  return found == known.end() ? std::nullopt : std::optional(found->value);
}

std::vector<std::string> metric_paths(const std::string& metrics, int side) {
  std::vector<std::string> out = metric_names(metrics, side);
  for (NamedValue& sum : sums_over_roles(parsed(metrics), side)) {
    if (std::ranges::find(out, sum.path) == out.end()) out.push_back(std::move(sum.path));
  }
  return out;
}

std::vector<std::string> metric_names(const std::string& metrics, int side) {
  const Json json = parsed(metrics);
  std::vector<std::string> out;
  for (Place& each : places(json, side)) out.push_back(std::move(each.path));
  return out;
}

std::vector<NamedValue> metric_values(const std::string& metrics, int side) { return values(parsed(metrics), side); }

std::vector<NamedValue> all_metric_values(const std::string& metrics, int side) { return all(parsed(metrics), side); }

std::optional<double> match_number(const std::string& metrics, const std::string& name) {
  const Json json = parsed(metrics);
  const auto found = json.find(name);
  if (found == json.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

}  // namespace regista::study
