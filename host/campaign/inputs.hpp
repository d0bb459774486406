// SPDX-License-Identifier: MIT
// Everything a match is a function of, but its seed, as names and hashes of contents; and from them the key of the
// fixture. Two matches with the same key and seed are the same match: it need be played once only. Names are for people
// and no part of the key.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/input.hpp"
#include "config/node.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"

namespace regista::campaign {

// What one team brings along: its resolved document, the plugins it names, the files their parameters name. In an
// order that depends on contents and ids alone. root: of copies of the files (document_copies.hpp); it is left out, so
// that copies are the same inputs as the files.
std::vector<Input> team_inputs(const mind::TeamPlan& plan, const config::Node& document,
                               const plugin::Catalogue& catalogue, const std::string& root = {});

inline constexpr const char* program_input = "program";
inline constexpr const char* mathematics_input = "mathematics library";

// What is not a team's own: rules, robot, disturbances of home and of away, limit, where it is played (program and
// mathematics library), and last the opening where there is one.
std::vector<Input> common_inputs(const match::Setup& setup, const std::string& program, const std::string& mathematics);

Input opening_input(config::Opening opening);

// 32 hexadecimal digits. home, away: team_inputs; the order matters.
std::string fixture_key(std::span<const Input> home, std::span<const Input> away, std::span<const Input> common);

// Hash of the program that runs now, even if its file has been replaced since. Throws std::runtime_error.
std::string program_hash();

}  // namespace regista::campaign
