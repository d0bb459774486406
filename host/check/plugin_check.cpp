// SPDX-License-Identifier: MIT
#include "check/plugin_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <iterator>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>

#include <regista/testkit/cost.hpp>
#include <regista/testkit/kind_checks.hpp>

#include "check/file_checks.hpp"
#include "check/perturbed_rerun.hpp"
#include "config/errors.hpp"
#include "plugin/description.hpp"
#include "plugin/elf_file.hpp"
#include "plugin/shared_object.hpp"
#include "texts/message.hpp"

namespace regista::check {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::array file_checks{"object",  "exports", "relocations", "needs",
                                 "imports", "open",    "hand_shake",  "ending"};
std::string kind_and(std::int32_t kind, std::string_view check) {
  return fmt::format("{}.{}", plugin::kind_name(kind), check);
}

// Returns whether `only` names this check. A part, such as "assigner" or "promises", names all checks that have it.
bool is_wanted(const std::vector<std::string>& only, std::string_view check) {
  if (only.empty()) return true;
  const std::size_t point = check.find('.');
  return std::ranges::any_of(only, [&](std::string_view each) {
    return each == check ||
           (point != std::string_view::npos && (each == check.substr(0, point) || each == check.substr(point + 1)));
  });
}

Outcome outcome_of(const testkit::Findings& findings) {
  Outcome out;
  const auto add = [&out](const std::vector<std::string>& lines) {
    for (const std::string& line : lines) out.lines.push_back(texts::one_line(line));
  };
  if (!findings.empty()) {
    out.status = Status::fail;
    add(findings.lines());
    return out;
  }
  if (!findings.doubts().empty()) out.status = Status::warn;
  add(findings.doubts());
  add(findings.remarks());
  return out;
}

bool is_named(const std::vector<std::string>& names, std::string_view id) {
  return names.empty() || std::ranges::find(names, id) != names.end();
}

std::vector<std::string> checks_of(std::int32_t kind) {
  std::vector<std::string> out;
  for (const testkit::Check& check : testkit::contract(kind)) {
    if (check.name != "descriptor") out.push_back(kind_and(kind, check.name));
  }
  for (const char* check : {"elsewhere", "alone", "cost"}) out.push_back(kind_and(kind, check));
  return out;
}

// The checks of one file. The constructor inspects the file, and run() checks it.
class FileCheck {
 public:
  // note: receives a text about the current check.
  FileCheck(const fs::path& file, const Options& options, const Listener& listener, Underway& note)
      : file_(fs::absolute(file)), options_(options), listener_(listener), object_(read_object(file_)), note_(note) {
    report_.file = texts::visible(file.string());
    testkit_options_ = options_with(options_.seed, given_, plugin_, note_);
    testkit_options_.may_idle = options_.may_idle;
    testkit_options_.doubts_idleness = true;
    if (!object_.wrong.empty() || !is_plugin()) return;
    surveyed_ = std::move(plugin::scan_files(std::array{file_}).front());
    if (is_open()) given_ = GivenValues(options_.parameters, surveyed_, options_.plugins);
  }
  FileCheck(const FileCheck&) = delete;
  FileCheck& operator=(const FileCheck&) = delete;

  // --- Names that a user can request. A file that cannot be opened has no such names.

  const std::string& name() const { return report_.file; }
  bool is_open() const { return object_.wrong.empty() && is_plugin() && surveyed_.refusal.empty(); }
  std::vector<std::string> plugins() const {
    std::vector<std::string> out;
    for (const auto& each : surveyed_.plugins) out.emplace_back(each->declared().id);
    return out;
  }
  const std::vector<std::string>& parameters() const { return given_.known(); }
  std::vector<std::string> checks() const {
    std::vector<std::string> out(file_checks.begin(), file_checks.end());
    for (const auto& each : surveyed_.plugins) {
      if (!is_named(options_.plugins, each->declared().id)) continue;
      out.insert(out.end(), {"descriptor", "creation"});
      for (const std::int32_t kind : kinds_checked) {
        if (each->implements(kind)) std::ranges::copy(checks_of(kind), std::back_inserter(out));
      }
    }
    return out;
  }

  Report run() {
    here("object", "is a shared object of this machine",
         object_.wrong.empty() ? Outcome{} : Outcome{Status::fail, {object_.wrong}}, !object_.wrong.empty());
    if (!object_.wrong.empty()) return std::move(report_);
    here("exports", "exports the entry point and nothing else", exports_of(object_), !is_plugin());
    if (!is_plugin()) return std::move(report_);
    here("relocations", "its code can be shared between processes", relocations_of(object_));
    here("needs", "needs libraries that are everywhere", needs_of(object_, file_));
    here("imports", "calls nothing that sound plugins do not need", imports_of(object_));
    here("open", "can be opened, and declares plugins of this interface", opening(), !is_open());
    if (!is_open()) return std::move(report_);
    const auto count = static_cast<std::uint32_t>(surveyed_.plugins.size());
    apart("hand_shake", "gives every host the same answers", [&] { return shake_hands(file_, count); });
    check_ending();
    for (const auto& each : surveyed_.plugins) {
      if (is_named(options_.plugins, each->declared().id)) check_plugin(*each);
    }
    return std::move(report_);
  }

 private:
  bool is_plugin() const { return std::ranges::binary_search(object_.exports, REGISTA_ENTRY_NAME); }

  Outcome opening() const {
    if (!surveyed_.refusal.empty()) return {Status::fail, {surveyed_.refusal}};
    if (!surveyed_.remark.empty()) return {Status::warn, {surveyed_.remark}};
    return {};
  }

  // Runs in a child even for a debugger, because it checks the end of a process.
  void check_ending() {
    judge("ending", "lets a process end that has opened it", [&]() -> Outcome {
      const auto open = [&] {
        Outcome out = open_and_no_more(file_);
        note_.write("the end of the process");
        return out;
      };
      return in_a_child(open, options_.deadline, note_, Ending::as_programs_do);
    });
  }

  void check_plugin(const plugin::Description& plugin) {
    plugin_ = plugin.declared().id;
    hung_ = false;
    apart("descriptor", "describes itself", [&] { return outcome_of(testkit::check_descriptor(loaded())); });
    const std::size_t before = report_.verdicts.size();
    apart("creation", "can be created with its defaults", [&] { return why_not_created(); });
    if (report_.verdicts.size() > before && report_.verdicts.back().status != Status::pass) {
      plugin_.clear();
      return;
    }
    for (const std::int32_t kind : kinds_checked) {
      if (!plugin.implements(kind)) continue;
      bool determined = true;
      for (const testkit::Check& check : testkit::contract(kind)) {
        if (check.name == "descriptor") continue;  // one check of the descriptor serves all kinds
        apart(kind_and(kind, check.name), check.promise, [&]() -> Outcome {
          const testkit::Loaded own = loaded();
          if (!check.applies(own, testkit_options_)) return {Status::skip, {}};
          // "growth" and "reads" compare two instances, so these checks need a passed "determinism".
          if (!determined && (check.name == "growth" || check.name == "reads")) {
            return {Status::skip, {"the same calls do not give the same bytes: mend that first"}};
          }
          return judged(check, own);
        });
        if (check.name == "determinism") determined = !last_failed(kind_and(kind, check.name));
      }
      check_elsewhere(kind);
      check_alone(kind, determined && !last_failed(kind_and(kind, "elsewhere")));
      apart(kind_and(kind, "cost"), "what a call costs", [&] { return cost_of(kind); });
    }
    plugin_.clear();
  }

  bool last_failed(std::string_view check) const {
    return !report_.verdicts.empty() && report_.verdicts.back().check == check &&
           report_.verdicts.back().status == Status::fail;
  }

  // Adds a hint to a warning: an assigner may leave a robot idle on purpose.
  Outcome judged(const testkit::Check& check, const testkit::Loaded& own) const {
    const testkit::Findings findings = check.run(own, testkit_options_);
    Outcome out = outcome_of(findings);
    if (check.name == "promises" && out.status == Status::warn) {
      out.lines.insert(out.lines.begin() + static_cast<std::ptrdiff_t>(findings.doubts().size()),
                       "if that is meant: --may-idle");
    }
    return out;
  }

  // Tries to create the plugin. The outcome says why this failed, for example without a file that a parameter needs.
  Outcome why_not_created() const {
    const testkit::Loaded own = loaded();
    std::string files;
    for (std::size_t i = 0; i < own.parameter_count(); ++i) {
      const regista_parameter& each = own.parameter(i);
      const bool given = std::ranges::any_of(options_.parameters, [&](const auto& p) { return p.first == each.name; });
      if (each.type == REGISTA_TYPE_FILE && !given) files += fmt::format(" --set {}=FILE", each.name);
    }
    try {
      testkit::Values values(own);
      testkit_options_.base(values);
      const testkit::Instance instance(own, testkit::EnvironmentBuilder{}, values);
    } catch (const testkit::CallFailed& failure) {
      if (files.empty()) return {Status::fail, {failure.what()}};
      return {Status::warn, {failure.what(), "nothing more can be checked without it:" + files}};
    }
    return {};
  }

  testkit::Loaded loaded() const { return {file_.string(), plugin_}; }

  // Returns an outcome whose only line is the hash of a whole scenario.
  Outcome digest(std::int32_t kind) const {
    return {Status::pass, {fmt::format("{:016x}", testkit::scenario_digest(kind, loaded(), testkit_options_))}};
  }

  void check_elsewhere(std::int32_t kind) {
    judge(kind_and(kind, "elsewhere"), "does the same in another process, folder and environment", [&]() -> Outcome {
      if (options_.in_process || hung_ || options_.perturbed.empty()) return {Status::skip, {}};
      const auto without_digest = [](Outcome outcome) {
        if (outcome.lines.size() > 1 && outcome.status != Status::crash) outcome.lines.erase(outcome.lines.begin());
        return outcome;
      };
      const Outcome first = in_a_child([&] { return digest(kind); }, options_.deadline, note_);
      if (first.status != Status::pass) return without_digest(first);
      const Elsewhere same{file_, plugin_, kind, options_.seed, options_.visitors, options_.parameters};
      std::vector<std::string> words = options_.perturbed;
      std::ranges::copy(same.words(), std::back_inserter(words));
      const Outcome second = in_another_program(std::move(words), environment_elsewhere(), options_.deadline, note_);
      if (second.status != Status::pass) return without_digest(second);
      if (first.lines == second.lines) return {};
      return {Status::fail,
              {"the same calls give another result in another process: it depends on addresses, the folder, the "
               "environment, or on what others do"}};
    });
  }

  void check_alone(std::int32_t kind, bool determined) {
    judge(kind_and(kind, "alone"), "answers each of a team's robots as if it were alone", [&]() -> Outcome {
      if (options_.in_process || hung_) return {Status::skip, {}};
      if (!determined)
        return {Status::skip, {"the same calls do not give the same bytes, here or elsewhere: mend that first"}};
      Outcome changed = in_a_child([&] { return changes_own_memory(kind); }, options_.deadline, note_);
      if (changed.status != Status::pass) return changed;
      const Outcome team = in_a_child([&] { return digests(kind, std::nullopt); }, options_.deadline, note_);
      if (team.status != Status::pass) return team;
      for (std::size_t robot = 0; robot < testkit::robots_of_a_team; ++robot) {
        const Outcome alone = in_a_child([&] { return digests(kind, robot); }, options_.deadline, note_);
        if (alone.status != Status::pass) return alone;
        if (robot < team.lines.size() && alone.lines == std::vector{team.lines[robot]}) continue;
        return {Status::fail,
                {fmt::format("robot {} is answered otherwise when six others are asked in the same process: they share "
                             "something that is in no instance",
                             robot + 1)}};
      }
      return {};
    });
  }

  // Returns one line for each robot with the hash of its answers. With `only`, returns the line of this robot alone.
  Outcome digests(std::int32_t kind, std::optional<std::size_t> only) const {
    Outcome out;
    const std::vector<std::uint64_t> all = testkit::team_digests(kind, loaded(), testkit_options_, only);
    for (std::size_t robot = 0; robot < all.size(); ++robot) {
      if (only.value_or(robot) == robot) out.lines.push_back(fmt::format("{:016x}", all[robot]));
    }
    return out;
  }

  // Plays the scenario of the kind (the calls by which the testkit checks it) twice. Fails if the second play changes
  // variables of the plugin's file; the first play may set variables.
  Outcome changes_own_memory(std::int32_t kind) const {
    const auto counts_its_lines = [](const std::string& name) { return name.starts_with("__gcov"); };
    if (std::ranges::any_of(object_.imports, counts_its_lines)) return {};
    const testkit::Loaded own = loaded();
    testkit::play_scenario(kind, own, testkit_options_, [](const std::string&) {});
    plugin::OwnMemory memory(reinterpret_cast<const void*>(own.descriptor().create));
    Outcome out;
    memory.remember();
    testkit::play_scenario(kind, own, testkit_options_, [&](const std::string& step) {
      const auto change = memory.change();
      if (!change || out.status != Status::pass) return;
      const std::string variable = plugin::variable_at(file_, *change);
      out.status = Status::fail;
      out.lines = {fmt::format("changed {} that all its instances share{}",
                               change->of_thread ? "a variable of the thread" : "a variable",
                               variable.empty() ? "" : ": " + variable),
                   "first at: " + step};
    });
    return out;
  }

  Outcome cost_of(std::int32_t kind) const {
    Outcome out;
    for (const testkit::Cost& each : testkit::cost_of_calls(kind, loaded(), testkit_options_, count_allocations())) {
      std::string line = fmt::format("{}: half of the calls within {:.1f} us, 99 % within {:.1f} us", each.call,
                                     each.median_microseconds, each.p99_microseconds);
      if (each.allocations) line += fmt::format(", {:.1f} allocations a call", *each.allocations);
      out.lines.push_back(line + fmt::format(" ({} calls)", each.count));
      constexpr double much = 5'000.0;
      if (each.mean_microseconds > much) {
        out.status = Status::warn;
        out.lines.push_back(
            fmt::format("a match will be slow: a call takes {:.0f} us on average, and every robot makes it ten "
                        "times a second",
                        each.mean_microseconds));
      }
    }
    return out;
  }

  // Adds the verdict of a check that needs no child. bars: adds the verdict even if the user did not ask for the check.
  void here(const std::string& name, const std::string& promise, const Outcome& outcome, bool bars = false) {
    judge(
        name, promise, [&] { return outcome; }, bars);
  }
  void apart(const std::string& name, const std::string& promise, const std::function<Outcome()>& check) {
    const auto alone = [&] {
      return leaving_the_process_alone([&] {
        Outcome out = without_exceptions(check);
        note_.write("after the last call");
        return out;
      });
    };
    judge(name, promise, [&]() -> Outcome {
      if (hung_) return {Status::skip, {"an earlier check had to be ended"}};  // a second check would hang, too
      Outcome out = options_.in_process ? here_and_now(alone) : in_a_child(alone, options_.deadline, note_);
      hung_ = out.hung;
      return out;
    });
  }
  // Runs a check in this process. An exception that would end a child becomes an outcome.
  static Outcome here_and_now(const std::function<Outcome()>& check) {
    try {
      return check();
    } catch (const std::bad_alloc&) {
      return {Status::crash, {"took all the memory that there is"}};
    }
  }
  // Makes a check and adds its verdict, if the user asked for the check. bars: as for here().
  void judge(const std::string& name, const std::string& promise, const std::function<Outcome()>& check,
             bool bars = false) {
    if (!bars && !is_wanted(options_.only, name)) return;
    const auto began = Clock::now();
    Outcome outcome = check();
    const std::chrono::duration<double> seconds = Clock::now() - began;
    // Names of files and messages of the loader may contain bytes that are not text.
    for (std::string& line : outcome.lines) line = texts::visible(line);
    report_.verdicts.push_back({plugin_, name, promise, outcome.status, std::move(outcome.lines), seconds.count()});
    if (listener_.verdict) listener_.verdict(report_.file, report_.verdicts.back());
  }

  fs::path file_;
  Options options_;
  const Listener& listener_;
  ObjectFile object_;
  plugin::ScannedFile surveyed_;
  GivenValues given_;
  testkit::Options testkit_options_;
  std::string plugin_;
  Underway& note_;
  bool hung_ = false;  // true: a check of this plugin hung
  Report report_;
};

// Returns the names of all files together, each name once.
template <class Names>
std::vector<std::string> of_all(const std::deque<FileCheck>& files, Names names) {
  std::vector<std::string> out;
  for (const FileCheck& file : files) {
    for (const std::string& each : (file.*names)()) texts::add_once(out, each);
  }
  return out;
}

void refuse_unknown(std::string_view what, const std::string& where, const std::vector<std::string>& asked,
                    const std::vector<std::string>& known) {
  for (const std::string& each : asked) {
    if (std::ranges::find(known, each) == known.end()) throw config::BadInput(texts::unknown(what, each, where, known));
  }
}

void refuse_what_nobody_has(const std::deque<FileCheck>& files, const Options& options) {
  // If a file cannot be opened, refuses nothing, because a name may belong to this file. The file fails anyway.
  if (!std::ranges::all_of(files, &FileCheck::is_open)) return;
  const std::string where = files.size() == 1 ? files.front().name() : "these files";
  refuse_unknown("plugin", where, options.plugins, of_all(files, &FileCheck::plugins));
  std::vector<std::string> parameters;
  for (const auto& each : options.parameters) parameters.push_back(each.first);
  refuse_unknown("parameter", (options.plugins.empty() ? "the plugins of " : "the chosen plugins of ") + where,
                 parameters, of_all(files, &FileCheck::parameters));
  const std::vector<std::string> checks = of_all(files, &FileCheck::checks);
  for (const std::string& each : options.only) {
    const std::vector<std::string> alone{each};
    if (std::ranges::any_of(checks, [&](const std::string& check) { return is_wanted(alone, check); })) continue;
    throw config::BadInput(files.size() == 1 ? fmt::format("--only {}: {} has no such check", each, where)
                                             : fmt::format("--only {}: none of these files has such a check", each));
  }
}

// Returns all names that Options::only may contain: the checks, and the parts of their names.
std::vector<std::string> known_checks() {
  std::vector<std::string> out(file_checks.begin(), file_checks.end());
  out.insert(out.end(), {"descriptor", "creation"});
  const auto add = [&out](const std::string& name) { texts::add_once(out, name); };
  for (const std::int32_t kind : kinds_checked) {
    add(std::string(plugin::kind_name(kind)));
    for (const std::string& check : checks_of(kind)) {
      add(check.substr(check.find('.') + 1));
      add(check);
    }
  }
  return out;
}

}  // namespace

std::vector<Report> check_files(const std::vector<fs::path>& files, const Options& options, const Listener& listener) {
  refuse_unknown("check", "--only", options.only, known_checks());
  for (const fs::path& file : files) {
    std::error_code none;
    if (!fs::exists(file, none)) throw config::BadInput(fmt::format("{}: no such file", file.string()));
  }
  Underway note;
  std::deque<FileCheck> checks;  // a deque, because FileCheck cannot move
  for (const fs::path& file : files) checks.emplace_back(file, options, listener, note);
  refuse_what_nobody_has(checks, options);
  std::vector<Report> out;
  for (FileCheck& each : checks) {
    out.push_back(each.run());
    if (listener.report) listener.report(out.back());
  }
  return out;
}

}  // namespace regista::check
