// SPDX-License-Identifier: MIT
// Courses of tournaments made by hand, to be reported.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "campaign/match_encoding.hpp"
#include "report/tournament_report.hpp"
#include "study/tournament_course.hpp"
#include "unit/study/tournament_fixture.hpp"

namespace regista::report {

inline campaign::MatchResult match(int home, int away, const std::string& metrics = "{}") {
  return {{home, away}, "full_time", "9f2c", campaign::metrics_from_json(metrics), std::nullopt, 1.0};
}

inline campaign::MatchResult failed(int side, const std::string& what = "Segmentation fault") {
  return campaign::forfeit({side, "greedy", "assign", 3, 417, what}, 1.0);
}

// One that could not be played.
inline campaign::MatchResult unplayed(const std::string& why = "Segmentation fault, in no plugin's call") {
  campaign::MatchResult out;
  out.ended = "set_aside";
  out.why_set_aside = why;
  return out;
}

struct Course {
  explicit Course(std::vector<std::string> labels, std::uint64_t pairs = 1'000'000,
                  const study::Objective& objective = study::FixedNumber{}) {
    plan.asked.name = "trial";
    plan.asked.settings.seeds = config::Seeds::consecutive;
    for (std::string& label : labels) {
      plan.asked.teams.push_back({label + ".yaml", ""});
      plan.teams.push_back({label, {{"team", "hash of " + label}}});
    }
    plan.asked.pairs = static_cast<int>(pairs);
    plan.asked.test = study::test_of(objective);
    plan.most_goals = 10;
    tournament.emplace(plan);
  }
  Course(const Course&) = delete;
  Course& operator=(const Course&) = delete;

  bool take(const campaign::MatchResult& decided) { return tournament->take(&decided); }

  // So many pairs of each kind, LL, LD, WL, WD, WW, for each pairing in turn and in no particular order, unless it is
  // over before; one goal decides.
  void take_pairs(const std::vector<std::array<int, 5>>& of_pairings) {
    constexpr std::array<std::array<int, 2>, 5> kinds{{{-1, -1}, {-1, 0}, {1, -1}, {0, 1}, {1, 1}}};
    std::vector<std::vector<std::array<int, 2>>> left(of_pairings.size());
    for (std::size_t pairing = 0; pairing < of_pairings.size(); ++pairing) {
      for (std::size_t kind = 0; kind < 5; ++kind) {
        left[pairing].insert(left[pairing].end(), static_cast<std::size_t>(of_pairings[pairing][kind]), kinds[kind]);
      }
      std::shuffle(left[pairing].begin(), left[pairing].end(), std::mt19937_64(pairing));
    }
    for (std::size_t pair = 0; pair < left.front().size(); ++pair) {
      for (const auto& pairing : left) {
        const auto [first, second] = pairing.at(pair);
        take(match(std::max(first, 0), std::max(-first, 0)));
        if (!take(match(std::max(-second, 0), std::max(second, 0)))) return;
      }
    }
  }

  TournamentView view() const {
    return {plan, *tournament, [](std::uint64_t index) { return "again " + std::to_string(index); }};
  }

  study::TournamentPlan plan;
  std::optional<study::Tournament> tournament;
};

inline std::string tournament_text(const TournamentView& view) { return outline_text(tournament_outline(view)); }
inline std::string tournament_json(const TournamentView& view) { return outline_json(tournament_outline(view)); }
inline std::string tournament_page(const TournamentView& view, const TournamentPage& page,
                                   const std::vector<Figure>& figures = {}) {
  return outline_page(tournament_outline(view, &page), "night.db", figures);
}
inline std::string tournament_page(const TournamentView& view, const TournamentHistory& record) {
  return tournament_page(view, TournamentPage{record, {}, {}, {}});
}

// A report without what was played.
inline std::string without_played(std::string text) {
  const std::size_t begin = text.find("\nWhat was played\n");
  return text.erase(begin, text.find("\n\n", begin) + 1 - begin);
}

inline study::ScoreTest sprt(double elo0, double elo1, statistics::Model model = statistics::Model::normalized) {
  study::ScoreTest out;
  out.design.model = model;
  out.design.hypotheses = {elo0, elo1};
  return out;
}

}  // namespace regista::report
