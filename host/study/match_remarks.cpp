// SPDX-License-Identifier: MIT
#include "study/match_remarks.hpp"

#include <fmt/format.h>

namespace regista::study {

void RemarkList::add(std::uint64_t match, const std::string& text) {
  ++count_;
  if (listed_.size() < most_listed) listed_.push_back({match, text});
}

std::string why_unplayable(const std::string& who, const std::string& last) {
  return fmt::format("{}: {} matches could not be played, and no team can be blamed: {}", who, most_set_aside, last);
}

void MatchRemarks::take(std::uint64_t match, const campaign::Decided& decided) {
  if (decided.set_aside()) unplayed_.add(match, decided.why_set_aside);
  if (!decided.irreproducible.empty()) irreproducible_.add(match, decided.irreproducible);
  if (!decided.shared.empty()) shared_.add(match, decided.shared);
  if (!decided.broken.empty()) broken_.add(match, decided.broken);
  if (!decided.kept.empty() && decided.shared.empty() && decided.irreproducible.empty()) kept_.add(match, decided.kept);
  if (!decided.unproven.empty()) unproven_.add(match, decided.unproven);
  if (decided.output.empty()) return;
  ++written_count_;
  if (written_.size() < most_written) written_.push_back(match);
}

}  // namespace regista::study
