// SPDX-License-Identifier: MIT
// The contract of every kind as a list of named checks, without any test framework:
//
//   for (const Check& check : contract(REGISTA_KIND_ASSIGNER)) {
//     if (check.applies(plugin, {})) print(check.name, check.run(plugin, {}).text());
//   }
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <regista/testkit/kind_checks.hpp>

namespace regista::testkit {

struct Check {
  std::string name;     // one word
  std::string promise;  // a sentence
  std::function<Findings(const Loaded&, const Options&)> run;
  // Whether there is anything to check: a plugin that receives no messages need not bear any.
  std::function<bool(const Loaded&, const Options&)> applies = [](const Loaded&, const Options&) { return true; };
};

// kind: REGISTA_KIND_PREDICTOR .. REGISTA_KIND_SENDER, or REGISTA_KIND_BEHAVIOUR.
std::vector<Check> contract(std::int32_t kind);

// The scenario that the checks of a kind play with a plugin.
std::vector<Scenario> scenarios(std::int32_t kind, const Loaded& plugin, const Options& options);

// A number for all that a plugin answers in that scenario, with its default parameters: the same in every process,
// unless the plugin depends on what it must not depend on.
std::uint64_t scenario_digest(std::int32_t kind, const Loaded& plugin, const Options& options);

// The same, of the beginnings of those scenarios, for each robot of a team whose robots are asked in turns, as in a
// match: once all the same, and once more each something else. `only`: that robot alone, from 0, and then the others'
// are 0. Robots that decide alone have the same numbers either way, where nothing of the plugin was called before in
// the process.
std::vector<std::uint64_t> team_digests(std::int32_t kind, const Loaded& plugin, const Options& options,
                                        std::optional<std::size_t> only = std::nullopt);
inline constexpr std::size_t robots_of_a_team = 7;

// Plays these beginnings with one instance; `after` gets the name of each step that it has played. For what plugins
// leave in memory, for example.
void play_scenario(std::int32_t kind, const Loaded& plugin, const Options& options,
                   const std::function<void(const std::string& step)>& after);

}  // namespace regista::testkit
