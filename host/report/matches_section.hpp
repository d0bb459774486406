// SPDX-License-Identifier: MIT
// The section of a study's page about its matches: first the clearest wins and the forfeits, then a folded table of all
// matches that readers can sort and filter. Links lead to pages with replays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/job.hpp"
#include "report/outline.hpp"

namespace regista::report {

// --- A list of matches in bounded memory: the first matches of the schedule, the clearest wins of each team (the wins
// by most goals), and the first forfeits.

// The teams of a match, as the study names them, and how the match started.
struct MatchPlayers {
  std::array<std::string, 2> sides;  // home, away
  std::string opening;               // name of the opening; empty: from kick-off
  std::uint64_t seed = 0;
};

struct ListedMatch {
  std::uint64_t row = 0;  // row in the file of results, from 1
  MatchPlayers players;
  std::array<int, 2> score{};       // goals by side
  std::string hash;                 // hash of all states of the match; empty: the match did not end
  std::optional<int> forfeited_by;  // side that forfeited the match
  std::string why;                  // why the match was forfeited or not played; otherwise empty
  std::optional<double> seconds;    // s of wall time; missing if the match was played several times

  bool played() const { return why.empty(); }
  int difference() const { return score[0] - score[1]; }
  std::optional<std::size_t> winner() const;  // side of the winner; nothing for a draw or a match that did not end
};

// Makes the list entry of a match. row: row in the file of results, from 1.
ListedMatch listed(std::uint64_t row, MatchPlayers players, const campaign::MatchResult& decided);

// Returns 32 hexadecimal digits: a hash of teams, opening, seed, and ListedMatch::hash or the side that forfeited.
std::string fingerprint_of(const ListedMatch& match);

class MatchList {
 public:
  static constexpr std::size_t most_listed = 2000, most_forfeits = 200, clearest_of_a_side = 5;

  // of_a_side: number of clearest wins that the list keeps for each team.
  explicit MatchList(std::size_t of_a_side = clearest_of_a_side) : of_a_side_(of_a_side) {}

  void take(ListedMatch match);

  std::uint64_t count() const { return count_; }
  const std::vector<ListedMatch>& first() const { return first_; }  // in the order of the schedule
  struct Wins {
    std::string side;
    std::vector<ListedMatch> clearest;  // ordered by goal difference (largest first), goals of the loser, row
  };
  std::vector<Wins> clearest() const;  // wins of each team; the team with the clearest win comes first
  const std::vector<ListedMatch>& forfeits() const { return forfeits_; }  // at most the first `most_forfeits` forfeits
  std::uint64_t forfeit_count() const { return forfeit_count_; }          // number of all forfeits
  double usual_seconds() const;  // median wall time of the matches in first(), s
  // Returns at most `most` matches: the clearest win of each team, a forfeit, the second clearest wins, a forfeit, ...
  std::vector<ListedMatch> highlights(std::size_t most) const;

 private:
  std::size_t of_a_side_;
  std::vector<ListedMatch> first_, forfeits_;
  std::map<std::string, std::vector<ListedMatch>> wins_;  // by name of the winner
  std::uint64_t count_ = 0, forfeit_count_ = 0;
};

// A link to a page with the replay of a match.
struct ReplayLink {
  std::string file, fragment;  // path relative to the study's page; fragment with the time at which the replay opens
  bool same = true;            // true: the replay equals the stored match; false: the replay ended differently
};
using FindReplay = std::function<std::optional<ReplayLink>(const ListedMatch& match)>;

struct MatchesOnPage {
  std::string results;    // path of the results relative to the page
  bool has_table = true;  // true: `regista report --csv` writes a table of the matches
  FindReplay replay;
};

// Returns a file name in a form that a command does not take for an option, even if the name begins with -.
std::string as_argument(const std::string& path);

Section matches_section(const MatchList& matches, const MatchesOnPage& page);

// Returns a sentence with links to matches, which the page shows beside the headline. Empty before the first match.
Sentence ways_to_matches(const MatchList& matches, const MatchesOnPage& page);

// --- HTML pages with replays, in a folder beside the results. A replay page may be older than the results. So the head
// of a replay page has a note (ReplayNote) about its match. replay_pages() ignores a page whose match has changed.

struct ReplayNote {
  std::string match;   // fingerprint_of() the stored match
  bool same = true;    // true: the replay equals the stored match
  double opens = 0.0;  // time that the page shows first, s from the beginning of the match
};

// replay_mark() returns a note as HTML for the head of a page. replay_note() reads this note, if the page has one.
texts::Html replay_mark(const ReplayNote& note);
// beginning: the first 2048 bytes of the page.
std::optional<ReplayNote> replay_note(std::string_view beginning);

// Returns N for each file of a folder whose name is N plus `extension`, such as 12 for "12.html".
std::set<std::uint64_t> numbered_files(const std::filesystem::path& folder, std::string_view extension);

// Returns a function that finds the replay page of a match. page: page of the study, which links to the replays.
FindReplay replay_pages(const std::filesystem::path& results, const std::filesystem::path& page);

}  // namespace regista::report
