// SPDX-License-Identifier: MIT
#include "match/metric_table.hpp"

#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace regista::match {
namespace {

using Source = MetricSource;
using Of = MetricRow::Of;
using Total = MetricRow::Total;

// Reads `value` from the part of the metrics whose type is Part: MatchMetrics, TeamMetrics or a struct within these.
template <class Part, class Value>
const Value& member(const Source& from, Value Part::*value) {
  const MatchMetrics& match = from.result.metrics;
  const TeamMetrics& team = from.team();
  return std::get<const Part&>(std::tie(from.result, match, match.ball_rests, team, team.coordination, team.agreement,
                                        team.tenure, team.targets, team.ball, team.world_model, team.play,
                                        team.segments)).*
         value;
}

// How an HTML page shows a row. A row with an empty title is on no page. digits: digits of a mean after the point.
struct Page {
  const char* title = "";
  int digits = 2;
};

// Makes a row. get: a function of MetricSource, or a pointer to a member that member() can read.
template <class Get>
MetricRow row(Total total, std::string name, const char* unit, Page page, std::string meaning, Get get) {
  MetricRow out{.name = std::move(name),
                .unit = unit,
                .total = total,
                .title = page.title,
                .digits = page.digits,
                .meaning = std::move(meaning)};
  if constexpr (std::is_member_pointer_v<Get>) {
    out.get = [get](const Source& from) { return member(from, get); };
  } else {
    out.get = std::move(get);
  }
  return out;
}

template <class Get>
MetricRow sum(std::string name, const char* unit, Page page, std::string meaning, Get get) {
  return row(Total::sum, std::move(name), unit, page, std::move(meaning), std::move(get));
}

template <class Get>
MetricRow mean(std::string name, const char* unit, Page page, std::string meaning, Get get) {
  return row(Total::mean, std::move(name), unit, page, std::move(meaning), std::move(get));
}

MetricRow of(Of whom, MetricRow row) {
  row.of = whom;
  return row;
}

std::vector<MetricRow> numbers_of_the_match() {
  std::vector<MetricRow> rows{
      sum("simulated_seconds", "s", {}, "from the placement to the end, breaks left out", &Result::simulated_seconds),
      sum("playing_seconds", "s", {}, "phase Playing", &MatchMetrics::playing_seconds),
      sum("in_play_seconds", "s", {}, "ball in play", &MatchMetrics::in_play_seconds),
      sum("ball_rest_seconds", "s", {},
          "in play, the ball is slower than 0.05 m/s though an able robot of either team could touch it within 3 s: "
          "the way from its centre to that of the ball, less the radius of its body, is at most what it walks in 3 s "
          "at full forward speed",
          &BallRests::seconds),
      sum("ball_rests", "times", {}, "that it came to rest so", &BallRests::count),
      sum("long_ball_rests", "times", {}, "those of them that lasted more than 15 s of play", &BallRests::long_ones),
      mean("ball_rest_longest_seconds", "s", {}, "the longest of them", &BallRests::longest_seconds),
      sum("ball_crowd_seconds", "s", {}, "in play, five or more active robots of both teams are within 1 m of the ball",
          &MatchMetrics::ball_crowd_seconds),
      sum("duels", "times", {},
          "in play, for 1 s or more without a break at least one able robot of each team is within 0.5 m of the ball. "
          "When that holds again before anybody has touched the ball, it is the same duel",
          &MatchMetrics::duels),
  };
  for (MetricRow& each : rows) each.of = Of::match;
  rows.insert(rows.begin(), sum("score", "goals", {}, "that count, at the end",
                                [](const Source& from) { return from.result.score[index(from.side)]; }));
  return rows;
}

using Counts = RoleMetrics::Counts;

// The rows with one number for each role. Studies may also name the sum of a number over all roles of a team.
std::vector<MetricRow> numbers_of_roles() {
  std::vector<MetricRow> rows{
      sum("overlap_seconds", "s", {}, "`h_r >= 2`", [](const Source& from) { return from.role().all.overlap_seconds; }),
      sum("uncovered_seconds", "s", {},
          "`h_r = 0` though the role was wanted: it is in the list in force, its place in that list (from 0) is below "
          "`R`, `R` is at least its `least_in_play`, and one of the robots it is bound to, if any, is active. In force "
          "is the list in which most active robots hold "
          "a role; while nobody holds one, none",
          [](const Source& from) { return from.role().all.uncovered_seconds; }),
      sum("switches", "times", {}, "a robot takes the role in Playing that it did not hold at its last decision",
          [](const Source& from) { return from.role().all.switches; }),
      sum("unplayed_seconds", "s", {},
          "`h_r = 0` though more than `R / 2` of the active robots last decided on an assignment in which somebody has "
          "the role",
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
          sum(std::string(name) + '_' + span.name + "_silence_seconds", "s", {}, span.meaning,
              [value = value, counts = span.counts](const Source& from) { return from.role().*counts.*value; }));
    }
  }
  for (const Span& span : {before, after}) {
    rows.push_back(sum(std::string("switches_") + span.name + "_silence", "times", {}, span.meaning,
                       [counts = span.counts](const Source& from) { return (from.role().*counts).switches; }));
  }
  rows.push_back(sum("robot_seconds", "s", {}, "by robot: time it was active and held the role",
                     [](const Source& from) { return from.role().robot_seconds; }));
  for (MetricRow& each : rows) each.of = Of::role;
  return rows;
}

// The rows with sums over all roles per minute of play. Rates allow a comparison of spans of different lengths.
std::vector<MetricRow> rates() {
  struct Span {
    const char *name, *meaning;
    Counts RoleMetrics::*counts;
    double (*length)(const Source& from);
  };
  constexpr Span all{"", "`60 * sum over roles / playing_seconds`", &RoleMetrics::all,
                     [](const Source& from) { return from.result.metrics.playing_seconds; }};
  constexpr Span before{
      "_before_silence", "over `playing_seconds - silent_seconds`", &RoleMetrics::before_silence,
      [](const Source& from) { return from.result.metrics.playing_seconds - from.team().coordination.silent_seconds; }};
  constexpr Span after{"_after_silence", "over `silent_seconds`", &RoleMetrics::after_silence,
                       [](const Source& from) { return from.team().coordination.silent_seconds; }};
  std::vector<MetricRow> rows;
  for (const Span& span : {all, before, after}) {
    const auto add = [&](const std::string& what, const char* unit, auto Counts::*value) {
      rows.push_back(mean("rates." + what + "_per_minute" + span.name, unit, {}, span.meaning,
                          [span, value](const Source& from) -> std::optional<double> {
                            if (!(span.length(from) > 0.0)) return std::nullopt;
                            double sum = 0.0;
                            for (const RoleMetrics& role : from.team().coordination.roles) {
                              sum += role.*span.counts.*value;
                            }
                            return 60.0 * sum / span.length(from);
                          }));
    };
    add("overlap_seconds", "s/min", &Counts::overlap_seconds);
    add("uncovered_seconds", "s/min", &Counts::uncovered_seconds);
    add("switches", "1/min", &Counts::switches);
  }
  return rows;
}

std::vector<MetricRow> numbers_of_coordination() {
  std::vector<MetricRow> rows = numbers_of_roles();
  const std::vector<MetricRow> of_the_team{
      sum("silent_seconds", "s", {"Silent to the end, s of play", 1},
          "of Playing, after the silence began; 0 without one", &CoordinationMetrics::silent_seconds),
      mean("agreement", "share", {"Agreement of all robots on the assignment, share of time", 3},
           "of the samples with `R >= 2`: all active robots last decided on the same assignment of the whole team; "
           "`null` without such samples",
           &CoordinationMetrics::agreement),
      mean("agreement_before_silence", "share", {}, "the same, of the samples before the team's silence",
           &CoordinationMetrics::agreement_before_silence),
      mean("agreement_after_silence", "share", {}, "of those after it began",
           &CoordinationMetrics::agreement_after_silence),
      mean("context_agreement", "share", {"Agreement of all robots on the context, share of time", 3},
           "of the samples with `R >= 2`: all active robots last decided in the same context, or all in none",
           &AgreementMetrics::context),
      mean("kept_tasks_agreement", "share", {"Agreement of all robots on the kept tasks, share of time", 3},
           "of the same samples: all active robots last kept the same tasks, or had none to keep",
           &AgreementMetrics::kept_tasks),
      mean("assignment_agreement_given_tasks", "share", {"", 3},
           "of those of them with the same kept tasks: all active robots last decided on the same assignment",
           &AgreementMetrics::assignment_given_tasks),
      mean("tenure_median_seconds", "s", {"Median tenure of a role, s"},
           "how long a robot holds a role before it takes another: median over all finished tenures of all robots; "
           "`null` without one",
           &TenureMetrics::median_seconds),
      mean("tenure_10_percent_seconds", "s", {}, "their 0.1 quantile: a tenth of the tenures are shorter",
           &TenureMetrics::tenth_seconds),
      mean("target_distance_mean_metres", "m", {"Distance between two targets, m"},
           "distance between the targets of two active robots: mean over all pairs of all samples",
           &TargetMetrics::mean_metres),
      mean("target_distance_least_metres", "m", {},
           "that of the pair whose targets are nearest together: mean over the samples with two targets or more",
           &TargetMetrics::least_metres),
      mean("nearest_plays_ball", "share", {"The robot nearest to the ball plays it, share of time in play", 3},
           "of the samples in play with an able robot of the team: the one nearest to the ball goes for it",
           &BallMetrics::nearest_plays_share),
      mean("robots_near_ball", "robots", {"Robots within 1 m of the ball"},
           "active ones whose centre is within 1 m of that of the ball: mean over the samples in play",
           &BallMetrics::robots_near),
      sum("ball_chased_by_several_seconds", "s", {"Two or more robots go for the ball, s", 1},
          "in play, two or more able robots of the team go for the ball", &BallMetrics::chased_by_several_seconds)};
  rows.insert(rows.end(), of_the_team.begin(), of_the_team.end());
  std::ranges::move(rates(), std::back_inserter(rows));
  return rows;
}

std::vector<MetricRow> numbers_of_packets() {
  const auto segments = [](const char* name, const char* meaning, std::int64_t mind::SegmentCounts::*count) {
    return sum(name, "segments", {}, meaning, count);
  };
  return {
      sum("packets", "packets", {}, "charged to the budget, too long ones included",
          [](const Source& from) { return from.result.packets[index(from.side)]; }),
      sum("packet_bytes", "bytes", {}, "of those packets, core and segments together, without what the network adds",
          &TeamMetrics::packet_bytes),
      of(Of::event, sum("packets_by_reason", "packets", {},
                        "those that the sender plugin sent for this reason: an event, or one that the plugin names",
                        [](const Source& from) { return from.team().packets_by_reason[from.member]; })),
      sum("packets_share", "packets", {},
          "of a match that is ended before its time (`--limit`, an opening), else `null`: the budget times the share "
          "of the time it may last",
          [](const Source& from) { return from.packets_share; }),
      sum("packets_over_share", "packets", {},
          "`packets` less that share. A team above it by more than 5 % of the share sends more often than the budget "
          "of a whole match allows",
          [](const Source& from) -> std::optional<double> {
            if (!from.packets_share) return std::nullopt;
            return from.result.packets[index(from.side)] - rounded_metric(*from.packets_share);
          }),
      sum("budget_curve", "packets", {},
          "what is left of the budget when the clock of the match shows 1, 2, 3 ... minutes, through all halves",
          [](const Source& from) {
            const std::vector<int>& curve = from.team().budget_curve;
            return std::vector<double>(curve.begin(), curve.end());
          }),
      segments("segments_offered",
               "bytes that plugins offered for packets through their mailboxes, those refused left out",
               &mind::SegmentCounts::offered),
      segments("segments_refused",
               "offers that were refused: too long for any packet, expired already, too many pending, or senseless",
               &mind::SegmentCounts::refused),
      segments("segments_sent", "of those offered: left a robot in a packet, whatever the radio made of it",
               &mind::SegmentCounts::sent),
      sum("segment_bytes", "bytes", {}, "of the segments that were sent, with the two bytes of heading of each",
          &mind::SegmentCounts::bytes),
      segments("segments_dropped",
               "of those offered: expired, replaced or withdrawn before a packet took them. What is neither sent nor "
               "dropped was pending at the end",
               &mind::SegmentCounts::dropped),
      segments("segments_heard",
               "segments that reached a plugin of a teammate: each of those sent counts once for every teammate that "
               "heard it",
               &mind::SegmentCounts::heard),
  };
}

// The texts of the rows about the estimates of one object: the ball, the robot's own pose or the teammates.
struct Estimates {
  const char* name;
  EstimateMetrics WorldModelMetrics::*of;
  const char *error, *known, *rmse, *nees, *coverage;  // error: title of rmse_metres; the other texts are meanings
};

void add(std::vector<MetricRow>& rows, const Estimates& what) {
  const auto add = [&](const char* last, const char* unit, const char* title, const char* meaning,
                       std::optional<double> EstimateMetrics::*value) {
    rows.push_back(mean(std::string("world_model.") + what.name + '.' + last, unit, {title}, meaning,
                        [of = what.of, value](const Source& from) { return from.team().world_model.*of.*value; }));
  };
  add("known_share", "share", "", what.known, &EstimateMetrics::known_share);
  add("rmse_metres", "m", what.error, what.rmse, &EstimateMetrics::rmse_metres);
  add("nees", "", "", what.nees, &EstimateMetrics::nees);
  add("coverage_95", "share", "", what.coverage, &EstimateMetrics::coverage_95);
}

std::vector<MetricRow> numbers_of_the_world() {
  std::vector<MetricRow> rows{mean("ball_seen_share", "share", {"Ball seen, share of time", 3},
                                   "samples (10 Hz) in which an active robot saw the ball in the image of its last "
                                   "decision: a sighting within 1 m of it",
                                   &WorldModelMetrics::ball_seen_share)};
  constexpr auto as_before = "as of the ball";
  add(rows,
      {"ball", &WorldModelMetrics::ball, "Error of the ball, m",
       "`K / A`: it believes to know where the ball is, and its own eyes have not refuted that",
       "`sqrt(sum of e'e / K)`", "mean of `e' P^-1 e`; 2 when covariances are true, more when they promise too much",
       "`e' P^-1 e <= 5.991`, the 0.95 quantile of chi-square with two degrees of freedom; 0.95 when they are true"});
  add(rows, {"self", &WorldModelMetrics::self, "Error of the own place, m", "1: every robot has a pose",
             "of the robot's own place", as_before, as_before});
  add(rows, {"teammates", &WorldModelMetrics::teammates, "Error of teammates, m",
             "over pairs of active robots: it reckons with the other (heard of, not believed penalised, not given up "
             "for lost)",
             "over the pairs with `K`", as_before, as_before});
  rows.insert(rows.end(),
              {mean("world_model.opponents.listed", "robots", {"Opponents known to a robot"},
                    "mean number of opponents that it lists, right or wrong", &WorldModelMetrics::opponents_listed),
               mean("world_model.opponents.ospa_metres", "m", {"Error of opponents, m (OSPA)"},
                    "mean OSPA between the opponents it lists and the active ones", &WorldModelMetrics::ospa_metres),
               mean("world_model.opponents.ospa_location_metres", "m", {}, "its part from places",
                    &WorldModelMetrics::ospa_location_metres),
               mean("world_model.opponents.ospa_cardinality_metres", "m", {}, "its part from numbers; the two add up",
                    &WorldModelMetrics::ospa_cardinality_metres)});
  return rows;
}

std::vector<MetricRow> numbers_of_soccer() {
  const auto count = [](const char* name, Page page, const char* meaning, auto get) {
    return sum(name, "times", page, meaning, get);
  };
  return {
      count("shots", {"Shots"},
            "a touch in Playing after which the ball, if nobody touched it again, would roll all over the opponent's "
            "goal line between the posts: the way there is at most `v^2 / (2 a)`. A shot lasts until the ball is on no "
            "such course any more or is dead; touches that leave it there are part of it",
            &PlayMetrics::shots),
      count("shots_scored", {}, "a goal that counts ended the shot", &PlayMetrics::shots_scored),
      count("shots_saved", {"Shots saved by the others"},
            "the touch of an opponent, goalkeeper or not, turned the ball away", &PlayMetrics::shots_saved),
      count("passes", {"Passes", 1},
            "the next robot to touch the ball after one of the team is another one of the team, more than 0.5 m from "
            "where it was touched last; nobody put the ball down in between",
            &PlayMetrics::passes),
      count("interceptions", {"Interceptions", 1},
            "the same, but the robot before was an opponent; a save is not an interception",
            &PlayMetrics::interceptions),
      count("meant_passes", {"Meant passes", 1},
            "kicks that reached the ball and of which the behaviour said that they are meant for a teammate (extension "
            "`regista.pass`)",
            &PlayMetrics::meant_passes),
      count("meant_passes_arrived", {"Meant passes that arrived", 1},
            "after them, the next robot but the kicker to touch the ball is a teammate, the meant one or another; the "
            "kicker has not kicked again, and nobody put the ball down in between",
            &PlayMetrics::meant_passes_arrived),
      count("meant_passes_intercepted", {"Meant passes that were intercepted", 1}, "the same, but it is an opponent",
            &PlayMetrics::meant_passes_intercepted),
      count(
          "clearances", {"Clearances", 1},
          "kicks in open play of a ball in the own third, `x < -length / 6` in the field frame of the team, that are "
          "neither a meant pass nor a shot, and after which the ball leaves that third or gets 2 m farther away from "
          "the centre of the own goal than it lay, before another robot touches it. Assumption: a robot that kicks the "
          "ball out of there for no particular teammate clears it; a goal kick is not a clearance",
          &PlayMetrics::clearances),
      count("duels_won", {"Duels won", 1},
            "of the `duels` of the match: the team is the first to touch the ball once the duel is over, or scores out "
            "of it",
            &PlayMetrics::duels_won),
      sum("possession_seconds", "s", {"Possession, s", 1}, "in play, last touched by this team",
          &PlayMetrics::possession_seconds),
      mean("possession_share", "share", {}, "of the time in play that either team had it",
           &PlayMetrics::possession_share),
      mean("territory.ball_x_metres", "m", {}, "mean of the ball's x in the field frame of the team, in play",
           &PlayMetrics::ball_x_metres),
      mean("territory.opponent_half_share", "share", {"Ball in the other half, share of time in play", 3},
           "in play, `x > 0`", &PlayMetrics::opponent_half_share),
      sum("goal_empty_seconds", "s", {"No robot at the own goal, s", 1},
          "in play, no able robot of the team has its centre in its own penalty area",
          &PlayMetrics::goal_empty_seconds),
      sum("distance_walked_metres", "m", {"Distance walked, m", 1}, "sum of the team's `robot_distance_metres`",
          &PlayMetrics::distance_walked_metres),
      sum("robot_distance_metres", "m", {},
          "by robot: sum of `0.1 s * speed` of its body in Playing while active; being pushed counts",
          &PlayMetrics::robot_distance_metres),
      count("kicks", {"Kicks", 1}, "kicks that reached the ball", &TeamMetrics::kicks),
      count("touches", {"Touches", 1},
            "physics steps (0.02 s) in which a robot of the team touched the ball; where two touch it in one step, "
            "only the harder touch counts",
            &TeamMetrics::touches),
      count("falls", {"Falls"}, "of robots of the team", &TeamMetrics::falls),
      count("penalties", {"Penalties"},
            "of robots: removals, and robots that are penalised where they stand for moving in Set (Motion in Set, 15 "
            "s without being taken out)",
            &TeamMetrics::penalties),
  };
}

std::vector<MetricRow> numbers_of_plugins() {
  return {of(Of::plugin_total,
             sum("plugin_totals", "", {},
                 "what a plugin of the team declares as a sum: of all that its instances in all robots reported",
                 [](const Source& from) { return from.team().plugins.totals[from.member]; })),
          of(Of::plugin_value, mean("plugin_values", "", {},
                                    "what a plugin of the team declares as a mean, a least or a greatest value, or a "
                                    "mean over time; `null` when it reported nothing",
                                    [](const Source& from) { return from.team().plugins.values[from.member]; }))};
}

// Reads the number or list of a row from `source`, and appends the names and values.
void take(const MetricRow& row, const MetricSource& source, const MetricName& name, std::vector<MetricName>& names,
          std::vector<double>& values) {
  if (const auto* const number = std::get_if<MetricRow::Number>(&row.get)) {
    const std::optional<double> value = (*number)(source);
    names.push_back(name);
    // Numbers of plugins are not rounded, because they may be very small.
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

bool has_members(const MetricRow& row) {
  return row.of == Of::event || row.of == Of::plugin_total || row.of == Of::plugin_value;
}

bool ends_with_name(std::string_view path, const std::string& name) {
  return path == name || (path.ends_with(name) && path[path.size() - name.size() - 1] == '.');
}

}  // namespace

std::string MetricRow::path(const std::string& member) const {
  if (of == Of::role) return member + '.' + name;
  return has_members(*this) ? name + '.' + member : name;
}

std::string MetricRow::pattern() const {
  return path(of == Of::role ? "<role>" : of == Of::event ? "<event>" : "<plugin>.<metric>");
}

double rounded_metric(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }  // + 0.0 turns -0 into 0

const std::vector<MetricRow>& metric_table() {
  static const std::vector<MetricRow> table = [] {
    const std::array parts{numbers_of_the_match, numbers_of_coordination, numbers_of_packets,
                           numbers_of_the_world, numbers_of_soccer,       numbers_of_plugins};
    static_assert(parts.size() == metric_parts.size());
    std::vector<MetricRow> rows;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (MetricRow& row : parts[i]()) {
        row.part = metric_parts[i];
        rows.push_back(std::move(row));
      }
    }
    return rows;
  }();
  return table;
}

std::vector<std::string> metric_members(const MetricRow& row, const MemberNames& team) {
  if (row.of == Of::role) return team.roles;
  if (row.of == Of::event) return team.reasons;
  if (row.of == Of::plugin_total) return team.plugin_totals;
  if (row.of == Of::plugin_value) return team.plugin_values;
  return {""};
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
    // The loop over roles is the outer one, so that all numbers of a role are next to each other.
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
  // Role rows are searched last, because a plugin's metric may have the same name as a number of a role.
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
