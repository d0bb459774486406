// SPDX-License-Identifier: MIT
#include "algorithm.hpp"

#include <gtest/gtest.h>

#include <regista/testkit/contract.hpp>

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "gaussian_mixture");
