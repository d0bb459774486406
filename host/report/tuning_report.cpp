// SPDX-License-Identifier: MIT
#include "report/tuning_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "process/program.hpp"
#include "report/tuning_figures.hpp"
#include "report/tuning_page.hpp"
#include "report/tuning_problem.hpp"

namespace regista::report {

TuningReport::TuningReport(study::TuningPlan plan, study::OutOfTime out_of_time)
    : plan_(std::move(plan)), study_(plan_, std::move(out_of_time)) {}

std::vector<std::string> TuningReport::notes() const { return problem_notes(plan_); }

std::string TuningReport::match(const study::Round& round, std::uint64_t index,
                                const campaign::Decided& decided) const {
  std::string stage = record().stage ? study::name(*record().stage) : "";
  if (record().stage == study::TuningStage::search) stage += fmt::format(" after {} points", record().trace.size());
  return match_text(stage, round.job(index), decided);
}

std::string TuningReport::incomplete() const {
  if (!record().stage) return {};
  return fmt::format("{} matches: the tuning is not at its end", study_.counted());
}

std::vector<Figure> TuningReport::figures() const { return tuning_figures(view()); }

std::string TuningReport::page(PageFrame frame) const {
  return tuning_page({view(),
                      std::move(frame.figures),
                      {frame.results.filename().string(), frame.program, fingerprint_.text(),
                       plan_.asked.search.minutes ? "The search had a limit of wall time. If that limit ended it, "
                                                    "another machine may end it at another evaluation."
                                                  : ""}});
}

}  // namespace regista::report
