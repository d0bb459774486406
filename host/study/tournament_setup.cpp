// SPDX-License-Identifier: MIT
#include "study/tournament_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/mathematics.hpp"
#include "config/bad_input.hpp"
#include "config/documents.hpp"
#include "config/flow.hpp"
#include "config/scalar.hpp"
#include "config/text.hpp"
#include "config/typed.hpp"
#include "match/match.hpp"
#include "plugin/declarations.hpp"
#include "study/document_settings.hpp"
#include "study/more_pairs.hpp"
#include "study/packets_spent.hpp"
#include "study/sequential_test_options.hpp"
#include "study/study_inputs.hpp"

namespace regista::study {
namespace {

constexpr std::size_t most_teams = 1000;

// What is asked for, whoever says it, and where a document says it.
struct Asked {
  TournamentRequest options;  // those of a document are as the command line would say them
  config::Node document;      // absent: the command line said it
  std::vector<Setting> settings;
  std::vector<config::NamedPath> scenes;
  std::string name, question;
  config::Isolation isolation = config::Isolation::after_death;
  bool play_twice = true, allow_shared_memory = false;

  bool by_document() const { return !options.file.empty(); }
};

Format parse_format(const std::string& text) {
  if (text.empty() || text == "round-robin") return Format::round_robin;
  if (text == "gauntlet") return Format::gauntlet;
  throw config::BadInput(
      config::unknown("format", text, "--format", std::vector<std::string>{"round-robin", "gauntlet"}));
}

Objective parse_objective(const TournamentRequest& options) {
  const auto alone = [](const std::string& option, const std::string& text, const char* wants) {
    if (!text.empty())
      throw config::BadInput(fmt::format("{} {}: belongs to {}, which is not given", option, text, wants));
  };
  if (!options.sprt.empty() && !options.metric.empty()) {
    throw config::BadInput("--sprt and --metric: a tournament has one test; which of them is to decide?");
  }
  if (!options.sprt.empty()) {
    ScoreTest test;
    test.design.model = parse_model(options.model.empty() ? "normalized" : options.model);
    test.design.hypotheses = parse_hypotheses("--sprt", options.sprt);
    test.design.rates =
        parse_rates(options.alpha.empty() ? "0.05" : options.alpha, options.beta.empty() ? "0.05" : options.beta);
    return test;
  }
  alone("--model", options.model, "--sprt");
  alone("--beta", options.beta, "--sprt");
  if (!options.metric.empty()) {
    return ValueTest{options.metric, config::parse_rate("--alpha", options.alpha.empty() ? "0.05" : options.alpha)};
  }
  alone("--alpha", options.alpha, "--sprt or --metric");
  return FixedNumber{};
}

// Throws the error of a value that the document sets with its place there: of the value, or of its path where there is
// no such path.
void tell_where_it_is_set(std::string text, const Asked& asked) {
  for (const Setting& each : asked.settings) {
    const std::string said = fmt::format("--set {}={}: ", each.path, each.value);
    if (!text.starts_with(said)) continue;
    text.erase(0, said.size());
    for (const std::string_view side : {"home team: ", "away team: "}) {
      if (text.starts_with(side)) text.erase(0, side.size());
    }
    const bool of_path = text.starts_with("unknown ") || text.find("begin the path") != std::string::npos;
    throw config::Error(of_path ? each.path_where : each.value_where, each.path + ": " + text);
  }
}

// Those that do not begin with a team's letter go to the match as they are.
void check_overrides(const TournamentRequest& options) {
  for (const std::string& typed : options.overrides) {
    const std::string first = typed.substr(0, typed.find('.'));
    if (first.size() == 1 && first[0] >= 'A' && first[0] <= 'Z') {
      throw config::BadInput(fmt::format("--set {}: teams are called by small letters", config::one_line(typed)));
    }
    if (first == "home" || first == "away") {
      throw config::BadInput(
          fmt::format("--set {}: in a tournament each team plays on both sides; begin the path with a for the first "
                      "team, b for the second, and so on",
                      config::one_line(typed)));
    }
    if (first == "home_disturbance" || first == "away_disturbance") {
      throw config::BadInput(
          fmt::format("--set {}: in a tournament each team plays on both sides; a path that begins with disturbance is "
                      "for both teams",
                      config::one_line(typed)));
    }
    if (first.size() == 1 && first[0] >= 'a' && first[0] <= 'z' &&
        static_cast<std::size_t>(first[0] - 'a') >= options.teams.size()) {
      throw config::BadInput(fmt::format("--set {}: there are {} teams, a to {}", config::one_line(typed),
                                         options.teams.size(),
                                         letter(std::min<std::size_t>(options.teams.size(), 26) - 1)));
    }
  }
}

// A match of the plan, set up; errors name teams as they were typed.
campaign::MatchSetup setup_of(const TournamentPlan& plan, const Fixture& fixture, const Asked& asked,
                              const plugin::Catalogue& catalogue) {
  try {
    return campaign::match_setup(campaign::request_of(job(plan, fixture)), catalogue);
  } catch (const config::Error& error) {
    std::string text = error.what();
    for (const auto& [side, team] : {std::pair{"--set home.", fixture.home}, {"--set away.", fixture.away}}) {
      if (text.starts_with(side)) {
        text.replace(0, std::string_view(side).size(), fmt::format("--set {}.", letter(team)));
      }
    }
    tell_where_it_is_set(text, asked);
    throw config::BadInput(text);
  }
}

// What a disturbance of its own adds to the matches of a team on this side.
void keep_disturbance(Entrant& team, std::size_t side, const std::vector<campaign::Input>& inputs) {
  if (!team.disturbed()) return;
  team.disturbances.resize(2);
  team.disturbances[side] =
      *std::ranges::find_if(inputs, [side](const campaign::Input& each) { return is_disturbance(each, side); });
}

// What teams are called: their names; where these are the same, with their files; where these are too, with letters.
void label_teams(std::vector<Entrant>& teams) {
  const auto distinguish = [&](auto&& by) {
    std::map<std::string, int> seen;
    for (const Entrant& team : teams) ++seen[team.label];
    for (std::size_t i = 0; i < teams.size(); ++i) {
      if (seen[teams[i].label] > 1) teams[i].label = fmt::format("{} ({})", teams[i].label, by(i));
    }
  };
  const auto same_files = [&](const Entrant& a) { return std::ranges::count(teams, a.file, &Entrant::file) > 1; };
  distinguish([&](std::size_t i) {
    return same_files(teams[i]) ? (i < 26 ? letter(i) : std::to_string(i + 1)) : teams[i].file;
  });
}

void require_metric(const TournamentPlan& plan, const mind::TeamPlan& team, const Asked& asked) {
  const auto* const test = std::get_if<ValueTest>(&plan.objective);
  if (test == nullptr || test->value == goals_value) return;
  std::vector<std::string> paths = metric_paths_of(team);
  const std::string prefix = "roles.";
  const std::string path = test->value.starts_with(prefix) ? test->value.substr(prefix.size()) : test->value;
  const std::string who = asked.by_document() ? "test.metric" : "--metric";
  const auto refuse = [&](const std::string& text) {
    if (asked.by_document()) throw config::Error(asked.document["test"]["metric"].where(), text);
    throw config::BadInput(text);
  };
  if (const std::string why = why_missing(path, plan.short_games()); !why.empty())
    refuse(fmt::format("{} {}", who, why));
  if (std::ranges::find(paths, path) != paths.end()) return;
  paths.insert(paths.begin(), goals_value);
  refuse(config::unknown("metric", test->value, fmt::format("{}, of team {}", who, team.team().name), paths));
}

void refuse_what_never_ends(const Asked& asked, const TournamentPlan& plan) {
  if (!asked.options.pairs.empty() || !equal_teams(plan, {0, 1})) return;
  const std::string why = "the teams are equal to the last byte, so every pair is even and ";
  if (asked.by_document()) {
    throw config::Error(asked.document["test"].where(),
                        "test: " + why + "it would never stop; `pairs` says how many are enough");
  }
  throw config::BadInput("tournament: " + why + "--sprt would never stop; --pairs N says how many are enough");
}

// Each fixture is known with all its inputs before the first match.
void refuse_too_many(const Asked& asked, const TournamentPlan& plan) {
  constexpr std::size_t most_fixtures = 50'000;
  const std::size_t fixtures = Calendar(plan).fixtures();
  if (fixtures <= most_fixtures) return;
  const std::string why =
      fmt::format("{} teams from {} openings make {} fixtures; at most {} can be kept; fewer openings",
                  plan.teams.size(), plan.openings.size(), fixtures, most_fixtures);
  if (asked.by_document()) {
    throw config::Error(asked.document["teams"].where(), "teams: " + why + " or `format: gauntlet` make fewer");
  }
  throw config::BadInput("tournament: " + why + " or --format gauntlet make fewer");
}

struct Scene {
  std::string file, who;  // who: what a message about it begins with
};

std::vector<Scene> scenes_of(const Asked& asked) {
  std::vector<Scene> out;
  const auto add = [&out](const std::string& path, const std::string& who) {
    for (const std::string& file : opening_files({path}, who)) out.push_back({file, who});
  };
  for (const std::string& path : asked.options.openings) add(path, "--openings");
  for (const config::NamedPath& each : asked.scenes)
    add(from_here(each.path), config::to_string(each.where) + ": openings");
  return out;
}

// As the command line would say what the document says.
Asked asked_by_document(const TournamentRequest& given) {
  for (const auto& [option, text] : {std::pair{"--format", &given.format},
                                     {"--pairs", &given.pairs},
                                     {"--sprt", &given.sprt},
                                     {"--model", &given.model},
                                     {"--metric", &given.metric},
                                     {"--alpha", &given.alpha},
                                     {"--beta", &given.beta},
                                     {"--seed", &given.seed},
                                     {"--limit", &given.limit},
                                     {"--rules", &given.rules},
                                     {"--robot", &given.robot},
                                     {"--disturbance", &given.disturbance},
                                     {"--failures-in-a-row", &given.failures_in_a_row}}) {
    if (text->empty()) continue;
    throw config::BadInput(fmt::format("{} {}: {} says that; --set PATH=VALUE lays another value over it", option,
                                       config::one_line(*text), given.file));
  }
  if (!given.teams.empty()) throw config::BadInput(fmt::format("--team: {} says who plays", given.file));
  if (!given.openings.empty()) throw config::BadInput(fmt::format("--openings: {} names the scenes", given.file));
  Asked out;
  out.document = config::load(given.file, given.overrides);
  const config::Tournament tournament = config::read_tournament(out.document);
  out.name = tournament.name;
  out.question = tournament.question;
  out.scenes = tournament.openings;
  out.isolation = tournament.isolation;
  out.play_twice = tournament.play_twice;
  out.allow_shared_memory = tournament.allow_shared_memory;
  out.options = given;
  TournamentRequest& options = out.options;
  options.overrides.clear();
  for (const config::Tournament::Team& each : tournament.teams) {
    options.teams.push_back(from_here(each.team));
    options.disturbances.push_back(from_here(each.disturbance));
  }
  for (const config::Node::Entry& entry : tournament.set.entries()) {
    if (entry.key.starts_with("opening.") && tournament.openings.empty()) {
      throw config::Error(entry.key_where, entry.key + ": there is no opening; `openings` names some");
    }
    out.settings.push_back({entry.key, config::flow(entry.value), entry.key_where, entry.value.where()});
    options.overrides.push_back(fmt::format("{}={}", entry.key, out.settings.back().value));
  }
  options.format = tournament.format == config::Tournament::Format::gauntlet ? "gauntlet" : "round-robin";
  if (tournament.pairs) options.pairs = std::to_string(*tournament.pairs);
  if (const auto& test = tournament.test) {
    options.alpha = config::real_text(test->alpha);
    if (test->elo) {
      options.sprt = fmt::format("{},{}", config::real_text((*test->elo)[0]), config::real_text((*test->elo)[1]));
      options.model = test->model == config::TournamentTest::Model::logistic ? "logistic" : "normalized";
      if (test->beta) options.beta = config::real_text(*test->beta);
    } else {
      options.metric = test->metric;
    }
  }
  options.seed = std::to_string(tournament.seed);
  if (tournament.limit) options.limit = config::real_text(*tournament.limit);
  options.rules = from_here(tournament.rules);
  options.robot = from_here(tournament.robot);
  options.disturbance = from_here(tournament.disturbance);
  options.failures_in_a_row = std::to_string(tournament.failures_in_a_row);
  return out;
}

Asked asked_by(const TournamentRequest& given) {
  if (!given.file.empty()) return asked_by_document(given);
  Asked out;
  out.options = given;
  if (out.options.seed.empty()) out.options.seed = "1";
  if (out.options.failures_in_a_row.empty()) out.options.failures_in_a_row = "10";
  return out;
}

}  // namespace

static PlannedTournament plan_of(const TournamentRequest& given, const plugin::Catalogue& catalogue,
                                 config::Mistakes& mistakes) {
  const Asked asked = asked_by(given);
  const TournamentRequest& options = asked.options;
  if (options.teams.size() < 2) {
    throw config::BadInput(fmt::format(
        "tournament: expected a document, or two teams or more, each by --team FILE; {} given", options.teams.size()));
  }
  if (options.teams.size() > most_teams) {
    throw config::BadInput(fmt::format("tournament: {} teams; at most {} can play", options.teams.size(), most_teams));
  }
  PlannedTournament out;
  TournamentPlan& plan = out.plan;
  plan.name = asked.name;
  plan.question = asked.question;
  plan.objective = parse_objective(options);
  const bool tested = !std::holds_alternative<FixedNumber>(plan.objective);
  if (tested && options.teams.size() > 2) {
    throw config::BadInput(
        "tournament: a sequential test is between two teams; give --pairs alone to rank more of them");
  }
  if (options.pairs.empty() && !std::holds_alternative<ScoreTest>(plan.objective)) {
    throw config::BadInput(
        tested ? "tournament: how many pairs of matches at most? Say --pairs N; equal teams would play on "
                 "for ever"
               : "tournament: how many pairs of matches? Say --pairs N, or --sprt ELO0,ELO1 for a "
                 "sequential test");
  }
  plan.pairs = options.pairs.empty() ? most_pairs : config::parse_whole("--pairs", options.pairs, 1, most_pairs);
  plan.format = parse_format(options.format);
  plan.first_seed = campaign::parse_seed(options.seed, "--seed");
  if (plan.first_seed > UINT64_MAX - (plan.pairs - 1)) {
    throw config::BadInput(
        fmt::format("--seed {}: {} pairs from there would need seeds beyond {}", options.seed, plan.pairs, UINT64_MAX));
  }
  plan.failures_in_a_row =
      static_cast<int>(config::parse_whole("--failures-in-a-row", options.failures_in_a_row, 0, 1'000'000));
  plan.limits = campaign::limits_of(options, asked.isolation, asked.play_twice, asked.allow_shared_memory);
  plan.folder = std::filesystem::current_path().string();
  try {
    check_overrides(options);
  } catch (const config::BadInput& error) {
    tell_where_it_is_set(error.what(), asked);
    throw;
  }
  plan.common.rules = options.rules;
  plan.common.robot = options.robot;
  plan.common.disturbance = options.disturbance;
  plan.common.overrides = options.overrides;
  plan.common.plugins = options.plugins;
  plan.common.limit = options.limit;
  for (const std::string& file : options.teams) plan.teams.push_back({file, file, {}});
  for (std::size_t team = 0; team < options.disturbances.size(); ++team)
    plan.teams[team].disturbance = options.disturbances[team];

  const std::string program = campaign::program_hash(), mathematics = campaign::mathematics_fingerprint();
  const std::vector<Scene> scenes = scenes_of(asked);
  if (!scenes.empty()) plan.openings = {{scenes.front().file, {}}};
  const auto look_at_team = [&](std::size_t team) {
    Fixture fixture;
    fixture.home = team;
    fixture.away = (team + 1) % plan.teams.size();
    const campaign::MatchSetup prepared = setup_of(plan, fixture, asked, catalogue);
    if (!mistakes.doubtful("test.metric")) {
      mistakes.attempt("test.metric", [&] { require_metric(plan, *prepared.plans[0], asked); });
    }
    plan.teams[team].label = prepared.plans[0]->team().name;
    plan.teams[team].inputs = campaign::team_inputs(*prepared.plans[0], *prepared.documents[0], catalogue);
    out.documents.push_back(
        config::show(*prepared.documents[0], plugin::declarations(catalogue.plugins()), config::Remarks::without));
    plan.common_inputs = campaign::common_inputs(without_opening(prepared.setup), program, mathematics);
    keep_disturbance(plan.teams[fixture.home], 0, plan.common_inputs);
    keep_disturbance(plan.teams[fixture.away], 1, plan.common_inputs);
    if (scenes.empty()) plan.most_goals = match::most_goal_difference(prepared.setup);
  };
  for (std::size_t team = 0; team < plan.teams.size(); ++team) mistakes.attempt("", [&] { look_at_team(team); });
  if (!mistakes.none()) return out;
  if (std::ranges::any_of(plan.teams, &Entrant::disturbed)) {
    // What is common is that of teams that nothing of their own disturbs.
    TournamentPlan without = plan;
    for (Entrant& each : without.teams) each.disturbance.clear();
    Fixture fixture;
    fixture.away = 1;
    plan.common_inputs = campaign::common_inputs(without_opening(setup_of(without, fixture, asked, catalogue).setup),
                                                 program, mathematics);
  }
  label_teams(plan.teams);
  std::vector<Opening> found;
  const auto look_at_scene = [&](const Scene& scene) {
    TournamentPlan with = plan;
    with.openings = {{scene.file, {}}};
    Fixture fixture;
    fixture.away = 1;
    const campaign::MatchSetup prepared = setup_of(with, fixture, asked, catalogue);
    plan.most_goals = std::max(plan.most_goals, match::most_goal_difference(prepared.setup));
    add_scene(found, {scene.file, campaign::opening_input(*prepared.setup.opening)}, prepared.setup.opening->name,
              scene.who);
  };
  for (const Scene& scene : scenes) mistakes.attempt("", [&] { look_at_scene(scene); });
  plan.openings = std::move(found);
  if (!mistakes.none()) return out;
  refuse_what_never_ends(asked, plan);
  refuse_too_many(asked, plan);
  return out;
}

PlannedTournament planned_tournament(const TournamentRequest& options, const plugin::Catalogue& catalogue) {
  config::Mistakes first(config::Mistakes::After::stop);
  return plan_of(options, catalogue, first);
}

void check_tournament(const TournamentRequest& options, const plugin::Catalogue& catalogue,
                      config::Mistakes& mistakes) {
  mistakes.attempt("", [&] { plan_of(options, catalogue, mistakes); });
}

}  // namespace regista::study
