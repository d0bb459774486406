// SPDX-License-Identifier: MIT
// A team that does not settle is a finding; how fast the others are is a remark.
#include <regista/testkit/kind_checks.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <regista/testkit/rehearsal.hpp>

namespace regista::testkit {

namespace {

constexpr std::size_t most_told = 3;  // acts without agreement, of each loss

std::string with_one_decimal(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", number);
  return text;
}

}  // namespace

bool detail::says_it_negotiates(const Loaded& plugin) {
  const auto* const table = static_cast<const regista_assigner*>(plugin.descriptor().table(REGISTA_KIND_ASSIGNER));
  return table != nullptr && table->size >= sizeof(regista_assigner) &&
         (table->flags & REGISTA_ASSIGNER_NEGOTIATES) != 0;
}

Findings check_rehearsal(const Loaded& plugin, const Options& options) {
  Findings findings(options.underway);
  Values values(plugin);
  options.base(values);
  // Who does not say that it negotiates may talk of other things.
  const bool bound = detail::says_it_negotiates(plugin);
  const auto no_agreement = [&](const auto&... parts) {
    if (bound) {
      findings.say(parts...);
    } else {
      findings.doubt(parts...);
    }
  };
  for (const double loss : {0.0, 0.3, 0.6}) {
    const std::string lost = std::to_string(static_cast<int>(100.0 * loss + 0.5)) + " % of the packets lost";
    std::vector<double> times;
    std::size_t without = 0;
    double bytes = 0.0, robot_seconds = 0.0;
    for (const int robots : {3, 7}) {
      for (const std::uint64_t seed : {2 * options.seed + 1, 2 * options.seed + 2}) {
        RehearsalConditions conditions;
        conditions.robots = robots;
        conditions.radio.loss = loss;
        conditions.seed = seed;
        conditions.may_idle = options.may_idle;
        const std::string place = lost + ", " + std::to_string(robots) + " robots";
        findings.where(place, "");
        const Rehearsal rehearsal = rehearse(plugin, values, conditions);
        if (rehearsal.offers == 0 && !bound) {
          findings.remark("it offers nothing to its teammates, so there is nothing to rehearse");
          return findings;
        }
        for (const std::string& broken : rehearsal.broken) findings.say(broken);
        for (const Act& act : rehearsal.acts) {
          if (act.settled_after) {
            times.push_back(*act.settled_after);
          } else if (++without <= most_told) {
            findings.where(place, act.name);
            no_agreement("no agreement within ", with_one_decimal(act.length), " s: ", act.disagreement);
          }
        }
        bytes += static_cast<double>(rehearsal.bytes);
        robot_seconds += rehearsal.robot_seconds;
      }
    }
    if (without > most_told) {
      findings.where(lost, "");
      no_agreement("no agreement in ", without - most_told, without == most_told + 1 ? " other act" : " other acts");
    }
    if (times.empty()) continue;
    std::ranges::sort(times);
    findings.remark(lost, ": they agree after ", with_one_decimal(times[times.size() / 2]), " s (median) and ",
                    with_one_decimal(times.back()), " s (longest), and a robot says ",
                    with_one_decimal(bytes / robot_seconds), " bytes a second");
  }
  if (!findings.doubts().empty()) {
    findings.where("", "");
    findings.doubt("it does not say that it negotiates, and may mean to decide alone");
  }
  return findings;
}

}  // namespace regista::testkit
