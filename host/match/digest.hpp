// SPDX-License-Identifier: MIT
// Digest computes one hash (XXH3, 64 bits) of a match. Two matches with equal hashes almost surely had equal body
// states, commands, packets and referee decisions in every step. unsound() checks the outcome of a mind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

#include "config/robot.hpp"
#include "mind/action.hpp"

namespace regista::match {

class Digest {
 public:
  Digest();
  ~Digest();

  void add(std::span<const std::byte> bytes);

  // Hashes the bytes of a value. Padding bytes are undefined, so this function accepts only scalars.
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) { add(std::as_bytes(std::span(&value, 1))); }

  std::uint64_t value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string hash_text(std::uint64_t hash);  // Returns the hash as 16 hexadecimal digits.

struct TeamCounts {  // How many roles, reasons to send and plugin metrics a team has.
  std::size_t roles = 0, reasons = 0, plugin_metrics = 0;
};

// Returns a description of the first fault of an outcome; an empty text if the outcome has no fault. A fault is a
// number that is infinite, NaN or out of range, or a kick, role, task, reason to send or metric that does not exist.
std::string unsound(const mind::Outcome& outcome, const config::Robot& robot, const TeamCounts& team);

// Adds the outcome's command, role, reason to send and packet to the hash.
void add(Digest& digest, const mind::Outcome& outcome);

}  // namespace regista::match
