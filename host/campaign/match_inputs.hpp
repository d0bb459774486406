// SPDX-License-Identifier: MIT
// All inputs of a match except its seed, as names and hashes of contents. The key of a fixture is made of the hashes;
// names are for people. Two matches with the same key and seed are the same match, so only one of them is played.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "config/node.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"

namespace regista::campaign {

// One input, for example {"plugin greedy (lib/greedy.so)", "greedy 9f2c..."}.
struct Input {
  std::string name, hash;
  friend bool operator==(const Input&, const Input&) = default;
};

// Lists in words the inputs that have changed, are gone or are new: "plugin greedy (lib/greedy.so) has changed". Each
// name appears once. Inputs whose names differ only in the path in brackets are the same input.
std::vector<std::string> differences(std::span<const Input> before, std::span<const Input> now);

// Returns the inputs of one team: its resolved document, its plugins, and the files that its parameters name. The order
// of the inputs depends only on contents and ids. root: the folder of copies of the files (stored_setup.hpp). All names
// and contents leave `root` out, so that copies give the same inputs as the files.
std::vector<Input> team_inputs(const mind::TeamPlan& plan, const config::Node& document,
                               const plugin::Catalogue& catalogue, const std::string& root = {});

inline constexpr const char* program_input = "program";
inline constexpr const char* mathematics_input = "mathematics library";

// Returns the inputs for both teams: rules, robot, disturbances, limit, program, mathematics library, opening.
std::vector<Input> common_inputs(const match::Setup& setup, const std::string& program, const std::string& mathematics);

Input opening_input(config::Opening opening);

// Returns the key of a fixture, 32 hexadecimal digits. home, away: team_inputs(); exchanged sides give another key.
std::string fixture_key(std::span<const Input> home, std::span<const Input> away, std::span<const Input> common);

// Returns the hash of the running program, even if its file has been replaced since. Throws std::runtime_error.
std::string program_hash();

// Returns the version of the C library and a hash of the results of its functions at a few hundred points. The last
// digits of these results depend on the version and on the processor family, for which the library chooses its code.
std::string mathematics_fingerprint();

}  // namespace regista::campaign
