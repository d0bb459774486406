#include <gtest/gtest.h>
#include <regista/testkit/contract.hpp>
REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "imm_ball");
