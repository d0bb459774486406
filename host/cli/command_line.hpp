// SPDX-License-Identifier: MIT
// The command line: functions that add the commands, and run(), which runs the command that the arguments name.
#pragma once

#include <span>

#include "command/command.hpp"
#include "command/terminal.hpp"
#include "results/study_kind.hpp"

namespace regista::cli {

// --- Names from other namespaces that the code of every command uses.

using command::BadInput;
using command::Command;
using command::complain;
using command::exit_bad_input;
using command::exit_by_signal;
using command::exit_done;
using command::exit_internal;
using command::exit_no;
using command::explain_current_exception;
using command::Interrupted;
using output::Reads;
using output::Writes;
using results::Invocation;

// --- The commands of the program. Each function adds one command, with its options and examples, to `parent`.

// parent: the program, or its group of commands `plugin` or `config`. `invocation` must outlive the commands.
using AddCommand = void(Command& parent, const Invocation& invocation);
AddCommand add_match, add_view, add_tournament, add_experiment, add_tune, add_run, add_resume, add_report, add_results,
    add_gather, add_status, add_stop, add_cluster_task, add_power, add_sprt, add_rank, add_evaluate_predictor,
    add_metrics, add_completion;
AddCommand add_plugin_list, add_plugin_info, add_plugin_new, add_plugin_check, add_plugin_reference;
AddCommand add_config_check, add_config_show, add_config_diff, add_config_schema, add_config_reference, add_config_draw,
    add_config_copy;

AddCommand add_commands;  // adds all commands

// Runs the command that the arguments name. studies: all kinds of studies. Returns the exit code. Throws nothing.
int run(int argc, char** argv, std::span<const results::StudyKind> studies);

}  // namespace regista::cli
