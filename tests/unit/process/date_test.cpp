// SPDX-License-Identifier: MIT
#include "process/confinement.hpp"

#include <gtest/gtest.h>
#include <sys/time.h>

#include <chrono>
#include <cmath>
#include <ctime>

#include "process/child.hpp"
#include "process/sanitized.hpp"

namespace regista::process {
namespace {

constexpr double earlier = 100'000'000.0;  // s
constexpr double patience = 60.0;          // s that the test may take

bool is_earlier(double now, double then) { return std::abs(then + earlier - now) < patience; }

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

TEST(Date, IsEarlierWhoeverAsks) {
  if (sanitized) GTEST_SKIP() << "a sanitizer has these functions";
  const double now = seconds(CLOCK_REALTIME), up = seconds(CLOCK_MONOTONIC);
  Child child = Child::copy({}, [&] {
    set_date_back(static_cast<std::int64_t>(earlier));
    if (!is_earlier(now, seconds(CLOCK_REALTIME)) || !is_earlier(now, seconds(CLOCK_REALTIME_COARSE))) return 1;
    if (!is_earlier(now, static_cast<double>(std::time(nullptr)))) return 2;
    timeval at{};
    gettimeofday(&at, nullptr);
    if (!is_earlier(now, static_cast<double>(at.tv_sec))) return 3;
    timespec got{};
    if (timespec_get(&got, TIME_UTC) != TIME_UTC || !is_earlier(now, static_cast<double>(got.tv_sec))) return 4;
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    if (!is_earlier(now, std::chrono::duration<double>(since).count())) return 5;
    // What is measured from no date stays.
    if (std::abs(seconds(CLOCK_MONOTONIC) - up) > patience) return 6;
    return 0;
  });
  const ProcessEnd end = child.wait();
  EXPECT_TRUE(end.exited_with(0)) << end.in_words();
  EXPECT_LT(std::abs(seconds(CLOCK_REALTIME) - now), patience);
}

}  // namespace
}  // namespace regista::process
