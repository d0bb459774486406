// SPDX-License-Identifier: MIT
#include "cli/tournament_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "config/text.hpp"

namespace regista::cli {
namespace {

using Json = nlohmann::ordered_json;

// The place of what pairs say about strength (Elo, LOS, LLR); lines of the page, each with a newline.
std::string strength_text(const study::Standing&) { return ""; }

// The same as members of the JSON object.
void add_strength(Json&, const study::Standing&) {}

double points(const study::Standing& standing) {
  return static_cast<double>(standing.wins) + 0.5 * static_cast<double>(standing.draws);
}

std::string forfeits_text(const PlayedTournament& tournament) {
  std::string out;
  for (const study::Forfeits& each : tournament.standing.forfeits) {
    out += fmt::format("{} {} {}\n  the first again: {}\n", each.count, each.count == 1 ? "match" : "matches",
                       forfeit_text(tournament.labels[static_cast<std::size_t>(each.team)], each.failure),
                       tournament.again(each.first_match));
  }
  if (tournament.standing.unlisted_forfeits > 0) {
    out += fmt::format("{} more matches forfeited for other reasons\n", tournament.standing.unlisted_forfeits);
  }
  return out.empty() ? "" : '\n' + out;
}

}  // namespace

std::string forfeit_text(const std::string& label, const campaign::Failure& failure) {
  return config::one_line(
      fmt::format("forfeited by {}: plugin {}, {}: {}", label, failure.plugin, failure.call, failure.what));
}

std::string tournament_text(const PlayedTournament& tournament) {
  const study::Standing& standing = tournament.standing;
  std::string out = fmt::format("Results of {} vs {} ({} {}, seeds {} to {}):\n", tournament.labels[0],
                                tournament.labels[1], tournament.pairs, tournament.pairs == 1 ? "pair" : "pairs",
                                tournament.first_seed, tournament.first_seed + tournament.pairs - 1);
  if (tournament.equal_teams) out += "A/A: the teams are equal, so every pair is a draw by construction\n";
  out += strength_text(standing);
  const double share = standing.games() == 0 ? 0.0 : points(standing) / static_cast<double>(standing.games());
  out += fmt::format("Games: {}, Wins: {}, Losses: {}, Draws: {}, Points: {:.1f} ({:.2f} %)\n", standing.games(),
                     standing.wins, standing.losses, standing.draws, points(standing), 100.0 * share);
  out += fmt::format("Ptnml(0-2): [{}]\n", fmt::join(standing.pairs, ", "));
  out += fmt::format("Goals: {}:{}\n", standing.goals[0], standing.goals[1]);
  return out + forfeits_text(tournament);
}

std::string tournament_json(const PlayedTournament& tournament) {
  const study::Standing& standing = tournament.standing;
  Json out;
  out["teams"] = tournament.labels;
  out["equal_teams"] = tournament.equal_teams;
  out["pairs"] = tournament.pairs;
  out["first_seed"] = tournament.first_seed;
  out["games"] = standing.games();
  out["wins"] = standing.wins;
  out["losses"] = standing.losses;
  out["draws"] = standing.draws;
  out["points"] = points(standing);
  out["pentanomial"] = standing.pairs;
  out["goals"] = standing.goals;
  add_strength(out, standing);
  Json forfeits = Json::array();
  for (const study::Forfeits& each : standing.forfeits) {
    forfeits.push_back({{"team", tournament.labels[static_cast<std::size_t>(each.team)]},
                        {"plugin", each.failure.plugin},
                        {"call", each.failure.call},
                        {"what", each.failure.what},
                        {"matches", each.count},
                        {"again", tournament.again(each.first_match)}});
  }
  out["forfeits"] = forfeits;
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace regista::cli
