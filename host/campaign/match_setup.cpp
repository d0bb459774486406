// SPDX-License-Identifier: MIT
#include "campaign/match_setup.hpp"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <cstdint>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "config/document_files.hpp"
#include "config/documents.hpp"
#include "config/errors.hpp"
#include "config/parse.hpp"
#include "config/read.hpp"
#include "config/renamed_keys.hpp"
#include "config/scalar.hpp"
#include "config/values.hpp"
#include "match/teams.hpp"
#include "plugin/info.hpp"
#include "plugin/shared_object.hpp"
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
  const auto seconds = config::typed_number(text);
  if (!seconds || !(*seconds > 0.0) || *seconds > longest_limit) {
    throw config::BadInput(
        fmt::format("--limit: {}; expected seconds above 0, up to {:.0f}", texts::in_quotes(text), longest_limit));
  }
  return *seconds;
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

// Returns the requested opening; nothing without a request. Throws config::Error if rules or robots do not allow it.
std::optional<config::Opening> opening_of(const std::string& file, const config::Overrides& all,
                                          const match::Setup& setup) {
  const config::Overrides overrides = overrides_for(config::DocumentKind::opening.name, all);
  if (file.empty()) {
    if (overrides.empty()) return std::nullopt;
    throw config::Error(overrides.front().where, "there is no opening; --opening FILE names one");
  }
  const config::Node document = config::load(file, overrides);
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
TeamSetup team_of(const ReadTeam& read_team, const Job& job, const config::Overrides& all, match::Side side,
                  const config::Rules& rules, const config::Robot& robot) {
  const std::string name = match::name(side);
  try {
    return read_team(job.teams[match::index(side)], overrides_for(name, all), rules, robot);
  } catch (const config::Error& error) {
    const auto is_blamed = [&](const config::Override& each) {
      return each.where.line == 0 && each.where == error.where() && !is_for(first_part(each.path), name);
    };
    if (std::ranges::none_of(all, is_blamed)) throw;
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

std::string required_content(const std::filesystem::path& file) {
  errno = 0;
  std::optional<std::string> out = config::file_content(file);
  if (!out) throw std::system_error(errno == 0 ? EIO : errno, std::generic_category(), "cannot read " + file.string());
  return std::move(*out);
}

template <class Profile>
Input profile_input(const char* kind, Profile values) {
  const std::string shown = config::show(config::declare(values), config::Node(), {}, config::Remarks::without);
  return {fmt::format("{} {}", kind, values.name), plugin::content_hash(shown)};
}

// Makes inputs of home and away different, even if their contents are equal.
Input of_side(const char* side, const Input& input) {
  return {side + input.name, plugin::content_hash(side + input.hash)};
}

std::string without(const std::string& root, std::string text) {
  for (std::size_t at = 0; !root.empty() && (at = text.find(root + '/', at)) != std::string::npos;) {
    text.erase(at, root.size());
  }
  return text;
}

class Collected {
 public:
  explicit Collected(const std::string& root) : root_(root) {}

  void add(const mind::Part& part) {
    const std::filesystem::path& file = part.found->file;
    const std::string id = part.found->descriptor->id;
    put(fmt::format("plugin {} ({})", id, file.string()),
        [&] { return id + ' ' + plugin::content_hash(required_content(file)); });
    // used.hash is the hash of the content when the parameters were read. The file may have changed since.
    for (const plugin::FileUsed& used : part.parameters.files()) {
      put(fmt::format("file {} of plugin {}", without(root_, used.path.string()), id), [&] { return used.hash; });
    }
  }
  std::vector<Input> take() {
    std::ranges::stable_sort(inputs_, {}, [](const Input& input) { return input.hash; });
    return std::move(inputs_);
  }

 private:
  template <class Hash>
  void put(const std::string& name, Hash hash) {
    if (std::ranges::find(inputs_, name, &Input::name) == inputs_.end()) inputs_.push_back({name, hash()});
  }
  const std::string& root_;
  std::vector<Input> inputs_;
};

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

void refuse_unknown_sides(const config::Overrides& typed) {
  for (const config::Override& each : typed) {
    const std::string_view first = first_part(each.path);
    if (first.size() == 1 && first < each.path && first >= "c" && first <= "z")
      throw config::Error(each.where, fmt::format("{}: a match has two teams, a and b", each.path));
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

ReadTeam team_reader(const plugin::Catalogue& catalogue, KeyNames keys) {
  return [&catalogue, keys](const std::string& file, const config::Overrides& overrides, const config::Rules& rules,
                            const config::Robot& robot) {
    return team_setup(file, overrides, rules, robot, catalogue, keys);
  };
}

MatchSetup match_setup(const Job& job, const plugin::Catalogue& catalogue, KeyNames keys) {
  return match_setup(job, config::typed_overrides(job.overrides), team_reader(catalogue, keys));
}

MatchSetup match_setup(const Job& job, const config::Overrides& overrides, const ReadTeam& read_team) {
  MatchSetup out;
  out.setup.seed = job.seed;
  if (!job.limit.empty()) out.setup.limit = parse_limit(job.limit);

  using config::DocumentKind;
  const auto document = [&](const DocumentKind& kind, const std::string& name, const std::string& file) {
    return profile(kind, name, file, overrides_for(kind.name, overrides));
  };
  out.setup.rules =
      config::read_document<config::Rules>(document(DocumentKind::rules, config::Rules{}.name, job.rules));
  const config::Node of_robot = document(DocumentKind::robot, config::Robot{}.name, job.robot);
  const config::Robot robot = config::read_document<config::Robot>(of_robot);
  config::check(robot, out.setup.rules, of_robot);
  out.setup.robots = {robot, robot};
  for (const match::Side side : match::both_sides) {
    const std::string& own = side == match::Side::home ? job.home_disturbance : job.away_disturbance;
    out.setup.disturbances[match::index(side)] =
        disturbance_of(own.empty() ? job.disturbance : own, overrides, side, out.setup.rules);
  }
  out.setup.opening = opening_of(job.opening, overrides, out.setup);
  config::fit_packets(out.setup.rules, match::limit_of(out.setup), out.setup.opening.has_value());

  for (const match::Side side : match::both_sides) {
    TeamSetup team = team_of(read_team, job, overrides, side, out.setup.rules, robot);
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

std::string match_command(const Job& job, const std::string& program) {
  std::vector<std::string> words = match_arguments(job);
  words.insert(words.begin(), program);
  return process::shell_line(words);
}

std::string input_of(const Job& job, const std::string& name) {
  const auto found = std::ranges::find(job.common_inputs, name, &Input::name);
  return found == job.common_inputs.end() ? std::string() : found->hash;
}

std::vector<Input> team_inputs(const mind::TeamPlan& plan, const config::Node& document,
                               const plugin::Catalogue& catalogue, const std::string& root) {
  Collected plugins(root);
  for (const mind::Part* part : plan.parts()) plugins.add(*part);
  const std::string shown =
      without(root, config::show(document, plugin::declarations(catalogue.plugins()), config::Remarks::without));
  std::vector<Input> out{{"team " + without(root, plan.team().file), plugin::content_hash(shown)}};
  std::ranges::move(plugins.take(), std::back_inserter(out));
  return out;
}

std::vector<Input> common_inputs(const match::Setup& setup, const std::string& program,
                                 const std::string& mathematics) {
  const std::string limit = setup.limit ? fmt::format("{:a}", *setup.limit) : "none";
  std::vector<Input> out{profile_input("rules", setup.rules),
                         profile_input("robot", setup.robots[0]),
                         of_side("home ", profile_input("disturbance", setup.disturbances[0])),
                         of_side("away ", profile_input("disturbance", setup.disturbances[1])),
                         {"limit", plugin::content_hash(limit)},
                         {program_input, program},
                         {mathematics_input, mathematics}};
  if (setup.opening) out.push_back(opening_input(*setup.opening));
  return out;
}

Input opening_input(config::Opening opening) {
  opening.summary.clear();  // the summary is for people, like a comment
  return profile_input("opening", std::move(opening));
}

std::string fixture_key(std::span<const Input> home, std::span<const Input> away, std::span<const Input> common) {
  std::string all;
  for (const std::span<const Input> part : {home, away, common}) {
    for (const Input& input : part) all += input.hash + '\n';
    all += "--\n";
  }
  return plugin::content_hash(all);
}

std::string program_hash() { return plugin::content_hash(required_content("/proc/self/exe")); }

std::string mathematics_fingerprint() {
  using Function = double (*)(double);
  constexpr std::array<Function, 10> functions{[](double x) { return std::sin(x); },
                                               [](double x) { return std::cos(x); },
                                               [](double x) { return std::tan(x); },
                                               [](double x) { return std::atan(x); },
                                               [](double x) { return std::exp(x); },
                                               [](double x) { return std::log(1.0 + std::abs(x)); },
                                               [](double x) { return std::asin(x / 8.0); },
                                               [](double x) { return std::tanh(x); },
                                               [](double x) { return std::atan2(x, 1.5 - x); },
                                               [](double x) { return std::pow(1.0 + std::abs(x), 0.37 * x); }};
  std::vector<double> results;
  for (int i = -300; i <= 300; ++i) {
    // x is volatile, so that the compiler does not compute the results at compile time.
    volatile double x = 0.0257 * i;
    for (const Function function : functions) {
      const double value = function(x);
      results.push_back(std::isnan(value) ? 0.0 : value);
      results.push_back(static_cast<double>(std::sin(static_cast<float>(x))));
    }
  }
  const std::string_view bytes(reinterpret_cast<const char*>(results.data()), results.size() * sizeof(double));
  return std::string(gnu_get_libc_version()) + ' ' + plugin::content_hash(bytes);
}

FoundInputs inputs_of(const MatchSetup& prepared, const plugin::Catalogue& catalogue, const std::string& program,
                      const std::string& mathematics, const std::string& root) {
  return {team_inputs(*prepared.plans[0], *prepared.documents[0], catalogue, root),
          team_inputs(*prepared.plans[1], *prepared.documents[1], catalogue, root),
          common_inputs(prepared.setup, program, mathematics)};
}

std::vector<std::string> differences(std::span<const Input> before, std::span<const Input> now) {
  std::vector<std::string> out;
  const auto add = [&](const std::string& text) { texts::add_once(out, text); };
  // An input with the same content under another name, such as another spelling of a path, counts as unchanged.
  const auto elsewhere = [](std::span<const Input> inputs, const Input& wanted) {
    return std::ranges::find(inputs, wanted.hash, &Input::hash) != inputs.end();
  };
  // "plugin greedy (lib/greedy.so)" and "plugin greedy (/home/me/lib/greedy.so)" name the same input.
  const auto named_as = [](std::span<const Input> inputs, const std::string& name) {
    const auto subject = [](const std::string& of) { return of.substr(0, of.find(" (")); };
    const auto found = std::ranges::find(inputs, name, &Input::name);
    if (found != inputs.end()) return found;
    return std::ranges::find_if(inputs, [&](const Input& each) { return subject(each.name) == subject(name); });
  };
  for (const Input& old : before) {
    if (elsewhere(now, old)) continue;
    const auto found = named_as(now, old.name);
    if (found == now.end())
      add(old.name + " is no longer used");
    else if (found->hash != old.hash)
      add(old.name + " has changed");
  }
  for (const Input& input : now) {
    if (elsewhere(before, input)) continue;
    if (named_as(before, input.name) == before.end()) add(input.name + " is new");
  }
  return out;
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
    for (const std::string& each : differences(*before, *found)) texts::add_once(changed, each);
  }
  return texts::join(changed);
}

}  // namespace regista::campaign
