// SPDX-License-Identifier: MIT
// What is said about a tournament: a function of its plan and its results in order, equal to the byte however often it
// was stopped and by however many workers it was played. The block of two teams has the form that users of the test
// frames of chess engines know.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "match/metric_columns.hpp"
#include "report/what_was_played.hpp"
#include "study/tournament.hpp"
#include "study/tournament_plan.hpp"

namespace regista::report {

struct TournamentView {
  const study::TournamentPlan& plan;
  const study::Tournament& course;
  // The command that plays a match of the schedule by itself.
  std::function<std::string(std::uint64_t match)> again;

  const std::string& label(std::size_t team) const { return plan.teams[team].label; }
};

WhatWasPlayed what_was_played(const study::TournamentPlan& plan);

// "paper vs fixed_rate", and how many pairs of what.
std::string title(const TournamentView& view);

// The numbers of the first pairing, or the ranking of more than two teams: what a live display shows. Lines, each
// ended.
std::string standing_text(const TournamentView& view);

// The whole page: title, standing, verdict, failures.
std::string tournament_text(const TournamentView& view);

// One JSON object with a newline.
std::string tournament_json(const TournamentView& view);

// Metrics that stand in the table though nobody asked for any: of short games the packets, and the share of the budget.
match::MetricPaths csv_metrics(const study::TournamentPlan& plan);

// Lines of a table with a row for each match, in the order of the schedule (RFC 4180, but lines end with \n).
// Metrics stand at the end of it, those of the match after those of the teams.
std::string csv_head(const match::MetricPaths& metrics);
std::string csv_line(const TournamentView& view, std::uint64_t index, const campaign::Decided& decided,
                     match::MetricColumns& metrics);

// "plugin hangs"; where only the team is known "a plugin of small"
std::string plugin_text(const std::string& plugin, const std::string& team);

// "forfeited by small: plugin hangs, holds: used more than 5 s of processor time"
std::string forfeit_text(const std::string& label, const campaign::Failure& failure);

// "H1", "H0", "INCONCLUSIVE", "NO_VERDICT" where pairs that could not be played prevent one; empty without a test
const char* name(study::Verdict verdict);

}  // namespace regista::report
