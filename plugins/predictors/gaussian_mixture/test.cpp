// SPDX-License-Identifier: MIT
#include "algorithm.hpp"
