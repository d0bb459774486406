// SPDX-License-Identifier: MIT
// What a subcommand is: it adds itself, its options and its examples to the command line, and is run if it was chosen.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace regista::cli {

struct StudyKind;

// How the program was started, and which studies it knows.
struct Invocation {
  std::vector<std::string> arguments;  // the first is the name of the program
  std::filesystem::path executable{};  // its own file; empty when the system does not tell
  std::span<const StudyKind> studies{};
};

struct Command {
  CLI::App* app;
  std::function<int()> run;  // exit code; throws what end_of_program.hpp knows to explain
};

Command add_match(CLI::App& parent, const Invocation& invocation);
Command add_experiment(CLI::App& parent, const Invocation& invocation);
Command add_tune(CLI::App& parent, const Invocation& invocation);
Command add_evaluate_predictor(CLI::App& parent, const Invocation& invocation);
Command add_play_one(CLI::App& parent, const Invocation& invocation);
Command add_report(CLI::App& parent, const Invocation& invocation);
Command add_sprt(CLI::App& parent, const Invocation& invocation);
Command add_tournament(CLI::App& parent, const Invocation& invocation);
Command add_view(CLI::App& parent, const Invocation& invocation);
Command add_metrics(CLI::App& parent);
Command add_plugin_list(CLI::App& parent, const Invocation& invocation);
Command add_plugin_info(CLI::App& parent, const Invocation& invocation);
Command add_plugin_reference(CLI::App& parent, const Invocation& invocation);
Command add_config_check(CLI::App& parent, const Invocation& invocation);
Command add_config_show(CLI::App& parent, const Invocation& invocation);
Command add_config_schema(CLI::App& parent, const Invocation& invocation);

}  // namespace regista::cli
