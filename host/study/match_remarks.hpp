// SPDX-License-Identifier: MIT
// What is to be reported of single matches of a study besides their results: which could not be played, which came out
// otherwise when they were played a second time, in which robots did not decide alone, and in which plugins wrote to
// standard error. In memory that does not
// grow with the number of matches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "campaign/job.hpp"

namespace regista::study {

struct MatchRemark {
  std::uint64_t match = 0;  // in the schedule, from 0
  std::string text;         // one line
  friend bool operator==(const MatchRemark&, const MatchRemark&) = default;
};

class RemarkList {
 public:
  static constexpr std::size_t most_listed = 100;

  void add(std::uint64_t match, const std::string& text);

  const std::vector<MatchRemark>& listed() const { return listed_; }  // the first ones
  std::uint64_t count() const { return count_; }                      // of all
  std::uint64_t unlisted() const { return count_ - listed_.size(); }

 private:
  std::vector<MatchRemark> listed_;
  std::uint64_t count_ = 0;
};

// So many matches of one pairing that died without anybody to blame end a study.
inline constexpr std::uint64_t most_set_aside = 3;
// Why. who: "a against b"; last: what ended the last of them.
std::string why_unplayable(const std::string& who, const std::string& last);

class MatchRemarks {
 public:
  static constexpr std::size_t most_written = 20;  // matches that are named

  // Each match in the order of the schedule.
  void take(std::uint64_t match, const campaign::Decided& decided);

  const RemarkList& unplayed() const { return unplayed_; }              // and why
  const RemarkList& irreproducible() const { return irreproducible_; }  // and where two plays first differed
  const RemarkList& shared() const { return shared_; }  // whose plugin used what its robot alone does not know
  const RemarkList& broken() const { return broken_; }  // which promise a plugin breaks where it is looked at closely
  const RemarkList& kept() const { return kept_; }      // what plugins keep outside, though nothing came of it
  const RemarkList& unproven() const { return unproven_; }  // why it is not known that robots decide alone
  // Matches in which plugins wrote to standard error: the first ones, and how many there are.
  const std::vector<std::uint64_t>& written() const { return written_; }
  std::uint64_t written_count() const { return written_count_; }

 private:
  RemarkList unplayed_, irreproducible_, shared_, broken_, kept_, unproven_;
  std::vector<std::uint64_t> written_;
  std::uint64_t written_count_ = 0;
};

}  // namespace regista::study
