// SPDX-License-Identifier: MIT
#include "study/idle_terms_check.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>

#include "campaign/supervised.hpp"
#include "mind/coordination/idle_terms.hpp"
#include "plugin/failure.hpp"

namespace regista::study {
namespace {

// What the copy has found, in memory that both processes see.
struct Findings {
  std::array<char, 4096> idle{};    // 1 for each term that is idle; the list of a page is far shorter
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

}  // namespace

std::vector<config::Warning> idle_terms_check(const mind::TeamPlan& plan) {
  std::size_t terms = 0;
  for (const mind::ContextPlan& context : plan.contexts()) terms += context.terms.size();
  const auto findings = shared_findings();
  if (terms == 0 || terms > findings->idle.size()) return {};
  const auto work = [&](campaign::WorkerNote& note) {
    const campaign::StandardOutputKept kept;
    try {
      std::ranges::copy(mind::idle_terms(plan, {.note = &note.call}), findings->idle.begin());
    } catch (const plugin::Failure& failure) {
      tell(failure.what(), *findings);
    }
    return EXIT_SUCCESS;
  };
  const auto lost = [&](const campaign::Loss& loss) {
    const plugin::CallNote& call = loss.note.call;
    const bool known = call.plugin.front() != '\0';
    tell(known ? fmt::format("{}, in {} of plugin {}", loss.what, call.call.data(), call.plugin.data()) : loss.what,
         *findings);
    return EXIT_SUCCESS;
  };
  const auto interrupted = [](int signal_number, bool) {
    std::signal(signal_number, SIG_DFL);
    return std::raise(signal_number);
  };
  campaign::run_supervised({}, {work, lost, interrupted});
  if (findings->failure.front() != '\0') {
    return {{plan.team().where, fmt::format("utility: its terms could not be tried on scenes: {}",
                                            std::string_view(findings->failure.data()))}};
  }
  std::vector<bool> idle;
  for (std::size_t i = 0; i < terms; ++i) idle.push_back(findings->idle[i] != 0);
  return mind::idle_term_warnings(plan, idle);
}

}  // namespace regista::study
