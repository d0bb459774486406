// SPDX-License-Identifier: MIT
#include "config/tournament.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "config/file.hpp"
#include "config/line.hpp"
#include "config/read.hpp"

namespace regista::config {

static Map declare(Tournament::Team& team) {
  return {.fields = {required(file("team", team.team, "the team")),
                     file("disturbance", team.disturbance, "of this team alone; without it that of all teams")},
          .where = &team.where};
}

static Map declare(TournamentTest& test) {
  return {.fields =
              {
                  numbers("elo", Member<std::array<double, 2>>(test.elo), {-4000, 4000}, "1",
                          "strengths of the first team that the scores of pairs are to tell apart, the smaller first",
                          true),
                  choice("model", test.model, {"normalized", "logistic"}, "what `elo` is in"),
                  line("metric", test.metric, "`goals`, or a number of a match, of which a difference is looked for"),
                  real("alpha", test.alpha, {1e-6, 0.5}, "1", "rate of finding a difference in error"),
                  real("beta", test.beta, {1e-6, 0.5}, "1", "with `elo`: rate of missing it; without it 0.05"),
              },
          .where = &test.where,
          .exactly_one = {"elo", "metric"},
          .needs = {{{"beta", "elo"}}}};
}

Map declare(Tournament& tournament) {
  return {joined(
      {
          without_effect(required(name("tournament", tournament.name, "name of this tournament"))),
          without_effect(line("question", tournament.question, "what it is to answer")),
          required(list("teams", tournament.teams, 2, 1000, "that play")),
          choice("format", tournament.format, {"round_robin", "gauntlet"},
                 "of more than two teams: all against all, or the first against each of the others"),
          integer("pairs", tournament.pairs, {1, 10000000}, "1",
                  "of matches with the sides swapped, of each pairing; with a test: at most"),
          section("test", tournament.test, "a sequential test between two teams; without it all pairs are played"),
          integer("seed", tournament.seed, {0, largest_seed}, "1", "of the first pair of matches"),
          profile("disturbance", tournament.disturbance, "none", "of all teams; `none` is built in"),
          integer("failures_in_a_row", tournament.failures_in_a_row, {0, 1000000}, "1",
                  "forfeits by the same plugin after which a team is set aside; 0: never"),
      },
      fields_of(
          tournament.settings,
          "values laid over documents, by path; a path that begins with a is of the first team, b of the second"))};
}

void check(const Tournament& tournament, const Node& document, Mistakes& mistakes) {
  if (tournament.test && tournament.teams.size() > 2) {
    refuse(document, {"test", "teams"},
           fmt::format("test: a sequential test is between two teams, and there are {}; pairs alone rank more of them",
                       tournament.teams.size()),
           mistakes);
  }
  const bool ends_by_itself = tournament.test && tournament.test->elo;
  if (!tournament.pairs && !ends_by_itself) {
    mistakes.add(Error(document.where(), tournament.test
                                             ? "pairs: how many at most? Equal teams would play on for ever"
                                             : "pairs: how many are played? Or name a test that ends by itself: `test: "
                                               "{elo: [0, 20]}`"),
                 "pairs");
  }
  if (tournament.test && !ends_by_itself) {
    if (tournament.test->metric.empty() && !mistakes.doubtful("test")) {
      refuse(document, {"test.metric"}, "test.metric: expected `goals`, or a number of a match", mistakes);
    }
    if (tournament.test->model != TournamentTest::Model::normalized) {
      refuse(document, {"test.model"}, "test.model: belongs to elo, and this test is on a metric", mistakes);
    }
  }
  if (ends_by_itself && (*tournament.test->elo)[0] == (*tournament.test->elo)[1]) {
    refuse(document, {"test.elo"}, "test.elo: the first must be the smaller one", mistakes);
  }
  if (ends_by_itself && !(tournament.test->alpha + tournament.test->beta.value_or(TournamentTest::usual_rate) < 1.0)) {
    refuse(document, {"test.beta", "test.alpha"}, "test: alpha and beta: their sum must be below 1", mistakes);
  }
}

}  // namespace regista::config
