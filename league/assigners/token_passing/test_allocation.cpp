// SPDX-License-Identifier: MIT
// A robot allocates nothing after reserve(), whatever it hears and whichever tasks come and go.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <random>
#include <vector>

#include "message.hpp"
#include "robot.hpp"

namespace {

using namespace token_passing;

std::vector<double> kept_alive;  // outside of functions, so that no compiler leaves an allocation out

TEST(TokenPassing, NothingIsAllocatedAfterReserve) {
  std::mt19937 random(3);
  for (int round = 0; round < 50; ++round) {
    const int robots = 1 + static_cast<int>(random() % 22), tokens = 1 + static_cast<int>(random() % 64);
    Settings settings;
    settings.takeover = static_cast<Takeover>(random() % 3);
    settings.foresight = random() % 2 == 0;
    const Layout layout{robots, tokens, settings.rounds()};
    Robot robot;
    robot.reserve(robots, tokens);
    std::vector<std::uint8_t> bytes;
    std::vector<Told> read_back;
    bytes.reserve(layout.bytes(static_cast<std::size_t>(tokens)));
    read_back.reserve(static_cast<std::size_t>(tokens));
    for (int tick = 0; tick < 100; ++tick) {
      std::vector<Work> work;
      std::vector<std::int32_t> able;
      for (int i = 0; i < robots * tokens; ++i) able.push_back(static_cast<std::int32_t>(random() % 1200) - 200);
      for (int id = 0; id < tokens; ++id) {
        if (random() % 3 == 0) continue;
        const auto first = static_cast<std::size_t>(id * robots);
        work.push_back({id, id, std::span<const std::int32_t>(able).subspan(first, static_cast<std::size_t>(robots))});
      }
      const Robots members = static_cast<Robots>(random()) & ((Robots{1} << robots) - 1);
      const int sender = 1 + static_cast<int>(random() % static_cast<unsigned>(robots));
      const Situation situation{0.1 * tick, 1, random() % 4 == 0 ? members : members | 1u, work};
      const auto count = regista::testkit::allocations_during([&] {
        robot.decide(settings, situation);
        write(layout, robot.told(), bytes);
        if (sender != 1 && read(layout, 0, bytes, read_back)) {
          for (Told& each : read_back) ++each.token.hop;
          robot.hear(1, sender, read_back, 0.1 * tick, 0.1 * tick, true);
        }
        robot.transmitted(robot.told().size());
      });
      ASSERT_EQ(count, 0u) << robots << " robots, " << tokens << " tokens";
    }
  }
  EXPECT_GT(regista::testkit::allocations_during([] { kept_alive = std::vector<double>(1000); }), 0u);  // it counts
}

}  // namespace
