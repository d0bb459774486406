// SPDX-License-Identifier: MIT
#include "cli/tournament_files.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "cli/end_of_program.hpp"
#include "config/text.hpp"

namespace regista::cli {
namespace {

// Their names in the file.
constexpr auto schedule = "schedule";
constexpr auto teams_documents = "documents";

study::TournamentPlan plan_of(const std::string& file, const std::string& stored) {
  try {
    return study::tournament_plan_from_json(stored);
  } catch (const std::invalid_argument& error) {
    throw BadInput(fmt::format("{}: {}", file, error.what()));
  }
}

template <class Open>
auto opening(Open open) {
  try {
    return open();
  } catch (const campaign::StoreRefusal& error) {
    throw BadInput(error.what());
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
}

}  // namespace

campaign::Store open_results(const std::string& file, bool resume, const study::TournamentPlan& plan,
                             const std::vector<std::string>& documents) {
  return opening([&] {
    campaign::Store store(file, resume ? campaign::Store::Mode::open : campaign::Store::Mode::create, REGISTA_VERSION);
    const std::string stored = store.meta(schedule);
    if (stored.empty()) {  // new, or killed before there was one
      using Json = nlohmann::json;
      store.set_meta(teams_documents, Json(documents).dump(-1, ' ', false, Json::error_handler_t::replace));
      store.set_meta(schedule, study::to_json(plan));
      return store;
    }
    const std::vector<std::string> changed = study::differences(plan_of(file, stored), plan);
    if (changed.empty()) return store;
    throw BadInput(
        fmt::format("--resume: {} was begun with something else: {}; its matches would be mixed with others; "
                    "--results names a new file",
                    file, config::join(changed)));
  });
}

std::vector<std::string> stored_documents(const campaign::Store& store) {
  const std::string stored = store.meta(teams_documents);
  if (stored.empty()) return {};
  try {
    return nlohmann::json::parse(stored).get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception&) {
    throw campaign::StoreError("the teams' documents in the results are damaged");
  }
}

std::string damaged_metrics(const std::string& file, const std::invalid_argument& error) {
  return fmt::format("results in {} are damaged: metrics: {}", file, error.what());
}

StoredTournament read_results(const std::string& file) {
  return opening([&] {
    campaign::Store store(file, campaign::Store::Mode::read, REGISTA_VERSION);
    const std::string stored = store.meta(schedule);
    if (stored.empty()) throw BadInput(fmt::format("{}: holds no tournament yet", file));
    return StoredTournament{std::move(store), plan_of(file, stored)};
  });
}

}  // namespace regista::cli
