// SPDX-License-Identifier: MIT
// A tournament as its reports look at it, and what they say of it in a line or a table.
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

// The score so far, for a live display. Lines, each ended.
std::string standing_text(const TournamentView& view);

// Metrics that stand in the table though nobody asked for any: of short games the packets, and the share of the budget.
match::MetricPaths csv_metrics(const study::TournamentPlan& plan);

// Lines of a table with a row for each match, in the order of the schedule (RFC 4180, but lines end with \n).
// Metrics stand at the end of it, those of the match after those of the teams.
std::string csv_head(const match::MetricPaths& metrics);
std::string csv_line(const TournamentView& view, std::uint64_t index, const campaign::Decided& decided,
                     match::MetricColumns& metrics);

// "H1", "H0", "INCONCLUSIVE", "NO_VERDICT" where pairs that could not be played prevent one; empty without a test
const char* name(study::Verdict verdict);

}  // namespace regista::report
