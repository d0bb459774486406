// SPDX-License-Identifier: MIT
#include "report/packets_spent.hpp"

#include <fmt/format.h>

#include "texts/json.hpp"

namespace regista::report {

std::string packets_clause(const study::PacketsSpent& packets) {
  if (packets.games() == 0) return {};
  return fmt::format("spent {:.4g} packets per match; the share of the budget for this length is {:.4g}{}",
                     packets.spent(), packets.share(), packets.overspent() ? ": OVERSPENT" : "");
}

nlohmann::ordered_json packets_json(const study::PacketsSpent& packets) {
  if (packets.games() == 0) return nullptr;
  return {{"per_match", packets.spent()}, {"share", packets.share()}, {"overspent", packets.overspent()}};
}

}  // namespace regista::report
