// SPDX-License-Identifier: MIT
// What every study is: a plan that was fixed before the first match, rounds of matches that it asks for, and findings
// that grow with the results. Who answers it does not know: an engine that plays the matches, on any number of workers,
// or a file in which they were kept. So a study that is played, one that is resumed, and one that is read back are the
// same run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/store.hpp"

namespace regista::study {

// Matches that can be played in any order, and are counted in one. Most studies ask for a single round; a search asks
// for the next one by what the last one said.
struct Round {
  std::uint64_t matches = 0;
  std::uint64_t first_row = 0;  // rows of the file of results that earlier rounds have taken
  std::vector<campaign::Store::Fixture> fixtures;
  struct Place {
    std::size_t fixture = 0;  // of the above
    std::uint64_t seed = 0;
  };
  // What is to be played at this place, from 0 on; nothing when it is not wanted any more.
  std::function<std::optional<Place>(std::uint64_t index)> at;
  std::function<campaign::Job(std::uint64_t index)> job;
  // To be called in the order of indices; nothing for a match that is not wanted. False: nothing more is needed.
  std::function<bool(std::uint64_t index, const campaign::Decided* decided)> take;
  bool may_end_early = false;  // a test decides after which match nothing more is needed
  // Whether this match is the first of its pairing, which is played twice. Empty: none is.
  std::function<bool(std::uint64_t index)> first_of_pairing;
};

// Answers a round: calls take() until it has enough or all were taken; or throws.
using PlayRound = std::function<void(const Round& round)>;

class Study {
 public:
  virtual ~Study() = default;

  // Why it can find nothing any more, though it is not at its end; mostly empty.
  virtual std::string unplayable() const { return {}; }
  virtual const char* what() const = 0;            // "tournament", for messages
  virtual std::uint64_t most_matches() const = 0;  // of all rounds
  virtual std::uint64_t counted() const = 0;       // matches that were taken and count
  virtual campaign::Metrics metrics() const = 0;   // what it looks at of them
  virtual campaign::Limits limits() const = 0;     // of each match
  virtual const std::string& folder() const = 0;   // in which it was begun, absolute: paths are relative to it

  // The plan as JSON, from which it can be made again: {"study": KIND, ...}.
  virtual std::string plan() const = 0;
  // What differs between such a plan of the same kind and its own, in words; nothing when they are the same. Throws
  // std::invalid_argument for what is none.
  virtual std::vector<std::string> differences(const std::string& before) const = 0;

  // Asks for its rounds, once. Throws StudyError, and what `play` throws.
  virtual void run(const PlayRound& play) = 0;
};

// A study that cannot go on: what() is one line that says why.
class StudyError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Is called with each match after it was taken; null: one that was not wanted.
using AfterMatch = std::function<void(const Round& round, std::uint64_t index, const campaign::Decided* decided)>;

// `play`, with `after` called after each match; as it is where `after` is empty.
PlayRound observed(PlayRound play, AfterMatch after);

// `play`, but each round begins with a look at the rows that are stored already. Throws campaign::StoreDamaged for one
// that is none of its matches. end: the rows that all rounds until then have asked for. The store and it outlive this.
PlayRound where_planned(PlayRound play, const campaign::Store& store, std::uint64_t& end);
// Once no round follows: throws campaign::StoreDamaged for a row that is stored beyond them.
void require_no_row_beyond(const campaign::Store& store, std::uint64_t end);

// Answers a round by what a file holds. False: a match is missing, and those from it on were not taken. Throws
// campaign::StoreError.
bool answer_from(const campaign::Store& store, const Round& round, campaign::Metrics metrics);

// Takes what a file holds: all matches in their order up to the first one that is missing, or to the study's end.
// Throws campaign::StoreError.
void read_back(Study& study, const campaign::Store& store, campaign::Metrics metrics, const AfterMatch& after = {});

}  // namespace regista::study
