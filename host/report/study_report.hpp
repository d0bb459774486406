// SPDX-License-Identifier: MIT
// What is said of a study, whatever it is: while it is played, and at its end as an outline (outline.hpp), as a table,
// in figures. A report owns its study and that one's plan. It says the same of a study that was played just now and of
// one that was read back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "report/figure.hpp"
#include "report/outline.hpp"
#include "study/study.hpp"

namespace regista::report {

// The command that plays a match by itself.
using CommandOf = std::function<std::string(const campaign::Job& job)>;

// What stands in a table of results besides what always does.
struct TableWish {
  bool all_metrics = false;
  match::MetricPaths metrics{};  // that matches of the file have
};

// What a page shows of files besides the results.
struct PageFiles {
  std::filesystem::path results, page;
  std::vector<std::string> documents;  // of the teams, resolved; empty: not known
};

class StudyReport {
 public:
  virtual ~StudyReport() = default;
  virtual study::Study& study() = 0;
  virtual const study::Study& study() const = 0;

  virtual std::vector<std::string> teams() const { return {}; }  // who plays, as the study calls them

  virtual WhatWasPlayed played() const = 0;
  // What was found, as far as it has come; a page has more sections, and figures.
  virtual Outline outline() const = 0;
  virtual Outline page_outline(const PageFiles& /*files*/) const { return outline(); }

  // Before its first match: what is worth knowing, lines without their ends.
  virtual std::vector<std::string> notes() const { return {}; }

  // While it is played: how things stand, in lines, each ended.
  virtual std::string standing() const = 0;
  // "small 1:0 other": a match that was taken, in a line without its end.
  virtual std::string match(const study::Round& round, std::uint64_t index, const campaign::Decided& decided) const = 0;

  // "3 of 8 matches without a gap: the tournament is not at its end"; empty at its end.
  virtual std::string incomplete() const = 0;

  // The table: begin_table() gives its head, table_lines() what it says of each match once the study has taken it,
  // end_table() what it says at the end. In this order.
  virtual bool is_table_of_matches() const { return true; }
  virtual bool has_a_column_for_each_metric() const { return false; }  // then TableWish::metrics is asked for
  virtual std::string begin_table(const TableWish& wish) = 0;
  virtual std::string table_lines(const study::Round& round, std::uint64_t index, const campaign::Decided& decided) = 0;
  virtual std::string end_table() const { return {}; }
  // A second, short table of what was found; empty where there is none.
  virtual std::string summary_table() const { return {}; }

  // A page takes notes from its first match on: begin_page(), then for each match take(), then end_page().
  virtual campaign::Metrics page_metrics() const { return study().metrics(); }
  virtual void begin_page(const std::filesystem::path& /*results*/) {}
  virtual void take(const study::Round& round, std::uint64_t index, const campaign::Decided* decided) = 0;
  virtual void end_page() {}
  virtual std::vector<Figure> figures() const = 0;
};

}  // namespace regista::report
