// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_setup.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "config/read.hpp"
#include "config/scalar.hpp"
#include "study/tuning/tuning_planner.hpp"

namespace regista::study {
namespace {

// Selection, verification and slices.
void count_stages(TuningPlanner& planner) {
  TuningPlan& plan = planner.plan();
  const config::Tuning& asked = planner.asked();
  const std::uint64_t pair = plan.matches_of_pair();
  plan.selection_pairs = pairs_in(asked.selection.matches, pair * plan.finalists);
  if (plan.selection_pairs < 1) {
    planner.require_matches("selection.matches", pair * plan.finalists,
                            fmt::format("too few for {} finalists", plan.finalists));
  }
  const std::uint64_t together = plan.head_to_head ? 2 * plan.candidates : pair * (plan.candidates + 1);
  plan.verification_pairs = pairs_in(asked.verification.matches, together);
  const std::uint64_t least = least_verification_pairs(plan);
  if (plan.verification_pairs < least) {
    planner.require_matches(
        "verification.matches", least * together,
        fmt::format("{} pairs cannot show any difference with a confidence of {}, whatever they are",
                    plan.verification_pairs, config::real_text(plan.confidence)));
  }
  plan.slice_points = static_cast<std::uint64_t>(asked.slices.points);
  plan.slice_pairs = plan.slice_points == 0 ? 0 : static_cast<std::uint64_t>(asked.slices.pairs);
}

// Where there are mistakes, not all of it.
TuningPlan planned(const TuningRequest& options, const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  TuningPlanner planner(options, catalogue, mistakes);
  mistakes.attempt("search", [&] {
    planner.choose_algorithm();
    const Algorithm algorithm = planner.plan().algorithm;
    if (planner.asked().search.population && !has_population(algorithm)) {
      config::refuse(planner.document(), {"search.population"},
                     fmt::format("search.population: {} has none", name(algorithm)));
    }
  });
  if (planner.prepare()) {
    mistakes.attempt("", [&] {
      planner.count_search(std::array{planner.plan().algorithm});
      count_stages(planner);
    });
  }
  return std::move(planner.plan());
}

}  // namespace

TuningPlan planned_tuning(const TuningRequest& options, const plugin::Catalogue& catalogue) {
  config::Mistakes first(config::Mistakes::After::stop);
  return planned(options, catalogue, first);
}

void check_tuning(const TuningRequest& options, const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  planned(options, catalogue, mistakes);
}

std::vector<std::string> notes_on(const TuningPlan& plan) {
  std::vector<std::string> out;
  for (const TuningOpponent& each : plan.opponents) {
    const campaign::Job& job = each.jobs[0];
    if (job.home_inputs != job.away_inputs) continue;
    out.push_back(
        fmt::format("{} is the base team itself: its own value against it is 0 goals by construction", each.label));
  }
  return out;
}

}  // namespace regista::study
