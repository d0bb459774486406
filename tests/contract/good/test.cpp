// SPDX-License-Identifier: MIT
// The suites accept what is sound.
#include <regista/testkit/contract.hpp>

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "first_free");
REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "nearness", {.order_of_opponents_is_irrelevant = true});
REGISTA_CONTEXT_CONTRACT(REGISTA_PLUGIN_FILE, "ball_seen");
REGISTA_POSITIONER_CONTRACT(REGISTA_PLUGIN_FILE, "at_the_ball");
REGISTA_SENDER_CONTRACT(REGISTA_PLUGIN_FILE, "every_second");
REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "last_news");
