// SPDX-License-Identifier: MIT
// Once for promises, twice side by side for determinism, twice in different memory for growth, twice with more and less
// of a frame for what is read.
#include <regista/testkit/course.hpp>

#include <algorithm>

namespace regista::testkit {

using detail::step;

Trail detail::step(const Course& course, Instance& instance, std::size_t index, const Showing& showing,
                   Findings& findings) {
  Trail trail;
  try {
    course.play(instance, index, showing, findings, trail);
  } catch (const CallFailed& failure) {
    findings.say(failure.what());
    for (const char* c = failure.what(); *c != '\0'; ++c) trail.add(*c);
  }
  return trail;
}

Findings detail::everywhere(const Loaded& plugin, const Options& options, const std::vector<Course>& courses,
                            const std::function<void(const Corner&, const Course&, Findings&)>& body) {
  Findings findings(options.underway);
  Values base(plugin);
  options.base(base);
  for (const Corner& corner : corners(plugin, base)) {
    for (const Course& course : courses) {
      findings.where(corner.name, "");
      try {
        body(corner, course, findings);
      } catch (const CallFailed& failure) {
        findings.say(failure.what());
      }
    }
  }
  return findings;
}

namespace {

// Of a comparison: the whole course with the defaults, its beginning with other parameters. What depends on the order
// of calls shows with any parameters; what they change are single answers, which check_promises() looks at throughout.
std::size_t steps_compared(const Corner& corner, const Course& course) {
  constexpr std::size_t enough = 120;
  return corner.is_default ? course.steps : std::min(course.steps, enough);
}

}  // namespace

Findings check_promises(const Loaded& plugin, const Options& options, const std::vector<Course>& courses) {
  return detail::everywhere(plugin, options, courses,
                            [&](const Corner& corner, const Course& course, Findings& findings) {
                              Instance instance(plugin, course.environment, corner.values);
                              for (std::size_t i = 0; i < course.steps; ++i) {
                                findings.where(corner.name, course.name(i));
                                step(course, instance, i, {}, findings);
                              }
                            });
}

Findings check_determinism(const Loaded& plugin, const Options& options, const std::vector<Course>& courses) {
  return detail::everywhere(
      plugin, options, courses, [&](const Corner& corner, const Course& course, Findings& findings) {
        Instance first(plugin, course.environment, corner.values);
        Instance second(plugin, course.environment, corner.values);
        std::vector<Trail> trails;
        Findings elsewhere;
        for (std::size_t i = 0; i < steps_compared(corner, course); ++i) {
          findings.where(corner.name, course.name(i));
          trails.push_back(step(course, first, i, {}, elsewhere));
          if (!elsewhere.empty())
            return;  // that is told by check_promises(), and what follows from it is no other fault
          if (step(course, second, i, {}, elsewhere) != trails.back()) {
            findings.say("two instances with the same seed and the same calls give different results");
            return;
          }
        }
        first.reset(1);
        for (std::size_t i = 0; i < steps_compared(corner, course); ++i) {
          findings.where(corner.name, course.name(i));
          if (step(course, first, i, {}, elsewhere) != trails[i]) {
            findings.say("after reset() with the same seed the same calls give another result: something was kept");
            return;
          }
        }
      });
}

Findings check_growth(const Loaded& plugin, const Options& options, const std::vector<Course>& courses) {
  return detail::everywhere(
      plugin, options, courses, [&](const Corner& corner, const Course& course, Findings& findings) {
        constexpr Layout later{24};
        Instance today(plugin, course.environment, corner.values);
        Instance tomorrow(plugin, course.environment, corner.values, later);
        Findings elsewhere, then;
        for (std::size_t i = 0; i < steps_compared(corner, course); ++i) {
          findings.where(corner.name, course.name(i));
          const Trail now = step(course, today, i, {}, elsewhere);
          if (!elsewhere.empty()) return;
          if (step(course, tomorrow, i, {later, REGISTA_READS_ALL}, then) != now) {
            findings.say(
                "structs and elements that are longer than today's change the result: step by stride, not by sizeof");
            return;
          }
        }
      });
}

Findings check_memory(const Loaded& plugin, const Options& options, const std::vector<Course>& courses) {
  Findings findings(options.underway);
  Values values(plugin);
  options.base(values);
  for (const Course& course : courses) {
    constexpr Layout guarded{0, true};
    Instance instance(plugin, course.environment, values, guarded);
    Findings elsewhere;
    for (std::size_t i = 0; i < course.steps; ++i) {
      findings.where("", course.name(i));
      step(course, instance, i, {guarded, REGISTA_READS_ALL}, elsewhere);
    }
  }
  return findings;
}

Findings check_reads(const Loaded& plugin, const Options& options, const std::vector<Course>& courses) {
  return detail::everywhere(plugin, options, courses,
                            [&](const Corner& corner, const Course& course, Findings& findings) {
                              const Showing as_declared{{}, plugin.descriptor().reads};
                              Instance with_all(plugin, course.environment, corner.values);
                              Instance with_less(plugin, course.environment, corner.values);
                              Findings elsewhere;
                              for (std::size_t i = 0; i < steps_compared(corner, course); ++i) {
                                findings.where(corner.name, course.name(i));
                                const Trail all = step(course, with_all, i, {}, elsewhere);
                                if (!elsewhere.empty()) return;
                                if (step(course, with_less, i, as_declared, elsewhere) != all) {
                                  findings.say("parts of the frame that its `reads` do not name change the result");
                                  return;
                                }
                              }
                            });
}

}  // namespace regista::testkit
