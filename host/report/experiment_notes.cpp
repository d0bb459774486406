// SPDX-License-Identifier: MIT
// What is to be known to read the tables of an experiment.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "report/experiment.hpp"
#include "report/number.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

std::string minutes(double seconds) { return fixed(seconds / 60.0, 1); }

// By arm; of a sweep from the least to the most.
std::string playing_note(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<double> seconds;
  std::vector<std::string> by_arm;
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    const auto each = view.course.playing_seconds_of_a_match(i);
    if (!each) continue;
    seconds.push_back(*each);
    by_arm.push_back(fmt::format("{} {}", texts::visible(label(plan, i)), minutes(*each)));
  }
  if (seconds.empty()) return {};
  const std::string least = minutes(*std::ranges::min_element(seconds));
  const std::string most = minutes(*std::ranges::max_element(seconds));
  const std::string range = !plan.swept()   ? fmt::format("{}", fmt::join(by_arm, ", "))
                            : least == most ? least
                                            : fmt::format("{} to {}", least, most);
  return fmt::format("Mean minutes of a match in the phase Playing: {}.", range);
}

// Of games that are shorter than a match: all arms, of a sweep those conditions that overspend.
std::string packets_note(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<std::string> spent;
  std::size_t conditions = 0, overspent = 0;
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    const study::PacketsSpent& packets = view.course.packets(i);
    if (packets.games() == 0) continue;
    ++conditions;
    if (packets.overspent()) ++overspent;
    if (plan.swept() && !packets.overspent()) continue;
    spent.push_back(fmt::format("{} {:.4g} of {:.4g}{}", texts::visible(label(plan, i)), packets.spent(),
                                packets.share(), packets.overspent() ? " (OVERSPENT)" : ""));
  }
  if (conditions == 0) return {};
  const std::string all = fmt::format("{}", fmt::join(spent, ", "));
  const std::string of_sweep = overspent == 0
                                   ? fmt::format("within it in all {} conditions", conditions)
                                   : fmt::format("above it in {} of {} conditions, {}", overspent, conditions, all);
  return fmt::format("Packets per match, and the share of the budget for games of this length: {}.",
                     plan.swept() ? of_sweep : all);
}

bool of_both_teams(std::string_view path) {
  const std::string_view document = path.substr(0, path.find('.'));
  return document == "rules" || document == "robot";
}

std::string opponent_note(const study::ExperimentPlan& plan) {
  std::vector<std::string> paths;
  const auto add = [&](std::string_view path) {
    if (!of_both_teams(path)) return;
    const std::string shown = texts::visible(path);
    if (std::ranges::find(paths, shown) == paths.end()) paths.push_back(shown);
  };
  add(plan.sweep());
  for (const config::Experiment::Arm& arm : plan.asked.arms) {
    for (const config::Node::Entry& each : arm.set.entries()) add(each.key);
  }
  if (paths.empty()) return {};
  return fmt::format("Rules and robot apply to the opponent, too: the opponent is not the same at all values of {}.",
                     fmt::join(paths, ", "));
}

std::string interval_note(const study::ExperimentPlan& plan) {
  if (plan.primary().empty() || plan.comparisons().size() < 2) return {};
  return fmt::format(
      "Each {:.4g} % interval holds for its own comparison, p after Holm for all {} comparisons together. So an "
      "interval may leave out 0 although no difference was found.",
      100.0 * plan.asked.confidence, plan.comparisons().size());
}

}  // namespace

std::vector<std::string> experiment_notes(const ExperimentView& view) {
  std::vector<std::string> out{playing_note(view), packets_note(view), opponent_note(view.plan),
                               interval_note(view.plan)};
  std::erase(out, "");
  return out;
}

}  // namespace regista::report
