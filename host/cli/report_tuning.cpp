// SPDX-License-Identifier: MIT
#include "cli/report_tuning.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "campaign/shell.hpp"
#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "cli/stored_tuning.hpp"
#include "report/fingerprint.hpp"
#include "report/tuning.hpp"
#include "report/tuning_figures.hpp"
#include "report/tuning_page.hpp"

namespace regista::cli {
namespace {

struct Told {
  explicit Told(const study::TuningPlan& plan) : record(plan) {}
  study::TuningRecord record;
  report::Fingerprint fingerprint;
  std::uint64_t matches = 0;
};

std::shared_ptr<const Told> told(const StoredResults& results) {
  const auto& plan = std::get<study::TuningPlan>(results.plan);
  const auto out = std::make_shared<Told>(plan);
  stored_tuning(results.store, plan, out->record, [&](std::uint64_t row, const campaign::Decided& decided) {
    out->fingerprint.take(row, decided);
    ++out->matches;
  });
  return out;
}

std::string incomplete(const StoredResults& results, const Told& told) {
  if (!told.record.stage) return {};
  return fmt::format("{} holds {} matches: the tuning is not at its end", results.file.string(), told.matches);
}

}  // namespace

int tell_tuning(const StoredResults& results, const TuningWishes& wishes) {
  const auto& plan = std::get<study::TuningPlan>(results.plan);
  try {
    const auto found = told(results);
    const std::string not_at_end = incomplete(results, *found);
    if (!not_at_end.empty()) complain(not_at_end);
    const report::TuningView view{plan, found->record, ""};
    print(wishes.csv ? report::tuning_csv(view) : wishes.json ? report::tuning_json(view) : report::tuning_text(view));
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  } catch (const std::invalid_argument& error) {
    throw BadInput(damaged_metrics(results.file.string(), error));
  }
  return exit_done;
}

ToldStudy told_tuning(const StoredResults& results) {
  const auto& plan = std::get<study::TuningPlan>(results.plan);
  const auto found = told(results);
  ToldStudy out;
  out.incomplete = incomplete(results, *found);
  const auto view = [found, &plan]() -> report::TuningView { return {plan, found->record, ""}; };
  out.figures = report::tuning_figures(view());
  out.page = [found, view, &results, &plan](const std::filesystem::path&, std::vector<report::PageFigure> figures) {
    return report::tuning_page({view(), std::move(figures), results.store.meta("program"), found->fingerprint.text(),
                                campaign::command_line(report::tuning_arguments(plan))});
  };
  return out;
}

}  // namespace regista::cli
