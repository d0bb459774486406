// SPDX-License-Identifier: MIT
// The report of a tournament. For two teams its lines have the form that testers of chess engines know.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "match/metric_numbers.hpp"
#include "match/metric_table.hpp"
#include "report/match_remarks.hpp"
#include "report/outline.hpp"
#include "report/study_report.hpp"
#include "report/tournament_history.hpp"
#include "study/tournament_course.hpp"
#include "study/tournament_plan.hpp"

namespace regista::report {

struct TournamentView {
  const study::TournamentPlan& plan;
  const study::Tournament& course;
  // Returns the command that plays one match of the schedule.
  std::function<std::string(std::uint64_t match)> again;

  const std::string& shown(std::size_t team) const { return plan.teams[team].shown(); }  // for people
  const std::string& label(std::size_t team) const { return plan.teams[team].label; }    // for JSON and CSV
};

WhatWasPlayed what_was_played(const study::TournamentPlan& plan);

// Returns "match", or "scene" if the games begin from an opening.
const char* game_word(const study::TournamentPlan& plan);
const char* games_word(const study::TournamentPlan& plan);  // "matches", "scenes"

// Returns a title such as "paper vs fixed_rate", followed by number and kind of pairs.
std::string title(const TournamentView& view);

// The result for readers who know football and no statistics.
struct TournamentVerdict {
  Sentence sentence;
  std::vector<Sentence> beside;  // sentences about the data behind the result and about its limits
};

// Returns the verdict. A finding needs a test that was fixed before the first match and has ended. This is a sequential
// test or, for a fixed number of pairs, an exact sign-flip test of the pairs' goal differences at 5 %, adjusted by Holm
// for the number of pairings. The goal difference has Student's interval. Without a finding, the text says how many
// pairs would find a difference of half a goal per game.
TournamentVerdict tournament_verdict(const TournamentView& view);

// Returns the state of a running tournament for a live display. Every line has a line end.
std::string standing_text(const TournamentView& view);

// --- Recordings of the tournament's matches. The folder of recordings may have recordings of other matches: of deleted
// results, of killed workers, of matches after the end of a test. The page lists only recordings that fit the results.

struct PageRecordings {
  std::vector<RecordedRow> fitting;  // matches whose recordings equal the stored matches
  std::uint64_t not_read = 0;        // number of files beyond the first TournamentHistory::most_recorded
};

struct RecordingLink {
  std::string path;     // relative to the page
  std::string command;  // command that shows the recording, to be run in the folder of the page
};

PageRecordings page_recordings(const TournamentView& view, const TournamentHistory& record,
                               const std::filesystem::path& results);

// Inputs of the tournament's page. The text and the JSON do without these inputs.
struct TournamentPage {
  const TournamentHistory& record;
  std::vector<std::string> documents;  // resolved document of each team; empty list: unknown
  PageRecordings recordings;
  std::function<RecordingLink(std::uint64_t match)> link_to;
  std::span<const match::MetricRow> metrics = match::metric_table();  // metrics with their titles
};

Outline tournament_outline(const TournamentView& view, const TournamentPage* page = nullptr);

// Returns the figures that have data. For two teams: curves over pairs named "elo", "llr" (if the test uses scores) or
// "value" (goals or the tested metric), and "goal_differences", "roles", "packets". For more teams: "ranking", "elo".
std::vector<Figure> tournament_figures(const TournamentView& view, const TournamentHistory& record);

// These sections are empty without data.
Section standing_section(const TournamentView& view);  // where the teams stand
Section rounds_section(const TournamentView& view);    // who met in each round of a Swiss tournament or a knock-out
Section curves_section(const TournamentView& view);    // curves of Elo and of the test over pairs
Section variance_section(const TournamentView& view);  // how much the play in pairs reduces the variance
Section goals_section(const TournamentView& view, const TournamentHistory& record);
Section roles_section(const TournamentView& view, const TournamentHistory& record,
                      std::span<const match::MetricRow> metrics);  // numbers of roles, such as overlap and switches
Section packets_section(const TournamentView& view, const TournamentHistory* record);
Section plugins_section(const TournamentView& view, const TournamentHistory& record);  // numbers that plugins report
Section recordings_section(const TournamentView& view, const PageRecordings& recordings,
                           const std::function<RecordingLink(std::uint64_t match)>& link_to);

using TeamText = const std::string& (TournamentView::*)(std::size_t team) const;
ForfeitWords forfeit_words(const TournamentView& view, TeamText name);

// Returns the metrics of a table without the option --metrics: for short games packets and their share of the budget.
match::MetricPaths csv_metrics(const study::TournamentPlan& plan);

// A table with a row for each match in the order of the schedule (RFC 4180, but lines end with \n). The last columns
// are the metrics: first the metrics of the teams, then the metrics of the match.
std::string csv_head(const match::MetricPaths& metrics);
std::string csv_line(const TournamentView& view, std::uint64_t index, const campaign::MatchResult& decided,
                     match::MetricColumns& metrics);

// Returns "H1", "H0", "INCONCLUSIVE" or "NO_VERDICT" (unplayed pairs prevent a verdict); empty without a test.
const char* name(study::Verdict verdict);

// again: makes the command with which the reader of the report plays a match again.
std::unique_ptr<StudyReport> tournament_report(study::TournamentPlan plan, CommandOf again);

}  // namespace regista::report
