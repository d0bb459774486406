// SPDX-License-Identifier: MIT
// The contract of plugins that receive messages, of any kind: regista_mailbox in <regista/abi.h>.
#pragma once

#include <cstdint>

#include <regista/testkit/course.hpp>

namespace regista::testkit {

// Segments of any content may arrive (another version of the plugin may have written them). To refuse one is sound; to
// break the rules of every call is not. What it says of bytes, if anything, is one line that ends, and always the same.
Findings check_mailbox(const Loaded& plugin, const Options& options, std::uint32_t subject);

// The same messages, each on pages of its own, with default parameters: whoever goes beyond ends the process, as in
// check_memory().
void play_messages_guarded(const Loaded& plugin, const Options& options, std::uint32_t subject = 0);

}  // namespace regista::testkit
