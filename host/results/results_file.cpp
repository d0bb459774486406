// SPDX-License-Identifier: MIT
#include "results/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "campaign/document_copies.hpp"
#include "campaign/inputs.hpp"
#include "command/end_of_program.hpp"
#include "output/output.hpp"
#include "study/plan_names.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::results {
namespace {

// Their names in the file.
constexpr auto schedule = "schedule";
constexpr auto resolved_teams = "documents";

std::vector<std::string> differences(const std::string& file, const std::string& before, const study::Study& now,
                                     std::span<const StudyKind> kinds) {
  const StudyKind &then = kind_of(file, before, kinds), &kind = kind_of(file, now.plan(), kinds);
  if (&then != &kind) return {fmt::format("it was {}, now {}", then.article, kind.article)};
  try {
    return now.differences(before);
  } catch (const std::invalid_argument& error) {
    throw command::BadInput(fmt::format("{}: {}", file, error.what()));
  }
}

// "; Regista 0.1.0 began it", where this is another version.
std::string other_program(const campaign::Store& store) {
  const std::string began = store.meta("program");
  return began.empty() || began == REGISTA_VERSION ? std::string() : fmt::format("; Regista {} began it", began);
}

// In a study's folder on a cluster (cluster/study_folder.hpp) other machines read it.
campaign::Journal journal_of(const std::string& file) {
  std::error_code none;
  const std::filesystem::path folder = std::filesystem::absolute(file, none).parent_path();
  return std::filesystem::exists(folder / "cluster.json", none) ? campaign::Journal::rollback : campaign::Journal::log;
}

// Values that decide nothing may be asked for otherwise, but a study is one.
void remark_on_other_values(const std::string& file, const std::string& stored, const std::string& asked) {
  const auto document = [](const std::string& plan) {
    const auto json = nlohmann::json::parse(plan, nullptr, false);
    return json.is_object() ? json.value("document", std::string()) : std::string();
  };
  if (document(stored) == document(asked) || document(stored).empty()) return;
  command::complain(fmt::format(
      "{} goes on as it was begun: what is asked for otherwise now, though it decides no match, is left out", file));
}

void remark_on(const campaign::Store& store) {
  if (const std::string remark = store.remark(); !remark.empty()) command::complain(remark);
}

template <class Open>
auto opening(Open open) {
  try {
    return open();
  } catch (const campaign::StoreRefusal& error) {
    throw command::BadInput(error.what());
  } catch (const campaign::StoreDiskError& error) {
    throw output::WriteError(error.what());
  } catch (const campaign::StoreError& error) {
    throw command::BadInput(error.what());
  }
}

}  // namespace

const StudyKind& kind_of(const std::string& file, const std::string& plan, std::span<const StudyKind> kinds) {
  const std::string study = study::study_of(plan);
  const auto found = std::ranges::find(kinds, study, &StudyKind::name);
  if (found == kinds.end()) {
    throw command::BadInput(
        fmt::format("{}: {}", file, study.empty() ? "its plan is damaged" : "these are results of another study"));
  }
  return *found;
}

std::string stored_plan(const campaign::Store& store) { return store.meta(schedule); }

void give_pairs(const std::string& file, std::uint64_t pairs, std::span<const StudyKind> kinds) {
  opening([&] {
    campaign::Store store(file, campaign::Store::Mode::open, REGISTA_VERSION, journal_of(file));
    const std::string before = store.meta(schedule);
    const StudyKind& kind = kind_of(file, before, kinds);
    if (!kind.with_pairs)
      throw command::BadInput(fmt::format("--pairs {}: {}: {} has no number of pairs", pairs, file, kind.article));
    try {
      const std::string now = kind.with_pairs(before, pairs);
      if (now != before) store.set_meta(schedule, now);
    } catch (const std::invalid_argument& error) {
      throw command::BadInput(fmt::format("--pairs {}: {}: {}", pairs, file, error.what()));
    }
  });
}

campaign::Store open_results(const std::string& file, bool resume, const study::Study& study,
                             const BegunWith& begun_with, std::span<const StudyKind> kinds) {
  std::error_code error;
  if (resume && std::filesystem::status(file, error).type() == std::filesystem::file_type::not_found) {
    throw command::BadInput(
        fmt::format("--resume: {}: no such file; without --resume it is begun", texts::one_line(file)));
  }
  return opening([&] {
    campaign::Store store(file, resume ? campaign::Store::Mode::open : campaign::Store::Mode::create, REGISTA_VERSION,
                          journal_of(file));
    remark_on(store);
    const std::string stored = store.meta(schedule);
    if (stored.empty()) {  // new, or killed before there was one
      using Json = nlohmann::json;
      store.keep(campaign::documents_in(begun_with.files));
      store.set_meta(resolved_teams, Json(begun_with.teams).dump(-1, ' ', false, Json::error_handler_t::replace));
      store.set_meta(schedule, study.plan());
      return store;
    }
    const std::vector<std::string> changed = differences(file, stored, study, kinds);
    if (changed.empty()) {
      remark_on_other_values(file, stored, study.plan());
      return store;
    }
    throw command::BadInput(
        fmt::format("--resume: {} was begun with something else: {}; its matches would be mixed with others; "
                    "--results names a new file{}",
                    file, texts::join(changed), other_program(store)));
  });
}

std::vector<std::string> stored_documents(const campaign::Store& store) {
  const std::string stored = store.meta(resolved_teams);
  if (stored.empty()) return {};
  try {
    return nlohmann::json::parse(stored).get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception&) {
    throw campaign::StoreError("the teams' documents in the results are damaged");
  }
}

campaign::Store read_results(const std::string& file) {
  return opening([&] {
    campaign::Store store(file, campaign::Store::Mode::read, REGISTA_VERSION);
    if (store.meta(schedule).empty()) throw command::BadInput(fmt::format("{}: holds no study yet", file));
    return store;
  });
}

ResultsTogether::~ResultsTogether() = default;

ResultsTogether::ResultsTogether(const std::vector<std::string>& files, std::span<const StudyKind> kinds) {
  using campaign::Store;
  if (files.size() == 1) {
    store_ = std::make_unique<Store>(read_results(files.front()));
    remark_on(*store_);
    return;
  }
  const std::string first = texts::one_line(files.front());
  try {
    folder_ = std::make_unique<process::TemporaryFolder>();
  } catch (const std::system_error& error) {
    throw output::WriteError(fmt::format("the results cannot be put together: {}", error.what()));
  }
  opening([&] {
    store_ = std::make_unique<Store>(folder_->path() / "together.db", Store::Mode::create, REGISTA_VERSION);
    for (const std::string& each : files) {
      const Store part = read_results(each);
      remark_on(part);
      const std::string name = texts::one_line(each), plan = part.meta(schedule);
      if (store_->meta(schedule).empty()) {
        store_->set_meta(resolved_teams, part.meta(resolved_teams));
        store_->set_meta(schedule, plan);
        store_->keep(part.documents());
      } else if (plan != store_->meta(schedule)) {
        const auto study = stored_study(first, *store_, {}, kinds);
        // The folders in which they were begun may differ.
        const std::vector<std::string> changed = differences(name, plan, study->study(), kinds);
        if (!changed.empty())
          throw command::BadInput(fmt::format("{} and {} are not of one study: {}", first, name, texts::join(changed)));
      }
      const campaign::Taken taken = store_->take(part, Store::Unknown::planned);
      if (taken.refused > 0) throw command::BadInput(fmt::format("{}: {}", name, taken.why.front()));
    }
  });
}

std::unique_ptr<report::StudyReport> stored_study(const std::string& file, const campaign::Store& store,
                                                  report::CommandOf again, std::span<const StudyKind> kinds) {
  if (!again) again = [](const campaign::Job&) { return std::string(); };
  return opening([&] {
    const std::string plan = store.meta(schedule);
    try {
      return kind_of(file, plan, kinds).report(plan, &store, std::move(again));
    } catch (const std::invalid_argument& error) {
      throw command::BadInput(fmt::format("{}: {}", file, error.what()));
    }
  });
}

std::vector<campaign::Job> first_jobs(study::Study& study) {
  struct Asked {
    std::vector<campaign::Job> jobs;
  };
  try {
    study.run([](const study::Round& round) {
      Asked asked;
      std::set<std::pair<std::string, std::vector<std::string>>> seen;
      for (const campaign::Store::Fixture& fixture : round.fixtures) {
        bool is_new = false;
        for (const std::string& file : {fixture.job.teams[0], fixture.job.teams[1], fixture.job.opening})
          is_new |= seen.emplace(file, fixture.job.overrides).second;
        if (is_new) asked.jobs.push_back(fixture.job);
      }
      throw asked;
    });
  } catch (const Asked& asked) {
    return asked.jobs;
  }
  return {};  // it asks for nothing
}

std::optional<campaign::Store::Row> stored_match(const campaign::Store& store, study::Study& study, std::uint64_t row) {
  const auto place = static_cast<std::int64_t>(row);
  if (auto found = store.row(place)) return found;
  // Equal matches share a row. What the first round asks for is known without any result.
  struct Asked {
    std::optional<campaign::Job> job;
  };
  try {
    study.run([row](const study::Round& round) {
      throw Asked{row <= round.matches ? std::optional(round.job(row - 1)) : std::nullopt};
    });
  } catch (const Asked& asked) {
    if (!asked.job) return std::nullopt;
    const campaign::Job& job = *asked.job;
    const std::string key = campaign::fixture_key(job.home_inputs, job.away_inputs, job.common_inputs);
    const std::int64_t number = store.numbers(std::span(&key, 1)).front();
    const auto decided = store.find(place, {number, job.seed}, campaign::Metrics::left_out);
    if (decided) return campaign::Store::Row{job, *decided};
  }
  return std::nullopt;
}

}  // namespace regista::results
