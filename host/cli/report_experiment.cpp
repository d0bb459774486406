// SPDX-License-Identifier: MIT
#include "cli/report_experiment.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "campaign/shell.hpp"
#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "cli/stored_trials.hpp"
#include "cli/study_run.hpp"
#include "report/experiment.hpp"
#include "report/experiment_figures.hpp"
#include "report/experiment_page.hpp"
#include "report/fingerprint.hpp"
#include "study/experiment.hpp"

namespace regista::cli {
namespace {

// In pieces, so that many rows need no memory.
constexpr std::size_t piece = std::size_t{1} << 20;

}  // namespace

int tell_experiment(const StoredResults& results, const ExperimentWishes& wishes, const Invocation& invocation) {
  const auto& plan = std::get<study::ExperimentPlan>(results.plan);
  study::Experiment course(plan);
  const report::ExperimentView view{plan, course, [&](std::uint64_t index) {
                                      return play_again(study::job(plan, study::trial(plan, index)), invocation);
                                    }};
  try {
    std::string csv = wishes.csv ? report::experiment_csv_head(plan) : std::string();
    stored_trials(results.store, plan, [&](std::uint64_t index, const campaign::Decided& decided) {
      course.take(decided);
      if (!wishes.csv) return;
      csv += report::experiment_csv_lines(plan, index, decided,
                                          wishes.metrics ? report::CsvMeasures::all : report::CsvMeasures::shown);
      if (csv.size() <= piece) return;
      print(csv);
      csv.clear();
    });
    if (!course.complete()) complain(not_at_its_end(results, "experiment", course.taken(), plan.matches()));
    if (wishes.csv)
      print(csv);
    else
      print(wishes.json ? report::experiment_json(view) : report::experiment_text(view));
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  } catch (const std::invalid_argument& error) {
    throw BadInput(damaged_metrics(results.file.string(), error));
  }
  return exit_done;
}

ToldStudy told_experiment(const StoredResults& results) {
  const auto& plan = std::get<study::ExperimentPlan>(results.plan);
  const auto course = std::make_shared<study::Experiment>(plan);
  report::Fingerprint fingerprint;
  stored_trials(results.store, plan, [&](std::uint64_t index, const campaign::Decided& decided) {
    course->take(decided);
    fingerprint.take(index, decided);
  });
  ToldStudy out;
  if (!course->complete()) out.incomplete = not_at_its_end(results, "experiment", course->taken(), plan.matches());
  const auto view = [course, &plan]() -> report::ExperimentView {
    return {plan, *course, [&plan](std::uint64_t index) {
              return campaign::command_line(campaign::match_arguments(study::job(plan, study::trial(plan, index))));
            }};
  };
  out.figures = report::experiment_figures(view());
  out.page = [view, fingerprint, &results, &plan](const std::filesystem::path&,
                                                  std::vector<report::PageFigure> figures) {
    return report::experiment_page({view(), std::move(figures), results.store.meta("program"), fingerprint.text(),
                                    campaign::command_line(report::experiment_arguments(plan))});
  };
  return out;
}

}  // namespace regista::cli
