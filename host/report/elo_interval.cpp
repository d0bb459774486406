// SPDX-License-Identifier: MIT
#include "report/elo_interval.hpp"

#include <cassert>
#include <optional>

#include "report/standing.hpp"

namespace regista::report {

statistics::Count uneven(const statistics::PairCounts& pairs) { return total(pairs) - pairs.seen[2]; }

bool enough_for_interval(const statistics::PairCounts& pairs) { return uneven(pairs) >= fewest_uneven_pairs; }

IntervalUse interval_use(const TournamentView& view, std::size_t pairing) {
  const study::Meeting& meeting = view.course.meetings()[pairing];
  const std::optional<Strength> known = strength(view.course, meeting);
  assert(known);
  const study::Verdict verdict = view.course.verdict();
  if (verdict == study::Verdict::accept_h0 || verdict == study::Verdict::accept_h1) return IntervalUse::biased;
  if (!view.course.complete()) return IntervalUse::not_at_its_end;
  if (!enough_for_interval(meeting.pairs)) return IntervalUse::too_few_pairs;
  const statistics::Interval& interval = known->elo.interval;
  if (!interval.bounded()) return IntervalUse::unbounded;
  const bool differs = verdict == study::Verdict::none && p_values(view.course).adjusted[pairing] < significance_level;
  return differs == interval.contains(0.0) ? IntervalUse::contradicted : IntervalUse::shown;
}

}  // namespace regista::report
