// SPDX-License-Identifier: MIT
#include "report/page_recordings.hpp"

#include <string_view>

#include "recording/match_to_find.hpp"
#include "study/recording_place.hpp"

namespace regista::report {

PageRecordings page_recordings(const TournamentView& view, const CourseRecord& record,
                               const std::filesystem::path& results) {
  constexpr std::string_view kind = "opening ";  // before the name of an opening as an input of matches
  PageRecordings out;
  out.not_read = record.recorded_matches() - record.recorded().size();
  for (const RecordedRow& each : record.recorded()) {
    const study::Fixture fixture = view.course.calendar().at(each.index);
    recording::MatchToFind match{
        fixture.seed, {view.plan.teams[fixture.home].label, view.plan.teams[fixture.away].label}, "", {}, {}};
    if (!view.plan.openings.empty()) {
      const std::string& input = view.plan.openings[fixture.opening].input.name;
      match.opening = input.starts_with(kind) ? input.substr(kind.size()) : input;
    }
    if (!each.forfeited) {
      match.score = each.score;
      match.packets = each.packets;
    }
    if (recording::holds(study::recording_file(results, static_cast<std::int64_t>(each.index) + 1), match)) {
      out.fitting.push_back(each);
    }
  }
  return out;
}

}  // namespace regista::report
