// SPDX-License-Identifier: MIT
// The interface of all studies. A study has a plan that was fixed before the first match, asks for rounds of matches,
// and has findings that grow with the results. The plan and the results in their order determine all findings. A study
// does not know whether an engine plays its matches or a results file holds their results. So the same code runs when a
// study is played, resumed or read back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/store.hpp"

namespace regista::study {

// Names of studies in plans: {"study": NAME, ...}.
inline constexpr const char* tournament_study = "tournament";
inline constexpr const char* experiment_study = "experiment";
inline constexpr const char* tuning_study = "tuning";

// The name of the study in a plan, such as "tournament"; empty if the plan names no study.
std::string study_of(const std::string& plan);

// Matches that can be played in any order. The study takes their results in the order of their indices. Most studies
// ask for a single round. After each round, a search uses the results to choose its next round.
struct Round {
  std::uint64_t matches = 0;
  std::uint64_t first_row = 0;  // number of rows of the results file that earlier rounds use
  std::vector<campaign::Store::Fixture> fixtures;
  struct Place {
    std::size_t fixture = 0;  // index into `fixtures` (matches without their seeds)
    std::uint64_t seed = 0;
  };
  // The match with this index, from 0; nullopt if the study does not want the match any more.
  std::function<std::optional<Place>(std::uint64_t index)> at;
  std::function<campaign::Job(std::uint64_t index)> job;
  // Gives the study the result of a match. `decided` is null if the study did not want the match. The caller calls
  // take() in the order of indices. take() returns false if the round needs no more matches.
  std::function<bool(std::uint64_t index, const campaign::MatchResult* decided)> take;
  bool may_end_early = false;  // a test or a time limit may end the round before its last match
  // The number of matches with one pair number, over all pairings or conditions. A time limit (--until, --minutes)
  // stops the study only after a multiple of this number of matches. 0: it never stops the study.
  std::uint64_t matches_of_a_pair = 0;
  // Whether a match is the first of its pairing. The engine plays such a match twice. Empty function: no such match.
  std::function<bool(std::uint64_t index)> first_of_pairing;
};

// A function that plays a round: calls round.take() for each match until take() returns false. May throw.
using PlayRound = std::function<void(const Round& round)>;

class Study {
 public:
  virtual ~Study() = default;

  // The reason why the study must stop before its end, for example that matches cannot be played; empty: no reason.
  virtual std::string unplayable() const { return {}; }
  virtual const char* what() const = 0;            // name for messages, "tournament"
  virtual std::uint64_t most_matches() const = 0;  // upper bound of the matches of all rounds
  virtual std::uint64_t counted() const = 0;       // number of matches that count so far
  virtual campaign::Metrics metrics() const = 0;   // the metrics of a match that the study needs
  virtual campaign::Limits limits() const = 0;     // limits of each match
  virtual const std::string& folder() const = 0;   // absolute path; relative paths in the plan start at it
  // What ends a study whose number of matches nobody set: "the test" or "the clock"; otherwise empty.
  virtual std::string_view open_end() const { return {}; }
  std::string so_far(std::uint64_t matches) const;  // "5 of 24 matches"; "5 matches (the clock ends the study)"

  // The plan as JSON, {"study": KIND, ...}. The program can make the study again from this text.
  virtual std::string plan() const = 0;
  // The differences between another plan of the same kind and the study's own plan, in words; empty if the plans are
  // equal. Throws std::invalid_argument if the text is not such a plan.
  virtual std::vector<std::string> differences(const std::string& before) const = 0;

  // Passes the study's rounds to `play`, one by one. Call run() only once. Throws StudyError, and what `play` throws.
  virtual void run(const PlayRound& play) = 0;
};

// Thrown when a study cannot go on. what() gives the reason in one line.
class StudyError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A function to call after each Round::take(). `decided` is null for a match that the study did not want.
using AfterMatch = std::function<void(const Round& round, std::uint64_t index, const campaign::MatchResult* decided)>;

// Returns a PlayRound that plays rounds with `play` and calls `after` after each take(). `after` may be empty.
PlayRound observed(PlayRound play, AfterMatch after);

// Returns a PlayRound that checks the stored rows of a round, then calls `play`. The check throws
// campaign::StoreDamaged if a row does not hold the planned match. Each call raises `end` to the last row that the
// round may use. `store` and `end` must outlive the PlayRound.
PlayRound where_planned(PlayRound play, const campaign::Store& store, std::uint64_t& end);
// Call this after the last round. Throws campaign::StoreDamaged if the store has a row before 1 or after `end`.
void require_no_row_beyond(const campaign::Store& store, std::uint64_t end);

// Gives a round the stored results of its matches. If `store` lacks a match, returns false at once: the study gets
// neither this match nor later matches. Otherwise returns true. Throws campaign::StoreError.
bool answer_from(const campaign::Store& store, const Round& round, campaign::Metrics metrics);

// Runs a study on its stored matches, to its end or the first match that `store` lacks. Throws campaign::StoreError.
void read_back(Study& study, const campaign::Store& store, campaign::Metrics metrics, const AfterMatch& after = {});

// --- Files that belong to a file of results are in the same folder. NAME.db has the page NAME.html, the tuned team
// NAME.tuned.yaml and so on. Only the ending .db is removed: b.sqlite has the page b.sqlite.html. A recording or replay
// has the row of its match, from 1, as its name: NAME.recordings/12.mcap, NAME.replays/12.html.

// The path of the file with this ending that belongs to `results`. ending: begins with a dot.
inline std::filesystem::path beside(const std::filesystem::path& results, const std::string& ending) {
  std::filesystem::path name = results.extension() == ".db" ? results.stem() : results.filename();
  name += ending;
  return results.parent_path() / name;
}

inline std::filesystem::path page_file(const std::filesystem::path& results) { return beside(results, ".html"); }

inline std::filesystem::path tuned_file(const std::filesystem::path& results) { return beside(results, ".tuned.yaml"); }

inline std::filesystem::path figure_folder(const std::filesystem::path& results) { return beside(results, ".figures"); }

inline std::filesystem::path recording_folder(const std::filesystem::path& results) {
  return beside(results, ".recordings");
}

inline std::filesystem::path recording_file(const std::filesystem::path& results, std::int64_t row) {
  return recording_folder(results) / (std::to_string(row) + ".mcap");
}

inline std::filesystem::path replay_folder(const std::filesystem::path& results) { return beside(results, ".replays"); }

inline std::filesystem::path replay_file(const std::filesystem::path& results, std::int64_t row) {
  return replay_folder(results) / (std::to_string(row) + ".html");
}

}  // namespace regista::study
