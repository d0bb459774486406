// SPDX-License-Identifier: MIT
// A task of the array: it plays its slices of the study (slice.hpp) on this node, into a part of its own.
#pragma once

#include <string>

#include "cluster/study_folder.hpp"
#include "results/invocation.hpp"

namespace regista::cluster {

// Returns when the part is whole, or has been before. Throws BadInput, Interrupted, output::WriteError.
void play_task(const std::string& folder, const TaskName& name, const results::Invocation& invocation);

}  // namespace regista::cluster
