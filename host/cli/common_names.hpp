// SPDX-License-Identifier: MIT
// What every command says in the words of the rooms below: how it is declared, what is wrong, how it ends.
#pragma once

#include "command/command.hpp"
#include "command/end_of_program.hpp"
#include "results/invocation.hpp"

namespace regista::cli {

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

}  // namespace regista::cli
