// SPDX-License-Identifier: MIT
#include "campaign/match_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "campaign/overrides.hpp"
#include "config/bad_input.hpp"
#include "config/check.hpp"
#include "config/documents.hpp"
#include "config/packet_share.hpp"
#include "config/parse.hpp"
#include "config/read.hpp"
#include "config/team_size.hpp"
#include "config/typed.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

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

// The built-in values as a document; all of them written out where paths are to address them.
config::Node built_in(const config::DocumentKind& kind, const std::string& name, bool addressed) {
  const std::string key(kind.name);
  const config::Location where{fmt::format("built-in {} {}", key, name), 0, 0};
  const config::Node bare = config::Node::map({{key, where, config::Node::scalar(name, false, where)}}, where);
  if (!addressed) return bare;
  return config::parse_text(config::show(bare), where.file);
}

config::Node profile(const config::DocumentKind& kind, const std::string& name, const std::string& file,
                     const config::Overrides& overrides) {
  // The name of the built-in profile means it, unless there is a file of that name.
  const bool by_name = file == name && !std::filesystem::exists(file);
  return file.empty() || by_name ? config::override_with(built_in(kind, name, !overrides.empty()), overrides)
                                 : config::load(file, overrides);
}

// None where none is asked for. Throws config::Error where it cannot be played by rules and robots of the setup.
std::optional<config::Opening> opening_of(const MatchRequest& request, const SortedOverrides& overrides,
                                          const match::Setup& setup) {
  const std::string name(config::DocumentKind::opening.name);
  if (request.opening.empty()) {
    if (overrides.of(name).empty()) return std::nullopt;
    throw config::Error(overrides.of(name).front().where, "there is no opening; --opening FILE names one");
  }
  const config::Node document = config::load(request.opening, overrides.of(name));
  config::Opening opening = config::read_document<config::Opening>(document);
  if (const auto misfit = config::misfit(opening, setup.rules, setup.robots)) {
    config::refuse(document, {misfit->path}, misfit->reason);
  }
  return opening;
}

config::Disturbance disturbance_of(const std::string& file, const SortedOverrides& overrides, match::Side side,
                                   const config::Rules& rules) {
  const config::Node document = profile(config::DocumentKind::disturbance, config::Disturbance{}.name, file,
                                        overrides.of(std::string(match::name(side)) + "_disturbance"));
  config::Disturbance disturbance = config::read_document<config::Disturbance>(document);
  config::check(disturbance, rules, document);
  return disturbance;
}

// A path for both teams may be wrong for one of them.
TeamSetup team_of(const ReadTeam& read_team, const MatchRequest& request, const SortedOverrides& overrides,
                  match::Side side, const config::Rules& rules, const config::Robot& robot) {
  const std::string name = match::name(side);
  try {
    return read_team(request.teams[match::index(side)], overrides.of(name), rules, robot);
  } catch (const config::Error& error) {
    const auto is_blamed = [&](const config::Override& each) {
      return each.where.line == 0 && each.where == error.where() && !each.path.starts_with(name + '.');
    };
    if (std::ranges::none_of(request.overrides, is_blamed)) throw;
    throw config::Error(error.where(), name + " team: " + error.message());
  }
}

}  // namespace

std::uint64_t parse_seed(const std::string& text, const std::string& option) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || rest != end) {
    throw config::BadInput(
        fmt::format("{}: {}; expected a whole number from 0 to {}", option, texts::in_quotes(text), UINT64_MAX));
  }
  return seed;
}

TeamSetup team_setup(const std::string& file, const config::Overrides& overrides, const config::Rules& rules,
                     const config::Robot& robot, const plugin::Catalogue& catalogue) {
  const auto document = std::make_shared<const config::Node>(config::load(file, overrides));
  const config::Team team = config::read_document<config::Team>(*document);
  config::check(team, rules, *document);
  return {document, std::make_shared<const mind::TeamPlan>(team, rules, robot, catalogue),
          config::warnings(team, rules, *document)};
}

MatchSetup match_setup(const MatchRequest& request, const plugin::Catalogue& catalogue) {
  return match_setup(request, [&catalogue](const std::string& file, const config::Overrides& overrides,
                                           const config::Rules& rules, const config::Robot& robot) {
    return team_setup(file, overrides, rules, robot, catalogue);
  });
}

MatchSetup match_setup(const MatchRequest& request, const ReadTeam& read_team) {
  MatchSetup out;
  out.setup.seed = parse_seed(request.seed, "--seed");
  if (!request.limit.empty()) out.setup.limit = parse_limit(request.limit);

  using config::DocumentKind;
  const SortedOverrides overrides(request.overrides);
  const auto document = [&](const DocumentKind& kind, const std::string& name, const std::string& file) {
    return profile(kind, name, file, overrides.of(kind.name));
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
        disturbance_of(own.empty() ? request.disturbance : own, overrides, side, out.setup.rules);
  }
  out.setup.opening = opening_of(request, overrides, out.setup);
  config::fit_packets(out.setup.rules, match::limit_of(out.setup), out.setup.opening.has_value());

  for (const match::Side side : match::both_sides) {
    TeamSetup team = team_of(read_team, request, overrides, side, out.setup.rules, robot);
    for (config::Warning& each : team.warnings) {
      const auto same = [&](const config::Warning& other) { return to_string(other) == to_string(each); };
      if (std::ranges::none_of(out.warnings, same)) out.warnings.push_back(std::move(each));
    }
    out.documents[match::index(side)] = std::move(team.document);
    out.plans[match::index(side)] = std::move(team.plan);
  }
  return out;
}

}  // namespace regista::campaign
