// SPDX-License-Identifier: MIT
#include "check/plugin_check.hpp"

#include <alloca.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <map>
#include <span>
#include <string_view>
#include <system_error>

#include <regista/testkit/check_life.hpp>
#include <regista/testkit/checks.hpp>
#include <regista/testkit/cost.hpp>

#include "check/allocations.hpp"
#include "check/file_checks.hpp"
#include "check/given_values.hpp"
#include "check/object_file.hpp"
#include "check/process_watch.hpp"
#include "config/bad_input.hpp"
#include "config/text.hpp"
#include "config/visible_text.hpp"
#include "plugin/descriptor.hpp"
#include "plugin/survey.hpp"

namespace regista::check {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::array file_checks{"object", "exports", "relocations", "imports", "open", "hand_shake", "ending"};
constexpr std::array<std::int32_t, 7> kinds_checked{
    REGISTA_KIND_PREDICTOR, REGISTA_KIND_CONTEXT, REGISTA_KIND_POSITIONER, REGISTA_KIND_UTILITY,
    REGISTA_KIND_ASSIGNER,  REGISTA_KIND_SENDER,  REGISTA_KIND_BEHAVIOUR};

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
    for (const std::string& line : lines) out.lines.push_back(config::one_line(line));
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

// As in another process of another user: addresses, folder, environment, and what others have drawn from rand().
void go_elsewhere() {
  static const std::vector<char> padding(300'007);
  std::error_code none;
  fs::current_path("/", none);
  ::setenv("REGISTA_CHECK_ELSEWHERE", "1", 1);
  for (int i = 0; i < 17; ++i) std::rand();
  errno = ENOENT;
}

class FileCheck {
 public:
  FileCheck(const fs::path& file, const Options& options, const std::function<void(const Verdict&)>& told)
      : file_(fs::absolute(file)), options_(options), told_(told) {
    report_.file = config::visible(file.string());
    testkit_options_.may_idle = options_.may_idle;
    testkit_options_.doubts_idleness = true;
    testkit_options_.seed = options_.seed;
    testkit_options_.base = [this](testkit::Values& values) { given_.give(plugin_, values); };
    testkit_options_.underway = [this](const std::string& corner, const std::string& scene) {
      note_.write(corner + (corner.empty() || scene.empty() ? "" : "; ") + scene);
    };
  }

  Report run() {
    const ObjectFile object = read_object(file_);
    const bool is_plugin = std::ranges::binary_search(object.exports, REGISTA_ENTRY_NAME);
    plugin::Surveyed surveyed;
    if (object.wrong.empty() && is_plugin) {
      surveyed = std::move(plugin::survey(std::array{file_}).front());
      if (surveyed.refusal.empty()) refuse_bad_input(surveyed);  // before anything is told
    }
    here("object", "is a shared object of this machine", [&] {
      return object.wrong.empty() ? Outcome{} : Outcome{Status::fail, {object.wrong}};
    });
    if (!object.wrong.empty()) return std::move(report_);
    here("exports", "exports the entry point and nothing else", [&] { return exports_of(object); });
    if (!is_plugin) return std::move(report_);
    here("relocations", "its code can be shared between processes", [&] { return relocations_of(object); });
    here("imports", "calls nothing that sound plugins do not need", [&] { return imports_of(object); });
    here("open", "can be opened, and declares plugins of this interface", [&]() -> Outcome {
      if (!surveyed.refusal.empty()) return {Status::fail, {surveyed.refusal}};
      if (!surveyed.remark.empty()) return {Status::warn, {surveyed.remark}};
      return {};
    });
    if (!surveyed.refusal.empty()) return std::move(report_);
    const auto count = static_cast<std::uint32_t>(surveyed.plugins.size());
    apart("hand_shake", "gives every host the same answers", [&] { return shake_hands(file_, count); });
    apart("ending", "lets a process end that has opened it", [&] { return end_after_opening(file_); });
    for (const auto& each : surveyed.plugins) {
      if (is_named(options_.plugins, each->declared().id)) check_plugin(*each);
    }
    return std::move(report_);
  }

 private:
  static bool is_named(const std::vector<std::string>& names, std::string_view id) {
    return names.empty() || std::ranges::find(names, id) != names.end();
  }
  // Of what was asked, what this file does not have.
  void refuse_bad_input(const plugin::Surveyed& surveyed) {
    std::vector<std::string> known;
    for (const auto& each : surveyed.plugins) known.emplace_back(each->declared().id);
    for (const std::string& each : options_.plugins) {
      if (!is_named(known, each)) throw config::BadInput(config::unknown("plugin", each, report_.file, known));
    }
    given_ = GivenValues(options_.parameters, surveyed, report_.file);
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
      if (options_.in_process || hung_) return {Status::skip, {}};
      const auto without_digest = [](Outcome outcome) {
        if (outcome.lines.size() > 1 && outcome.status != Status::crash) outcome.lines.erase(outcome.lines.begin());
        return outcome;
      };
      const Outcome first = in_a_child([&] { return digest(kind); }, options_.deadline, note_);
      if (first.status != Status::pass) return without_digest(first);
      const Outcome second = in_a_child(
          [&] {
            go_elsewhere();
            auto* const deeper = static_cast<volatile char*>(::alloca(70'003));  // the stack is elsewhere, too
            deeper[0] = 1;
            digest(kind);  // and something was played before
            return digest(kind);
          },
          options_.deadline, note_);
      if (second.status != Status::pass) return without_digest(second);
      if (first.lines == second.lines) return {};
      return {Status::fail,
              {"the same calls give another result in another process: it depends on addresses, the folder, the "
               "environment, or on what others do"}};
    });
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

  void here(const std::string& name, const std::string& promise, const std::function<Outcome()>& check) {
    if (is_wanted(options_.only, name)) judge(name, promise, check);
  }
  void apart(const std::string& name, const std::string& promise, const std::function<Outcome()>& check) {
    if (!is_wanted(options_.only, name)) return;
    const auto alone = [&] {
      return leaving_the_process_alone([&] {
        Outcome out = check();
        note_.write("after the last call");
        return out;
      });
    };
    judge(name, promise, [&]() -> Outcome {
      if (hung_) return {Status::skip, {"an earlier check had to be ended"}};  // nobody waits twice
      Outcome out = options_.in_process ? alone() : in_a_child(alone, options_.deadline, note_);
      hung_ = out.hung;
      return out;
    });
  }
  void judge(const std::string& name, const std::string& promise, const std::function<Outcome()>& check) {
    const auto began = Clock::now();
    Outcome outcome = check();
    const std::chrono::duration<double> seconds = Clock::now() - began;
    // A name of a file or what the loader says of it may be no text at all.
    for (std::string& line : outcome.lines) line = config::visible(line);
    report_.verdicts.push_back({plugin_, name, promise, outcome.status, std::move(outcome.lines), seconds.count()});
    if (told_) told_(report_.verdicts.back());
  }

  fs::path file_;
  Options options_;
  const std::function<void(const Verdict&)>& told_;
  GivenValues given_;
  testkit::Options testkit_options_;
  std::string plugin_;
  SharedNote note_;
  bool hung_ = false;  // a check of this plugin
  Report report_;
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
    std::vector<std::string> checks;
    for (const testkit::Check& check : testkit::contract(kind)) checks.push_back(check.name);
    checks.insert(checks.end(), {"elsewhere", "cost"});
    for (const std::string& check : checks) {
      if (check == "descriptor") continue;
      add(check);
      add(kind_and(kind, check));
    }
  }
  return out;
}

Report check_file(const std::filesystem::path& file, const Options& options,
                  const std::function<void(const Verdict&)>& told) {
  const std::vector<std::string> known = known_checks();
  for (const std::string& each : options.only) {
    if (std::ranges::find(known, each) == known.end())
      throw config::BadInput(config::unknown("check", each, "--only", known));
  }
  std::error_code none;
  if (!fs::exists(file, none)) throw config::BadInput(fmt::format("{}: no such file", file.string()));
  return FileCheck(file, options, told).run();
}

}  // namespace regista::check
