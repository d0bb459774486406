// SPDX-License-Identifier: MIT
// A mind in the steady state allocates nothing: it is asked ten times a second in each of fourteen robots.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>

#include "team.hpp"

namespace {

// This file replaces the program's allocation functions, to count what happens between two marks.
bool counting = false;
std::size_t allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  if (counting) ++allocations;
  void* const memory = alignment <= alignof(std::max_align_t)
                           ? std::malloc(size)
                           : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return counted(size, 1); }
void* operator new[](std::size_t size) { return counted(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace regista::mind {
namespace {

TEST(Allocation, NothingIsAllocatedAfterAHundredDecisions) {
  const auto plan = plan_of(team());
  std::vector<Mind> minds;
  for (int number = 1; number <= 7; ++number) minds.emplace_back(*plan, number, 1);
  std::vector<Outcome> outcomes(7);
  std::vector<std::vector<std::uint8_t>> air(7);
  for (auto& bytes : air) bytes.reserve(128);
  std::vector<HeardPacket> heard;
  heard.reserve(7);
  Percepts given;
  given.balls.reserve(4);
  given.robots.reserve(16);

  for (int k = 0; k < 400; ++k) {
    const double time = 0.1 * k;
    if (k == 100) allocations = 0;
    for (std::size_t i = 0; i < 7; ++i) {
      given.time = time;
      given.game.phase = Phase::playing;
      given.odometry = {0.02, 0.0, 0.05};
      given.placed.reset();
      if (k == 0) given.placed = placed(-3.0 + 0.9 * static_cast<double>(i), 0.5);
      given.balls.clear();
      given.robots.clear();
      if (k % 7 != 0) given.balls.push_back({{1.0 + 0.3 * std::sin(0.1 * k), 0.2}, 0.05, 0.05});
      for (int r = 0; r < 7; ++r) given.robots.push_back({{0.8 + 0.5 * r, 0.3 * r - 1.0}, 0.1, 0.1, r == 3});
      heard.clear();
      for (std::size_t j = 0; j < 7; ++j) {
        if (j != i && !air[j].empty()) heard.push_back({time, air[j]});
      }
      counting = true;
      minds[i].think(given, heard, outcomes[i]);
      counting = false;
    }
    for (std::size_t i = 0; i < 7; ++i) air[i].assign(outcomes[i].packet.begin(), outcomes[i].packet.end());
    ASSERT_TRUE(k < 100 || allocations == 0) << allocations << " by decision " << k;
  }
  EXPECT_EQ(minds[0].world().common().active.size(), 7u) << "they did hear each other";
}

// The counter counts: otherwise the test above could not fail.
TEST(Allocation, IsCounted) {
  allocations = 0;
  counting = true;
  std::vector<int>* const volatile some = new std::vector<int>(100);
  counting = false;
  delete some;
  EXPECT_EQ(allocations, 2u);
}

}  // namespace
}  // namespace regista::mind
