// SPDX-License-Identifier: MIT
#include "config/tournament.hpp"

#include "config/read.hpp"

namespace regista::config {

static Map declare(Tournament::Team& team) {
  return {{
      required(file("team", team.team, "the team")),
      file("disturbance", team.disturbance, "of this team alone; without it that of all teams"),
  }};
}

static Map declare(TournamentTest& test) {
  return {.fields =
              {
                  numbers("elo", test.elo, {-4000, 4000}, "1",
                          "strengths of the first team that the scores of pairs are to tell apart, the smaller first",
                          true),
                  choice("model", test.model, {"normalized", "logistic"}, "what `elo` is in"),
                  line("metric", test.metric, "`goals`, or a number of a match, of which a difference is looked for"),
                  real("alpha", test.alpha, {1e-6, 0.5}, "1", "rate of finding a difference in error"),
                  real("beta", test.beta, {1e-6, 0.5}, "1", "with `elo`: rate of missing it; without it 0.05"),
              },
          .exactly_one = {"elo", "metric"},
          .needs = {{"beta", "elo"}}};
}

Map declare(Tournament& tournament) {
  return {joined(
      {
          without_effect(required(name("tournament", tournament.name, "name of this tournament"))),
          without_effect(line("question", tournament.question, "what it is to answer")),
          required(list("teams", tournament.teams, 2, 1000, "that play")),
          choice("format", tournament.format, {"round_robin", "gauntlet", "swiss", "knock_out"},
                 "of more than two teams: all against all, the first against each of the others, rounds of teams with "
                 "about as many points, or the loser leaves"),
          integer("rounds", tournament.rounds, {1, 999}, "1",
                  "of a Swiss tournament; without it as many as a knock-out has"),
          integer("pairs", tournament.pairs, {1, 10000000}, "1",
                  "of matches with the sides swapped, of each meeting; with a test: at most"),
          section("test", tournament.test, "a sequential test between two teams; without it all pairs are played"),
          integer("seed", tournament.seed, {0, largest_seed}, "1",
                  "of the pairs of matches; the same seed plays the same"),
          file("disturbance", tournament.disturbance, "of all teams; `none` is built in", "none"),
          integer("failures_in_a_row", tournament.failures_in_a_row, {0, 1000000}, "1",
                  "forfeits by the same plugin after which a team is set aside; 0: never"),
      },
      fields_of(
          tournament.settings,
          "values laid over documents, by path; a path that begins with a is of the first team, b of the second"))};
}

void check(const Tournament& tournament, const Node& document, Mistakes& mistakes) {
  const Refusals wrong(document, mistakes);
  const std::optional<TournamentTest>& test = tournament.test;
  if (test && tournament.teams.size() > 2) {
    wrong({"test", "teams"},
          "test: a sequential test is between two teams, and there are {}; pairs alone rank more of them",
          tournament.teams.size());
  }
  using enum Tournament::Format;
  const bool in_rounds = tournament.format == swiss || tournament.format == knock_out;
  if (in_rounds && tournament.teams.size() < 3) {
    wrong({"format", "teams"}, "format: rounds are for three teams or more, and there are {}", tournament.teams.size());
  }
  if (tournament.rounds && tournament.format != swiss) {
    wrong({"rounds"}, "rounds: belongs to `format: swiss`");
  } else if (tournament.rounds && static_cast<std::size_t>(*tournament.rounds) >= tournament.teams.size()) {
    wrong({"rounds"}, "rounds: {} teams have at most {} rounds until all have met", tournament.teams.size(),
          tournament.teams.size() - 1);
  }
  const bool ends_by_itself = test && test->elo;
  if (!tournament.pairs && !ends_by_itself && !mistakes.doubtful("pairs")) {
    mistakes.add(Error(document.where(), test ? "pairs: how many at most? Equal teams would play on for ever"
                                              : "pairs: how many are played? Or name a test that ends by itself, "
                                                "`test: {elo: [0, 20]}`, or give it a time: `regista run FILE --until "
                                                "08:00`"),
                 "pairs");
  }
  if (test && !ends_by_itself) {
    if (test->metric.empty() && !mistakes.doubtful("test")) {
      wrong({"test.metric"}, "test.metric: expected `goals`, or a number of a match");
    }
    if (test->model != TournamentTest::Model::normalized) {
      wrong({"test.model"}, "test.model: belongs to elo, and this test is on a metric");
    }
  }
  if (!ends_by_itself) return;
  if ((*test->elo)[0] == (*test->elo)[1]) wrong({"test.elo"}, "test.elo: the first must be the smaller one");
  if (!(test->alpha + test->beta.value_or(TournamentTest::usual_rate) < 1.0)) {
    wrong({"test.beta", "test.alpha"}, "test: alpha and beta: their sum must be below 1");
  }
}

}  // namespace regista::config
