// SPDX-License-Identifier: MIT
// Who is to blame when workers die over a match. A match is a pure function, so a plugin that kills its worker does it
// again; what a second try does not reproduce was an accident of the machine.
#pragma once

#include <optional>
#include <span>

#include "campaign/job.hpp"
#include "campaign/worker.hpp"

namespace regista::campaign {

enum class Judgement {
  play_again,
  forfeit,  // two deaths in the hands of the same side: the last one's suspect loses
  give_up,  // two deaths before any plugin was called, worker after worker killed from outside, or a match too long
};

inline constexpr std::size_t most_deaths = 6;  // over one match, until it is given up

// deaths: all over this match so far, none of which is an answer; at least one. A signal that comes from outside is
// nobody's fault, unless it comes twice in the very same call: then the plugin sends it itself.
Judgement judge(std::span<const End> deaths);

// In whose hands the worker died; nothing when no plugin had been called.
std::optional<Failure> suspect(const End& death);

}  // namespace regista::campaign
