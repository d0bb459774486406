// SPDX-License-Identifier: MIT
#include "report/tuning_report.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "report/match_remarks.hpp"
#include "study/tuning/tuning_setup.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

std::string team_of(const campaign::Job& job, std::size_t side) {
  return std::filesystem::path(job.teams[side]).stem().string();
}

}  // namespace

Outline TuningReport::page_outline(const PageFiles& /*files*/) const {
  Outline out = outline();
  out.fingerprint = fingerprint_.text();
  return out;
}

std::vector<std::string> TuningReport::notes() const {
  std::vector<std::string> out;
  for (const std::string& each : study::notes_on(plan_)) out.push_back("note: " + texts::one_line(each));
  return out;
}

// "search after 3 points, seed 12: small 1:0 other"
std::string TuningReport::match(const study::Round& round, std::uint64_t index,
                                const campaign::Decided& decided) const {
  std::string out = record().stage ? study::name(*record().stage) : "";
  if (record().stage == study::TuningStage::search) out += fmt::format(" after {} points", record().trace.size());
  const campaign::Job job = round.job(index);
  out += fmt::format(", seed {}: {} {}:{} {}", job.seed, team_of(job, 0), decided.score[0], decided.score[1],
                     team_of(job, 1));
  if (decided.set_aside()) out += ", could not be played: " + decided.why_set_aside;
  if (decided.failure)
    out += ", " + forfeit_text(team_of(job, static_cast<std::size_t>(decided.failure->side)), *decided.failure);
  return texts::one_line(out);
}

std::string TuningReport::incomplete() const {
  if (!record().stage) return {};
  return fmt::format("{} matches: the tuning is not at its end", study_.counted());
}

}  // namespace regista::report
