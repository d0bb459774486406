// SPDX-License-Identifier: MIT
#include "match/metric_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "match/names.hpp"

namespace regista::match {
namespace {

using Source = MetricSource;
using Of = MetricRow::Of;
using Total = MetricRow::Total;

std::vector<double> reals(const std::vector<int>& values) { return {values.begin(), values.end()}; }

std::vector<MetricRow> numbers_of_the_match() {
  const std::string_view part = "match";
  return {
      {.part = part,
       .name = "score",
       .unit = "goals",
       .total = Total::sum,
       .meaning = "that count, at the end",
       .get = [](const Source& from) { return from.result.score[index(from.side)]; }},
      {.of = Of::match,
       .part = part,
       .name = "simulated_seconds",
       .unit = "s",
       .total = Total::sum,
       .meaning = "from the placement to the end, breaks left out",
       .get = [](const Source& from) { return from.result.simulated_seconds; }},
      {.of = Of::match,
       .part = part,
       .name = "playing_seconds",
       .unit = "s",
       .total = Total::sum,
       .meaning = "phase Playing",
       .get = [](const Source& from) { return from.result.metrics.playing_seconds; }},
      {.of = Of::match,
       .part = part,
       .name = "in_play_seconds",
       .unit = "s",
       .total = Total::sum,
       .meaning = "ball in play",
       .get = [](const Source& from) { return from.result.metrics.in_play_seconds; }},
      {.of = Of::match,
       .part = part,
       .name = "ball_rest_seconds",
       .unit = "s",
       .total = Total::sum,
       .meaning = "in play, the ball is slower than 0.05 m/s though an able robot of either team could touch it within "
                  "3 s: the way from its centre to that of the ball, less the radius of its body, is at most what it "
                  "walks in 3 s at full forward speed",
       .get = [](const Source& from) { return from.result.metrics.ball_rests.seconds; }},
      {.of = Of::match,
       .part = part,
       .name = "ball_rests",
       .unit = "times",
       .total = Total::sum,
       .meaning = "that it came to rest so",
       .get = [](const Source& from) { return from.result.metrics.ball_rests.count; }},
      {.of = Of::match,
       .part = part,
       .name = "long_ball_rests",
       .unit = "times",
       .total = Total::sum,
       .meaning = "those of them that lasted more than 15 s of play",
       .get = [](const Source& from) { return from.result.metrics.ball_rests.long_ones; }},
      {.of = Of::match,
       .part = part,
       .name = "ball_rest_longest_seconds",
       .unit = "s",
       .meaning = "the longest of them",
       .get = [](const Source& from) { return from.result.metrics.ball_rests.longest_seconds; }},
      {.of = Of::match,
       .part = part,
       .name = "ball_crowd_seconds",
       .unit = "s",
       .total = Total::sum,
       .meaning = "in play, five or more active robots of both teams are within 1 m of the ball",
       .get = [](const Source& from) { return from.result.metrics.ball_crowd_seconds; }},
      {.of = Of::match,
       .part = part,
       .name = "duels",
       .unit = "times",
       .total = Total::sum,
       .meaning =
           "in play, for 1 s or more without a break at least one able robot of each team is within 0.5 m of the "
           "ball. When that holds again before anybody has touched the ball, it is the same duel",
       .get = [](const Source& from) { return from.result.metrics.duels; }},
  };
}

// A number of one role; all of them add up to one of the team.
MetricRow of_role(std::string name, const char* unit, std::string meaning, MetricRow::Number get) {
  return {.of = Of::role,
          .part = "coordination",
          .name = std::move(name),
          .unit = unit,
          .total = Total::sum,
          .meaning = std::move(meaning),
          .get = std::move(get)};
}

using Counts = RoleMetrics::Counts;

std::vector<MetricRow> numbers_of_roles() {
  std::vector<MetricRow> rows{
      of_role("overlap_seconds", "s", "`h_r >= 2`", [](const Source& from) { return from.role().all.overlap_seconds; }),
      of_role("uncovered_seconds", "s",
              "`h_r = 0` though the role was wanted: it is in the list in force, its place in that list (from 0) is "
              "below `R`, and the robot it is bound to, if any, is active. In force is the list in which most active "
              "robots hold a role; while nobody holds one, none",
              [](const Source& from) { return from.role().all.uncovered_seconds; }),
      of_role("switches", "times", "a robot takes the role in Playing that it did not hold at its last decision",
              [](const Source& from) { return from.role().all.switches; }),
      of_role("unplayed_seconds", "s",
              "`h_r = 0` though more than `R / 2` of the active robots last decided on an assignment in which somebody "
              "has the role",
              [](const Source& from) { return from.role().all.unplayed_seconds; })};
  struct Span {
    const char *name, *meaning;
    Counts RoleMetrics::*counts;
  };
  constexpr Span before{"before", "the part of it before the team's silence", &RoleMetrics::before_silence};
  constexpr Span after{"after", "the part after it began", &RoleMetrics::after_silence};
  for (const auto& [name, value] :
       {std::pair{"overlap", &Counts::overlap_seconds}, std::pair{"uncovered", &Counts::uncovered_seconds}}) {
    for (const Span& span : {before, after}) {
      rows.push_back(
          of_role(std::string(name) + '_' + span.name + "_silence_seconds", "s", span.meaning,
                  [value = value, counts = span.counts](const Source& from) { return from.role().*counts.*value; }));
    }
  }
  for (const Span& span : {before, after}) {
    rows.push_back(of_role(std::string("switches_") + span.name + "_silence", "times", span.meaning,
                           [counts = span.counts](const Source& from) { return (from.role().*counts).switches; }));
  }
  rows.push_back({.of = Of::role,
                  .part = "coordination",
                  .name = "robot_seconds",
                  .unit = "s",
                  .total = Total::sum,
                  .meaning = "by robot: time it was active and held the role",
                  .get = [](const Source& from) { return from.role().robot_seconds; }});
  return rows;
}

// Of all roles together, by the minute of play: spans of different length beside each other.
MetricRow rate(const std::string& what, const char* unit, const std::string& span, std::string meaning,
               Counts RoleMetrics::*counts, double Counts::*seconds, double (*length)(const Source& from)) {
  return {.part = "coordination",
          .name = "rates." + what + "_per_minute" + span,
          .unit = unit,
          .meaning = std::move(meaning),
          .get = [counts, seconds, length](const Source& from) -> std::optional<double> {
            if (!(length(from) > 0.0)) return std::nullopt;
            double sum = 0.0;
            for (const RoleMetrics& role : from.team().coordination.roles) {
              sum += seconds == nullptr ? (role.*counts).switches : role.*counts.*seconds;
            }
            return 60.0 * sum / length(from);
          }};
}

std::vector<MetricRow> rates() {
  constexpr auto playing = [](const Source& from) { return from.result.metrics.playing_seconds; };
  constexpr auto silent = [](const Source& from) { return from.team().coordination.silent_seconds; };
  constexpr auto heard = [](const Source& from) {
    return from.result.metrics.playing_seconds - from.team().coordination.silent_seconds;
  };
  struct Span {
    const char *name, *meaning;
    Counts RoleMetrics::*counts;
    double (*length)(const Source& from);
  };
  std::vector<MetricRow> rows;
  for (const Span& span :
       {Span{"", "`60 * sum over roles / playing_seconds`", &RoleMetrics::all, playing},
        Span{"_before_silence", "over `playing_seconds - silent_seconds`", &RoleMetrics::before_silence, heard},
        Span{"_after_silence", "over `silent_seconds`", &RoleMetrics::after_silence, silent}}) {
    const auto add = [&](const char* what, const char* unit, double Counts::*seconds) {
      rows.push_back(rate(what, unit, span.name, span.meaning, span.counts, seconds, span.length));
    };
    add("overlap_seconds", "s/min", &Counts::overlap_seconds);
    add("uncovered_seconds", "s/min", &Counts::uncovered_seconds);
    add("switches", "1/min", nullptr);
  }
  return rows;
}

std::vector<MetricRow> agreement_by_step() {
  const auto row = [](const char* name, const char* title, const char* meaning,
                      std::optional<double> AgreementMetrics::*value) {
    return MetricRow{.part = "coordination",
                     .name = name,
                     .unit = "share",
                     .title = title,
                     .digits = 3,
                     .meaning = meaning,
                     .get = [value](const Source& from) { return from.team().agreement.*value; }};
  };
  return {row("context_agreement", "Agreement of all robots on the context, share of time",
              "of the samples with `R >= 2`: all active robots last decided in the same context, or all in none",
              &AgreementMetrics::context),
          row("kept_tasks_agreement", "Agreement of all robots on the kept tasks, share of time",
              "of the same samples: all active robots last kept the same tasks, or had none to keep",
              &AgreementMetrics::kept_tasks),
          row("assignment_agreement_given_tasks", "",
              "of those of them with the same kept tasks: all active robots last decided on the same assignment",
              &AgreementMetrics::assignment_given_tasks)};
}

std::vector<MetricRow> tenures_and_targets() {
  const std::string_view part = "coordination";
  return {
      {.part = part,
       .name = "tenure_median_seconds",
       .unit = "s",
       .title = "Median tenure of a role, s",
       .meaning = "how long a robot holds a role before it takes another: median over all finished tenures of all "
                  "robots; `null` without one",
       .get = [](const Source& from) { return from.team().tenure.median_seconds; }},
      {.part = part,
       .name = "tenure_10_percent_seconds",
       .unit = "s",
       .meaning = "their 0.1 quantile: a tenth of the tenures are shorter",
       .get = [](const Source& from) { return from.team().tenure.tenth_seconds; }},
      {.part = part,
       .name = "target_distance_mean_metres",
       .unit = "m",
       .title = "Distance between two targets, m",
       .meaning = "distance between the targets of two active robots: mean over all pairs of all samples",
       .get = [](const Source& from) { return from.team().targets.mean_metres; }},
      {.part = part,
       .name = "target_distance_least_metres",
       .unit = "m",
       .meaning = "that of the pair whose targets are nearest together: mean over the samples with two targets or more",
       .get = [](const Source& from) { return from.team().targets.least_metres; }},
  };
}

std::vector<MetricRow> at_the_ball() {
  const std::string_view part = "coordination";
  return {
      {.part = part,
       .name = "nearest_plays_ball",
       .unit = "share",
       .title = "The robot nearest to the ball plays it, share of time in play",
       .digits = 3,
       .meaning = "of the samples in play with an able robot of the team: the one nearest to the ball goes for it",
       .get = [](const Source& from) { return from.team().ball.nearest_plays_share; }},
      {.part = part,
       .name = "robots_near_ball",
       .unit = "robots",
       .title = "Robots within 1 m of the ball",
       .meaning = "active ones whose centre is within 1 m of that of the ball: mean over the samples in play",
       .get = [](const Source& from) { return from.team().ball.robots_near; }},
      {.part = part,
       .name = "ball_chased_by_several_seconds",
       .unit = "s",
       .total = Total::sum,
       .title = "Two or more robots go for the ball, s",
       .digits = 1,
       .meaning = "in play, two or more able robots of the team go for the ball",
       .get = [](const Source& from) { return from.team().ball.chased_by_several_seconds; }},
  };
}

std::vector<MetricRow> numbers_of_coordination() {
  const std::string_view part = "coordination";
  std::vector<MetricRow> rows = numbers_of_roles();
  rows.push_back({.part = part,
                  .name = "silent_seconds",
                  .unit = "s",
                  .total = Total::sum,
                  .title = "Silent to the end, s of play",
                  .digits = 1,
                  .meaning = "of Playing, after the silence began; 0 without one",
                  .get = [](const Source& from) { return from.team().coordination.silent_seconds; }});
  rows.push_back({.part = part,
                  .name = "agreement",
                  .unit = "share",
                  .title = "Agreement of all robots on the assignment, share of time",
                  .digits = 3,
                  .meaning = "of the samples with `R >= 2`: all active robots last decided on the same assignment of "
                             "the whole team; `null` without such samples",
                  .get = [](const Source& from) { return from.team().coordination.agreement; }});
  rows.push_back({.part = part,
                  .name = "agreement_before_silence",
                  .unit = "share",
                  .meaning = "the same, of the samples before the team's silence",
                  .get = [](const Source& from) { return from.team().coordination.agreement_before_silence; }});
  rows.push_back({.part = part,
                  .name = "agreement_after_silence",
                  .unit = "share",
                  .meaning = "of those after it began",
                  .get = [](const Source& from) { return from.team().coordination.agreement_after_silence; }});
  for (auto* const more : {agreement_by_step, tenures_and_targets, at_the_ball, rates}) {
    std::ranges::move(more(), std::back_inserter(rows));
  }
  return rows;
}

// How many segments of a team's mailboxes came to something.
MetricRow segments(const char* what, const char* meaning, std::int64_t SegmentMetrics::*count) {
  return {.part = "packets",
          .name = std::string("segments_") + what,
          .unit = "segments",
          .total = Total::sum,
          .meaning = meaning,
          .get = [count](const Source& from) { return from.team().segments.*count; }};
}

std::vector<MetricRow> numbers_of_packets() {
  const std::string_view part = "packets";
  return {
      {.part = part,
       .name = "packets",
       .unit = "packets",
       .total = Total::sum,
       .meaning = "charged to the budget, too long ones included",
       .get = [](const Source& from) { return from.result.packets[index(from.side)]; }},
      {.part = part,
       .name = "packet_bytes",
       .unit = "bytes",
       .total = Total::sum,
       .meaning = "of those packets, core and segments together, without what the network adds",
       .get = [](const Source& from) { return from.team().packet_bytes; }},
      {.of = Of::event,
       .part = part,
       .name = "packets_by_reason",
       .unit = "packets",
       .total = Total::sum,
       .meaning = "those that the sender plugin sent for this reason: an event, or one that the plugin names",
       .get = [](const Source& from) { return from.team().packets_by_reason[from.member]; }},
      {.part = part,
       .name = "packets_share",
       .unit = "packets",
       .total = Total::sum,
       .meaning = "of a match that is ended before its time (`--limit`, an opening), else `null`: the budget times the "
                  "share of the time it may last",
       .get = [](const Source& from) { return from.packets_share; }},
      {.part = part,
       .name = "packets_over_share",
       .unit = "packets",
       .total = Total::sum,
       .meaning = "`packets` less that share; above 0 is overspent: the team could not go on like this for a whole "
                  "match",
       .get = [](const Source& from) -> std::optional<double> {
         if (!from.packets_share) return std::nullopt;
         return from.result.packets[index(from.side)] - rounded_metric(*from.packets_share);
       }},
      {.part = part,
       .name = "budget_curve",
       .unit = "packets",
       .total = Total::sum,
       .meaning =
           "what is left of the budget when the clock of the match shows 1, 2, 3 ... minutes, through all halves",
       .get = [](const Source& from) { return reals(from.team().budget_curve); }},
      segments("offered", "bytes that plugins offered for packets through their mailboxes, those refused left out",
               &SegmentMetrics::offered),
      segments("refused",
               "offers that were refused: too long for any packet, expired already, too many pending, or senseless",
               &SegmentMetrics::refused),
      segments("sent", "of those offered: left a robot in a packet, whatever the radio made of it",
               &SegmentMetrics::sent),
      {.part = part,
       .name = "segment_bytes",
       .unit = "bytes",
       .total = Total::sum,
       .meaning = "of the segments that were sent, with the two bytes of heading of each",
       .get = [](const Source& from) { return from.team().segments.bytes; }},
      segments("dropped",
               "of those offered: expired, replaced or withdrawn before a packet took them. What is neither sent nor "
               "dropped was pending at the end",
               &SegmentMetrics::dropped),
      segments("heard",
               "segments that reached a plugin of a teammate: each of those sent counts once for every teammate that "
               "heard it",
               &SegmentMetrics::heard),
  };
}

// The four numbers of the estimates of one thing. error: the title of rmse_metres.
struct Estimates {
  const char* name;
  EstimateMetrics WorldModelMetrics::*of;
  const char *error, *known, *rmse, *nees, *coverage;  // meanings, but for the first
};

void add(std::vector<MetricRow>& rows, const Estimates& what) {
  const std::string name = std::string("world_model.") + what.name + '.';
  const auto get = [of = what.of](std::optional<double> EstimateMetrics::*value) {
    return [of, value](const Source& from) { return from.team().world_model.*of.*value; };
  };
  const auto row = [&](const char* last, const char* unit, const char* title, const char* meaning,
                       std::optional<double> EstimateMetrics::*value) {
    rows.push_back(
        {.part = "world", .name = name + last, .unit = unit, .title = title, .meaning = meaning, .get = get(value)});
  };
  row("known_share", "share", "", what.known, &EstimateMetrics::known_share);
  row("rmse_metres", "m", what.error, what.rmse, &EstimateMetrics::rmse_metres);
  row("nees", "", "", what.nees, &EstimateMetrics::nees);
  row("coverage_95", "share", "", what.coverage, &EstimateMetrics::coverage_95);
}

std::vector<MetricRow> numbers_of_the_world() {
  const std::string_view part = "world";
  std::vector<MetricRow> rows{{.part = part,
                               .name = "ball_seen_share",
                               .unit = "share",
                               .title = "Ball seen, share of time",
                               .digits = 3,
                               .meaning = "samples (10 Hz) in which an active robot saw the ball in the image of its "
                                          "last decision: a sighting within 1 m of it",
                               .get = [](const Source& from) { return from.team().world_model.ball_seen_share; }}};
  constexpr auto as_before = "as of the ball";
  add(rows,
      {"ball", &WorldModelMetrics::ball, "Error of the ball, m",
       "`K / A`: it believes to know where the ball is, and its own eyes have not refuted that",
       "`sqrt(sum of e'e / K)`", "mean of `e' P^-1 e`; 2 when covariances are true, more when they promise too much",
       "`e' P^-1 e <= 5.991`, the 0.95 quantile of chi-square with two degrees of freedom; 0.95 when they are "
       "true"});
  add(rows, {"self", &WorldModelMetrics::self, "Error of the own place, m", "1: every robot has a pose",
             "of the robot's own place", as_before, as_before});
  add(rows, {"teammates", &WorldModelMetrics::teammates, "Error of teammates, m",
             "over pairs of active robots: it reckons with the other (heard of, not believed penalised, not given up "
             "for lost)",
             "over the pairs with `K`", as_before, as_before});
  const auto opponents = [&](const char* name, const char* unit, const char* title, const char* meaning,
                             std::optional<double> WorldModelMetrics::*value) {
    rows.push_back({.part = part,
                    .name = std::string("world_model.opponents.") + name,
                    .unit = unit,
                    .title = title,
                    .meaning = meaning,
                    .get = [value](const Source& from) { return from.team().world_model.*value; }});
  };
  opponents("listed", "robots", "Opponents known to a robot", "mean number of opponents that it lists, right or wrong",
            &WorldModelMetrics::opponents_listed);
  opponents("ospa_metres", "m", "Error of opponents, m (OSPA)",
            "mean OSPA between the opponents it lists and the active ones", &WorldModelMetrics::ospa_metres);
  opponents("ospa_location_metres", "m", "", "its part from places", &WorldModelMetrics::ospa_location_metres);
  opponents("ospa_cardinality_metres", "m", "", "its part from numbers; the two add up",
            &WorldModelMetrics::ospa_cardinality_metres);
  return rows;
}

// How often something happened.
template <class Get>
MetricRow count(const char* name, const char* title, int digits, const char* meaning, Get get) {
  return {.part = "soccer",
          .name = name,
          .unit = "times",
          .total = Total::sum,
          .title = title,
          .digits = digits,
          .meaning = meaning,
          .get = get};
}

std::vector<MetricRow> numbers_of_soccer() {
  const std::string_view part = "soccer";
  return {
      count("shots", "Shots", 2,
            "a touch in Playing after which the ball, if nobody touched it again, would roll all over the opponent's "
            "goal line between the posts: the way there is at most `v^2 / (2 a)`. A shot lasts until the ball is on no "
            "such course any more or is dead; touches that leave it there are part of it",
            [](const Source& from) { return from.team().play.shots; }),
      count("shots_scored", "", 2, "a goal that counts ended the shot",
            [](const Source& from) { return from.team().play.shots_scored; }),
      count("shots_saved", "Shots saved by the others", 2,
            "the touch of an opponent, goalkeeper or not, turned the ball away",
            [](const Source& from) { return from.team().play.shots_saved; }),
      count("passes", "Passes", 1,
            "the next robot to touch the ball after one of the team is another one of the team, more than 0.5 m from "
            "where it was touched last; nobody put the ball down in between",
            [](const Source& from) { return from.team().play.passes; }),
      count("interceptions", "Interceptions", 1, "the same, but the robot before was an opponent; a save is none",
            [](const Source& from) { return from.team().play.interceptions; }),
      count("meant_passes", "Meant passes", 1,
            "kicks that reached the ball and of which the behaviour said that they are meant for a teammate (extension "
            "`regista.pass`)",
            [](const Source& from) { return from.team().play.meant_passes; }),
      count("meant_passes_arrived", "Meant passes that arrived", 1,
            "after them, the next robot but the kicker to touch the ball is a teammate, the meant one or another; the "
            "kicker has not kicked again, and nobody put the ball down in between",
            [](const Source& from) { return from.team().play.meant_passes_arrived; }),
      count("meant_passes_intercepted", "Meant passes that were intercepted", 1, "the same, but it is an opponent",
            [](const Source& from) { return from.team().play.meant_passes_intercepted; }),
      count("clearances", "Clearances", 1,
            "kicks in open play of a ball in the own third, `x < -length / 6` in the field frame of the team, that are "
            "neither a meant pass nor a shot, and after which the ball leaves that third or gets 2 m farther away from "
            "the centre of the own goal than it lay, before another robot touches it. Assumption: whoever kicks the "
            "ball out of there for nobody in particular clears it; a goal kick is none",
            [](const Source& from) { return from.team().play.clearances; }),
      count("duels_won", "Duels won", 1,
            "of the `duels` of the match: the team is the first to touch the ball once the duel is over, or scores out "
            "of it",
            [](const Source& from) { return from.team().play.duels_won; }),
      {.part = part,
       .name = "possession_seconds",
       .unit = "s",
       .total = Total::sum,
       .title = "Possession, s",
       .digits = 1,
       .meaning = "in play, last touched by this team",
       .get = [](const Source& from) { return from.team().play.possession_seconds; }},
      {.part = part,
       .name = "possession_share",
       .unit = "share",
       .meaning = "of the time in play that either team had it",
       .get = [](const Source& from) { return from.team().play.possession_share; }},
      {.part = part,
       .name = "territory.ball_x_metres",
       .unit = "m",
       .meaning = "mean of the ball's x in the field frame of the team, in play",
       .get = [](const Source& from) { return from.team().play.ball_x_metres; }},
      {.part = part,
       .name = "territory.opponent_half_share",
       .unit = "share",
       .title = "Ball in the other half, share of time in play",
       .digits = 3,
       .meaning = "in play, `x > 0`",
       .get = [](const Source& from) { return from.team().play.opponent_half_share; }},
      {.part = part,
       .name = "distance_walked_metres",
       .unit = "m",
       .total = Total::sum,
       .title = "Distance walked, m",
       .digits = 1,
       .meaning = "sum of the team's `robot_distance_metres`",
       .get = [](const Source& from) { return from.team().play.distance_walked_metres; }},
      {.part = part,
       .name = "robot_distance_metres",
       .unit = "m",
       .total = Total::sum,
       .meaning = "by robot: sum of `0.1 s * speed` of its body in Playing while active; being pushed counts",
       .get = [](const Source& from) { return from.team().play.robot_distance_metres; }},
      count("kicks", "Kicks", 1, "kicks that reached the ball", [](const Source& from) { return from.team().kicks; }),
      count("touches", "Touches", 1,
            "physics steps (0.02 s) in which a robot of the team touched the ball; where two touch it in one step, "
            "only the harder touch counts",
            [](const Source& from) { return from.team().touches; }),
      count("falls", "Falls", 2, "of robots of the team", [](const Source& from) { return from.team().falls; }),
      count("penalties", "Penalties", 2,
            "of robots: removals, and robots that are penalised where they stand for moving in Set (Motion in Set, "
            "15 s without being taken out)",
            [](const Source& from) { return from.team().penalties; }),
  };
}

// One row's numbers of one source.
void take(const MetricRow& row, const MetricSource& source, const MetricName& name, std::vector<MetricName>& names,
          std::vector<double>& values) {
  if (const auto* const number = std::get_if<MetricRow::Number>(&row.get)) {
    const std::optional<double> value = (*number)(source);
    names.push_back(name);
    // How small the numbers of a plugin are, only the plugin knows.
    const bool as_it_is = row.of == Of::plugin_total || row.of == Of::plugin_value;
    values.push_back(!value ? std::numeric_limits<double>::quiet_NaN() : as_it_is ? *value : rounded_metric(*value));
    return;
  }
  int place = 0;
  for (const double value : std::get<MetricRow::List>(row.get)(source)) {
    names.push_back(name);
    names.back().place = ++place;
    values.push_back(rounded_metric(value));
  }
}

std::vector<MetricRow> numbers_of_plugins() {
  const std::string_view part = "plugins";
  return {
      {.of = Of::plugin_total,
       .part = part,
       .name = "plugin_totals",
       .total = Total::sum,
       .meaning = "what a plugin of the team declares as a sum: of all that its instances in all robots reported",
       .get = [](const Source& from) { return from.team().plugins.totals[from.member]; }},
      {.of = Of::plugin_value,
       .part = part,
       .name = "plugin_values",
       .meaning = "what a plugin of the team declares as a mean, a least or a greatest value, or a mean over time; "
                  "`null` when it reported nothing",
       .get = [](const Source& from) { return from.team().plugins.values[from.member]; }},
  };
}

bool has_members(const MetricRow& row) {
  return row.of == Of::event || row.of == Of::plugin_total || row.of == Of::plugin_value;
}

bool ends_with_name(std::string_view path, const std::string& name) {
  return path == name || (path.ends_with(name) && path[path.size() - name.size() - 1] == '.');
}

}  // namespace

std::string MetricRow::path(const std::string& member) const {
  switch (of) {
    case Of::match:
    case Of::team:
      break;
    case Of::role:
      return member + '.' + name;
    case Of::event:
    case Of::plugin_total:
    case Of::plugin_value:
      return name + '.' + member;
  }
  return name;
}

std::string MetricRow::pattern() const {
  return path(of == Of::role ? "<role>" : of == Of::event ? "<event>" : "<plugin>.<metric>");
}

double rounded_metric(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }  // never -0

const std::vector<MetricRow>& metric_table() {
  static const std::vector<MetricRow> table = [] {
    std::vector<MetricRow> rows = numbers_of_the_match();
    for (auto* const part :
         {numbers_of_coordination, numbers_of_packets, numbers_of_the_world, numbers_of_soccer, numbers_of_plugins}) {
      std::ranges::move(part(), std::back_inserter(rows));
    }
    return rows;
  }();
  return table;
}

std::vector<std::string> metric_members(const MetricRow& row, const MemberNames& team) {
  switch (row.of) {
    case Of::role:
      return team.roles;
    case Of::event:
      return team.reasons;
    case Of::plugin_total:
      return team.plugin_totals;
    case Of::plugin_value:
      return team.plugin_values;
    default:
      return {""};
  }
}

MetricNumbers metric_numbers(std::span<const MetricRow> table, const MetricSource& source, const RoleNames& roles) {
  std::vector<MetricName> names;
  std::vector<double> values;
  MetricSource from = source;
  from.member = 0;
  for (const MetricRow& row : table) {
    if (row.of == Of::match) take(row, from, {.name = row.name}, names, values);
  }
  for (const Side side : both_sides) {
    from.side = side;
    const std::vector<std::string>& own_roles = roles[index(side)];
    const PluginMetrics& plugins = from.team().plugins;
    const MemberNames team{own_roles, from.team().reasons, plugins.total_names, plugins.value_names};
    for (const MetricRow& row : table) {
      if (row.of == Of::match || row.of == Of::role) continue;
      const std::vector<std::string> members = metric_members(row, team);
      for (from.member = 0; from.member < members.size(); ++from.member) {
        take(row, from, {.side = side, .name = row.path(members[from.member])}, names, values);
      }
    }
    // A role's numbers stand together.
    for (from.member = 0; from.member < own_roles.size(); ++from.member) {
      for (const MetricRow& row : table) {
        if (row.of != Of::role) continue;
        take(row, from, {.side = side, .role = own_roles[from.member], .name = row.name}, names, values);
      }
    }
  }
  return {std::make_shared<const MetricNames>(std::move(names)), std::move(values)};
}

const MetricRow* find_metric(std::span<const MetricRow> table, std::string_view path) {
  path = without_roles(path);
  // These first: a plugin may call a number as those of roles are called.
  for (const MetricRow& row : table) {
    if (row.of == Of::role) continue;
    if (path == row.name || (has_members(row) && path.starts_with(row.name + '.'))) return &row;
  }
  for (const MetricRow& row : table) {
    if (row.of == Of::role && ends_with_name(path, row.name)) return &row;
  }
  return nullptr;
}

std::vector<std::string> metric_paths(std::span<const MetricRow> table, const MemberNames& team) {
  std::vector<std::string> out;
  for (const MetricRow& row : table) {
    if (row.is_list() || row.of == Of::match || row.of == Of::role) continue;
    for (const std::string& each : metric_members(row, team)) out.push_back(row.path(each));
  }
  const auto of_role = [](const MetricRow& row) { return row.of == Of::role && !row.is_list(); };
  for (const std::string& role : team.roles) {
    for (const MetricRow& row : table) {
      if (of_role(row)) out.push_back(row.path(role));
    }
  }
  for (const MetricRow& row : table) {
    if (of_role(row) && row.total == Total::sum) out.push_back(row.name);
  }
  return out;
}

}  // namespace regista::match
