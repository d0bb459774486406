// SPDX-License-Identifier: MIT
// The report of any study: lines while the study is running, and then an outline (outline.hpp), a table and figures. A
// report owns its study and the plan. A study that was just played and its file of results give the same report.
// The report depends only on the plan and on the results in order. Interruptions of the study and the number of worker
// processes change no byte of the report.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "report/figure.hpp"
#include "report/matches_section.hpp"
#include "report/outline.hpp"
#include "study/settings.hpp"
#include "study/study.hpp"

namespace regista::report {

// Returns the command that plays a single match.
using CommandOf = std::function<std::string(const campaign::Job& job)>;

struct TableOptions {
  bool all_metrics = false;
  match::MetricPaths metrics{};  // paths of all metrics of the matches in the file
};

struct PageFiles {
  std::filesystem::path results, page;  // file of the results, and file of the page itself
  std::vector<std::string> documents;   // resolved documents of the teams; empty list: the file has none
};

// A hash over all matches in the order of the schedule. Matches with equal results and states give equal hashes.
class Fingerprint {
 public:
  void take(std::uint64_t index, const campaign::MatchResult& decided);
  const std::string& text() const { return text_; }  // 32 hexadecimal digits; empty before the first match

 private:
  std::string text_;
};

// Returns the name of a file without folder and extension: "paper" for "teams/paper.yaml"; empty for no file.
std::string stem(const std::string& file);
// Returns the name of the opening of a match; empty for a match from kick-off.
std::string scene_name(const std::vector<study::Opening>& openings, std::size_t opening);

class StudyReport {
 public:
  StudyReport() = default;
  StudyReport(const StudyReport&) = delete;  // no copies: a study refers to its plan
  StudyReport& operator=(const StudyReport&) = delete;
  virtual ~StudyReport() = default;
  virtual study::Study& study() = 0;
  virtual const study::Study& study() const = 0;

  virtual std::vector<std::string> teams() const { return {}; }  // names of the teams in the study

  virtual WhatWasPlayed played() const = 0;
  // Returns the findings so far. page_outline() has additional sections and figures for a page.
  virtual Outline outline() const = 0;
  virtual Outline page_outline(const PageFiles& files) const;

  // Declares the study complete after its first `pairs` pairs, because a time limit (--until, --minutes) has stopped
  // the study. Only for studies whose rounds have pairs (study::Round::matches_of_a_pair).
  virtual void end_after(std::uint64_t /*pairs*/) {}

  // Returns lines without line ends, which the program shows before the first match.
  virtual std::vector<std::string> notes() const { return {}; }

  // Returns the state of a running study; every line has a line end.
  virtual std::string standing() const = 0;
  // Returns a played match as a line without line end: "small 1:0 other".
  virtual std::string match(const study::Round& round, std::uint64_t index,
                            const campaign::MatchResult& decided) const = 0;
  // Returns the teams of a match. By default each team has the name of its file.
  virtual MatchPlayers players(const study::Round& round, std::uint64_t index) const;

  // Returns "3 of 8 matches without a gap: the tournament is not at its end"; empty if the study is complete.
  virtual std::string incomplete() const = 0;

  // The parts of a table in order: the header, lines for each match after the study has taken it, the final lines.
  virtual bool is_table_of_matches() const { return true; }
  virtual bool has_a_column_for_each_metric() const { return false; }  // true: TableOptions::metrics is required
  virtual std::string begin_table(const TableOptions& /*options*/) { return {}; }
  virtual std::string table_lines(const study::Round& /*round*/, std::uint64_t /*index*/,
                                  const campaign::MatchResult& /*decided*/) {
    return {};
  }
  virtual std::string end_table() const { return {}; }
  virtual std::string summary_table() const { return {}; }  // a short table of the findings; empty: no such table

  // To make a page, call begin_page(), take() for each match, end_page(). take() computes at least the fingerprint.
  virtual campaign::Metrics page_metrics() const { return study().metrics(); }
  virtual void begin_page(const std::filesystem::path& /*results*/) {}
  virtual void take(const study::Round& round, std::uint64_t index, const campaign::MatchResult* decided) {
    fingerprint_.take(round.first_row + index, *decided);
  }
  virtual void end_page() {}
  virtual std::vector<Figure> figures() const = 0;
  const std::string& fingerprint() const { return fingerprint_.text(); }  // hash of the matches that take() received

 private:
  Fingerprint fingerprint_;
};

}  // namespace regista::report
