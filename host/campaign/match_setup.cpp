// SPDX-License-Identifier: MIT
#include "campaign/match_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <filesystem>
#include <utility>

#include "campaign/match_inputs.hpp"
#include "config/documents.hpp"
#include "config/errors.hpp"
#include "config/parse.hpp"
#include "config/profiles.hpp"
#include "config/read.hpp"
#include "config/renamed_keys.hpp"
#include "config/scalar.hpp"
#include "match/teams.hpp"
#include "process/child.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

constexpr std::array<std::string_view, 7> names{
    "home", "away", "rules", "robot", "home_disturbance", "away_disturbance", "opening"};

// What a user calls the documents of the two sides. Studies call them by side, because their teams change sides.
struct SideName {
  std::string_view letter, document;
};
constexpr std::array<SideName, 4> sides{
    {{"a", "home"}, {"b", "away"}, {"a_disturbance", "home_disturbance"}, {"b_disturbance", "away_disturbance"}}};

std::string_view first_part(std::string_view path) { return path.substr(0, path.find('.')); }

// Returns whether `part`, the first part of a path, names this document.
bool is_for(std::string_view part, std::string_view document) {
  const auto by_letter = std::ranges::find(sides, part, &SideName::letter);
  if (by_letter != sides.end()) return by_letter->document == document;
  return part == document || (part == "disturbance" && document.ends_with("_disturbance"));
}

constexpr double longest_limit = 1e6;  // s

double parse_limit(const std::string& text) {
  double seconds = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seconds);
  if (error != std::errc() || rest != end || !(seconds > 0.0) || seconds > longest_limit) {
    throw config::BadInput(
        fmt::format("--limit: {}; expected seconds above 0, up to {:.0f}", texts::in_quotes(text), longest_limit));
  }
  return seconds;
}

// Returns the built-in values as a document. addressed: the document names each value, so that --set can replace it.
config::Node built_in(const config::DocumentKind& kind, const std::string& name, bool addressed) {
  const std::string key(kind.name);
  const config::Location where{fmt::format("built-in {} {}", key, name), 0, 0};
  const config::Node bare = config::Node::map({{key, where, config::Node::scalar(name, false, where)}}, where);
  if (!addressed) return bare;
  return config::parse_text(config::show(bare), where.file);
}

config::Node profile(const config::DocumentKind& kind, const std::string& name, const std::string& file,
                     const config::Overrides& overrides) {
  // The name of the built-in profile selects this profile, unless a file has the same name.
  const bool by_name = file == name && !std::filesystem::exists(file);
  return file.empty() || by_name ? config::override_with(built_in(kind, name, !overrides.empty()), overrides)
                                 : config::load(file, overrides);
}

std::uint64_t seed_of(const MatchRequest& request) {
  return config::parse_whole("--seed", request.seed, 0, UINT64_MAX);
}

// Returns the requested opening; nothing without a request. Throws config::Error if rules or robots do not allow it.
std::optional<config::Opening> opening_of(const MatchRequest& request, const match::Setup& setup) {
  const std::string name(config::DocumentKind::opening.name);
  const config::Overrides overrides = overrides_for(name, request.overrides);
  if (request.opening.empty()) {
    if (overrides.empty()) return std::nullopt;
    throw config::Error(overrides.front().where, "there is no opening; --opening FILE names one");
  }
  const config::Node document = config::load(request.opening, overrides);
  config::Opening opening = config::read_document<config::Opening>(document);
  if (const auto misfit = config::misfit(opening, setup.rules, setup.robots)) {
    config::refuse(document, {misfit->path}, misfit->reason);
  }
  return opening;
}

config::Disturbance disturbance_of(const std::string& file, const config::Overrides& all, match::Side side,
                                   const config::Rules& rules) {
  const config::Node document = profile(config::DocumentKind::disturbance, config::Disturbance{}.name, file,
                                        overrides_for(std::string(match::name(side)) + "_disturbance", all));
  config::Disturbance disturbance = config::read_document<config::Disturbance>(document);
  config::check(disturbance, rules, document);
  return disturbance;
}

// Reads the team of one side. An error names the side, because a path of --set may be wrong for only one team.
TeamSetup team_of(const ReadTeam& read_team, const MatchRequest& request, match::Side side, const config::Rules& rules,
                  const config::Robot& robot) {
  const std::string name = match::name(side);
  try {
    return read_team(request.teams[match::index(side)], overrides_for(name, request.overrides), rules, robot);
  } catch (const config::Error& error) {
    const auto is_blamed = [&](const config::Override& each) {
      return each.where.line == 0 && each.where == error.where() && !is_for(first_part(each.path), name);
    };
    if (std::ranges::none_of(request.overrides, is_blamed)) throw;
    throw config::Error(error.where(), name + " team: " + error.message());
  }
}

config::Declares declared_in(const plugin::Catalogue& catalogue) {
  return [&catalogue](std::string_view id, std::string_view name) {
    for (const plugin::Found& each : catalogue.plugins()) {
      if (each.descriptor->id != id) continue;
      for (std::uint32_t i = 0; i < each.descriptor->parameter_count; ++i) {
        if (plugin::parameter(*each.descriptor, i).name == name) return true;
      }
    }
    return false;
  };
}

}  // namespace

config::Overrides overrides_for(std::string_view document, const config::Overrides& all) {
  assert(std::ranges::find(names, document) != names.end());
  config::Overrides out;
  for (const config::Override& each : all) {
    const std::size_t dot = each.path.find('.');
    const std::string_view first =
        dot == std::string::npos ? std::string_view() : std::string_view(each.path).substr(0, dot);
    const bool addressed = std::ranges::any_of(names, [first](std::string_view name) { return is_for(first, name); });
    if (!addressed && (document == "home" || document == "away")) out.push_back(each);
    if (is_for(first, document)) out.emplace_back(each.path.substr(dot + 1), each.value, each.where);
  }
  return out;
}

void refuse_former_sides(const config::Overrides& typed) {
  for (const config::Override& each : typed) {
    const std::string_view first = first_part(each.path);
    const auto former = std::ranges::find(sides, first, &SideName::document);
    if (former == sides.end()) continue;
    throw config::Error(each.where,
                        fmt::format("the first team, at home, is called a and the second b, as in all commands: {}{}",
                                    former->letter, each.path.substr(first.size())));
  }
}

TeamSetup team_setup(const std::string& file, const config::Overrides& overrides, const config::Rules& rules,
                     const config::Robot& robot, const plugin::Catalogue& catalogue, KeyNames keys) {
  config::Node written = config::load(file, overrides);
  if (keys == KeyNames::former_too) written = config::with_present_names(written, declared_in(catalogue));
  const auto document = std::make_shared<const config::Node>(std::move(written));
  const config::Team team = config::read_document<config::Team>(*document);
  config::check(team, rules, *document);
  return {document, std::make_shared<const mind::TeamPlan>(team, rules, robot, catalogue),
          config::warnings(team, rules, *document)};
}

MatchSetup match_setup(const MatchRequest& request, const plugin::Catalogue& catalogue, KeyNames keys) {
  return match_setup(request, [&catalogue, keys](const std::string& file, const config::Overrides& overrides,
                                                 const config::Rules& rules, const config::Robot& robot) {
    return team_setup(file, overrides, rules, robot, catalogue, keys);
  });
}

MatchSetup match_setup(const MatchRequest& request, const ReadTeam& read_team) {
  MatchSetup out;
  out.setup.seed = seed_of(request);
  if (!request.limit.empty()) out.setup.limit = parse_limit(request.limit);

  using config::DocumentKind;
  const auto document = [&](const DocumentKind& kind, const std::string& name, const std::string& file) {
    return profile(kind, name, file, overrides_for(kind.name, request.overrides));
  };
  out.setup.rules =
      config::read_document<config::Rules>(document(DocumentKind::rules, config::Rules{}.name, request.rules));
  const config::Node of_robot = document(DocumentKind::robot, config::Robot{}.name, request.robot);
  const config::Robot robot = config::read_document<config::Robot>(of_robot);
  config::check(robot, out.setup.rules, of_robot);
  out.setup.robots = {robot, robot};
  for (const match::Side side : match::both_sides) {
    const std::string& own = side == match::Side::home ? request.home_disturbance : request.away_disturbance;
    out.setup.disturbances[match::index(side)] =
        disturbance_of(own.empty() ? request.disturbance : own, request.overrides, side, out.setup.rules);
  }
  out.setup.opening = opening_of(request, out.setup);
  config::fit_packets(out.setup.rules, match::limit_of(out.setup), out.setup.opening.has_value());

  for (const match::Side side : match::both_sides) {
    TeamSetup team = team_of(read_team, request, side, out.setup.rules, robot);
    for (config::Warning& each : team.warnings) {
      const auto same = [&](const config::Warning& other) { return to_string(other) == to_string(each); };
      if (std::ranges::none_of(out.warnings, same)) out.warnings.push_back(std::move(each));
    }
    out.documents[match::index(side)] = std::move(team.document);
    out.plans[match::index(side)] = std::move(team.plan);
  }
  return out;
}

PlayedMatch match_to_play(const MatchSetup& prepared) {
  PlayedMatch out;
  out.seed = prepared.setup.seed;
  if (prepared.setup.opening) out.opening = prepared.setup.opening->name;
  out.budget = config::packets(prepared.setup.rules.messages);
  out.packets_share = packets_share_of(prepared.setup);
  for (const match::Side side : match::both_sides) {
    const mind::TeamPlan& plan = *prepared.plans[match::index(side)];
    out.teams[match::index(side)] = plan.team().name;
    out.titles[match::index(side)] = plan.team().title;
    out.role_names[match::index(side)] = match::role_names(match::roles(plan));
  }
  return out;
}

MatchRequest request_of(const Job& job) {
  MatchRequest request;
  request.teams.assign(job.teams.begin(), job.teams.end());
  request.rules = job.rules;
  request.robot = job.robot;
  request.disturbance = job.disturbance;
  request.home_disturbance = job.home_disturbance;
  request.away_disturbance = job.away_disturbance;
  request.overrides = config::typed_overrides(job.overrides);
  request.seed = std::to_string(job.seed);
  request.opening = job.opening;
  request.limit = job.limit;
  return request;
}

Job job_of(const MatchRequest& request, const std::vector<std::string>& plugins) {
  Job job;
  job.teams = {request.teams.at(0), request.teams.at(1)};
  job.rules = request.rules;
  job.robot = request.robot;
  job.disturbance = request.disturbance;
  job.home_disturbance = request.home_disturbance;
  job.away_disturbance = request.away_disturbance;
  for (const config::Override& each : request.overrides) job.overrides.push_back(to_string(each));
  job.plugins = plugins;
  job.opening = request.opening;
  job.limit = request.limit;
  job.seed = seed_of(request);
  return job;
}

std::string match_command(const Job& job, const std::string& program) {
  std::vector<std::string> words = match_arguments(job);
  words.insert(words.begin(), program);
  return process::shell_line(words);
}

std::string input_of(const Job& job, const std::string& name) {
  const auto found = std::ranges::find(job.common_inputs, name, &Input::name);
  return found == job.common_inputs.end() ? std::string() : found->hash;
}

FoundInputs inputs_of(const MatchSetup& prepared, const plugin::Catalogue& catalogue, const std::string& program,
                      const std::string& mathematics, const std::string& root) {
  return {team_inputs(*prepared.plans[0], *prepared.documents[0], catalogue, root),
          team_inputs(*prepared.plans[1], *prepared.documents[1], catalogue, root),
          common_inputs(prepared.setup, program, mathematics)};
}

std::string what_changed(const Job& job, const MatchSetup& prepared, const plugin::Catalogue& catalogue,
                         const std::string& program, const std::string& mathematics, const std::string& root) {
  if (job.common_inputs.empty()) return {};  // the job has no list of inputs
  return what_changed(job, inputs_of(prepared, catalogue, program, mathematics, root));
}

std::string what_changed(const Job& job, const FoundInputs& now) {
  std::vector<std::string> changed;
  for (const auto& [before, found] :
       {std::pair{&job.home_inputs, &now.home}, {&job.away_inputs, &now.away}, {&job.common_inputs, &now.common}}) {
    for (std::string& each : differences(*before, *found)) {
      if (std::ranges::find(changed, each) == changed.end()) changed.push_back(std::move(each));
    }
  }
  return texts::join(changed);
}

}  // namespace regista::campaign
