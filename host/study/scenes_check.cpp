// SPDX-License-Identifier: MIT
#include "study/scenes_check.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <memory>
#include <string_view>
#include <system_error>

#include "campaign/supervised.hpp"
#include "mind/coordination/idle_contexts.hpp"
#include "mind/coordination/idle_terms.hpp"
#include "mind/coordination/made_up.hpp"
#include "mind/unsendable_segments.hpp"
#include "plugin/failure.hpp"

namespace regista::study {
namespace {

// What the copy has found, in memory that both processes see. Lists of a page are far shorter.
struct Findings {
  std::array<char, 4096> idle{}, without_waypoints{};  // 1 for each term of which it is true
  std::array<mind::ContextFinding, 512> contexts{};
  std::array<mind::UnsendableSegment, 512> unsendable{};
  std::size_t unsendable_count = 0;
  int scenes = 0, without = 0;
  std::array<char, 512> failure{};  // ends with a zero; empty: none
};

void unmap(Findings* findings) { ::munmap(findings, sizeof(Findings)); }

std::unique_ptr<Findings, void (*)(Findings*)> shared_findings() {
  void* const memory = ::mmap(nullptr, sizeof(Findings), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "cannot share memory");
  return {new (memory) Findings, unmap};
}

void tell(std::string_view what, Findings& findings) {
  std::copy_n(what.data(), std::min(what.size(), findings.failure.size() - 1), findings.failure.data());
}

// Does the work in a copy of this process; what went wrong is told.
void try_on_scenes(Findings& findings, const std::function<void(plugin::Noting)>& work_on) {
  findings.failure.fill('\0');
  const auto work = [&](campaign::WorkerNote& note) {
    const campaign::StandardOutputKept kept;
    try {
      work_on({.note = &note.call});
    } catch (const plugin::Failure& failure) {
      tell(failure.what(), findings);
    }
    return EXIT_SUCCESS;
  };
  const auto lost = [&](const campaign::Loss& loss) {
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
}

std::vector<config::Warning> failed(const mind::TeamPlan& plan, const char* what, const Findings& findings) {
  return {{plan.team().where,
           fmt::format("{} could not be tried on scenes: {}", what, std::string_view(findings.failure.data()))}};
}

std::vector<config::Warning> check_contexts(const mind::TeamPlan& plan, Findings& findings) {
  const std::size_t count = plan.contexts().size();
  if (count == 0 || count > findings.contexts.size()) return {};
  try_on_scenes(findings, [&](plugin::Noting noting) {
    const mind::ContextFindings found = mind::idle_contexts(plan, noting);
    std::ranges::copy(found.contexts, findings.contexts.begin());
    findings.scenes = found.scenes;
    findings.without = found.without;
  });
  if (findings.failure.front() != '\0') return failed(plan, "contexts:", findings);
  const auto begin = findings.contexts.begin();
  return mind::idle_context_warnings(
      plan, {findings.scenes, findings.without, {begin, begin + static_cast<std::ptrdiff_t>(count)}});
}

std::vector<config::Warning> check_terms(const mind::TeamPlan& plan, Findings& findings) {
  std::size_t terms = 0;
  for (const mind::ContextPlan& context : plan.contexts()) terms += context.terms.size();
  if (terms == 0 || terms > findings.idle.size()) return {};
  try_on_scenes(findings, [&](plugin::Noting noting) {
    std::ranges::copy(mind::idle_terms(plan, noting), findings.idle.begin());
    std::ranges::copy(mind::terms_without_waypoints(plan, noting), findings.without_waypoints.begin());
  });
  if (findings.failure.front() != '\0') return failed(plan, "utility: its terms", findings);
  const auto bits = [terms](const std::array<char, 4096>& from) {
    std::vector<bool> out;
    for (std::size_t i = 0; i < terms; ++i) out.push_back(from[i] != 0);
    return out;
  };
  return mind::idle_term_warnings(plan, bits(findings.idle), bits(findings.without_waypoints));
}

std::vector<config::Warning> check_segments(const mind::TeamPlan& plan, Findings& findings) {
  if (std::ranges::none_of(plan.parts(), [](const mind::Part* part) { return mind::talks(*part); })) return {};
  try_on_scenes(findings, [&](plugin::Noting noting) {
    const std::vector<mind::UnsendableSegment> found = mind::unsendable_segments(plan, noting);
    findings.unsendable_count = std::min(found.size(), findings.unsendable.size());
    std::copy_n(found.begin(), findings.unsendable_count, findings.unsendable.begin());
  });
  if (findings.failure.front() != '\0') return failed(plan, "the whole team", findings);
  return mind::unsendable_segment_warnings(
      plan, {findings.unsendable.begin(),
             findings.unsendable.begin() + static_cast<std::ptrdiff_t>(findings.unsendable_count)});
}

}  // namespace

std::vector<config::Warning> scenes_check(const mind::TeamPlan& plan) {
  const auto findings = shared_findings();
  std::vector<config::Warning> out = check_contexts(plan, *findings);
  std::ranges::move(check_terms(plan, *findings), std::back_inserter(out));
  std::ranges::move(check_segments(plan, *findings), std::back_inserter(out));
  return out;
}

}  // namespace regista::study
