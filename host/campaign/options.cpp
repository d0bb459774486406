// SPDX-License-Identifier: MIT
#include "campaign/options.hpp"

#include <algorithm>
#include <thread>

#include "config/typed.hpp"

namespace regista::campaign {

void check(const Options& options) {
  number_of_workers(options);
  record_every(options);
}

int number_of_workers(const Options& options) {
  if (options.workers.empty()) return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 1024u));
  return static_cast<int>(config::parse_whole("--workers", options.workers, 1, 1024));
}

std::uint64_t record_every(const Options& options) {
  return options.record_every.empty() ? 0 : config::parse_whole("--record-every", options.record_every, 1, UINT64_MAX);
}

Limits limits_of(const config::MatchSettings& settings) {
  Limits limits;
  limits.processor_seconds = settings.limits.processor_seconds;
  limits.memory = static_cast<std::uint64_t>(settings.limits.memory) << 20;
  // A machine may have much else to do: only a plugin that sleeps comes here.
  limits.wall_seconds = settings.limits.wall_seconds.value_or(10 * limits.processor_seconds + 100);
  limits.match_wall_seconds = settings.limits.match_seconds;
  limits.play_twice = settings.play_twice;
  limits.allow_shared_memory = settings.allow_shared_memory;
  limits.isolation = settings.isolation == config::Isolation::always ? Isolation::always : Isolation::after_a_death;
  return limits;
}

}  // namespace regista::campaign
