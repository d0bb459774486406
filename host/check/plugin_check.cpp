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
#include <span>
#include <string_view>
#include <system_error>

#include <regista/testkit/check_life.hpp>
#include <regista/testkit/checks.hpp>
#include <regista/testkit/cost.hpp>

#include "check/allocations.hpp"
#include "check/elsewhere.hpp"
#include "check/file_checks.hpp"
#include "check/given_values.hpp"
#include "check/kinds_checked.hpp"
#include "check/object_file.hpp"
#include "check/process_watch.hpp"
#include "config/bad_input.hpp"
#include "plugin/descriptor.hpp"
#include "plugin/own_memory.hpp"
#include "plugin/survey.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::check {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::array file_checks{"object",  "exports", "relocations", "needs",
                                 "imports", "open",    "hand_shake",  "ending"};
std::string kind_and(std::int32_t kind, std::string_view check) {
  return fmt::format("{}.{}", plugin::kind_name(kind), check);
}

// "assigner" and "promises" name all checks of which they are a part.
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

// The checks of a kind, by their whole names.
std::vector<std::string> checks_of(std::int32_t kind) {
  std::vector<std::string> out;
  for (const testkit::Check& check : testkit::contract(kind)) {
    if (check.name != "descriptor") out.push_back(kind_and(kind, check.name));
  }
  out.push_back(kind_and(kind, "elsewhere"));
  out.push_back(kind_and(kind, "alone"));
  out.push_back(kind_and(kind, "cost"));
  return out;
}

// One file: looked at when it is constructed, checked by run().
class FileCheck {
 public:
  // note: of whatever is checked.
  FileCheck(const fs::path& file, const Options& options, const Listener& listener, Underway& note)
      : file_(fs::absolute(file)), options_(options), listener_(listener), object_(read_object(file_)), note_(note) {
    report_.file = texts::visible(file.string());
    testkit_options_.may_idle = options_.may_idle;
    testkit_options_.doubts_idleness = true;
    testkit_options_.seed = options_.seed;
    testkit_options_.base = [this](testkit::Values& values) { given_.give(plugin_, values); };
    testkit_options_.underway = [this](const std::string& corner, const std::string& scene) {
      note_.write(corner + (corner.empty() || scene.empty() ? "" : "; ") + scene);
    };
    if (!object_.wrong.empty() || !is_plugin()) return;
    surveyed_ = std::move(plugin::survey(std::array{file_}).front());
    if (is_open()) given_ = GivenValues(options_.parameters, surveyed_, options_.plugins);
  }
  FileCheck(const FileCheck&) = delete;
  FileCheck& operator=(const FileCheck&) = delete;

  // --- What it has to be asked for. One that cannot be opened has told nothing.

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

  // A process of its own has to end, also for a debugger.
  void check_ending() {
    if (!is_wanted(options_.only, "ending")) return;
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
        if (check.name == "descriptor") continue;  // it is that of all its kinds
        apart(kind_and(kind, check.name), check.promise, [&]() -> Outcome {
          const testkit::Loaded own = loaded();
          if (!check.applies(own, testkit_options_)) return {Status::skip, {}};
          // They compare two instances, too.
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

  // An assigner that leaves a robot idle may mean it.
  Outcome judged(const testkit::Check& check, const testkit::Loaded& own) const {
    const testkit::Findings findings = check.run(own, testkit_options_);
    Outcome out = outcome_of(findings);
    if (check.name == "promises" && out.status == Status::warn) {
      out.lines.insert(out.lines.begin() + static_cast<std::ptrdiff_t>(findings.doubts().size()),
                       "if that is meant: --may-idle");
    }
    return out;
  }

  // A plugin that needs a file cannot be created without one.
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

  // What a whole course came to, as a line.
  Outcome digest(std::int32_t kind) const {
    return {Status::pass, {fmt::format("{:016x}", testkit::course_digest(kind, loaded(), testkit_options_))}};
  }

  void check_elsewhere(std::int32_t kind) {
    const std::string name = kind_and(kind, "elsewhere");
    if (!is_wanted(options_.only, name)) return;
    judge(name, "does the same in another process, folder and environment", [&]() -> Outcome {
      if (options_.in_process || hung_ || options_.elsewhere.empty()) return {Status::skip, {}};
      const auto without_digest = [](Outcome outcome) {
        if (outcome.lines.size() > 1 && outcome.status != Status::crash) outcome.lines.erase(outcome.lines.begin());
        return outcome;
      };
      const Outcome first = in_a_child([&] { return digest(kind); }, options_.deadline, note_);
      if (first.status != Status::pass) return without_digest(first);
      const Elsewhere same{file_, plugin_, kind, options_.seed, options_.visitors, options_.parameters};
      std::vector<std::string> words = options_.elsewhere;
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
    const std::string name = kind_and(kind, "alone");
    if (!is_wanted(options_.only, name)) return;
    judge(name, "answers each of a team's robots as if it were alone", [&]() -> Outcome {
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

  // Lines: what a team's robots were answered, or the only one of them.
  Outcome digests(std::int32_t kind, std::optional<std::size_t> only) const {
    Outcome out;
    const std::vector<std::uint64_t> all = testkit::team_digests(kind, loaded(), testkit_options_, only);
    for (std::size_t robot = 0; robot < all.size(); ++robot) {
      if (only.value_or(robot) == robot) out.lines.push_back(fmt::format("{:016x}", all[robot]));
    }
    return out;
  }

  // What is made once, at the first use, is no news.
  Outcome changes_own_memory(std::int32_t kind) const {
    const auto counts_its_lines = [](const std::string& name) { return name.starts_with("__gcov"); };
    if (std::ranges::any_of(object_.imports, counts_its_lines)) return {};
    const testkit::Loaded own = loaded();
    testkit::play_course(kind, own, testkit_options_, [](const std::string&) {});
    plugin::OwnMemory memory(reinterpret_cast<const void*>(own.descriptor().create));
    Outcome out;
    memory.remember();
    testkit::play_course(kind, own, testkit_options_, [&](const std::string& step) {
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

  // bars: it stands in the way of all others, so it is told whichever were asked for.
  void here(const std::string& name, const std::string& promise, const Outcome& outcome, bool bars = false) {
    if (bars || is_wanted(options_.only, name)) judge(name, promise, [&] { return outcome; });
  }
  void apart(const std::string& name, const std::string& promise, const std::function<Outcome()>& check) {
    if (!is_wanted(options_.only, name)) return;
    const auto alone = [&] {
      return leaving_the_process_alone([&] {
        Outcome out = without_exceptions(check);
        note_.write("after the last call");
        return out;
      });
    };
    judge(name, promise, [&]() -> Outcome {
      if (hung_) return {Status::skip, {"an earlier check had to be ended"}};  // nobody waits twice
      Outcome out = options_.in_process ? here_and_now(alone) : in_a_child(alone, options_.deadline, note_);
      hung_ = out.hung;
      return out;
    });
  }
  // What a child would end with is an outcome here, too.
  static Outcome here_and_now(const std::function<Outcome()>& check) {
    try {
      return check();
    } catch (const std::bad_alloc&) {
      return {Status::crash, {"took all the memory that there is"}};
    }
  }
  void judge(const std::string& name, const std::string& promise, const std::function<Outcome()>& check) {
    const auto began = Clock::now();
    Outcome outcome = check();
    const std::chrono::duration<double> seconds = Clock::now() - began;
    // A name of a file or what the loader says of it may be no text at all.
    for (std::string& line : outcome.lines) line = texts::visible(line);
    report_.verdicts.push_back({plugin_, name, promise, outcome.status, std::move(outcome.lines), seconds.count()});
    if (listener_.verdict) listener_.verdict(report_.file, report_.verdicts.back());
  }

  fs::path file_;
  Options options_;
  const Listener& listener_;
  ObjectFile object_;
  plugin::Surveyed surveyed_;
  GivenValues given_;
  testkit::Options testkit_options_;
  std::string plugin_;
  Underway& note_;
  bool hung_ = false;  // a check of this plugin
  Report report_;
};

// Refuses what was asked of files that can be opened, and that none of them has.
class Asked {
 public:
  Asked(const std::deque<FileCheck>& files, const Options& options) : files_(files), options_(options) {}

  void refuse_what_nobody_has() const {
    // Whatever is asked may be meant for a file that has told nothing of itself; that one fails.
    if (!std::ranges::all_of(files_, &FileCheck::is_open)) return;
    const std::string where = files_.size() == 1 ? files_.front().name() : "these files";
    refuse("plugin", where, options_.plugins, of_all(&FileCheck::plugins));
    std::vector<std::string> parameters;
    for (const auto& each : options_.parameters) parameters.push_back(each.first);
    refuse("parameter", (options_.plugins.empty() ? "the plugins of " : "the chosen plugins of ") + where, parameters,
           of_all(&FileCheck::parameters));
    const std::vector<std::string> checks = of_all(&FileCheck::checks);
    for (const std::string& each : options_.only) {
      const std::vector<std::string> alone{each};
      if (std::ranges::any_of(checks, [&](const std::string& check) { return is_wanted(alone, check); })) continue;
      throw config::BadInput(files_.size() == 1 ? fmt::format("--only {}: {} has no such check", each, where)
                                                : fmt::format("--only {}: none of these files has such a check", each));
    }
  }

 private:
  template <class Names>
  std::vector<std::string> of_all(Names names) const {
    std::vector<std::string> out;
    for (const FileCheck& file : files_) {
      for (const std::string& each : (file.*names)()) {
        if (std::ranges::find(out, each) == out.end()) out.push_back(each);
      }
    }
    return out;
  }
  static void refuse(std::string_view what, const std::string& where, const std::vector<std::string>& asked,
                     const std::vector<std::string>& known) {
    for (const std::string& each : asked) {
      if (std::ranges::find(known, each) == known.end())
        throw config::BadInput(texts::unknown(what, each, where, known));
    }
  }

  const std::deque<FileCheck>& files_;
  const Options& options_;
};

}  // namespace

std::vector<std::string> known_checks() {
  std::vector<std::string> out(file_checks.begin(), file_checks.end());
  out.emplace_back("descriptor");
  out.emplace_back("creation");
  const auto add = [&out](const std::string& name) {
    if (std::ranges::find(out, name) == out.end()) out.push_back(name);
  };
  for (const std::int32_t kind : kinds_checked) {
    add(std::string(plugin::kind_name(kind)));
    for (const std::string& check : checks_of(kind)) {
      add(check.substr(check.find('.') + 1));
      add(check);
    }
  }
  return out;
}

std::vector<Report> check_files(const std::vector<fs::path>& files, const Options& options, const Listener& listener) {
  const std::vector<std::string> known = known_checks();
  for (const std::string& each : options.only) {
    if (std::ranges::find(known, each) == known.end())
      throw config::BadInput(texts::unknown("check", each, "--only", known));
  }
  for (const fs::path& file : files) {
    std::error_code none;
    if (!fs::exists(file, none)) throw config::BadInput(fmt::format("{}: no such file", file.string()));
  }
  Underway note;
  std::deque<FileCheck> checks;  // they stay where they are
  for (const fs::path& file : files) checks.emplace_back(file, options, listener, note);
  Asked(checks, options).refuse_what_nobody_has();
  std::vector<Report> out;
  for (FileCheck& each : checks) {
    out.push_back(each.run());
    if (listener.report) listener.report(out.back());
  }
  return out;
}

}  // namespace regista::check
