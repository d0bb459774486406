// SPDX-License-Identifier: MIT
// The contract of every kind as a list of named checks, without any test framework:
//
//   for (const Check& check : contract(REGISTA_KIND_ASSIGNER)) {
//     if (check.applies(plugin, {})) print(check.name, check.run(plugin, {}).text());
//   }
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <regista/testkit/check_assigner.hpp>
#include <regista/testkit/check_context.hpp>
#include <regista/testkit/check_descriptor.hpp>
#include <regista/testkit/check_mailbox.hpp>
#include <regista/testkit/check_positioner.hpp>
#include <regista/testkit/check_predictor.hpp>
#include <regista/testkit/check_sender.hpp>
#include <regista/testkit/check_utility.hpp>

namespace regista::testkit {

struct Check {
  std::string name;     // one word
  std::string promise;  // a sentence
  std::function<Findings(const Loaded&, const Options&)> run;
  // Whether there is anything to check: a plugin that receives no messages need not bear any.
  std::function<bool(const Loaded&, const Options&)> applies = [](const Loaded&, const Options&) { return true; };
};

namespace detail {

inline std::vector<Rehearsal> rehearsals(std::int32_t kind, const Loaded& plugin, const Options& options) {
  switch (kind) {
    case REGISTA_KIND_PREDICTOR:
      return predictor_rehearsals(plugin);
    case REGISTA_KIND_CONTEXT:
      return context_rehearsals(options);
    case REGISTA_KIND_POSITIONER:
      return positioner_rehearsals(options);
    case REGISTA_KIND_UTILITY:
      return utility_rehearsals(options);
    case REGISTA_KIND_ASSIGNER:
      return assigner_rehearsals(options);
    default:
      return sender_rehearsals(options);
  }
}

// An exception of the suite itself, or a plugin without this kind, is a finding and not a crash.
inline Check guarded_check(std::int32_t kind, Check check) {
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

template <class Rehearse>
Check rehearsed(std::int32_t kind, const char* name, const char* promise, Rehearse check) {
  return {name, promise, [kind, check](const Loaded& plugin, const Options& options) {
            return check(plugin, options, rehearsals(kind, plugin, options));
          }};
}

inline bool models(const Loaded& plugin, std::uint32_t subject) { return (subjects_of(plugin) & subject) != 0; }

}  // namespace detail

// kind: REGISTA_KIND_PREDICTOR .. REGISTA_KIND_SENDER.
inline std::vector<Check> contract(std::int32_t kind) {
  std::vector<Check> out{
      {"descriptor", "describes itself", [](const Loaded& plugin, const Options&) { return check_descriptor(plugin); }},
      detail::rehearsed(kind, "promises", "every output is as abi.h promises", check_promises),
      detail::rehearsed(kind, "determinism", "the same calls give the same bytes, also after a reset",
                        check_determinism),
      detail::rehearsed(kind, "growth", "works with a host of a later minor version", check_growth),
      {"mailbox", "bears any message",
       [kind](const Loaded& plugin, const Options& options) {
         const std::uint32_t all = kind == REGISTA_KIND_PREDICTOR ? detail::subjects_of(plugin) : 0;
         return check_mailbox(plugin, options, all & (~all + 1));
       },
       [](const Loaded& plugin, const Options&) { return plugin.implements(REGISTA_KIND_MAILBOX); }}};
  if (kind == REGISTA_KIND_PREDICTOR) {
    out.push_back({"uncertainty", "the own pose does not become surer without news", check_uncertainty_grows,
                   [](const Loaded& p, const Options&) { return detail::models(p, REGISTA_SUBJECT_SELF); }});
    out.push_back({"labels", "opponents in view keep their labels", check_labels_are_stable,
                   [](const Loaded& p, const Options&) { return detail::models(p, REGISTA_SUBJECT_OPPONENTS); }});
  }
  if (kind == REGISTA_KIND_POSITIONER) {
    out.push_back({"capacity", "writes no further than it may", check_small_capacity});
  }
  if (kind == REGISTA_KIND_UTILITY) {
    out.push_back({"order", "the order of opponents does not matter", check_order_of_opponents,
                   [](const Loaded&, const Options& options) { return options.order_of_opponents_is_irrelevant; }});
  }
  for (Check& check : out) check = detail::guarded_check(kind, check);
  return out;
}

}  // namespace regista::testkit
