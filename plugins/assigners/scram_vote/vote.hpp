// SPDX-License-Identifier: MIT
// The vote on a mapping of MacAlpine, Barrera and Stone, "Positioning to Win" (RoboCup 2012): robots whose beliefs
// differ compute different assignments; each tells its own, and all play the one that most of the recent votes name.
//
// A ballot is, for every task in order of importance, the number of the robot that it gives the task, 0 for nobody: as
// few bits each as the largest number needs, behind three bits that say for which tasks it was cast. Seven tasks of
// seven robots are three bytes.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace scram {

// Three bits that mostly differ between different tasks. ids: in order of importance.
class Fingerprint {
 public:
  void add(std::int32_t id) { sum_ = (sum_ ^ static_cast<std::uint32_t>(id)) * 0x9e3779b97f4a7c15u; }
  std::uint8_t value() const { return static_cast<std::uint8_t>(sum_ >> 61); }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325u;
};

inline constexpr unsigned fingerprint_bits = 3;

inline std::size_t ballot_bytes(std::size_t tasks, unsigned team_size) {
  return (fingerprint_bits + tasks * static_cast<std::size_t>(std::bit_width(team_size)) + 7) / 8;
}

// Most tasks that a ballot of so many bytes, at least one, can be for.
inline std::size_t most_tasks(std::size_t bytes, unsigned team_size) {
  return (8 * bytes - fingerprint_bits) / static_cast<std::size_t>(std::bit_width(team_size));
}

// numbers: 0..team_size each. Fills `bytes` from its beginning.
inline void write_ballot(std::uint8_t fingerprint, std::span<const std::int32_t> numbers, unsigned team_size,
                         std::vector<std::uint8_t>& bytes) {
  bytes.assign(ballot_bytes(numbers.size(), team_size), 0);
  std::size_t at = 0;
  const auto put = [&](std::uint32_t value, unsigned bits) {
    for (unsigned bit = 0; bit < bits; ++bit, ++at) {
      bytes[at / 8] = static_cast<std::uint8_t>(bytes[at / 8] | (value >> bit & 1u) << at % 8);
    }
  };
  put(fingerprint, fingerprint_bits);
  for (const std::int32_t number : numbers)
    put(static_cast<std::uint32_t>(number), static_cast<unsigned>(std::bit_width(team_size)));
}

inline std::uint8_t fingerprint_of(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? 0 : static_cast<std::uint8_t>(bytes[0] & 7u);
}

// Reads numbers.size() entries of whatever was sent; the length has been checked. They may exceed the team's size.
inline void read_ballot(std::span<const std::uint8_t> bytes, unsigned team_size, std::span<std::int32_t> numbers) {
  assert(bytes.size() == ballot_bytes(numbers.size(), team_size));
  std::size_t at = fingerprint_bits;
  for (std::int32_t& number : numbers) {
    number = 0;
    for (unsigned bit = 0; bit < static_cast<unsigned>(std::bit_width(team_size)); ++bit, ++at) {
      number |= (bytes[at / 8] >> at % 8 & 1) << bit;
    }
  }
}

// The newest ballot of every teammate.
class BallotBox {
 public:
  void reserve(unsigned team_size, std::size_t most_tasks) {
    team_size_ = team_size;
    ballots_.resize(team_size);
    for (Ballot& each : ballots_) each.bytes.reserve(ballot_bytes(most_tasks, team_size));
  }
  void clear() {
    for (Ballot& each : ballots_) each.bytes.clear();
  }
  // Ballots of another length than any number of tasks could have are not kept.
  void put(int sender, std::span<const std::uint8_t> bytes, double time_sent) {
    if (sender < 1 || sender > static_cast<int>(team_size_)) return;
    Ballot& ballot = ballots_[static_cast<std::size_t>(sender - 1)];
    if (bytes.size() > ballot.bytes.capacity() || (!ballot.bytes.empty() && time_sent < ballot.time_sent)) return;
    ballot.bytes.assign(bytes.begin(), bytes.end());
    ballot.time_sent = time_sent;
  }
  // The tasks are others now: ballots that were cast for other tasks than these are void. `same_print`: the tasks
  // before had the same fingerprint, so that nothing tells their ballots apart.
  void tasks_changed(std::uint8_t fingerprint, bool same_print) {
    for (Ballot& each : ballots_) {
      if (same_print || fingerprint_of(each.bytes) != fingerprint) each.bytes.clear();
    }
  }

  // Changes `numbers`, the own mapping, to the one with the most votes among it and the ballots that were sent at or
  // after `since`; of equally many to the lexicographically least, nobody counting as the last robot. Ballots for which
  // `fits(numbers)` does not hold are not counted. `scratch`: two buffers as long as numbers.
  template <class Fits>
  void elect(std::span<std::int32_t> numbers, double since, std::span<std::int32_t> scratch, const Fits& fits) const {
    const std::size_t n = numbers.size();
    assert(scratch.size() >= 2 * n);
    const std::span<std::int32_t> own = scratch.first(n), other = scratch.subspan(n, n);
    std::copy(numbers.begin(), numbers.end(), own.begin());
    const std::size_t length = ballot_bytes(n, team_size_);
    const auto counts = [&](const Ballot& ballot) {
      return ballot.bytes.size() == length && ballot.time_sent >= since;
    };
    const auto votes_for = [&](std::span<const std::int32_t> mapping, std::span<std::int32_t> buffer) {
      int votes = std::equal(mapping.begin(), mapping.end(), own.begin()) ? 1 : 0;
      for (const Ballot& ballot : ballots_) {
        if (!counts(ballot)) continue;
        read_ballot(ballot.bytes, team_size_, buffer);
        if (std::equal(mapping.begin(), mapping.end(), buffer.begin())) ++votes;
      }
      return votes;
    };
    int most = votes_for(own, other);
    for (const Ballot& ballot : ballots_) {
      if (!counts(ballot)) continue;
      read_ballot(ballot.bytes, team_size_, other);
      if (!fits(std::span<const std::int32_t>(other))) continue;
      int votes = std::equal(own.begin(), own.end(), other.begin()) ? 1 : 0;
      for (const Ballot& each : ballots_) votes += counts(each) && each.bytes == ballot.bytes ? 1 : 0;
      if (votes < most || (votes == most && !lower(other, numbers))) continue;
      most = votes;
      std::copy(other.begin(), other.end(), numbers.begin());
    }
  }

 private:
  struct Ballot {
    std::vector<std::uint8_t> bytes;  // empty: none
    double time_sent = 0.0;
  };
  static bool lower(std::span<const std::int32_t> a, std::span<const std::int32_t> b) {
    const auto place = [](std::int32_t number) {
      return number == 0 ? std::numeric_limits<std::int32_t>::max() : number;
    };
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [&](std::int32_t x, std::int32_t y) { return place(x) < place(y); });
  }

  unsigned team_size_ = 0;
  std::vector<Ballot> ballots_;
};

}  // namespace scram
