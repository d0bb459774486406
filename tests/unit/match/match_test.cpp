// SPDX-License-Identifier: MIT
#include "match/match.hpp"
#include <gtest/gtest.h>
TEST(A,B){}
