// SPDX-License-Identifier: MIT
// A stream of random words without state to share: Philox4x32-10 of J. K. Salmon et al., "Parallel Random Numbers: As
// Easy as 1, 2, 3", SC 2011. Streams of different keys, or of counters that differ beyond their first word, have
// nothing to do with each other.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace regista::match {

class RandomWords {
 public:
  // The first word of the counter counts blocks of four words: 2^32 of them.
  RandomWords(std::uint64_t key, const std::array<std::uint32_t, 4>& counter)
      : key_{{static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)}},
        counter_{{counter[0], counter[1], counter[2], counter[3]}} {}

  // Nothing is worked out until it is asked for.
  std::uint32_t next() {
    if (used_ == 4) {
      words_ = Generator{}(counter_, key_);
      ++counter_[0];
      used_ = 0;
    }
    return words_[used_++];
  }

 private:
  using Generator = r123::Philox4x32;  // ten rounds
  Generator::key_type key_;
  Generator::ctr_type counter_;
  Generator::ctr_type words_;
  unsigned used_ = 4;
};

}  // namespace regista::match
