// SPDX-License-Identifier: MIT
// On what the robots of one team agree, step by step of a decision (docs/architecture.md), so that one can see where
// they part: on the context, on the tasks that the filter keeps, and on the assignment where the tasks are the same.
// Of samples in the phase Playing with two active robots or more; what all active robots decided last is compared.
// Agreement on the assignment alone is `agreement` in metrics_roles.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace regista::match {

// Shares; nothing where there is no such sample.
struct AgreementMetrics {
  std::optional<double> context, kept_tasks;
  std::optional<double> assignment_given_tasks;  // of the samples in which they agree on the tasks
};

class AgreementMeasures {
 public:
  AgreementMeasures(int team_size, std::size_t roles);  // rows of the table of roles

  // Robot `number` has decided. context: -1 = none; kept: rows of the table of roles, in any order.
  void decided(int number, int context, std::span<const int> kept);

  // A sample; active: bit n - 1 for robot n. same_assignment: all of these agree on it.
  void sample(std::uint32_t active, bool same_assignment);

  AgreementMetrics result() const;

 private:
  bool same_context(std::uint32_t active) const;
  bool same_tasks(std::uint32_t active) const;

  int team_size_;
  std::size_t words_;                // of a set of tasks
  std::vector<int> context_;         // by robot
  std::vector<std::uint64_t> kept_;  // team_size x words: bit t for task t
  int samples_ = 0, same_context_ = 0, same_tasks_ = 0, same_assignment_ = 0;
};

}  // namespace regista::match
