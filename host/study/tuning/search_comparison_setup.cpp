// SPDX-License-Identifier: MIT
#include "study/tuning/search_comparison_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "config/bad_input.hpp"
#include "config/read.hpp"
#include "config/typed.hpp"
#include "study/tuning/tuning_planner.hpp"

namespace regista::study {
namespace {

std::vector<Algorithm> compared_algorithms(const std::string& names) {
  std::vector<Algorithm> out;
  for (std::size_t begin = 0; begin <= names.size() && !names.empty();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    const std::string name = names.substr(begin, end - begin);
    const auto algorithm = algorithm_named(name);
    if (!algorithm) throw config::BadInput("--compare: " + unknown_algorithm(name));
    if (std::ranges::find(out, *algorithm) != out.end())
      throw config::BadInput("--compare: " + name + " is given twice");
    out.push_back(*algorithm);
    begin = end + 1;
  }
  return out;
}

// Judging takes the place of what a tuning does after its search.
void count_judging(TuningPlanner& planner, std::uint64_t runs) {
  TuningPlan& plan = planner.plan();
  const std::uint64_t pair = plan.matches_of_pair();
  plan.verification_pairs = pairs_in(planner.asked().verification.matches, pair);
  plan.selection_pairs = 1;
  plan.slice_points = 0;
  if (plan.verification_pairs < 2) {
    planner.require_matches("verification.matches", 2 * pair,
                            fmt::format("each of {} points is judged on as many", runs + 1));
  }
}

}  // namespace

SearchComparisonPlan planned_search_comparison(const SearchComparisonRequest& options,
                                               const plugin::Catalogue& catalogue) {
  config::Mistakes first(config::Mistakes::After::stop);
  TuningPlanner planner(options, catalogue, first);
  SearchComparisonPlan out;
  planner.choose_algorithm();
  out.algorithms = compared_algorithms(options.compare);
  out.repeats = config::parse_whole("--repeats", options.repeats.empty() ? "5" : options.repeats, 1, 1000);
  if (planner.plan().head_to_head) {
    config::refuse(planner.document(), {"verification.against"},
                   "verification.against: what is compared is judged against the opponents; set it to opponents");
  }
  if (planner.plan().minutes) {
    config::refuse(planner.document(), {"search.minutes"},
                   "search.minutes: algorithms are compared with equal numbers of matches, not in equal time");
  }
  planner.prepare();
  planner.count_search(out.algorithms);
  count_judging(planner, out.runs());
  out.tuning = std::move(planner.plan());
  return out;
}

}  // namespace regista::study
