// SPDX-License-Identifier: MIT
// What a worker is told, and what it answers: one match, as JSON in one line each way.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/input.hpp"
#include "campaign/limits.hpp"
#include "match/metric_numbers.hpp"
#include "plugin/call_note.hpp"

namespace regista::campaign {

// How far the minds of a match are kept apart. Where robots decide alone, the result is the same.
enum class Separation {
  none,    // one process for all
  teams,   // one for each team
  robots,  // one for each robot
};

// A match as the command line of `regista match` says it. Paths are relative to the folder the campaign was started in.
struct Job {
  std::array<std::string, 2> teams;       // files: home, away
  std::string rules, robot, disturbance;  // files; empty: the built-in values
  // Files: what disturbs one side alone, in the place of `disturbance`; empty: that one.
  std::string home_disturbance, away_disturbance;
  std::vector<std::string> overrides;  // of --set, as `regista match` understands them
  std::vector<std::string> plugins;    // folders of --plugins
  std::string opening;                 // file of the scene it starts from; empty: from kick-off
  std::string limit;                   // simulated seconds, as typed; empty: none, or the opening's length
  std::uint64_t seed = 1;
  std::string record;  // file that the worker records the match in, replacing it; empty: none. Part of no key.
  bool expects_failure = false;  // then as much as possible is to stand in that file when the worker dies
  // How it is played. Part of no key.
  Separation separation = Separation::none;
  bool elsewhere = false;  // in memory and in the file system, with another environment and at another date
  plugin::Look look = plugin::Look::seldom;
  bool hides = false;  // see plugin::Noting
  bool trail = false;  // what plugins answered is written to the worker's trail
  Limits limits;       // of the processes of minds that are kept apart
  bool is_apart() const { return separation != Separation::none; }
  // A folder with copies of the files, which stands for the root of the file system: names are to be read in the copy
  // of the folder that they were given in. Part of no key, and left out of what is compared with the inputs below;
  // empty: there are none.
  std::string root;
  // Files of the plugins that a search of the folders has found for these teams; empty: it is searched anew.
  std::vector<std::string> plugin_files;
  // What is to be played, as inputs.hpp counts it up. A worker that finds something else in the files does not play.
  std::vector<Input> home_inputs, away_inputs, common_inputs;
  friend bool operator==(const Job&, const Job&) = default;
};

// The words of `regista match` after the name of the program: plays this very match by itself.
std::vector<std::string> match_arguments(const Job& job);

// Who is to blame for a match that could not be played to its end.
struct Failure {
  int side = 0;              // 0 home, 1 away
  std::string plugin, call;  // id, "assign"
  int robot = 0;             // number, from 1
  std::uint64_t tick = 0;    // of the robot
  std::string what;          // "Segmentation fault", "point 0 at (1, nan) is outside the field"
  friend bool operator==(const Failure&, const Failure&) = default;
};

// A match that was decided: played, forfeited, or set aside because nobody can be blamed for the deaths over it.
struct Decided {
  std::array<int, 2> score{};      // by side; a forfeit is 0:10, of one that was set aside there is none
  std::string ended;               // "full_time", "mercy", "limit", "forfeit", "set_aside"
  std::string hash;                // over the course of the match, 16 digits; empty for what was not played to its end
  match::MetricNumbers metrics;    // none of what was not played to its end: missing, not zero
  std::optional<Failure> failure;  // of a forfeit
  double seconds = 0.0;            // s of wall time
  std::string why_set_aside{};     // how its workers died, one line; else empty
  std::string irreproducible{};    // where another play of the same match first differed, one line; else empty
  std::string shared{};            // who answers by more than what its own robot knows, one line; else empty
  std::string broken{};            // which promise a plugin breaks where it is looked at closely, one line; else empty
  std::string kept{};      // what plugins keep outside of their instances, though nothing came of it; else empty
  std::string unproven{};  // why it is not known that robots decide alone, though it was asked; mostly empty
  std::string output{};    // what plugins wrote to standard error, cut in the middle; mostly empty
  bool set_aside() const { return !why_set_aside.empty(); }
  friend bool operator==(const Decided&, const Decided&) = default;
};

// What a worker says at its end.
struct Answer {
  enum class Kind {
    played,   // `decided` holds the result
    failed,   // a plugin said so, broke a promise, or its process died: `decided.failure`
    changed,  // what stands in the files is not what is to be played: `message`
    refused,  // bad input: `message`
    stopped,  // an error of another kind: `message`
  };
  Kind kind = Kind::stopped;
  Decided decided;
  std::string message;        // of a match that was played: why it could not be recorded, else empty
  bool from_outside = false;  // of a failure: by a signal that people and systems send
};

std::string to_json(const Job& job);
std::string to_json(const Answer& answer);

// Throw std::invalid_argument for what these functions did not write.
Job job_from_json(const std::string& text);
Answer answer_from_json(const std::string& text);

std::string to_json(const Failure& failure);
Failure failure_from_json(const std::string& text);

std::string to_json(const std::vector<Input>& inputs);
std::vector<Input> inputs_from_json(const std::string& text);

inline constexpr int goals_of_forfeit = 10;

// The result of a match that the side of this failure loses.
Decided forfeit(const Failure& failure, double seconds);

}  // namespace regista::campaign
