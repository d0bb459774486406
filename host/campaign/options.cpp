// SPDX-License-Identifier: MIT
#include "campaign/options.hpp"

#include <algorithm>
#include <thread>

#include "config/bad_input.hpp"
#include "config/text.hpp"
#include "config/typed.hpp"

namespace regista::campaign {

void check(const Options& options) {
  number_of_workers(options);
  record_every(options);
  limits_of(options);
}

int number_of_workers(const Options& options) {
  if (options.workers.empty()) return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 1024u));
  return static_cast<int>(config::parse_whole("--workers", options.workers, 1, 1024));
}

std::uint64_t record_every(const Options& options) {
  return options.record_every.empty() ? 0 : config::parse_whole("--record-every", options.record_every, 1, UINT64_MAX);
}

Limits limits_of(const Options& options, config::Isolation isolation, bool play_twice, bool allow_shared_memory) {
  Limits limits;
  limits.processor_seconds =
      static_cast<int>(config::parse_whole("--processor-seconds", options.processor_seconds, 1, 1'000'000));
  limits.memory = config::parse_whole("--memory", options.memory, 64, std::uint64_t{1} << 24) << 20;
  // A machine may have much else to do: only a plugin that sleeps comes here.
  limits.wall_seconds = 10.0 * limits.processor_seconds + 100.0;
  if (!options.wall_seconds.empty()) {
    limits.wall_seconds =
        static_cast<double>(config::parse_whole("--wall-seconds", options.wall_seconds, 1, 1'000'000));
  }
  limits.match_wall_seconds =
      static_cast<double>(config::parse_whole("--match-seconds", options.match_seconds, 1, 1'000'000));
  limits.play_twice = play_twice && !options.play_once;
  limits.allow_shared_memory = allow_shared_memory;
  if (!options.isolation.empty()) {
    const std::vector<std::string>& known = config::isolation_names();
    const auto named = std::ranges::find(known, options.isolation);
    if (named == known.end()) throw config::BadInput(config::unknown("value", options.isolation, "--isolation", known));
    isolation = static_cast<config::Isolation>(named - known.begin());
  }
  limits.isolation = isolation == config::Isolation::always ? Isolation::always : Isolation::after_a_death;
  return limits;
}

}  // namespace regista::campaign
