// SPDX-License-Identifier: MIT
// The typed calls of every kind of plugin.
#pragma once

#include "plugin/assigner.hpp"
#include "plugin/behaviour.hpp"
#include "plugin/context.hpp"
#include "plugin/mailbox.hpp"
#include "plugin/positioner.hpp"
#include "plugin/predictor.hpp"
#include "plugin/sender.hpp"
#include "plugin/utility.hpp"
