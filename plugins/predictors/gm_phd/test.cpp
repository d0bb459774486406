// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <regista/testkit/contract.hpp>

#include "algorithm.hpp"

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "gm_phd");
