// SPDX-License-Identifier: MIT
#include "campaign/blame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace regista::campaign {
namespace {

// Returns whether the last three plays were isolated and the same side failed in each of these plays. If so, a signal
// from outside counts as a failure of this side.
bool again_and_again(std::span<const Attempt> attempts) {
  if (attempts.size() < isolated_plays) return false;
  const auto last = attempts.last(isolated_plays);
  return std::ranges::all_of(last, [&](const Attempt& each) {
    return each.isolated && !each.played && each.failure && each.failure->side == last.front().failure->side;
  });
}

bool failed_from_within(const Attempt& attempt) { return !attempt.played && !attempt.from_outside; }

Judgement after_a_failure(std::span<const Attempt> attempts) {
  const Attempt& last = attempts.back();
  if (last.isolated && last.failure && (!last.from_outside || again_and_again(attempts))) return Judgement::forfeit;
  const auto failures = std::ranges::count(attempts, false, &Attempt::played);
  // The process of an isolated match runs no code of plugins, so its death is a fault of the machine or of Regista.
  const auto own = std::ranges::count_if(
      attempts, [](const Attempt& each) { return each.isolated && !each.failure && failed_from_within(each); });
  const bool too_many =
      static_cast<std::size_t>(failures) >= most_failures || static_cast<std::size_t>(own) >= isolated_plays;
  return too_many ? Judgement::give_up : Judgement::play_isolated;
}

}  // namespace

Judgement judge(std::span<const Attempt> attempts) {
  assert(!attempts.empty());
  if (!attempts.back().played) return after_a_failure(attempts);
  if (std::ranges::none_of(attempts, failed_from_within)) return Judgement::counts;
  const auto survived =
      std::ranges::count_if(attempts, [](const Attempt& each) { return each.isolated && each.played; });
  return static_cast<std::size_t>(survived) < isolated_plays ? Judgement::play_isolated : Judgement::set_aside;
}

std::string why_set_aside(std::span<const Attempt> attempts) {
  const auto failed = std::ranges::find_if(attempts, failed_from_within);
  assert(failed != attempts.end());
  return fmt::format("{}; it did not come back in {} isolated plays", failed->what, isolated_plays);
}

std::string in_words(const std::string& what, const plugin::CallNote& note) {
  if (note.plugin.front() == '\0') return what;
  return fmt::format("{}; the {} call was {} of plugin {} ({}, robot {}, tick {})", what,
                     note.inside == 1 ? "present" : "last", note.call.data(), note.plugin.data(),
                     note.side == 1 ? "away" : "home", note.robot, note.tick);
}

}  // namespace regista::campaign
