// SPDX-License-Identifier: MIT
// What the calls of a plugin cost, measured over the scenario that its contract plays, with its default parameters.
// Wall time of this machine: for authors, not for tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <regista/testkit/loaded.hpp>
#include <regista/testkit/options.hpp>

namespace regista::testkit {

struct Cost {
  std::string call;  // "assign"
  std::size_t count = 0;
  double median_microseconds = 0.0, p99_microseconds = 0.0, mean_microseconds = 0.0;
  std::optional<double> allocations;  // by operator new, mean of a call; none: nobody counted
};

// Each scenario is played twice with the same instance, and the second time counts: what is kept from call to call is
// there by then. allocated: how often this process has allocated by operator new; null: not counted. kind: as of
// contract(). By the name of the call. Throws CallFailed when an instance cannot be created.
std::vector<Cost> cost_of_calls(std::int32_t kind, const Loaded& plugin, const Options& options,
                                std::size_t (*allocated)() = nullptr);

}  // namespace regista::testkit
