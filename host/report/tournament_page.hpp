// SPDX-License-Identifier: MIT
// A tournament as one page of HTML that needs nothing else: no network, no other file, no script. A function of plan,
// results in order, the pictures that were drawn, and the recordings that there are, with their place as seen from the
// page; no time of day and no running time stands in it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "match/metric_table.hpp"
#include "report/course_record.hpp"
#include "report/page_parts.hpp"
#include "report/page_recordings.hpp"
#include "report/tournament.hpp"

namespace regista::report {

// Where a recorded match is found, as seen from the page.
struct RecordingLink {
  std::string path;     // relative
  std::string command;  // that shows it, given in the folder of the page
};

struct PageSource {
  const TournamentView& view;
  const CourseRecord& record;
  std::vector<Figure> figures;
  std::vector<std::string> documents;  // resolved, by team; empty: not known
  WhatWasPlayed played;
  PlayedResults results;
  PageRecordings recordings;
  std::function<RecordingLink(std::uint64_t match)> recording;
  std::span<const match::MetricRow> metrics = match::metric_table();  // numbers of matches, as far as they have titles
};

std::string tournament_page(const PageSource& source);

}  // namespace regista::report
