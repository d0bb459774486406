// SPDX-License-Identifier: MIT
#include "campaign/blame.hpp"

#include <algorithm>
#include <cassert>

namespace regista::campaign {
namespace {

bool noted(const End& death) { return death.note.plugin.front() != '\0'; }

bool in_the_same_call(const End& a, const End& b) {
  return a.note.plugin == b.note.plugin && a.note.call == b.note.call && a.note.side == b.note.side &&
         a.note.robot == b.note.robot && a.note.tick == b.note.tick && a.note.inside == 1 && b.note.inside == 1;
}

// The second of these deaths has the same cause as the first.
bool repeats(const End& first, const End& second) {
  const bool outside = first.how == End::How::killed_from_outside || second.how == End::How::killed_from_outside;
  if (outside) return noted(first) && noted(second) && in_the_same_call(first, second);
  return noted(first) == noted(second) && (!noted(first) || first.note.side == second.note.side);
}

}  // namespace

Judgement judge(std::span<const End> deaths) {
  assert(!deaths.empty());
  const End& last = deaths.back();
  if (last.how == End::How::match_time) return Judgement::give_up;
  const auto earlier = deaths.first(deaths.size() - 1);
  const bool again = std::ranges::any_of(earlier, [&](const End& each) { return repeats(each, last); });
  if (again) return noted(last) ? Judgement::forfeit : Judgement::give_up;
  return deaths.size() >= most_deaths ? Judgement::give_up : Judgement::play_again;
}

std::optional<Failure> suspect(const End& death) {
  if (!noted(death)) return std::nullopt;
  const plugin::CallNote& note = death.note;
  const char* const when = note.inside == 1 ? "" : ", after this call";
  return Failure{note.side == 1 ? 1 : 0, note.plugin.data(), note.call.data(), note.robot, note.tick,
                 death.text + when};
}

}  // namespace regista::campaign
