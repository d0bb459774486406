// SPDX-License-Identifier: MIT
// The commands of the program: each declares itself, its options and its examples on its parent.
#pragma once

#include <string>

#include "cli/common_names.hpp"
#include "results/invocation.hpp"

namespace regista::cli {

// What a campaign starts the program for: does it, and ends the process, where name is of such a command; they are none
// of the command line's, and no help names them.
void run_for_campaign(const std::string& name, const Invocation& invocation);

void add_match(Command& program, const Invocation& invocation);
void add_experiment(Command& program, const Invocation& invocation);
void add_tune(Command& program, const Invocation& invocation);
void add_evaluate_predictor(Command& program, const Invocation& invocation);
void add_run(Command& program, const Invocation& invocation);
void add_resume(Command& program, const Invocation& invocation);
void add_report(Command& program, const Invocation& invocation);
void add_results(Command& program, const Invocation& invocation);
void add_gather(Command& program, const Invocation& invocation);
void add_status(Command& program);
void add_stop(Command& program);
void add_cluster_task(Command& program, const Invocation& invocation);
void add_sprt(Command& program);
void add_rank(Command& program);
void add_tournament(Command& program, const Invocation& invocation);
void add_view(Command& program, const Invocation& invocation);
void add_metrics(Command& program);
void add_completion(Command& program);
void add_plugin_list(Command& parent, const Invocation& invocation);
void add_plugin_check(Command& parent, const Invocation& invocation);
void add_plugin_info(Command& parent, const Invocation& invocation);
void add_plugin_new(Command& parent, const Invocation& invocation);
void add_plugin_reference(Command& parent, const Invocation& invocation);
void add_config_check(Command& parent, const Invocation& invocation);
void add_config_show(Command& parent, const Invocation& invocation);
void add_config_copy(Command& parent, const Invocation& invocation);
void add_config_draw(Command& parent);
void add_config_reference(Command& parent, const Invocation& invocation);
void add_config_schema(Command& parent, const Invocation& invocation);

}  // namespace regista::cli
