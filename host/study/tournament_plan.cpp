// SPDX-License-Identifier: MIT
#include "study/tournament_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "campaign/match_setup.hpp"
#include "match/match.hpp"
#include "match/side.hpp"
#include "plugin/info.hpp"
#include "study/measure.hpp"
#include "study/plan_fields.hpp"
#include "study/tournament_calendar.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

// Returns whether all numbers of the plan are in the ranges that class Tournament needs.
bool sound(const TournamentPlan& plan) {
  for (std::size_t i = 0; i < plan.teams.size(); ++i) {
    const bool own = !plan.asked.teams[i].disturbance.empty();
    if (plan.teams[i].disturbances.size() != (own ? 2u : 0u)) return false;
  }
  if (plan.rounds() > 0 && (plan.ended_after || !plan.asked.pairs || plan.teams.size() < 3)) return false;
  if (plan.ended_after && (*plan.ended_after == 0 || *plan.ended_after > plan.pairs())) return false;
  return plan.pairs() <= UINT64_MAX / 2 / plan.pairings().size() && plan.most_goals >= 1;
}

// Returns whether the first key of the path names a side or a document that is not a team's.
bool is_addressed(const std::string& path) {
  constexpr std::array first_parts{"home", "away", "rules", "robot", "disturbance", "opening"};
  return std::ranges::find(first_parts, first_part(path)) != first_parts.end();
}

void require_settable(const config::Node::Entry& setting, const TournamentPlan& plan) {
  const std::string first(first_part(setting.key));
  const auto refuse = [&](const std::string& why) {
    throw config::Error(setting.key_where, fmt::format("{}: {}", setting.key, why));
  };
  const bool letter = first.size() == 1 && first[0] >= 'a' && first[0] <= 'z';
  if (first.size() == 1 && first[0] >= 'A' && first[0] <= 'Z') refuse("teams are called by small letters");
  if (first == "home" || first == "away") {
    refuse(
        "in a tournament each team plays on both sides; begin the path with a for the first team, b for the second, "
        "and so on");
  }
  if (first == "home_disturbance" || first == "away_disturbance") {
    refuse(
        "in a tournament each team plays on both sides; a path that begins with disturbance is for both teams, and "
        "`teams` names a disturbance of one");
  }
  if (first == "opponent" || first == "opponent_disturbance")
    refuse("a tournament has no opponent; begin the path with a for the first team, b for the second, and so on");
  if (letter && first == setting.key)
    refuse(fmt::format("expected a path inside it, as in {}.teammates_forgotten_after", first));
  const std::size_t teams = plan.asked.teams.size();
  if (letter && static_cast<std::size_t>(first[0] - 'a') >= teams)
    refuse(fmt::format("there are {} teams, a to {}", teams, study::letter(std::min<std::size_t>(teams, 26) - 1)));
  if (first == "opening" && plan.asked.settings.openings.empty()) refuse("there is no opening; `openings` names some");
}

// Returns the name of a team and its file, or its letter if another team has the same file.
std::string told_apart(const TournamentPlan& plan, std::size_t team) {
  const std::string& file = plan.asked.teams[team].team;
  const bool same_file = std::ranges::count(plan.asked.teams, file, &config::Tournament::Team::team) > 1;
  const std::string letter = team < 26 ? study::letter(team) : std::to_string(team + 1);
  return fmt::format("{} ({})", plan.teams[team].label, same_file ? letter : file);
}

// A team's label is its name. If teams share a name, their file follows, or their letter if they also share the file.
// A title that is also another team's title, or name without a title, is followed by the label.
void label_teams(TournamentPlan& plan) {
  std::map<std::string, int> names, titles;
  for (const Entrant& team : plan.teams) {
    ++names[team.label];
    ++titles[team.shown()];
  }
  for (std::size_t i = 0; i < plan.teams.size(); ++i) {
    Entrant& team = plan.teams[i];
    if (names[team.label] > 1) team.label = told_apart(plan, i);
    if (!team.title.empty() && titles[team.title] > 1) team.title = fmt::format("{} ({})", team.title, team.label);
  }
}

struct Scene {
  std::string file, who;  // who: the beginning of messages about the scene
};

class TournamentPlanner : Planner<TournamentPlan> {
 public:
  using Planner<TournamentPlan>::Planner;

  PlannedTournament planned() {
    plan_.teams.resize(plan_.asked.teams.size());
    for (const config::Node::Entry& each : plan_.asked.settings.set.entries()) require_settable(each, plan_);
    find_scenes();
    for (std::size_t team = 0; team < plan_.teams.size(); ++team) {
      mistakes_.attempt("", [&] { look_at_team(team); });
    }
    if (!mistakes_.none()) return {};
    count_common_inputs();
    label_teams(plan_);
    look_at_scenes();
    if (!mistakes_.none()) return {};
    refuse_what_never_ends();
    refuse_too_many();
    return {std::move(plan_), std::move(documents_)};
  }

 private:
  // Sets up a match. A path without a side is set for home and away, because the path may be wrong for one team only.
  campaign::MatchSetup setup_of(const TournamentPlan& plan, std::size_t home = 0, std::size_t away = 1) const {
    const Fixture fixture{.home = home, .away = away};
    config::Overrides addressed;
    for (const config::Override& each : settings_of(plan, fixture)) {
      if (is_addressed(each.path)) {
        addressed.push_back(each);
        continue;
      }
      for (const char* const side : {"home.", "away."})
        addressed.emplace_back(side + each.path, each.value, each.where);
    }
    config::Overrides said;
    for (const config::Node::Entry& each : plan.asked.settings.set.entries())
      said.emplace_back(each.key, each.value, each.key_where);
    return match_of(job(plan, fixture), addressed, said, catalogue_);
  }

  void find_scenes() {
    for (const config::NamedPath& each : plan_.asked.settings.openings) {
      const std::string who = config::to_string(each.where) + ": openings";
      for (const std::string& file : opening_files(each.path, who)) scenes_.push_back({file, who});
    }
    if (!scenes_.empty()) plan_.openings = {{scenes_.front().file, {}}};
  }

  void require_metric(const mind::TeamPlan& team) const {
    const Objective objective = plan_.objective();
    const auto* const test = std::get_if<ValueTest>(&objective);
    if (test == nullptr || test->value == goals_value) return;
    std::vector<std::string> paths = metric_paths_of(team);
    const std::string path(match::without_roles(test->value));
    const config::Location where = document_["test"]["metric"].where();
    if (const std::string why = why_missing(path, plan_.short_games()); !why.empty())
      throw config::Error(where, "test.metric " + why);
    if (std::ranges::find(paths, path) != paths.end()) return;
    paths.insert(paths.begin(), goals_value);
    throw config::Error(
        where, texts::unknown("metric", test->value, fmt::format("test.metric, of team {}", team.team().name), paths));
  }

  void look_at_team(std::size_t team) {
    const std::size_t other = (team + 1) % plan_.teams.size();
    const campaign::MatchSetup prepared = setup_of(plan_, team, other);
    if (!mistakes_.doubtful("test.metric")) {
      mistakes_.attempt("test.metric", [&] { require_metric(*prepared.plans[0]); });
    }
    plan_.teams[team].label = prepared.plans[0]->team().name;
    if (prepared.plans[0]->team().title != plan_.teams[team].label)
      plan_.teams[team].title = prepared.plans[0]->team().title;
    plan_.teams[team].inputs = campaign::team_inputs(*prepared.plans[0], *prepared.documents[0], catalogue_);
    documents_.push_back(
        config::show(*prepared.documents[0], plugin::declarations(catalogue_.plugins()), config::Remarks::without));
    plan_.common_inputs = common_inputs_of(prepared);
    keep_disturbance(team, 0);
    keep_disturbance(other, 1);
    if (scenes_.empty()) plan_.most_goals = match::most_goal_difference(prepared.setup);
  }

  std::vector<campaign::Input> common_inputs_of(const campaign::MatchSetup& prepared) const {
    match::Setup setup = prepared.setup;
    setup.opening.reset();  // the common inputs do not include the scene
    return campaign::common_inputs(setup, program_, mathematics_);
  }

  // Stores the input that a team's own disturbance adds to the team's matches on this side.
  void keep_disturbance(std::size_t team, std::size_t side) {
    if (plan_.asked.teams[team].disturbance.empty()) return;
    std::vector<campaign::Input>& out = plan_.teams[team].disturbances;
    out.resize(2);
    out[side] = *std::ranges::find_if(plan_.common_inputs,
                                      [side](const campaign::Input& each) { return is_disturbance(each, side); });
  }

  // Sets the plan's common inputs: the common inputs of a match in which no team has a disturbance of its own.
  void count_common_inputs() {
    TournamentPlan without = plan_;
    for (std::size_t i = 0; i < without.teams.size(); ++i) {
      without.asked.teams[i].disturbance.clear();
      without.teams[i].disturbances.clear();
    }
    plan_.common_inputs = common_inputs_of(setup_of(without));
  }

  void look_at_scenes() {
    std::vector<Opening> found;
    for (const Scene& scene : scenes_) {
      mistakes_.attempt("", [&] {
        TournamentPlan with = plan_;
        with.openings = {{scene.file, {}}};
        const campaign::MatchSetup prepared = setup_of(with);
        plan_.most_goals = std::max(plan_.most_goals, match::most_goal_difference(prepared.setup));
        const config::Opening& opening = *prepared.setup.opening;
        add_scene(found, {scene.file, campaign::opening_input(opening), opening.length}, opening.name, scene.who);
      });
    }
    plan_.openings = std::move(found);
  }

  void refuse_what_never_ends() const {
    if (plan_.asked.pairs || !equal_teams(plan_, {0, 1})) return;
    throw config::Error(document_["test"].where(),
                        "test: the teams are equal to the last byte, so every pair is even and it would never stop; "
                        "`pairs` says how many are enough");
  }

  // Limits the number of fixtures, because the program keeps the inputs of all fixtures in memory.
  void refuse_too_many() const {
    constexpr std::size_t most_fixtures = 50'000;
    const std::size_t fixtures = Calendar(plan_).fixtures();
    if (fixtures <= most_fixtures) return;
    throw config::Error(document_["teams"].where(),
                        fmt::format("teams: {} teams from {} openings make {} fixtures; at most {} can be kept; fewer "
                                    "openings or `format: gauntlet` make fewer",
                                    plan_.teams.size(), plan_.openings.size(), fixtures, most_fixtures));
  }

  std::vector<Scene> scenes_;
  std::vector<std::string> documents_;
};

}  // namespace

// These functions are not in the unnamed namespace, because templates find them by argument-dependent lookup.

template <Like<Entrant> Team, class Visit>
static void fields(Team& team, Visit& visit) {
  visit("label", team.label);
  visit.maybe("title", team.title);
  visit("inputs", team.inputs);
  visit("disturbances", team.disturbances);
}

template <Like<TournamentPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit("teams", plan.teams);
  visit("openings", plan.openings);
  visit("most_goals", plan.most_goals);
  visit.maybe("pairs_before", plan.pairs_before);
  visit.maybe("ended_after", plan.ended_after);
  visit("folder", plan.folder);
  visit("plugins", plan.plugins);
  visit.maybe("program", plan.program);
  visit("common_inputs", plan.common_inputs);
}

Objective objective_of(const config::Tournament& asked) {
  if (!asked.test) return FixedNumber{};
  if (!asked.test->elo) return ValueTest{asked.test->metric, asked.test->alpha};
  ScoreTest out;
  using Model = config::TournamentTest::Model;
  out.design.model = asked.test->model == Model::logistic ? statistics::Model::logistic : statistics::Model::normalized;
  out.design.hypotheses = {(*asked.test->elo)[0], (*asked.test->elo)[1]};
  out.design.rates = {asked.test->alpha, asked.test->beta.value_or(config::TournamentTest::usual_rate)};
  return out;
}

std::uint64_t TournamentPlan::pairs() const {
  return asked.pairs ? static_cast<std::uint64_t>(*asked.pairs) : most_pairs;
}

std::string_view TournamentPlan::open_end() const {
  return pairs() != most_pairs ? "" : asked.test ? "the test" : "the clock";
}

std::vector<Pairing> TournamentPlan::pairings() const {
  std::vector<Pairing> out;
  const bool gauntlet = asked.format == config::Tournament::Format::gauntlet;
  for (std::size_t first = 0; first < asked.teams.size(); ++first) {
    for (std::size_t second = first + 1; second < asked.teams.size(); ++second) {
      if (!gauntlet || first == 0) out.push_back({first, second});
    }
  }
  return out;
}

std::uint64_t TournamentPlan::rounds() const {
  if (asked.format == config::Tournament::Format::knock_out) return knock_out_rounds(teams.size());
  if (asked.format != config::Tournament::Format::swiss) return 0;
  return asked.rounds ? static_cast<std::uint64_t>(*asked.rounds) : knock_out_rounds(teams.size());
}

std::uint64_t TournamentPlan::meetings() const {
  if (asked.format == config::Tournament::Format::knock_out) return teams.size() - 1;
  if (asked.format == config::Tournament::Format::swiss) return rounds() * (teams.size() / 2);
  return pairings().size();
}

std::optional<std::size_t> team_meant(const TournamentPlan& plan, const std::string& path) {
  const std::string_view first = first_part(path);
  if (first.size() != 1 || first[0] < 'a' || first[0] > 'z') return std::nullopt;
  const auto team = static_cast<std::size_t>(first[0] - 'a');
  return team < plan.asked.teams.size() ? std::optional(team) : std::nullopt;
}

bool is_disturbance(const campaign::Input& input, std::size_t side) {
  return input.name.starts_with(side == 0 ? "home disturbance " : "away disturbance ");
}

std::string letter(std::size_t team) {
  return team < 26 ? std::string(1, static_cast<char>('a' + static_cast<char>(team))) : std::string();
}

bool equal_teams(const TournamentPlan& plan, const Pairing& pairing) {
  const Entrant &a = plan.teams[pairing.first], &b = plan.teams[pairing.second];
  return campaign::fixture_key(a.inputs, b.inputs, {}) == campaign::fixture_key(b.inputs, a.inputs, {}) &&
         campaign::fixture_key(a.disturbances, b.disturbances, {}) ==
             campaign::fixture_key(b.disturbances, a.disturbances, {});
}

TournamentPlan with_pairs(TournamentPlan plan, std::uint64_t pairs, std::uint64_t stored_matches) {
  if (plan.asked.test) {
    throw std::invalid_argument(
        "it has a sequential test, whose error rates hold for the number of pairs that was fixed before the first "
        "match");
  }
  if (plan.rounds() > 0) {
    throw std::invalid_argument(
        "the draw of its later rounds depends on the number of pairs, so it cannot have more of them");
  }
  // A study that the clock had to end, and that was interrupted before, has the pairs that were begun.
  const bool begun = !plan.open_end().empty() && !plan.ended_after;
  const std::uint64_t of_each = 2 * plan.meetings();
  const std::uint64_t before = begun ? (stored_matches + of_each - 1) / of_each : plan.pairs_to_its_end();
  if (pairs == before && !plan.ended_after && !begun) return plan;
  if (pairs <= before) throw std::invalid_argument(fmt::format("it has {} pairs already", before));
  if (pairs > most_pairs) throw std::invalid_argument(fmt::format("at most {} pairs can be played", most_pairs));
  plan.ended_after = before;
  plan = without_end(std::move(plan));
  plan.asked.pairs = static_cast<int>(pairs);
  return plan;
}

TournamentPlan without_end(TournamentPlan plan) {
  if (!plan.ended_after) return plan;
  if (!plan.asked.test)
    plan.pairs_before += fmt::format("{}{}", plan.pairs_before.empty() ? "" : ", ", *plan.ended_after);
  plan.ended_after.reset();
  return plan;
}

config::Node until_the_clock(const config::Node& document) {
  if (document["format"] && (document["format"].text() == "swiss" || document["format"].text() == "knock_out")) {
    throw config::BadInput(
        "--until and --minutes: a tournament in rounds is played to its end, or its teams would have different numbers "
        "of matches");
  }
  if (document["pairs"] || document["test"]) return document;
  const config::Location where{"--until or --minutes", 0, 0};
  return config::with(document, "pairs", config::Node::scalar(std::to_string(most_pairs), false, where), where);
}

std::string to_json(const TournamentPlan& plan) { return plan_text(tournament_study, plan); }

TournamentPlan tournament_plan_from_json(const std::string& text) {
  return read_plan<TournamentPlan>(text, tournament_study, tournament_of_version_1, [](const TournamentPlan& plan) {
    if (plan.teams.size() != plan.asked.teams.size() || !sound(plan)) throw std::out_of_range("what no tournament has");
  });
}

std::vector<std::string> differences(const TournamentPlan& before, const TournamentPlan& now) {
  InputDifferences out(document_differences(before, now));
  for (std::size_t team = 0; team < std::min(before.teams.size(), now.teams.size()); ++team) {
    const std::string whose = fmt::format("team {}: ", before.teams[team].label);
    out.add(whose, before.teams[team].inputs, now.teams[team].inputs);
    out.add(whose, before.teams[team].disturbances, now.teams[team].disturbances);
  }
  out.add("", before.common_inputs, now.common_inputs);
  return std::move(out).with_openings(before.openings, now.openings);
}

PlannedTournament planned_tournament(const config::Node& document, const std::vector<std::string>& plugins,
                                     const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  return TournamentPlanner(document, plugins, catalogue, mistakes).planned();
}

}  // namespace regista::study
