// SPDX-License-Identifier: MIT
#include "cli/results_file.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <type_traits>
#include <utility>

#include "campaign/inputs.hpp"
#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "config/text.hpp"
#include "study/plan_json.hpp"

namespace regista::cli {
namespace {

// Their names in the file.
constexpr auto schedule = "schedule";
constexpr auto teams_documents = "documents";

StudyPlan plan_of(const std::string& file, const std::string& stored) {
  try {
    if (study::study_of(stored) == study::experiment_study) return study::experiment_plan_from_json(stored);
    if (study::study_of(stored) == study::tuning_study) return study::tuning_plan_from_json(stored);
    return study::tournament_plan_from_json(stored);
  } catch (const std::invalid_argument& error) {
    throw BadInput(fmt::format("{}: {}", file, error.what()));
  }
}

const char* with_article(const StudyPlan& plan) {
  constexpr std::array names{"a tournament", "an experiment", "a tuning"};
  return names[plan.index()];
}

std::vector<std::string> differences(const StudyPlan& before, const StudyPlan& now) {
  if (before.index() != now.index()) return {fmt::format("it was {}, now {}", with_article(before), with_article(now))};
  return std::visit(
      [&](const auto& plan) { return study::differences(std::get<std::decay_t<decltype(plan)>>(before), plan); }, now);
}

std::string json_of(const StudyPlan& plan) {
  return std::visit([](const auto& each) { return study::to_json(each); }, plan);
}

template <class Open>
auto opening(Open open) {
  try {
    return open();
  } catch (const campaign::StoreRefusal& error) {
    throw BadInput(error.what());
  } catch (const campaign::StoreDiskError& error) {
    throw WriteError(error.what());
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
}

}  // namespace

campaign::Store open_results(const std::string& file, bool resume, const StudyPlan& plan,
                             const std::vector<std::string>& documents) {
  std::error_code error;
  if (resume && std::filesystem::status(file, error).type() == std::filesystem::file_type::not_found) {
    throw BadInput(fmt::format("--resume: {}: no such file; without --resume it is begun", config::one_line(file)));
  }
  return opening([&] {
    campaign::Store store(file, resume ? campaign::Store::Mode::open : campaign::Store::Mode::create, REGISTA_VERSION);
    const std::string stored = store.meta(schedule);
    if (stored.empty()) {  // new, or killed before there was one
      using Json = nlohmann::json;
      store.set_meta(teams_documents, Json(documents).dump(-1, ' ', false, Json::error_handler_t::replace));
      store.set_meta(schedule, json_of(plan));
      return store;
    }
    const std::vector<std::string> changed = differences(plan_of(file, stored), plan);
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

std::uint64_t matches(const StudyPlan& plan) {
  if (const auto* const tuning = std::get_if<study::TuningPlan>(&plan)) return study::most_matches(*tuning);
  if (const auto* const tournament = std::get_if<study::TournamentPlan>(&plan)) return tournament->matches();
  return std::get<study::ExperimentPlan>(plan).matches();
}

std::optional<campaign::Store::Row> stored_match(const StoredStudy& study, std::uint64_t row) {
  const auto place = static_cast<std::int64_t>(row);
  // What a tuning plays depends on what came before: the file alone knows.
  if (std::holds_alternative<study::TuningPlan>(study.plan)) return study.store.row(place);
  campaign::Job job;
  if (const auto* const tournament = std::get_if<study::TournamentPlan>(&study.plan)) {
    job = study::job(*tournament, study::Calendar(*tournament).at(row - 1));
  } else {
    const auto& experiment = std::get<study::ExperimentPlan>(study.plan);
    job = study::job(experiment, study::trial(experiment, row - 1));
  }
  // Equal matches share a row.
  const std::string key = campaign::fixture_key(job.home_inputs, job.away_inputs, job.common_inputs);
  const std::int64_t number = study.store.numbers(std::span(&key, 1)).front();
  const auto decided = study.store.find(place, {number, job.seed}, campaign::Metrics::left_out);
  if (!decided) return std::nullopt;
  return campaign::Store::Row{std::move(job), *decided};
}

const std::string& folder(const StudyPlan& plan) {
  return std::visit([](const auto& each) -> const std::string& { return each.folder; }, plan);
}

const campaign::Limits& limits(const StudyPlan& plan) {
  return std::visit([](const auto& each) -> const campaign::Limits& { return each.limits; }, plan);
}

std::string damaged_metrics(const std::string& file, const std::invalid_argument& error) {
  return fmt::format("results in {} are damaged: metrics: {}", file, error.what());
}

StoredStudy read_results(const std::string& file) {
  return opening([&] {
    campaign::Store store(file, campaign::Store::Mode::read, REGISTA_VERSION);
    const std::string stored = store.meta(schedule);
    if (stored.empty()) throw BadInput(fmt::format("{}: holds no study yet", file));
    return StoredStudy{std::move(store), plan_of(file, stored)};
  });
}

}  // namespace regista::cli
