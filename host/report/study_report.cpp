// SPDX-License-Identifier: MIT
#include "report/study_report.hpp"

#include <fmt/format.h>

#include "plugin/shared_object.hpp"

namespace regista::report {

std::string stem(const std::string& file) { return std::filesystem::path(file).stem().string(); }

std::string scene_name(const std::vector<study::Opening>& openings, std::size_t opening) {
  return openings.empty() ? std::string() : stem(openings[opening].file);
}

Outline StudyReport::page_outline(const PageFiles& /*files*/) const {
  Outline out = outline();
  out.fingerprint = fingerprint();
  return out;
}

MatchPlayers StudyReport::players(const study::Round& round, std::uint64_t index) const {
  const campaign::Job job = round.job(index);
  return {{stem(job.teams[0]), stem(job.teams[1])}, stem(job.opening), job.seed};
}

void Fingerprint::take(std::uint64_t index, const campaign::MatchResult& decided) {
  std::string line = fmt::format("{} {} {}:{} {}", text_, index, decided.score[0], decided.score[1], decided.hash);
  if (decided.failure) line += campaign::to_json(*decided.failure);
  if (decided.set_aside()) line += " set aside";
  text_ = plugin::content_hash(line);
}

}  // namespace regista::report
