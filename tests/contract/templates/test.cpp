// SPDX-License-Identifier: MIT
// The templates of all kinds in both languages, by the contract of their kind.
#include <gtest/gtest.h>

#include <regista/testkit/contract.hpp>

REGISTA_PREDICTOR_CONTRACT(TEMPLATES "/predictor_in_cpp.so", "predictor_in_cpp");
REGISTA_PREDICTOR_CONTRACT(TEMPLATES "/predictor_in_c.so", "predictor_in_c");
REGISTA_CONTEXT_CONTRACT(TEMPLATES "/context_in_cpp.so", "context_in_cpp");
REGISTA_CONTEXT_CONTRACT(TEMPLATES "/context_in_c.so", "context_in_c");
REGISTA_POSITIONER_CONTRACT(TEMPLATES "/positioner_in_cpp.so", "positioner_in_cpp");
REGISTA_POSITIONER_CONTRACT(TEMPLATES "/positioner_in_c.so", "positioner_in_c");
REGISTA_UTILITY_CONTRACT(TEMPLATES "/utility_in_cpp.so", "utility_in_cpp", {.order_of_opponents_is_irrelevant = true});
REGISTA_UTILITY_CONTRACT(TEMPLATES "/utility_in_c.so", "utility_in_c", {.order_of_opponents_is_irrelevant = true});
REGISTA_ASSIGNER_CONTRACT(TEMPLATES "/assigner_in_cpp.so", "assigner_in_cpp", {.may_idle = true});
REGISTA_ASSIGNER_CONTRACT(TEMPLATES "/assigner_in_c.so", "assigner_in_c", {.may_idle = true});
REGISTA_BEHAVIOUR_CONTRACT(TEMPLATES "/behaviour_in_cpp.so", "behaviour_in_cpp");
REGISTA_BEHAVIOUR_CONTRACT(TEMPLATES "/behaviour_in_c.so", "behaviour_in_c");
REGISTA_SENDER_CONTRACT(TEMPLATES "/sender_in_cpp.so", "sender_in_cpp");
REGISTA_SENDER_CONTRACT(TEMPLATES "/sender_in_c.so", "sender_in_c");
