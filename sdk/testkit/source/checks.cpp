// SPDX-License-Identifier: MIT
// Which checks make up the contract of a kind.
#include <regista/testkit/checks.hpp>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <numeric>
#include <optional>

#include <regista/testkit/cost.hpp>

namespace regista::testkit {

std::vector<Scenario> scenarios(std::int32_t kind, const Loaded& plugin, const Options& options) {
  switch (kind) {
    case REGISTA_KIND_PREDICTOR:
      return predictor_scenarios(plugin, options);
    case REGISTA_KIND_CONTEXT:
      return context_scenarios(options);
    case REGISTA_KIND_POSITIONER:
      return positioner_scenarios(options);
    case REGISTA_KIND_UTILITY:
      return utility_scenarios(options);
    case REGISTA_KIND_ASSIGNER:
      return assigner_scenarios(options);
    case REGISTA_KIND_BEHAVIOUR:
      return behaviour_scenarios(options);
    default:
      return sender_scenarios(options);
  }
}

namespace {

// FNV-1a, 64 bits.
constexpr std::uint64_t empty_digest = 0xcbf29ce484222325u;
void add(std::uint64_t& digest, const Trail& trail) {
  for (const char byte : trail.bytes()) digest = (digest ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
}

}  // namespace

std::uint64_t scenario_digest(std::int32_t kind, const Loaded& plugin, const Options& options) {
  std::uint64_t digest = empty_digest;
  Values values(plugin);
  options.base(values);
  Findings elsewhere(options.underway);
  for (const Scenario& scenario : scenarios(kind, plugin, options)) {
    Instance instance(plugin, scenario.environment, values);
    for (std::size_t i = 0; i < scenario.steps; ++i) {
      elsewhere.where("", scenario.name(i));
      add(digest, detail::step(scenario, instance, i, {}, elsewhere));
    }
  }
  return digest;
}

namespace {
// Of each scenario, so that slow plugins are not asked for minutes: what needs longer to show is for a match to find.
constexpr std::size_t most_steps_of_a_team = 20;
}  // namespace

std::vector<std::uint64_t> team_digests(std::int32_t kind, const Loaded& plugin, const Options& options,
                                        std::optional<std::size_t> only) {
  std::vector<std::uint64_t> out(robots_of_a_team, 0);
  Values values(plugin);
  options.base(values);
  Findings elsewhere(options.underway);
  for (const Scenario& scenario : scenarios(kind, plugin, options)) {
    std::vector<std::unique_ptr<Instance>> team(robots_of_a_team);
    for (std::size_t robot = 0; robot < team.size(); ++robot) {
      if (only.value_or(robot) != robot) continue;
      EnvironmentBuilder environment = scenario.environment;
      const std::size_t size = environment.raw().team_size;  // some scenes are of smaller teams
      team[robot] = std::make_unique<Instance>(plugin, environment.own(static_cast<int>(robot % size) + 1), values);
    }
    const std::size_t steps = std::min(scenario.steps, most_steps_of_a_team);
    for (const std::size_t apart : {std::size_t{0}, std::size_t{1}}) {
      for (std::size_t i = 0; i < steps; ++i) {
        for (std::size_t robot = 0; robot < team.size(); ++robot) {
          if (!team[robot]) continue;
          const std::size_t index = (i + apart * robot) % scenario.steps;
          elsewhere.where("", scenario.name(index));
          add(out[robot], detail::step(scenario, *team[robot], index, {}, elsewhere));
        }
      }
    }
  }
  return out;
}

void play_scenario(std::int32_t kind, const Loaded& plugin, const Options& options,
                   const std::function<void(const std::string& step)>& after) {
  Values values(plugin);
  options.base(values);
  Findings elsewhere(options.underway);
  for (const Scenario& scenario : scenarios(kind, plugin, options)) {
    Instance instance(plugin, scenario.environment, values);
    for (std::size_t i = 0; i < std::min(scenario.steps, most_steps_of_a_team); ++i) {
      elsewhere.where("", scenario.name(i));
      detail::step(scenario, instance, i, {}, elsewhere);
      after(scenario.name(i));
    }
  }
}

std::vector<Cost> cost_of_calls(std::int32_t kind, const Loaded& plugin, const Options& options,
                                std::size_t (*allocated)()) {
  std::map<std::string, RecordingHost::CallCosts> costs;
  Values values(plugin);
  options.base(values);
  Findings elsewhere(options.underway);
  for (const Scenario& scenario : scenarios(kind, plugin, options)) {
    Instance instance(plugin, scenario.environment, values);
    instance.host().allocated = allocated;
    for (const bool counts : {false, true}) {
      instance.host().costs = counts ? &costs : nullptr;
      for (std::size_t i = 0; i < scenario.steps; ++i) {
        elsewhere.where("", scenario.name(i));
        detail::step(scenario, instance, i, {}, elsewhere);
      }
    }
  }
  std::vector<Cost> out;
  for (auto& entry : costs) {
    std::vector<double>& times = entry.second.seconds;
    std::ranges::sort(times);
    const auto microseconds = [&times](double share) {
      return 1e6 * times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    Cost cost{entry.first, times.size(), microseconds(0.5), microseconds(0.99), 0.0, std::nullopt};
    cost.mean_microseconds = 1e6 * std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
    if (const auto& counts = entry.second.allocations; !counts.empty()) {
      const std::size_t sum = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
      cost.allocations = static_cast<double>(sum) / static_cast<double>(counts.size());
    }
    out.push_back(std::move(cost));
  }
  return out;
}

namespace {

// An exception of the suite itself, or a plugin without this kind, is a finding and not a crash.
Check guarded_check(std::int32_t kind, Check check) {
  check.run = [kind, run = check.run](const Loaded& plugin, const Options& options) {
    Findings findings;
    if (!plugin.implements(kind)) {
      findings.say("\"", plugin.descriptor().id, "\" does not implement this kind");
      return findings;
    }
    try {
      return run(plugin, options);
    } catch (const std::exception& exception) {
      findings.say(exception.what());
    }
    return findings;
  };
  return check;
}

template <class CheckScenarios>
Check over_scenarios(std::int32_t kind, const char* name, const char* promise, CheckScenarios check) {
  return {name, promise, [kind, check](const Loaded& plugin, const Options& options) {
            return check(plugin, options, scenarios(kind, plugin, options));
          }};
}

// Who reads everything has nothing to hide from.
Check reads_check(std::int32_t kind) {
  Check out = over_scenarios(kind, "reads", "reads only what it declares", check_reads);
  out.applies = [](const Loaded& plugin, const Options&) {
    return (~plugin.descriptor().reads & REGISTA_READS_ALL) != 0;
  };
  return out;
}

// Of a predictor's subjects one will do.
std::uint32_t subject_of_mailbox(std::int32_t kind, const Loaded& plugin) {
  const std::uint32_t all = kind == REGISTA_KIND_PREDICTOR ? detail::subjects_of(plugin) : 0;
  return all & (~all + 1);
}

// What it hears is memory that it is given, too.
Findings check_memory_and_messages(std::int32_t kind, const Loaded& plugin, const Options& options) {
  Findings findings = check_memory(plugin, options, scenarios(kind, plugin, options));
  if (plugin.implements(REGISTA_KIND_MAILBOX)) {
    play_messages_guarded(plugin, options, subject_of_mailbox(kind, plugin));
  }
  return findings;
}

bool models(const Loaded& plugin, std::uint32_t subject) { return (detail::subjects_of(plugin) & subject) != 0; }

}  // namespace

std::vector<Check> contract(std::int32_t kind) {
  std::vector<Check> out{
      {"descriptor", "describes itself", [](const Loaded& plugin, const Options&) { return check_descriptor(plugin); }},
      over_scenarios(kind, "promises", "every output is as abi.h promises", check_promises),
      over_scenarios(kind, "determinism", "the same calls give the same bytes, also after a reset", check_determinism),
      over_scenarios(kind, "growth", "works with a host of a later minor version", check_growth),
      {"memory", "touches no memory but what it is given",
       [kind](const Loaded& plugin, const Options& options) {
         return check_memory_and_messages(kind, plugin, options);
       }},
      reads_check(kind),
      over_scenarios(kind, "life", "can be created, reset and destroyed in any order", check_life),
      {"mailbox", "bears any message",
       [kind](const Loaded& plugin, const Options& options) {
         return check_mailbox(plugin, options, subject_of_mailbox(kind, plugin));
       },
       [](const Loaded& plugin, const Options&) { return plugin.implements(REGISTA_KIND_MAILBOX); }}};
  if (kind == REGISTA_KIND_PREDICTOR) {
    out.push_back({"uncertainty", "the own pose does not become surer without news", check_uncertainty_grows,
                   [](const Loaded& p, const Options&) { return models(p, REGISTA_SUBJECT_SELF); }});
    out.push_back({"labels", "opponents in view keep their labels", check_labels_are_stable,
                   [](const Loaded& p, const Options&) { return models(p, REGISTA_SUBJECT_OPPONENTS); }});
    out.push_back({"track_at", "tells of a teammate later what its model would hold then", check_track_at,
                   [](const Loaded& p, const Options&) {
                     return models(p, REGISTA_SUBJECT_TEAMMATES) && detail::tells_track_at(p);
                   }});
  }
  if (kind == REGISTA_KIND_POSITIONER) {
    out.push_back({"capacity", "writes no further than it may", check_small_capacity});
  }
  if (kind == REGISTA_KIND_ASSIGNER) {
    out.push_back({"rehearsal", "teammates agree in spite of losses, delays and absences", check_rehearsal,
                   // Who says that it negotiates has to agree, whatever it talks with.
                   [](const Loaded& p, const Options&) {
                     return p.implements(REGISTA_KIND_MAILBOX) || detail::says_it_negotiates(p);
                   }});
  }
  if (kind == REGISTA_KIND_UTILITY) {
    out.push_back({"order", "the order of opponents does not matter", check_order_of_opponents,
                   [](const Loaded&, const Options& options) { return options.order_of_opponents_is_irrelevant; }});
  }
  for (Check& check : out) check = guarded_check(kind, check);
  return out;
}

}  // namespace regista::testkit
