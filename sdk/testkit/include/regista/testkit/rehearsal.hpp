// SPDX-License-Identifier: MIT
// The part that all kinds' checks share: play a course with an instance, and play it again where the result must be the
// same. A kind says how one step of its course is played; the steps' outputs, byte for byte, are the trail.
#pragma once

#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <regista/testkit/corners.hpp>
#include <regista/testkit/findings.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/options.hpp>

namespace regista::testkit {

// Outputs of one step, as bytes.
class Trail {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double>);
    append(&value, sizeof value);
  }
  // For structs of the ABI, which have no padding.
  template <class T>
  void add_all(const std::vector<T>& values) {
    add(static_cast<std::uint64_t>(values.size()));
    append(values.data(), values.size() * sizeof(T));
  }
  friend bool operator==(const Trail&, const Trail&) = default;

 private:
  void append(const void* from, std::size_t count) {
    if (count == 0) return;
    const auto* first = static_cast<const char*>(from);
    bytes_.insert(bytes_.end(), first, first + count);
  }
  std::vector<char> bytes_;
};

// One course for one environment.
struct Rehearsal {
  EnvironmentBuilder environment;
  std::size_t steps = 0;
  std::function<std::string(std::size_t)> name;  // of a step
  // Plays step `index`; says what breaks a promise; writes its output to the trail. May throw CallFailed.
  std::function<void(Instance&, std::size_t index, Growth, Findings&, Trail&)> play;
};

namespace detail {

// Plays one step; a failed call becomes a finding and part of the trail.
inline Trail step(const Rehearsal& rehearsal, Instance& instance, std::size_t index, Growth growth,
                  Findings& findings) {
  Trail trail;
  try {
    rehearsal.play(instance, index, growth, findings, trail);
  } catch (const CallFailed& failure) {
    findings.say(failure.what());
    for (const char* c = failure.what(); *c != '\0'; ++c) trail.add(*c);
  }
  return trail;
}

// `body(corner, rehearsal)` for all of them; an instance that cannot be created is a finding.
template <class Body>
Findings everywhere(const Loaded& plugin, const Options& options, const std::vector<Rehearsal>& rehearsals,
                    const Body& body) {
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

}  // namespace detail

// Every output is as abi.h promises.
inline Findings check_promises(const Loaded& plugin, const Options& options, const std::vector<Rehearsal>& rehearsals) {
  return detail::everywhere(plugin, options, rehearsals,
                            [&](const Corner& corner, const Rehearsal& rehearsal, Findings& findings) {
                              Instance instance(plugin, rehearsal.environment, corner.values);
                              for (std::size_t i = 0; i < rehearsal.steps; ++i) {
                                findings.where(corner.name, rehearsal.name(i));
                                detail::step(rehearsal, instance, i, {}, findings);
                              }
                            });
}

// Two instances side by side, and one of them after a reset, do the same.
inline Findings check_determinism(const Loaded& plugin, const Options& options,
                                  const std::vector<Rehearsal>& rehearsals) {
  return detail::everywhere(
      plugin, options, rehearsals, [&](const Corner& corner, const Rehearsal& rehearsal, Findings& findings) {
        Instance first(plugin, rehearsal.environment, corner.values);
        Instance second(plugin, rehearsal.environment, corner.values);
        std::vector<Trail> trails;
        Findings elsewhere;
        for (std::size_t i = 0; i < rehearsal.steps; ++i) {
          findings.where(corner.name, rehearsal.name(i));
          trails.push_back(detail::step(rehearsal, first, i, {}, elsewhere));
          if (detail::step(rehearsal, second, i, {}, elsewhere) != trails.back()) {
            findings.say("two instances with the same seed and the same calls give different results");
            return;
          }
        }
        first.reset(1);
        for (std::size_t i = 0; i < rehearsal.steps; ++i) {
          findings.where(corner.name, rehearsal.name(i));
          if (detail::step(rehearsal, first, i, {}, elsewhere) != trails[i]) {
            findings.say("after reset() with the same seed the same calls give another result: something was kept");
            return;
          }
        }
      });
}

// Larger elements and structs, as of a host of a later minor version, change nothing.
inline Findings check_growth(const Loaded& plugin, const Options& options, const std::vector<Rehearsal>& rehearsals) {
  return detail::everywhere(
      plugin, options, rehearsals, [&](const Corner& corner, const Rehearsal& rehearsal, Findings& findings) {
        constexpr Growth later{24};
        Instance today(plugin, rehearsal.environment, corner.values);
        Instance tomorrow(plugin, rehearsal.environment, corner.values, later);
        Findings elsewhere, then;
        for (std::size_t i = 0; i < rehearsal.steps; ++i) {
          findings.where(corner.name, rehearsal.name(i));
          const Trail now = detail::step(rehearsal, today, i, {}, elsewhere);
          if (detail::step(rehearsal, tomorrow, i, later, then) != now) {
            findings.say(
                "structs and elements that are longer than today's change the result: step by stride, not by sizeof");
            return;
          }
        }
      });
}

}  // namespace regista::testkit
