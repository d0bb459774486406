// SPDX-License-Identifier: MIT
// Once for promises, twice side by side for determinism, twice in different memory for growth, twice with more and less
// of a frame for what is read.
#include <regista/testkit/rehearsal.hpp>

namespace regista::testkit {

using detail::step;

Trail detail::step(const Rehearsal& rehearsal, Instance& instance, std::size_t index, const Showing& showing,
                   Findings& findings) {
  Trail trail;
  try {
    rehearsal.play(instance, index, showing, findings, trail);
  } catch (const CallFailed& failure) {
    findings.say(failure.what());
    for (const char* c = failure.what(); *c != '\0'; ++c) trail.add(*c);
  }
  return trail;
}

Findings detail::everywhere(const Loaded& plugin, const Options& options, const std::vector<Rehearsal>& rehearsals,
                            const std::function<void(const Corner&, const Rehearsal&, Findings&)>& body) {
  Findings findings;
  Values base(plugin);
  options.base(base);
  for (const Corner& corner : corners(plugin, base)) {
    for (const Rehearsal& rehearsal : rehearsals) {
      findings.where(corner.name, "");
      try {
        body(corner, rehearsal, findings);
      } catch (const CallFailed& failure) {
        findings.say(failure.what());
      }
    }
  }
  return findings;
}

Findings check_promises(const Loaded& plugin, const Options& options, const std::vector<Rehearsal>& rehearsals) {
  return detail::everywhere(plugin, options, rehearsals,
                            [&](const Corner& corner, const Rehearsal& rehearsal, Findings& findings) {
                              Instance instance(plugin, rehearsal.environment, corner.values);
                              for (std::size_t i = 0; i < rehearsal.steps; ++i) {
                                findings.where(corner.name, rehearsal.name(i));
                                step(rehearsal, instance, i, {}, findings);
                              }
                            });
}

Findings check_determinism(const Loaded& plugin, const Options& options, const std::vector<Rehearsal>& rehearsals) {
  return detail::everywhere(
      plugin, options, rehearsals, [&](const Corner& corner, const Rehearsal& rehearsal, Findings& findings) {
        Instance first(plugin, rehearsal.environment, corner.values);
        Instance second(plugin, rehearsal.environment, corner.values);
        std::vector<Trail> trails;
        Findings elsewhere;
        for (std::size_t i = 0; i < rehearsal.steps; ++i) {
          findings.where(corner.name, rehearsal.name(i));
          trails.push_back(step(rehearsal, first, i, {}, elsewhere));
          if (step(rehearsal, second, i, {}, elsewhere) != trails.back()) {
            findings.say("two instances with the same seed and the same calls give different results");
            return;
          }
        }
        first.reset(1);
        for (std::size_t i = 0; i < rehearsal.steps; ++i) {
          findings.where(corner.name, rehearsal.name(i));
          if (step(rehearsal, first, i, {}, elsewhere) != trails[i]) {
            findings.say("after reset() with the same seed the same calls give another result: something was kept");
            return;
          }
        }
      });
}

Findings check_growth(const Loaded& plugin, const Options& options, const std::vector<Rehearsal>& rehearsals) {
  return detail::everywhere(
      plugin, options, rehearsals, [&](const Corner& corner, const Rehearsal& rehearsal, Findings& findings) {
        constexpr Growth later{24};
        Instance today(plugin, rehearsal.environment, corner.values);
        Instance tomorrow(plugin, rehearsal.environment, corner.values, later);
        Findings elsewhere, then;
        for (std::size_t i = 0; i < rehearsal.steps; ++i) {
          findings.where(corner.name, rehearsal.name(i));
          const Trail now = step(rehearsal, today, i, {}, elsewhere);
          if (step(rehearsal, tomorrow, i, {later, REGISTA_READS_ALL}, then) != now) {
            findings.say(
                "structs and elements that are longer than today's change the result: step by stride, not by sizeof");
            return;
          }
        }
      });
}

Findings check_reads(const Loaded& plugin, const Options& options, const std::vector<Rehearsal>& rehearsals) {
  return detail::everywhere(plugin, options, rehearsals,
                            [&](const Corner& corner, const Rehearsal& rehearsal, Findings& findings) {
                              const Showing as_declared{{}, plugin.descriptor().reads};
                              Instance with_all(plugin, rehearsal.environment, corner.values);
                              Instance with_less(plugin, rehearsal.environment, corner.values);
                              Findings elsewhere;
                              for (std::size_t i = 0; i < rehearsal.steps; ++i) {
                                findings.where(corner.name, rehearsal.name(i));
                                const Trail all = step(rehearsal, with_all, i, {}, elsewhere);
                                if (step(rehearsal, with_less, i, as_declared, elsewhere) != all) {
                                  findings.say("parts of the frame that its `reads` do not name change the result");
                                  return;
                                }
                              }
                            });
}

}  // namespace regista::testkit
