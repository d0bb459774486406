// SPDX-License-Identifier: MIT
// What a tournament found: a function of its plan and its results in order, equal to the byte whether or not it was
// stopped and by however many workers it was played. The lines of two teams have the form that users of the test frames
// of chess engines know.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "match/metric_table.hpp"
#include "report/course_record.hpp"
#include "report/match_remarks.hpp"
#include "report/outline.hpp"
#include "report/page_recordings.hpp"
#include "report/tournament.hpp"

namespace regista::report {

// What a page shows besides: how it came there, and what else there is to look at.
struct TournamentPage {
  const CourseRecord& record;
  std::vector<std::string> documents;  // resolved, by team; empty: not known
  PageRecordings recordings;
  std::function<RecordingLink(std::uint64_t match)> link_to;
  std::span<const match::MetricRow> metrics = match::metric_table();  // numbers of matches, as far as they have titles
};

Outline tournament_outline(const TournamentView& view, const TournamentPage* page = nullptr);
nlohmann::ordered_json tournament_data(const TournamentView& view);  // for programs

// Its sections, each empty where there is nothing to show.
Section standing_section(const TournamentView& view);  // where the teams stand
Section curves_section(const TournamentView& view);    // Elo and test over pairs
Section variance_section(const TournamentView& view);  // what pairing gained
Section goals_section(const TournamentView& view, const CourseRecord& record);
Section roles_section(const TournamentView& view, const CourseRecord& record,
                      std::span<const match::MetricRow> metrics);  // overlap, uncovered, switches
Section packets_section(const TournamentView& view, const CourseRecord* record);
Section plugins_section(const TournamentView& view, const CourseRecord& record);  // numbers that plugins report
Section recordings_section(const TournamentView& view, const PageRecordings& recordings,
                           const std::function<RecordingLink(std::uint64_t match)>& link_to);

ForfeitWords forfeit_words(const TournamentView& view);
std::string scene_of(const TournamentView& view, const study::Fixture& fixture);  // empty: from kick-off

}  // namespace regista::report
