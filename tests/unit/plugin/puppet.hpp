// SPDX-License-Identifier: MIT
// A plugin inside the test: its calls do what the test says, so that every broken promise stands beside the message it
// must lead to. Calls are plain function pointers; lambdas without captures will do.
#pragma once

#include <cstdio>

#include "scene.hpp"

namespace regista::plugin::test {

struct Puppet {
  static inline regista_predictor predictor;
  static inline regista_context context;
  static inline regista_positioner positioner;
  static inline regista_utility utility;
  static inline regista_assigner assigner;
  static inline regista_sender sender;
  static inline regista_mailbox mailbox;
  static inline bool looks_closely;  // at what instances do from now on; see AnswerRooms

  // All calls do nothing and succeed, and are looked at closely.
  static void rest() {
    looks_closely = true;
    predictor = {sizeof predictor,
                 15,
                 [](void*, double, const regista_motion*, const regista_frame*, regista_error*) { return ok; },
                 [](void*, regista_span, const regista_visible_area*, regista_error*) { return ok; },
                 [](void*, regista_span, double, regista_error*) { return ok; },
                 [](void*, regista_room*, regista_error*) { return ok; },
                 nullptr};
    context = {sizeof context, 0, [](void*, const regista_frame*, std::int32_t*, regista_error*) { return ok; }};
    positioner = {sizeof positioner, 0,
                  [](void*, const regista_frame*, regista_placement*, regista_error*) { return ok; }};
    utility = {sizeof utility, 0,
               [](void*, const regista_frame*, const regista_matrix_room*, regista_error*) { return ok; }};
    assigner = {sizeof assigner, 0,
                [](void*, const regista_frame*, const regista_matrix*, std::int32_t*, regista_error*) { return ok; }};
    sender = {sizeof sender, 0,
              [](void*, const regista_frame*, regista_span, regista_span, const regista_budget*, regista_send*,
                 regista_error*) { return ok; },
              nullptr};
    mailbox = {sizeof mailbox,
               0,
               [](void*, std::uint64_t, regista_error*) { return ok; },
               [](void*, std::uint64_t, regista_error*) { return ok; },
               [](void*, const regista_message*, regista_error*) { return ok; },
               [](void*, const std::uint8_t*, std::uint32_t, char*, std::uint32_t, regista_error*) { return ok; }};
  }

  static constexpr std::int32_t ok = REGISTA_OK;

  static const void* table(std::int32_t kind) {
    switch (kind) {
      case REGISTA_KIND_PREDICTOR:
        return &predictor;
      case REGISTA_KIND_CONTEXT:
        return &context;
      case REGISTA_KIND_POSITIONER:
        return &positioner;
      case REGISTA_KIND_UTILITY:
        return &utility;
      case REGISTA_KIND_ASSIGNER:
        return &assigner;
      case REGISTA_KIND_SENDER:
        return &sender;
      case REGISTA_KIND_MAILBOX:
        return &mailbox;
      default:
        return nullptr;
    }
  }

  static regista_descriptor descriptor() {
    regista_descriptor out{};
    out.size = sizeof out;
    out.abi_major = REGISTA_ABI_MAJOR;
    out.abi_minor = REGISTA_ABI_MINOR;
    out.id = "puppet";
    out.version = "1.0.0";
    out.summary = "Does what the test says";
    out.licence = "MIT";
    out.build_tag = "in the test";
    out.parameter_stride = sizeof(regista_parameter);
    out.table = &table;
    out.create = [](const regista_environment*, const regista_host*, regista_span, regista_error*) -> void* {
      static char instance;
      return &instance;
    };
    out.reset = [](void*, std::uint64_t, regista_error*) { return ok; };
    out.destroy = [](void*) {};
    out.minimum_minor = REGISTA_ABI_MINOR;
    out.reads = REGISTA_READS_ALL;
    return out;
  }

  // A fresh instance; failures name the file "puppet.so".
  static std::shared_ptr<Instance> instance(std::uint32_t subject = 0) {
    static const regista_descriptor unchanging = descriptor();
    auto out = instance_of({"puppet.so", &unchanging}, subject);
    out->rooms().strict = looks_closely;
    return out;
  }

  // "plugin puppet (puppet.so) of team paper, robot 3, tick 417: <rest>"
  static std::string failure(const std::string& rest) {
    return "plugin puppet (puppet.so) of team paper, robot 3, tick 417: " + rest;
  }
};

// Fixture of tests that break one promise each.
class PuppetTest : public ::testing::Test {
 protected:
  void SetUp() override { Puppet::rest(); }
};

}  // namespace regista::plugin::test
