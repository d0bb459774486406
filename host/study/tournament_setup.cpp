// SPDX-License-Identifier: MIT
#include "study/tournament_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "campaign/inputs.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/mathematics.hpp"
#include "config/documents.hpp"
#include "config/read.hpp"
#include "config/values.hpp"
#include "match/match.hpp"
#include "plugin/declarations.hpp"
#include "study/packets_spent.hpp"
#include "study/settings.hpp"
#include "study/study_inputs.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

std::string first_part(const std::string& path) { return path.substr(0, path.find('.')); }

// Whether it begins with a team's letter, or is for other documents than a team's.
bool is_addressed(const std::string& path) {
  const std::string first = first_part(path);
  return (first.size() == 1 && first[0] >= 'a' && first[0] <= 'z') || first == "home" || first == "away" ||
         first == "rules" || first == "robot" || first == "disturbance" || first == "opening";
}

void require_settable(const config::Node::Entry& setting, const TournamentPlan& plan) {
  const std::string first = first_part(setting.key);
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

// What teams are called: their names; where these are the same, with their files; where these are too, with letters.
void label_teams(TournamentPlan& plan) {
  const auto file_of = [&](std::size_t i) { return plan.asked.teams[i].team; };
  std::map<std::string, int> seen;
  for (const Entrant& team : plan.teams) ++seen[team.label];
  for (std::size_t i = 0; i < plan.teams.size(); ++i) {
    std::string& label = plan.teams[i].label;
    if (seen[label] == 1) continue;
    const bool same_file = std::ranges::count(plan.asked.teams, file_of(i), &config::Tournament::Team::team) > 1;
    const std::string letter = i < 26 ? study::letter(i) : std::to_string(i + 1);
    label = fmt::format("{} ({})", label, same_file ? letter : file_of(i));
  }
}

struct Scene {
  std::string file, who;  // who: what a message about it begins with
};

class Planner {
 public:
  Planner(const config::Node& document, const std::vector<std::string>& plugins, const plugin::Catalogue& catalogue,
          config::Mistakes& mistakes)
      : document_(document),
        catalogue_(catalogue),
        mistakes_(mistakes),
        program_(campaign::program_hash()),
        mathematics_(campaign::mathematics_fingerprint()) {
    plan_.asked = config::read_document<config::Tournament>(document);
    config::rename_files(declare(plan_.asked), from_here);
    plan_.teams.resize(plan_.asked.teams.size());
    plan_.folder = std::filesystem::current_path().string();
    plan_.plugins = plugins;
  }

  PlannedTournament planned() {
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
  // Both sides are named, as an error of one is not the other's.
  campaign::MatchSetup setup_of(const TournamentPlan& plan, const Fixture& fixture) const {
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
      for (const std::string& file : opening_files({each.path}, who)) scenes_.push_back({file, who});
    }
    if (!scenes_.empty()) plan_.openings = {{scenes_.front().file, {}}};
  }

  void require_metric(const mind::TeamPlan& team) const {
    const Objective objective = plan_.objective();
    const auto* const test = std::get_if<ValueTest>(&objective);
    if (test == nullptr || test->value == goals_value) return;
    std::vector<std::string> paths = metric_paths_of(team);
    const std::string prefix = "roles.";
    const std::string path = test->value.starts_with(prefix) ? test->value.substr(prefix.size()) : test->value;
    const config::Location where = document_["test"]["metric"].where();
    if (const std::string why = why_missing(path, plan_.short_games()); !why.empty())
      throw config::Error(where, "test.metric " + why);
    if (std::ranges::find(paths, path) != paths.end()) return;
    paths.insert(paths.begin(), goals_value);
    throw config::Error(
        where, texts::unknown("metric", test->value, fmt::format("test.metric, of team {}", team.team().name), paths));
  }

  void look_at_team(std::size_t team) {
    Fixture fixture;
    fixture.home = team;
    fixture.away = (team + 1) % plan_.teams.size();
    const campaign::MatchSetup prepared = setup_of(plan_, fixture);
    if (!mistakes_.doubtful("test.metric")) {
      mistakes_.attempt("test.metric", [&] { require_metric(*prepared.plans[0]); });
    }
    plan_.teams[team].label = prepared.plans[0]->team().name;
    plan_.teams[team].inputs = campaign::team_inputs(*prepared.plans[0], *prepared.documents[0], catalogue_);
    documents_.push_back(
        config::show(*prepared.documents[0], plugin::declarations(catalogue_.plugins()), config::Remarks::without));
    plan_.common_inputs = common_inputs_of(prepared);
    keep_disturbance(fixture.home, 0);
    keep_disturbance(fixture.away, 1);
    if (scenes_.empty()) plan_.most_goals = match::most_goal_difference(prepared.setup);
  }

  std::vector<campaign::Input> common_inputs_of(const campaign::MatchSetup& prepared) const {
    return campaign::common_inputs(without_opening(prepared.setup), program_, mathematics_);
  }

  // What a disturbance of its own adds to the matches of a team on this side.
  void keep_disturbance(std::size_t team, std::size_t side) {
    if (plan_.asked.teams[team].disturbance.empty()) return;
    std::vector<campaign::Input>& out = plan_.teams[team].disturbances;
    out.resize(2);
    out[side] = *std::ranges::find_if(plan_.common_inputs,
                                      [side](const campaign::Input& each) { return is_disturbance(each, side); });
  }

  // What is common is that of teams that nothing of their own disturbs.
  void count_common_inputs() {
    TournamentPlan without = plan_;
    for (std::size_t i = 0; i < without.teams.size(); ++i) {
      without.asked.teams[i].disturbance.clear();
      without.teams[i].disturbances.clear();
    }
    Fixture fixture;
    fixture.away = 1;
    plan_.common_inputs = common_inputs_of(setup_of(without, fixture));
  }

  void look_at_scenes() {
    std::vector<Opening> found;
    for (const Scene& scene : scenes_) {
      mistakes_.attempt("", [&] {
        TournamentPlan with = plan_;
        with.openings = {{scene.file, {}}};
        Fixture fixture;
        fixture.away = 1;
        const campaign::MatchSetup prepared = setup_of(with, fixture);
        plan_.most_goals = std::max(plan_.most_goals, match::most_goal_difference(prepared.setup));
        add_scene(found, {scene.file, campaign::opening_input(*prepared.setup.opening)}, prepared.setup.opening->name,
                  scene.who);
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

  // Each fixture is known with all its inputs before the first match.
  void refuse_too_many() const {
    constexpr std::size_t most_fixtures = 50'000;
    const std::size_t fixtures = Calendar(plan_).fixtures();
    if (fixtures <= most_fixtures) return;
    throw config::Error(document_["teams"].where(),
                        fmt::format("teams: {} teams from {} openings make {} fixtures; at most {} can be kept; fewer "
                                    "openings or `format: gauntlet` make fewer",
                                    plan_.teams.size(), plan_.openings.size(), fixtures, most_fixtures));
  }

  const config::Node& document_;
  const plugin::Catalogue& catalogue_;
  config::Mistakes& mistakes_;
  std::string program_, mathematics_;
  std::vector<Scene> scenes_;
  TournamentPlan plan_;
  std::vector<std::string> documents_;
};

}  // namespace

PlannedTournament planned_tournament(const config::Node& document, const std::vector<std::string>& plugins,
                                     const plugin::Catalogue& catalogue) {
  config::Mistakes first(config::Mistakes::After::stop);
  return Planner(document, plugins, catalogue, first).planned();
}

void check_tournament(const config::Node& document, const std::vector<std::string>& plugins,
                      const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  mistakes.attempt("", [&] { Planner(document, plugins, catalogue, mistakes).planned(); });
}

}  // namespace regista::study
