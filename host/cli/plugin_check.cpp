// SPDX-License-Identifier: MIT
// `regista plugin check FILE.so`: does a plugin keep the promises of the interface?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "check/elsewhere.hpp"
#include "check/plugin_check.hpp"
#include "cli/commands.hpp"
#include "config/bad_input.hpp"
#include "config/typed.hpp"
#include "output/output.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto plugin_check_examples = R"(Examples:
  regista plugin check build/my_assigner.so
  regista plugin check build/my_assigner.so --only promises --only imports
  regista plugin check build/my_assigner.so --may-idle --set at_least=0.3
  regista plugin check build/*.so --json
  gdb --args regista plugin check build/my_assigner.so --only assigner.promises --in-process

The file may be of any language. First it is looked at without running it; then each check opens it in a process of its own, so
that a plugin that crashes, hangs or leaves threads behind is named and the other checks go on. The checks of a kind
are those of the testkit: empty teams, one robot, robots in one place, many tasks and few, the ends of all ranges of
parameters, structs and arrays that have grown, what is not declared to be read.

pass: sound; warn: may be meant, and may go wrong elsewhere; fail: breaks a promise of <regista/abi.h>; crash: the process of
the check died or had to be ended; skip: nothing to check.

Exit codes: 0 no check failed or crashed; 1 one did; 2 bad input; 3 a defect of Regista.)";

struct PluginCheckOptions {
  std::vector<std::string> files, only, plugins, parameters;
  std::string processor_seconds = "10", seed = "0";
  bool may_idle = false, in_process = false, json = false;
};

constexpr auto elsewhere_command = "check-elsewhere";

check::Options options_of(const PluginCheckOptions& options, const Invocation& invocation) {
  check::Options out;
  out.elsewhere = {"regista", "plugin", elsewhere_command};
  out.visitors = invocation.own("lib/regista/plugins");
  out.only = options.only;
  out.plugins = options.plugins;
  out.may_idle = options.may_idle;
  out.in_process = options.in_process;
  out.seed = static_cast<std::uint64_t>(config::parse_whole("--seed", options.seed, 0, 1'000'000'000));
  out.deadline.processor_seconds =
      static_cast<int>(config::parse_whole("--processor-seconds", options.processor_seconds, 1, 1'000'000));
  for (const std::string& each : options.parameters) {
    const std::size_t sign = each.find('=');
    if (sign == std::string::npos || sign == 0) {
      throw BadInput(fmt::format("--set {}: expected NAME=VALUE", texts::in_quotes(each)));
    }
    out.parameters.emplace_back(each.substr(0, sign), each.substr(sign + 1));
  }
  return out;
}

std::string text_of(const check::Verdict& verdict) {
  std::string out = fmt::format("  {:<5}  {:<24}  {}\n", check::word(verdict.status), verdict.check, verdict.promise);
  for (const std::string& line : verdict.lines) out += fmt::format("           {}\n", line);
  return out;
}

std::string summary_of(const check::Report& report) {
  std::string out = fmt::format("{}: {}", report.file, texts::counted(report.verdicts.size(), "check", "checks"));
  for (const check::Status status :
       {check::Status::pass, check::Status::warn, check::Status::fail, check::Status::crash, check::Status::skip}) {
    const auto count = std::ranges::count(report.verdicts, status, &check::Verdict::status);
    if (count > 0) out += fmt::format(", {} {}", count, check::word(status));
  }
  return out + '\n';
}

nlohmann::ordered_json json_of(const check::Report& report) {
  nlohmann::ordered_json checks = nlohmann::ordered_json::array();
  for (const check::Verdict& each : report.verdicts) {
    checks.push_back(
        {{"plugin", each.plugin.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(each.plugin)},
         {"check", each.check},
         {"status", check::word(each.status)},
         {"promise", each.promise},
         {"lines", each.lines},
         {"seconds", each.seconds}});
  }
  return {{"file", report.file}, {"passed", report.passed()}, {"checks", checks}};
}

int run(const PluginCheckOptions& options, const Invocation& invocation) {
  if (options.files.empty())
    throw BadInput("plugin check: which file? Name a shared object, such as build/my_plugin.so");
  const check::Options wanted = options_of(options, invocation);
  check::Listener listener;
  std::string plugin = "none yet";
  if (!options.json) {
    listener.verdict = [&](const std::string& file, const check::Verdict& verdict) {
      if (verdict.plugin != plugin) output::print((verdict.plugin.empty() ? file : verdict.plugin) + '\n');
      plugin = verdict.plugin;
      output::print(text_of(verdict));
    };
    listener.report = [&](const check::Report& report) {
      output::print(summary_of(report));
      plugin = "none yet";
    };
  }
  const std::vector<check::Report> reports =
      check::check_files({options.files.begin(), options.files.end()}, wanted, listener);
  if (options.json) {
    auto json = nlohmann::ordered_json::array();
    for (const check::Report& each : reports) json.push_back(json_of(each));
    output::print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
  }
  return std::ranges::all_of(reports, &check::Report::passed) ? exit_done : exit_no;
}

// What the check `elsewhere` plays when the program is started once more.
void add_elsewhere(Command& parent) {
  Command& command = parent.add(elsewhere_command, "a course of a plugin that is checked");
  command.hide();
  const auto words = std::make_shared<std::vector<std::string>>();
  command.take("words", *words, "WORD", "what to play, and where to tell it", Reads::data);
  command.run = [words]() -> int {
    if (words->size() < 2) throw BadInput("this command is for the program itself");
    const std::string note = std::move(words->back());
    words->pop_back();
    const std::string answer = std::move(words->back());
    words->pop_back();
    const check::Elsewhere what = check::Elsewhere::of(*words);
    check::answer_as_a_child(answer, note,
                             [&](check::Underway& shared) { return check::play_elsewhere(what, shared); });
  };
}

}  // namespace

void add_plugin_check(Command& parent, const Invocation& invocation) {
  add_elsewhere(parent);
  Command& command = parent.add("check", "see whether a plugin keeps the promises of the interface");
  const auto options = std::make_shared<PluginCheckOptions>();
  command.take("files", options->files, "FILE.so", "shared objects", Reads::data);
  command.take("--only", options->only, "CHECK",
               "this check alone, or all of a kind or a name (assigner, promises); may be repeated");
  command.take("--plugin", options->plugins, "ID", "this plugin of the file alone; may be repeated");
  command.take("--set", options->parameters, "NAME=VALUE", "a parameter of the plugin; may be repeated");
  command.flag("--may-idle", options->may_idle, "an assigner may leave a robot without a task that it could do");
  command.take("--processor-seconds", options->processor_seconds, "SECONDS", "processor time of one check; default 10");
  command.take("--seed", options->seed, "N", "other scenes, utilities, messages and losses by chance; default 0");
  command.flag("--in-process", options->in_process,
               "all checks in the program's own process, for a debugger: what ends it is not explained");
  command.flag("--json", options->json, "write JSON: a list, with one element for each file");
  command.notes(plugin_check_examples);
  command.run = [options, &invocation] { return run(*options, invocation); };
}

}  // namespace regista::cli
