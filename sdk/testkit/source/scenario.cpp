// SPDX-License-Identifier: MIT
// Once for promises, twice side by side for determinism, twice in different memory for growth, twice with more and less
// of a frame for what is read.
#include <regista/testkit/scenario.hpp>

#include <algorithm>
#include <memory>

#include <regista/testkit/sanitized.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

using detail::step;

Trail detail::step(const Scenario& scenario, Instance& instance, std::size_t index, const Showing& showing,
                   Findings& findings) {
  Trail trail;
  try {
    scenario.play(instance, index, showing, findings, trail);
  } catch (const CallFailed& failure) {
    findings.say(failure.what());
    for (const char* c = failure.what(); *c != '\0'; ++c) trail.add(*c);
  }
  return trail;
}

Findings detail::everywhere(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios,
                            const std::function<void(const Corner&, const Scenario&, Findings&)>& body) {
  Findings findings(options.underway);
  Values base(plugin);
  options.base(base);
  for (const Corner& corner : corners(plugin, base)) {
    for (const Scenario& scenario : scenarios) {
      findings.where(corner.name, "");
      try {
        body(corner, scenario, findings);
      } catch (const CallFailed& failure) {
        findings.say(failure.what());
      }
    }
  }
  return findings;
}

namespace {

// Sanitizers look at memory, for which the beginning of a scenario is enough.
std::size_t steps_played(const Corner& corner, const Scenario& scenario) {
  constexpr std::size_t enough = 120;
  return sanitized && !corner.is_default ? std::min(scenario.steps, enough) : scenario.steps;
}

// Of a comparison: the whole scenario with the defaults, its beginning with other parameters. What depends on the order
// of calls shows with any parameters; what they change are single answers, which check_promises() looks at throughout.
std::size_t steps_compared(const Corner& corner, const Scenario& scenario) {
  constexpr std::size_t enough = sanitized ? 40 : 120;
  return corner.is_default ? scenario.steps : std::min(scenario.steps, enough);
}

}  // namespace

Findings check_promises(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios) {
  return detail::everywhere(plugin, options, scenarios,
                            [&](const Corner& corner, const Scenario& scenario, Findings& findings) {
                              Instance instance(plugin, scenario.environment, corner.values);
                              for (std::size_t i = 0; i < steps_played(corner, scenario); ++i) {
                                findings.where(corner.name, scenario.name(i));
                                step(scenario, instance, i, {}, findings);
                              }
                            });
}

Findings check_determinism(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios) {
  return detail::everywhere(
      plugin, options, scenarios, [&](const Corner& corner, const Scenario& scenario, Findings& findings) {
        Instance first(plugin, scenario.environment, corner.values);
        Instance second(plugin, scenario.environment, corner.values);
        std::vector<Trail> trails;
        Findings elsewhere;
        for (std::size_t i = 0; i < steps_compared(corner, scenario); ++i) {
          findings.where(corner.name, scenario.name(i));
          trails.push_back(step(scenario, first, i, {}, elsewhere));
          if (!elsewhere.empty()) return;  // check_promises() reports it; what follows from it is no fault of its own
          if (step(scenario, second, i, {}, elsewhere) != trails.back()) {
            findings.say("two instances with the same seed and the same calls give different results");
            return;
          }
        }
        first.reset(1);
        for (std::size_t i = 0; i < steps_compared(corner, scenario); ++i) {
          findings.where(corner.name, scenario.name(i));
          if (step(scenario, first, i, {}, elsewhere) != trails[i]) {
            findings.say("after reset() with the same seed the same calls give another result: something was kept");
            return;
          }
        }
      });
}

Findings check_growth(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios) {
  return detail::everywhere(
      plugin, options, scenarios, [&](const Corner& corner, const Scenario& scenario, Findings& findings) {
        constexpr Layout later{24};
        Instance today(plugin, scenario.environment, corner.values);
        Instance tomorrow(plugin, scenario.environment, corner.values, later);
        Findings elsewhere, then;
        for (std::size_t i = 0; i < steps_compared(corner, scenario); ++i) {
          findings.where(corner.name, scenario.name(i));
          const Trail now = step(scenario, today, i, {}, elsewhere);
          if (!elsewhere.empty()) return;
          if (step(scenario, tomorrow, i, {later, REGISTA_READS_ALL}, then) != now) {
            findings.say(
                "structs and elements that are longer than today's change the result: step by stride, not by sizeof");
            return;
          }
        }
      });
}

Findings check_memory(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios) {
  // A change of a page's access costs more than the plugin's call: of a long scenario some steps are played, evenly
  // over it.
  constexpr std::size_t enough = 256;
  Findings findings(options.underway);
  Values values(plugin);
  options.base(values);
  for (const Scenario& scenario : scenarios) {
    constexpr Layout guarded{0, true};
    Instance instance(plugin, scenario.environment, values, guarded);
    Findings elsewhere;
    for (std::size_t i = 0; i < scenario.steps; i += 1 + scenario.steps / enough) {
      findings.where("", scenario.name(i));
      step(scenario, instance, i, {guarded, REGISTA_READS_ALL}, elsewhere);
    }
  }
  return findings;
}

Findings check_reads(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios) {
  return detail::everywhere(plugin, options, scenarios,
                            [&](const Corner& corner, const Scenario& scenario, Findings& findings) {
                              const Showing as_declared{{}, plugin.descriptor().reads};
                              Instance with_all(plugin, scenario.environment, corner.values);
                              Instance with_less(plugin, scenario.environment, corner.values);
                              Findings elsewhere;
                              for (std::size_t i = 0; i < steps_compared(corner, scenario); ++i) {
                                findings.where(corner.name, scenario.name(i));
                                const Trail all = step(scenario, with_all, i, {}, elsewhere);
                                if (!elsewhere.empty()) return;
                                if (step(scenario, with_less, i, as_declared, elsewhere) != all) {
                                  findings.say("parts of the frame that its `reads` do not name change the result");
                                  return;
                                }
                              }
                            });
}

Findings check_life(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios) {
  return detail::everywhere(
      plugin, options, scenarios, [&](const Corner& corner, const Scenario& scenario, Findings& findings) {
        findings.where(corner.name, "no call");
        const auto create = [&] { return std::make_unique<Instance>(plugin, scenario.environment, corner.values); };
        create();
        std::vector<std::unique_ptr<Instance>> team;
        constexpr std::size_t robots = 7;
        for (std::size_t i = 0; i < robots; ++i) team.push_back(create());
        for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
          for (auto& each : team) each->reset(seed);
        }
        // A match of one step, in which every other robot takes part, and another match after it.
        const auto play = [&](Instance& instance) {
          Trail trail;
          Findings elsewhere;
          if (scenario.steps == 0) return;
          findings.where(corner.name, scenario.name(0));
          scenario.play(instance, 0, {}, elsewhere, trail);
        };
        for (std::size_t i = 0; i < robots; i += 2) {
          play(*team[i]);
          team[i]->reset(2);
          play(*team[i]);
        }
        std::rotate(team.begin(), team.begin() + 3, team.end());
        team.clear();
      });
}

Scenario scenario_of_scenes(int size, const char* call, const std::vector<Scene>& scenario,
                            const std::function<void(Instance&, const Scene&, std::size_t, Findings&, Trail&)>& play) {
  Scenario r;
  r.environment = EnvironmentBuilder{}.team_size(static_cast<unsigned>(size)).own(own_number(size));
  r.steps = scenario.size();
  r.name = [scenario](std::size_t i) { return scenario[i].name(); };
  r.play = [scenario, call, play](Instance& instance, std::size_t i, const Showing& showing, Findings& findings,
                                  Trail& trail) {
    const Scene scene = scenario[i].shown(showing);
    play(instance, scene, i, findings, trail);
    if (!scene.unchanged()) findings.say(call, ": wrote to its input");
  };
  return r;
}

}  // namespace regista::testkit
