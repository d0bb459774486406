// SPDX-License-Identifier: MIT
// Which pairs occur in an optimal assignment, for the rule for ties: those whose reduced cost is 0, up to a tolerance
// (complementary slackness).
#pragma once

#include <cstddef>

#include "shortest_paths.hpp"
#include "tie_rule.hpp"

namespace assignment {

namespace detail {
inline bool is_tight(double reduced, double tolerance) { return reduced <= tolerance; }
inline bool is_tight(Ranked reduced, double tolerance) { return reduced.left_out <= 0 && reduced.sum <= tolerance; }
inline double reduced_cost(double cost, double agent, double object) { return cost - agent - object; }
inline Ranked reduced_cost(double cost, Ranked agent, Ranked object) { return Ranked{0, cost} - agent - object; }
}  // namespace detail

// Begins `ties` anew with the tight pairs of an optimal solution of `costs`. agents_are_columns: agents are the columns
// of the rule, objects its rows; otherwise the other way round. tolerance: in units of the costs, >= 0.
template <class Cost>
void name_tight_pairs(const ShortestPaths<Cost>& solution, const Costs& costs, bool agents_are_columns,
                      double tolerance, TieRule& ties) {
  using detail::is_tight;
  ties.begin(agents_are_columns ? costs.objects : costs.agents, agents_are_columns ? costs.agents : costs.objects);
  for (std::size_t agent = 0; agent < costs.agents; ++agent) {
    const double* row = costs.values + agent * costs.objects;
    const Cost agent_dual = solution.agent_dual[agent];
    for (std::size_t object = 0; object < costs.objects; ++object) {
      if (row[object] == infinity) continue;
      if (!is_tight(detail::reduced_cost(row[object], agent_dual, solution.object_dual[object]), tolerance)) continue;
      ties.tight(agents_are_columns ? object : agent, agents_are_columns ? agent : object);
    }
    if constexpr (ShortestPaths<Cost>::may_leave_out) {
      if (is_tight(Ranked{1, 0.0} - agent_dual, tolerance)) {
        agents_are_columns ? ties.column_may_stay_free(agent) : ties.row_may_stay_free(agent);
      }
    }
  }
  for (std::size_t object = 0; object < costs.objects; ++object) {
    if (is_tight(Cost{} - solution.object_dual[object], tolerance)) {
      agents_are_columns ? ties.row_may_stay_free(object) : ties.column_may_stay_free(object);
    }
  }
}

}  // namespace assignment
