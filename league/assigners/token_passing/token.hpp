// SPDX-License-Identifier: MIT
// The token of a task, as robots tell it to each other, and which of two states of one token is the later one.
//
// Who perceives a task makes a token of generation 1 for it. Only the holder changes a token: it counts `hop` up. Who
// takes a token back or makes a lost one anew begins the next generation and is its creator. So two different states
// of a token never have the same generation, creator and hop, and all robots that have heard the same states keep the
// same one: the later generation; of one generation that of the creator with the lower number, which has priority; of
// one creator the later hop. Generations and hops are serial numbers of eight bits: 3 comes after 250.
#pragma once

#include <cstdint>

#include "../negotiation/epoch.hpp"

namespace token_passing {

inline constexpr int most_robots = 32;

// Robots are numbered from 1; sets of robots have bit number - 1.
using Robots = std::uint32_t;
constexpr Robots only(int number) { return Robots{1} << (number - 1); }

struct Token {
  std::uint8_t generation = 0, hop = 0;
  std::uint8_t creator = 0, holder = 0;  // numbers; holder 0: lost (never told)
  std::uint8_t round = 0;                // how often the threshold was lowered
  bool kept = false;                     // the holder does the task
  bool done = false;                     // there is no such task any more
  Robots visited = 0;                    // in this round, and passed it on
  friend bool operator==(const Token&, const Token&) = default;
};

// Of `heard` as seen from `known`.
constexpr negotiation::Order compare(const Token& heard, const Token& known) {
  const negotiation::Order generations = negotiation::compare_epochs(heard.generation, known.generation);
  if (generations != negotiation::Order::same) return generations;
  if (heard.creator != known.creator) {
    return heard.creator < known.creator ? negotiation::Order::later : negotiation::Order::earlier;
  }
  return negotiation::compare_epochs(heard.hop, known.hop);
}

// What is told of one token. id: of the token; a task that needs two robots has two.
struct Told {
  int id = 0;
  Token token;
};

}  // namespace token_passing
