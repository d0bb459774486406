// SPDX-License-Identifier: MIT
// Nothing is allocated once the team is known.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <random>
#include <vector>

#include "claims.hpp"
#include "dealing.hpp"
#include "word.hpp"

namespace {

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(Hulks, NothingIsAllocatedWithinWhatWasReserved) {
  constexpr std::size_t robots = 22, tasks = 27, roles = 64;
  std::mt19937 random(16);
  hulks::Claims claims;
  claims.reserve(static_cast<int>(robots));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(hulks::word_bytes(roles));
  std::vector<double> values(robots * tasks);
  std::vector<std::uint32_t> order(tasks);
  std::vector<std::int32_t> out(robots);
  for (int round = 0; round < 2000; ++round) {
    for (double& each : values) each = random() % 3 == 0 ? hulks::forbidden : 0.0;
    for (std::uint32_t j = 0; j < tasks; ++j) order[j] = j;
    out.assign(robots, -1);
    const auto reach = static_cast<std::uint32_t>(random() % 20000);
    const hulks::Word word{random() % 4 != 0, reach / 2, 5};
    const auto sender = static_cast<int>(random() % robots) + 1;
    const auto count = regista::testkit::allocations_during([&] {
      claims.hear(sender, word, 0.1 * round, 0.1 * round);
      claims.decide({}, {0.1 * round, 3, true, true, reach, round % 7 == 0, round % 5 != 0, 22},
                    [&](int number) { return number % 5 != round % 5; });
      hulks::write({claims.part() == hulks::Part::striker, reach, 5}, roles, bytes);
      hulks::deal({values.data(), robots, tasks, tasks}, hulks::order_of_dealing(order, 0, 1), out);
    });
    ASSERT_EQ(count, 0u);
  }
  EXPECT_GT(regista::testkit::allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace
