// SPDX-License-Identifier: MIT
// There is no algorithm to test here; the plugin itself is opened and asked.
#include <gtest/gtest.h>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/loaded.hpp>

namespace {

using namespace regista::testkit;

REGISTA_CONTEXT_CONTRACT(REGISTA_PLUGIN_FILE, "always");

}  // namespace
