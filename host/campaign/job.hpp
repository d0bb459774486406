// SPDX-License-Identifier: MIT
// The job that a worker gets for one match, the worker's answer, and limits. Job and answer are one line of JSON each.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "match/metric_numbers.hpp"
#include "plugin/call_inputs.hpp"

namespace regista::campaign {

enum class Isolation {
  after_a_death,  // all minds share a process; if it dies, the match is replayed with one process for each team
  always,         // each team has its own process for its minds
};

// The limits of a match, and the rules that assign its minds to processes. A match that exceeds a limit is ended.
struct Limits {
  int processor_seconds = 10;                     // s of processor time for one call of a plugin
  std::uint64_t memory = std::uint64_t{2} << 30;  // bytes of address space of a process, RLIMIT_AS; 0: no limit
  double wall_seconds = 200.0;                    // s of wall time for one call: ends a plugin that sleeps
  double match_wall_seconds = 1800.0;             // s of wall time for a whole match
  Isolation isolation = Isolation::after_a_death;
  // The first match of a pairing is played a second time, with one process for each mind. The second play shows results
  // that are not reproducible, and robots that do not decide alone, that is, from their own knowledge only.
  bool play_twice = true;
  // true: the robots of a team may share memory, so the minds of a team share a process in both plays of a match.
  bool allow_shared_memory = false;

  // Returns the limit of processor time for the whole match, s (RLIMIT_CPU).
  int match_seconds() const { return 100 * processor_seconds; }
  friend bool operator==(const Limits&, const Limits&) = default;
};

// The key of a stored match: the number that the store gave to its fixture (the match without its seed), and its seed.
struct MatchKey {
  std::int64_t fixture = 0;
  std::uint64_t seed = 0;
  friend bool operator==(const MatchKey&, const MatchKey&) = default;
};

// The metrics of a stored match that are read. wanted: all, some kilobytes. packets: at least match::packet_metrics.
enum class Metrics { wanted, packets, left_out };

// How the minds of a match are divided among processes. The result is always the same if every robot decides alone.
enum class Separation {
  none,    // one process for all minds
  teams,   // one process for each team
  robots,  // one process for each robot
};

// One input of a match, for example {"plugin greedy (lib/greedy.so)", "greedy 9f2c..."}.
struct Input {
  std::string name, hash;
  friend bool operator==(const Input&, const Input&) = default;
};

// The files that a match has beside its teams, and its limit: options of `regista match`.
struct MatchConditions {
  std::string rules, robot, disturbance;  // files; empty: the built-in values
  // Files: the disturbance of one side, used instead of `disturbance`; empty: the side has `disturbance`.
  std::string home_disturbance, away_disturbance;
  std::string opening;  // file of the opening scene; empty: the match starts from kick-off
  std::string limit;    // simulated seconds, as typed; empty: no limit, or the opening's length
  friend bool operator==(const MatchConditions&, const MatchConditions&) = default;
};

// A match, described by the inputs of `regista match`. Paths are relative to the folder in which the campaign started.
struct Job : MatchConditions {
  std::array<std::string, 2> teams;    // files: home, away
  std::vector<std::string> overrides;  // values of --set, as `regista match` reads them
  std::vector<std::string> plugins;    // folders of --plugins
  std::uint64_t seed = 1;
  std::string record;            // file for the worker's recording, replaced if it exists; empty: none; not in the key
  bool expects_failure = false;  // true: the worker saves its recording more often, because it will probably die
  // How the match is played. The key of the match does not depend on these members.
  Separation separation = Separation::none;
  bool perturbed = false;  // true: the play has other memory addresses, another folder, environment and date
  plugin::Inspection look = plugin::Inspection::seldom;
  bool hides = false;  // true: inspected calls see only those inputs that their plugins declare to read
  bool trail = false;  // true: the worker writes the answers of plugins to its trail (decision_trail.hpp)
  Limits limits;       // for the worker and the processes of minds
  bool is_apart() const { return separation != Separation::none; }
  // The folder with copies of the files: the copy of /a/b is root/a/b. Empty: there are no copies. Relative names must
  // be read in the copy of the folder in which they were given. Keys and comparisons of inputs leave `root` out.
  std::string root;
  // Files of the plugins of the job's teams, found in the plugin folders; empty: the worker searches the folders.
  std::vector<std::string> plugin_files;
  // The inputs of the match (match_setup.hpp). A worker does not play if the files hold other inputs.
  std::vector<Input> home_inputs, away_inputs, common_inputs;
  friend bool operator==(const Job&, const Job&) = default;
};

// The command line that plays exactly this match alone: `regista match` without the name of the program.
std::vector<std::string> match_arguments(const Job& job);

// The team, plugin and robot to blame for a match that could not be played to its end.
struct Failure {
  int side = 0;              // 0 home, 1 away
  std::string plugin, call;  // id of the plugin, name of the call ("assign"); both empty: not known
  int robot = 0;             // number, from 1; 0: the robot is not known
  std::uint64_t tick = 0;    // number of the robot's tick
  std::string what;          // "Segmentation fault", "point 0 at (1, nan) is outside the field"
  friend bool operator==(const Failure&, const Failure&) = default;
};

// The result of a match that was played, forfeited, or set aside because workers died and no team is to blame.
struct MatchResult {
  std::array<int, 2> score{};        // by side; 0 and 10 goals for a forfeit; no meaning for a match set aside
  std::string ended{};               // "full_time", "mercy", "limit", "forfeit", "set_aside"
  std::string hash{};                // of all that happened in the match, 16 digits; empty: not played to its end
  match::MetricNumbers metrics{};    // empty if the match was not played to its end
  std::optional<Failure> failure{};  // set for a forfeit only
  double seconds = 0.0;              // s of wall time
  std::string why_set_aside{};       // how the workers died, one line; empty unless the match was set aside
  std::string irreproducible{};      // the first difference between two plays of this match, one line; usually empty
  std::string shared{};              // the plugin that used more than its own robot knows, one line; usually empty
  std::string broken{};              // the promise that a plugin broke under close inspection, one line; usually empty
  std::string kept{};      // what plugins keep outside of their instances without effect on the match; usually empty
  std::string unproven{};  // why the second play could not show that robots decide alone; usually empty
  std::string output{};    // what plugins wrote to standard error, without the middle if it was long; usually empty
  bool set_aside() const { return !why_set_aside.empty(); }
  friend bool operator==(const MatchResult&, const MatchResult&) = default;
};

// The message that a worker sends at its end.
struct Answer {
  enum class Kind {
    played,   // `decided` holds the result
    failed,   // a plugin reported a failure, broke a promise or died; `decided.failure` describes the failure
    changed,  // the files no longer hold the inputs of the job; `message` lists the differences
    refused,  // an input is bad; `message` says why
    stopped,  // another error stopped the match; `message` describes the error
  };
  Kind kind = Kind::stopped;
  MatchResult decided{};
  std::string message{};      // one line; Kind::played: the error of the recording, usually empty
  bool from_outside = false;  // Kind::failed: true if a signal that people and systems send caused the failure
};

std::string to_json(const Job& job);
std::string to_json(const Answer& answer);

// Both functions throw std::invalid_argument for a text that to_json() did not write.
Job job_from_json(const std::string& text);
Answer answer_from_json(const std::string& text);

std::string to_json(const Failure& failure);
Failure failure_from_json(const std::string& text);

std::string to_json(const std::vector<Input>& inputs);
std::vector<Input> inputs_from_json(const std::string& text);

// Returns the result of a match that the side in `failure` forfeits. seconds: s of wall time.
MatchResult forfeit(const Failure& failure, double seconds);

// Reads a whole number from 0 to `most` from a stored text. Throws std::out_of_range for any other value.
std::uint64_t whole_number(const nlohmann::ordered_json& json, std::uint64_t most = UINT64_MAX);

}  // namespace regista::campaign
