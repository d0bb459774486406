// SPDX-License-Identifier: MIT
#include "study/document_check.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "campaign/forked_match.hpp"
#include "config/document_files.hpp"
#include "config/errors.hpp"
#include "config/overlay.hpp"
#include "mind/coordination/unused_parts.hpp"
#include "mind/mind.hpp"
#include "plugin/fatal_signal.hpp"
#include "study/experiment_plan.hpp"
#include "study/prediction/forecast.hpp"
#include "study/tournament_plan.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

// The findings of a copy of this process, in memory that both share. The arrays are longer than a document needs.
struct SceneFindings {
  std::array<char, 4096> idle{}, without_waypoints{};  // for each utility term: 1 (true) or 0
  std::array<mind::ContextFinding, 512> contexts{};
  mind::SetPlayContexts set_plays{};
  std::array<double, 512> guarded{};  // for each context, see mind::guarded_shares()
  std::array<mind::UnsendableSegment, 512> unsendable{};
  std::size_t unsendable_count = 0;
  int scenes = 0, without = 0;
  std::array<char, 512> failure{};  // reason, ends with a zero; empty: no failure
};

void tell(std::string_view what, SceneFindings& findings) {
  std::copy_n(what.data(), std::min(what.size(), findings.failure.size() - 1), findings.failure.data());
}

// Runs `work_on` in a copy of this process, because plugins may crash or never return. Returns a warning on failure.
std::vector<config::Warning> try_on_scenes(const mind::TeamPlan& plan, const char* what, SceneFindings& findings,
                                           const std::function<void(plugin::CallTracing)>& work_on) {
  findings.failure.fill('\0');
  const auto work = [&](campaign::WorkerNote& note) {
    const auto kept = campaign::keep_standard_output();
    try {
      work_on({.note = &note.call});
    } catch (const plugin::Failure& failure) {
      tell(failure.what(), findings);
    }
    return EXIT_SUCCESS;
  };
  const auto lost = [&](const campaign::ChildDeath& loss) {
    const plugin::CallNote& call = loss.note.call;
    const bool known = call.plugin.front() != '\0';
    tell(known ? fmt::format("{}, in {} of plugin {}", loss.what, call.call.data(), call.plugin.data()) : loss.what,
         findings);
    return EXIT_SUCCESS;
  };
  const auto interrupted = [](int signal_number, bool) {
    std::signal(signal_number, SIG_DFL);
    return std::raise(signal_number);
  };
  campaign::run_supervised({}, {work, lost, interrupted});
  if (findings.failure.front() == '\0') return {};
  return {{plan.team().where,
           fmt::format("{} could not be tried on scenes: {}", what, std::string_view(findings.failure.data()))}};
}

std::vector<config::Warning> check_contexts(const mind::TeamPlan& plan, SceneFindings& findings) {
  const std::size_t count = plan.contexts().size();
  if (count == 0 || count > findings.contexts.size()) return {};
  const auto failed = try_on_scenes(plan, "contexts:", findings, [&](plugin::CallTracing tracing) {
    const mind::ContextFindings found = mind::idle_contexts(plan, tracing);
    std::ranges::copy(found.contexts, findings.contexts.begin());
    findings.scenes = found.scenes;
    findings.without = found.without;
    findings.set_plays = found.set_plays;
  });
  if (!failed.empty()) return failed;
  const auto begin = findings.contexts.begin();
  return mind::idle_context_warnings(
      plan,
      {findings.scenes, findings.without, {begin, begin + static_cast<std::ptrdiff_t>(count)}, findings.set_plays});
}

std::vector<config::Warning> check_terms(const mind::TeamPlan& plan, SceneFindings& findings) {
  std::size_t terms = 0;
  for (const mind::ContextPlan& context : plan.contexts()) terms += context.terms.size();
  if (terms == 0 || terms > findings.idle.size()) return {};
  const auto failed = try_on_scenes(plan, "utility: its terms", findings, [&](plugin::CallTracing tracing) {
    std::ranges::copy(mind::idle_terms(plan, tracing), findings.idle.begin());
    std::ranges::copy(mind::terms_without_waypoints(plan, tracing), findings.without_waypoints.begin());
  });
  if (!failed.empty()) return failed;
  const auto bits = [terms](const auto& from) { return std::vector<bool>(from.begin(), from.begin() + terms); };
  return mind::idle_term_warnings(plan, bits(findings.idle), bits(findings.without_waypoints));
}

std::vector<config::Warning> check_waypoints(const mind::TeamPlan& plan, SceneFindings& findings) {
  const std::size_t count = plan.contexts().size();
  if (count > findings.guarded.size()) return {};
  const auto failed = try_on_scenes(plan, "positioner: its waypoints", findings, [&](plugin::CallTracing tracing) {
    std::ranges::copy(mind::guarded_shares(plan, tracing), findings.guarded.begin());
  });
  if (!failed.empty()) return failed;
  const auto begin = findings.guarded.begin();
  return mind::guard_warnings(plan, {begin, begin + static_cast<std::ptrdiff_t>(count)});
}

std::vector<config::Warning> check_segments(const mind::TeamPlan& plan, SceneFindings& findings) {
  if (std::ranges::none_of(plan.parts(), [](const mind::Part* part) { return mind::talks(*part); })) return {};
  const auto failed = try_on_scenes(plan, "the whole team", findings, [&](plugin::CallTracing tracing) {
    const std::vector<mind::UnsendableSegment> found = mind::unsendable_segments(plan, tracing);
    findings.unsendable_count = std::min(found.size(), findings.unsendable.size());
    std::copy_n(found.begin(), findings.unsendable_count, findings.unsendable.begin());
  });
  if (!failed.empty()) return failed;
  return mind::unsendable_segment_warnings(
      plan, {findings.unsendable.begin(),
             findings.unsendable.begin() + static_cast<std::ptrdiff_t>(findings.unsendable_count)});
}

// Tries a team's plugins on generated scenes. Returns warnings of contexts that may never be in force, terms of the
// utility that change nothing, and segments that fit in no packet. The calling process must have no threads and no
// other children, see campaign/forked_match.hpp.
std::vector<config::Warning> scenes_check(const mind::TeamPlan& plan) {
  void* const memory =
      ::mmap(nullptr, sizeof(SceneFindings), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "cannot share memory");
  struct Unmap {
    void operator()(SceneFindings* findings) const { ::munmap(findings, sizeof(SceneFindings)); }
  };
  const std::unique_ptr<SceneFindings, Unmap> findings(new (memory) SceneFindings);
  std::vector<config::Warning> out = check_contexts(plan, *findings);
  std::ranges::move(check_terms(plan, *findings), std::back_inserter(out));
  std::ranges::move(check_waypoints(plan, *findings), std::back_inserter(out));
  std::ranges::move(check_segments(plan, *findings), std::back_inserter(out));
  return out;
}

// The remark in the head of an unfinished document: "# Sketch: what is not right yet".
std::optional<config::Warning> sketch_remark(const std::string& typed) {
  const std::string file = config::own_or_shipped(typed).string();
  if (!std::filesystem::is_regular_file(file)) return std::nullopt;  // a pipe can be read only once
  std::istringstream head(config::file_content(file).value_or(""));
  constexpr std::string_view mark = "# Sketch: ";
  std::string line;
  for (int number = 1; std::getline(head, line) && line.starts_with('#'); ++number) {
    if (line.starts_with(mark))
      return config::Warning{{file, number, 1}, "a sketch: " + texts::one_line(line.substr(mark.size()))};
  }
  return std::nullopt;
}

void check_team(const config::Node& document, const Profiles& by, const plugin::Catalogue& catalogue,
                std::vector<config::Warning>& warnings, config::Mistakes& mistakes) {
  const config::Team team = config::read_document<config::Team>(document, mistakes);
  config::check(team, by.rules, document, mistakes);
  const mind::TeamPlan plan(team, by.rules, by.robots[0], catalogue, mistakes);  // adds mistakes about the plugins
  if (!mistakes.none()) return;
  const mind::Mind first(plan, 1, 0);  // throws if a plugin refuses to start, e.g. if its file is missing
  std::ranges::move(config::warnings(team, by.rules, document), std::back_inserter(warnings));
  std::ranges::move(scenes_check(plan), std::back_inserter(warnings));
}

void check(const config::Node& written, const Profiles& by, const plugin::Catalogue& catalogue,
           std::span<const StudyCheck> studies, DocumentCheck& out, config::Mistakes& mistakes) {
  using config::DocumentKind;
  config::Node document = written;
  if (written[DocumentKind::tournament.name] && !written["pairs"] && until_the_clock(written)["pairs"]) {
    document = until_the_clock(written);
    out.warnings.push_back(
        {written.where(), "pairs: no number of them; regista run plays it with --until or --minutes"});
  }
  const auto study = std::ranges::find_if(
      studies, [&](const StudyCheck& each) { return static_cast<bool>(document[each.document.name]); });
  const DocumentKind& kind = study != studies.end() ? study->document : config::kind_of(document);
  out.kind = kind.name;
  if (kind == DocumentKind::team) return check_team(document, by, catalogue, out.warnings, mistakes);
  kind.with_values(document, mistakes, [](const config::Map&) {});
  if (kind == DocumentKind::opening)
    config::check(config::read_document<config::Opening>(document, mistakes), by.rules, by.robots, document, mistakes);
  if (!mistakes.none()) return;
  // The document itself is valid. The next checks show whether the program can plan it.
  if (kind == DocumentKind::predictor_study)
    const Forecaster forecaster(config::read_document<config::PredictorStudy>(document), catalogue);
  if (study != studies.end()) study->check(document, mistakes);
}

}  // namespace

DocumentCheck check_document(const std::string& file, const Profiles& played_by, const plugin::Catalogue& catalogue,
                             std::span<const StudyCheck> studies) {
  DocumentCheck out;
  out.file = file;
  if (const auto remark = sketch_remark(file)) out.warnings.push_back(*remark);
  config::Mistakes mistakes(config::Mistakes::After::go_on);
  std::vector<DocumentMistake> others;
  try {
    mistakes.attempt("", [&] { check(config::load(file), played_by, catalogue, studies, out, mistakes); });
  } catch (const config::BadInput& error) {
    others.push_back({{file}, error.what(), error.what()});
  } catch (const plugin::Failure& failure) {
    const config::Location where = failure.where().file.empty() ? config::Location{file} : failure.where();
    others.push_back({where, failure.what(), fmt::format("{}: {}", config::to_string(where), failure.what())});
  }
  for (const config::Error& each : mistakes.in_order(file))
    out.mistakes.push_back({each.where(), each.message(), each.what()});
  out.more = mistakes.total() - out.mistakes.size();
  std::ranges::move(others, std::back_inserter(out.mistakes));
  return out;
}

}  // namespace regista::study
