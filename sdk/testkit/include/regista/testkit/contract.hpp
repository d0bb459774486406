// SPDX-License-Identifier: MIT
// The contract suite of a kind as GoogleTest tests, in one line of a plugin's own test:
//
//   REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "greedy");
//   REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "auction", {.may_idle = true});
//
// Each registers the tests <Kind>Contract.<id>_<check>, at namespace scope.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/options.hpp>

namespace regista::testkit::detail {

struct Registration {
  std::int32_t kind;
  const char *suite, *file, *source;
  int line;

  // Registers the tests. Always true: the value of a constant at namespace scope.
  bool contract(const char* id, const Options& options = {}) const;
};

}  // namespace regista::testkit::detail

#define REGISTA_CONTRACT_NAME_2(line) regista_contract_##line
#define REGISTA_CONTRACT_NAME(line) REGISTA_CONTRACT_NAME_2(line)
// What follows is (id) or (id, {options}): the arguments of register_contract.
#define REGISTA_CONTRACT(kind, suite, file, ...)                       \
  [[maybe_unused]] static const bool REGISTA_CONTRACT_NAME(__LINE__) = \
      ::regista::testkit::detail::Registration{kind, suite, file, __FILE__, __LINE__}.contract(__VA_ARGS__)

#define REGISTA_PREDICTOR_CONTRACT(file, ...) \
  REGISTA_CONTRACT(REGISTA_KIND_PREDICTOR, "PredictorContract", file, __VA_ARGS__)
#define REGISTA_CONTEXT_CONTRACT(file, ...) REGISTA_CONTRACT(REGISTA_KIND_CONTEXT, "ContextContract", file, __VA_ARGS__)
#define REGISTA_POSITIONER_CONTRACT(file, ...) \
  REGISTA_CONTRACT(REGISTA_KIND_POSITIONER, "PositionerContract", file, __VA_ARGS__)
#define REGISTA_UTILITY_CONTRACT(file, ...) REGISTA_CONTRACT(REGISTA_KIND_UTILITY, "UtilityContract", file, __VA_ARGS__)
#define REGISTA_ASSIGNER_CONTRACT(file, ...) \
  REGISTA_CONTRACT(REGISTA_KIND_ASSIGNER, "AssignerContract", file, __VA_ARGS__)
#define REGISTA_SENDER_CONTRACT(file, ...) REGISTA_CONTRACT(REGISTA_KIND_SENDER, "SenderContract", file, __VA_ARGS__)
#define REGISTA_BEHAVIOUR_CONTRACT(file, ...) \
  REGISTA_CONTRACT(REGISTA_KIND_BEHAVIOUR, "BehaviourContract", file, __VA_ARGS__)
