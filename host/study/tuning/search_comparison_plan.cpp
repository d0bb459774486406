// SPDX-License-Identifier: MIT
#include "study/tuning/search_comparison_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "study/plan_json.hpp"
#include "study/tuning/tuning_plan_json.hpp"

namespace regista::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int plan_version = 1;
constexpr int plan_version_of_before = 1;  // of a tuning that held a comparison

std::vector<std::string> names(const std::vector<Algorithm>& algorithms) {
  std::vector<std::string> out;
  out.reserve(algorithms.size());
  for (const Algorithm each : algorithms) out.emplace_back(name(each));
  return out;
}

SearchComparisonPlan read(const Json& tuning, const Json& algorithms, const Json& repeats) {
  SearchComparisonPlan out;
  out.tuning = tuning_plan_of(tuning);
  if (!algorithms.is_array()) throw std::out_of_range("no list of algorithms");
  for (const Json& each : algorithms) out.algorithms.push_back(algorithm_of(each));
  out.repeats = campaign::whole_number(repeats);
  const bool sound = !out.algorithms.empty() && 1 <= out.repeats && out.repeats <= 1024 &&
                     std::ranges::all_of(out.algorithms, [&](Algorithm each) { return can_search(out.tuning, each); });
  if (!sound) throw std::out_of_range("a number that no comparison has");
  return out;
}

}  // namespace

std::uint64_t most_search_matches(const SearchComparisonPlan& plan) {
  return plan.runs() * plan.tuning.search_pairs * plan.tuning.matches_of_pair();
}

std::uint64_t judging_matches(const SearchComparisonPlan& plan) {
  return (plan.runs() + 1) * plan.tuning.verification_pairs * plan.tuning.matches_of_pair();  // one more: the base team
}

std::uint64_t most_matches(const SearchComparisonPlan& plan) {
  return most_search_matches(plan) + judging_matches(plan);
}

std::string to_json(const SearchComparisonPlan& plan) {
  return Json{{"study", search_comparison_study},
              {"version", plan_version},
              {"algorithms", names(plan.algorithms)},
              {"repeats", plan.repeats},
              {"tuning", json_of(plan.tuning)}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);  // names of files may be anything, JSON must be UTF-8
}

SearchComparisonPlan search_comparison_plan_from_json(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (holds_comparison_of_before(json)) {
    return read_plan(text, tuning_study, plan_version_of_before,
                     [](const Json& all) { return read(all, all.at("compared"), all.at("repeats")); });
  }
  return read_plan(text, search_comparison_study, plan_version,
                   [](const Json& all) { return read(all.at("tuning"), all.at("algorithms"), all.at("repeats")); });
}

std::vector<std::string> differences(const SearchComparisonPlan& before, const SearchComparisonPlan& now) {
  std::vector<std::string> out = differences(before.tuning, now.tuning);
  const auto compare = [&out](const char* what, const std::string& then, const std::string& today) {
    if (then != today) out.push_back(fmt::format("{}: was {}, now {}", what, then, today));
  };
  compare("--compare", fmt::format("{}", fmt::join(names(before.algorithms), ", ")),
          fmt::format("{}", fmt::join(names(now.algorithms), ", ")));
  compare("--repeats", std::to_string(before.repeats), std::to_string(now.repeats));
  return out;
}

}  // namespace regista::study
