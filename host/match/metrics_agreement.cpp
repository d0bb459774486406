// SPDX-License-Identifier: MIT
#include "match/metrics_agreement.hpp"

#include <algorithm>
#include <bit>

#include "match/sampling.hpp"

namespace regista::match {
namespace {

constexpr std::size_t bits = 64;  // of a word

}  // namespace

AgreementMeasures::AgreementMeasures(int team_size, std::size_t roles)
    : team_size_(team_size),
      words_((roles + bits - 1) / bits),
      context_(at(team_size), -1),
      kept_(at(team_size) * words_) {}

void AgreementMeasures::decided(int number, int context, std::span<const int> kept) {
  context_[at(number - 1)] = context;
  const std::span<std::uint64_t> set = std::span(kept_).subspan(at(number - 1) * words_, words_);
  std::ranges::fill(set, 0);
  for (const int task : kept) set[at(task) / bits] |= std::uint64_t{1} << (at(task) % bits);
}

void AgreementMeasures::sample(std::uint32_t active, bool same_assignment) {
  if (std::popcount(active) < 2) return;
  ++samples_;
  if (same_context(active)) ++same_context_;
  if (!same_tasks(active)) return;
  ++same_tasks_;
  if (same_assignment) ++same_assignment_;
}

bool AgreementMeasures::same_context(std::uint32_t active) const {
  const int first = context_[at(std::countr_zero(active))];
  for (int robot = 0; robot < team_size_; ++robot) {
    if ((active >> robot & 1u) != 0 && context_[at(robot)] != first) return false;
  }
  return true;
}

bool AgreementMeasures::same_tasks(std::uint32_t active) const {
  const auto kept = [this](int robot) { return std::span(kept_).subspan(at(robot) * words_, words_); };
  const std::span first = kept(std::countr_zero(active));
  for (int robot = 0; robot < team_size_; ++robot) {
    if ((active >> robot & 1u) != 0 && !std::ranges::equal(kept(robot), first)) return false;
  }
  return true;
}

AgreementMetrics AgreementMeasures::result() const {
  return {share(same_context_, samples_), share(same_tasks_, samples_), share(same_assignment_, same_tasks_)};
}

}  // namespace regista::match
