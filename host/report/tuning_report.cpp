// SPDX-License-Identifier: MIT
#include "report/tuning_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "campaign/shell.hpp"
#include "config/text.hpp"
#include "report/tournament.hpp"
#include "report/tuning_figures.hpp"
#include "report/tuning_page.hpp"
#include "study/tuning/tuning_setup.hpp"

namespace regista::report {
namespace {

std::string team_of(const campaign::Job& job, std::size_t side) {
  return std::filesystem::path(job.teams[side]).stem().string();
}

}  // namespace

TuningReport::TuningReport(study::TuningPlan plan, std::function<bool(std::uint64_t evaluations)> out_of_time)
    : plan_(std::move(plan)), study_(plan_, std::move(out_of_time)) {}

std::vector<std::string> TuningReport::notes() const {
  std::vector<std::string> out;
  for (const std::string& each : study::notes_on(plan_)) out.push_back("note: " + config::one_line(each));
  return out;
}

std::string TuningReport::match(const study::Round& round, std::uint64_t index,
                                const campaign::Decided& decided) const {
  std::string out = record().stage ? study::name(*record().stage) : "";
  if (record().stage == study::TuningStage::search && !plan_.compares()) {
    out += fmt::format(" after {} points", record().trace.size());
  }
  const campaign::Job job = round.job(index);
  out += fmt::format(", seed {}: {} {}:{} {}", job.seed, team_of(job, 0), decided.score[0], decided.score[1],
                     team_of(job, 1));
  if (decided.set_aside()) out += ", could not be played: " + decided.why_set_aside;
  if (decided.failure) {
    const auto side = static_cast<std::size_t>(decided.failure->side);
    out += ", " + forfeit_text(team_of(job, side), *decided.failure);
  }
  return config::one_line(out);
}

std::string TuningReport::incomplete() const {
  if (!record().stage) return {};
  return fmt::format("{} matches: the tuning is not at its end", study_.counted());
}

std::vector<Figure> TuningReport::figures() const { return tuning_figures(view()); }

std::string TuningReport::page(PageFrame frame) const {
  return tuning_page({view(), std::move(frame.figures), frame.program, fingerprint_.text(),
                      campaign::command_line(tuning_arguments(plan_))});
}

}  // namespace regista::report
