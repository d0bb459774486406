// SPDX-License-Identifier: MIT
// The contract suite of a kind as GoogleTest tests, in one line of a plugin's own test:
//
//   REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "greedy");
//   REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "auction", {.may_idle = true});
//
// Each registers the tests <Kind>Contract.<id>_<check>, at namespace scope.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include <regista/testkit/checks.hpp>

namespace regista::testkit::detail {

class ContractTest : public ::testing::Test {
 public:
  ContractTest(std::string file, std::string id, Options options, Check check)
      : file_(std::move(file)), id_(std::move(id)), options_(std::move(options)), check_(std::move(check)) {}
  void TestBody() override {
    try {
      const Findings findings = check_.run(Loaded(file_, id_), options_);
      if (!findings.empty()) ADD_FAILURE() << id_ << " breaks: " << check_.promise << "\n" << findings.text();
    } catch (const std::exception& exception) {
      FAIL() << exception.what();
    }
  }

 private:
  std::string file_, id_;
  Options options_;
  Check check_;
};

struct Registration {
  std::int32_t kind;
  const char *suite, *file, *source;
  int line;

  bool contract(const char* id, const Options& options = {}) const {
    for (const Check& check : testkit::contract(kind)) {
      if (!applies(check, id, options)) continue;
      const std::string name = std::string(id) + "_" + check.name;
      ::testing::RegisterTest(
          suite, name.c_str(), nullptr, nullptr, source, line,
          [=, from = file]() -> ::testing::Test* { return new ContractTest(from, id, options, check); });
    }
    return true;
  }

  // A plugin that cannot be opened gets every test: each says why it fails.
  bool applies(const Check& check, const char* id, const Options& options) const {
    try {
      return check.applies(Loaded(file, id), options);
    } catch (const std::exception&) {
      return true;
    }
  }
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
