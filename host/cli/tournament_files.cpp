// SPDX-License-Identifier: MIT
#include "cli/tournament_files.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "campaign/job.hpp"
#include "cli/end_of_program.hpp"
#include "config/text.hpp"

namespace regista::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto schedule = "schedule";  // its name in the file

Json json_of(const TournamentPlan& plan) {
  return {{"study", "tournament"},
          {"files", plan.files},
          {"pairs", plan.pairs},
          {"first_seed", plan.first_seed},
          {"a", Json::parse(campaign::to_json(plan.teams[0]))},
          {"b", Json::parse(campaign::to_json(plan.teams[1]))},
          {"common", Json::parse(campaign::to_json(plan.common))}};
}

// What the plan of a file has otherwise, in words.
std::vector<std::string> differences(const Json& stored, const TournamentPlan& plan) {
  std::vector<std::string> out;
  const auto number = [&](const char* key, const char* name, std::uint64_t now) {
    const auto before = stored.at(key).get<std::uint64_t>();
    if (before != now) out.push_back(fmt::format("{} was {}, now {}", name, before, now));
  };
  number("pairs", "--pairs", plan.pairs);
  number("first_seed", "--seed", plan.first_seed);
  const auto inputs = [&](const char* key, const std::vector<campaign::Input>& now, const char* whose) {
    const auto before = campaign::inputs_from_json(stored.at(key).dump());
    for (const std::string& each : campaign::differences(before, now)) out.push_back(whose + each);
  };
  inputs("a", plan.teams[0], "first team: ");
  inputs("b", plan.teams[1], "second team: ");
  inputs("common", plan.common, "");
  return out;
}

void require_same(const std::string& file, const std::string& stored, const TournamentPlan& plan) {
  std::vector<std::string> changed;
  try {
    const Json json = Json::parse(stored);
    if (json.at("study") != "tournament") {
      throw BadInput(fmt::format("--resume: {} holds results of another study", file));
    }
    changed = differences(json, plan);
  } catch (const Json::exception&) {
    throw BadInput(fmt::format("--resume: the plan in {} is damaged", file));
  } catch (const std::invalid_argument&) {
    throw BadInput(fmt::format("--resume: the plan in {} is damaged", file));
  }
  if (changed.empty()) return;
  throw BadInput(
      fmt::format("--resume: {} was begun with something else: {}; its matches would be mixed with others; "
                  "--results names a new file",
                  file, config::join(changed)));
}

}  // namespace

campaign::Store open_results(const std::string& file, bool resume, const TournamentPlan& plan) {
  try {
    campaign::Store store(file, resume ? campaign::Store::Mode::open : campaign::Store::Mode::create, REGISTA_VERSION);
    const std::string stored = store.meta(schedule);
    // None: the program was killed before it had written one.
    if (stored.empty())
      store.set_meta(schedule, json_of(plan).dump());
    else
      require_same(file, stored, plan);
    return store;
  } catch (const campaign::StoreRefusal& error) {
    throw BadInput(error.what());
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
}

}  // namespace regista::cli
