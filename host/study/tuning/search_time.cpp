// SPDX-License-Identifier: MIT
#include "study/tuning/search_time.hpp"

#include <charconv>
#include <chrono>
#include <optional>
#include <string>

#include "config/scalar.hpp"

namespace regista::study {
namespace {

using Clock = std::chrono::steady_clock;

// Their names in the file.
constexpr auto end_of_search = "search ended after";
constexpr auto time_of_search = "time of search";

// After so many points the search was ended for want of time; nothing where it was not.
std::optional<std::uint64_t> stored_end(const campaign::Store& store) {
  const std::string text = store.meta(end_of_search);
  std::uint64_t out = 0;
  if (text.empty()) return std::nullopt;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || rest != text.data() + text.size()) {
    throw campaign::StoreError("the end of the search in the results is damaged");
  }
  return out;
}

// How far the search had come when it was last looked at, and the wall time that it had taken until then.
struct SearchTime {
  std::uint64_t evaluations = 0;
  double seconds = 0.0;
};

SearchTime stored_time(const campaign::Store& store) {
  const std::string text = store.meta(time_of_search);
  SearchTime out;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, out.evaluations);
  if (error == std::errc() && rest != end) std::from_chars(rest + 1, end, out.seconds);
  return out;
}

}  // namespace

OutOfTime search_clock(campaign::Store& store, const TuningPlan& plan) {
  if (stored_end(store)) return stored_end_of_search(store);
  if (!plan.asked.search.minutes) return {};
  return [&store, most = 60.0 * *plan.asked.search.minutes, before = stored_time(store),
          began = std::optional<Clock::time_point>()](std::uint64_t evaluations) mutable {
    // What an earlier run has come to is read, not played: it was in time, and takes none.
    if (evaluations < before.evaluations) return false;
    if (!began) began = Clock::now();
    const double seconds = before.seconds + std::chrono::duration<double>(Clock::now() - *began).count();
    store.set_meta(time_of_search, std::to_string(evaluations) + ' ' + config::real_text(seconds));
    if (seconds < most) return false;
    // From here on it is part of the results: however often they are read, the search ends here.
    store.set_meta(end_of_search, std::to_string(evaluations));
    return true;
  };
}

OutOfTime stored_end_of_search(const campaign::Store& store) {
  return [ended = stored_end(store)](std::uint64_t evaluations) { return ended && evaluations >= *ended; };
}

}  // namespace regista::study
