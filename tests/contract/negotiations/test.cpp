// SPDX-License-Identifier: MIT
// A sound negotiation keeps the whole contract and passes the rehearsal at every loss; one with a mistake fails it, in
// words that lead to the mistake.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <regista/testkit/checks.hpp>
#include <regista/testkit/contract.hpp>
#include <regista/testkit/kind_checks.hpp>
#include <regista/testkit/rehearsal.hpp>
#include <regista/testkit/sanitized.hpp>

namespace {

// A rehearsal takes a second, and 15 with sanitizers: there one that passes and one that fails are enough.
#define NOT_WITH_SANITIZERS \
  if (sanitized) GTEST_SKIP() << "takes too long with sanitizers"

using namespace regista::testkit;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "consensus_auction");

Findings rehearsal_of(const char* id, std::uint64_t seed = 0) {
  Options options;
  options.seed = seed;
  return check_rehearsal(Loaded(REGISTA_PLUGIN_FILE, id), options);
}

TEST(Rehearsal, ASoundNegotiationPassesAtEveryLossWithAnySeed) {
  for (const std::uint64_t seed : {0u, 1u}) {
    if (sanitized && seed > 0) break;
    const Findings findings = rehearsal_of("consensus_auction", seed);
    EXPECT_TRUE(findings.empty()) << "seed " << seed << '\n' << findings.text();
    EXPECT_THAT(findings.remarks(),
                testing::ElementsAre(HasSubstr("0 % of the packets lost: they agree after"),
                                     HasSubstr("30 % of the packets lost"), HasSubstr("60 % of the packets lost")));
  }
}

TEST(Rehearsal, WhatWasToldAndWhatIsLeftCanBeCountedOn) {
  NOT_WITH_SANITIZERS;
  const Findings findings = rehearsal_of("asks_what_was_told");
  EXPECT_TRUE(findings.empty()) << findings.text();
}

TEST(Rehearsal, NamingTasksByTheirColumnFailsWhereARobotKnowsFewerTasks) {
  NOT_WITH_SANITIZERS;
  for (const char* id : {"names_columns", "counts_columns"}) {
    const Findings findings = rehearsal_of(id);
    EXPECT_THAT(findings.lines(), Contains(AllOf(HasSubstr("0 % of the packets lost, 3 robots"),
                                                 HasSubstr("robot 2 does not know one of the tasks"))));
    EXPECT_THAT(findings.lines(), testing::Not(Contains(HasSubstr("they begin")))) << id;
  }
}

TEST(Rehearsal, AContestedWinnerThatFallsSilentFails) {
  EXPECT_THAT(rehearsal_of("falls_silent").lines(),
              Contains(AllOf(HasSubstr("robots 2 and 3 both do"),
                             HasSubstr("(0 % of the packets lost, 3 robots; they begin)"))));
}

TEST(Rehearsal, SayingAClaimOnceFailsOnlyWherePacketsAreLost) {
  NOT_WITH_SANITIZERS;
  const Findings findings = rehearsal_of("speaks_once");
  EXPECT_THAT(findings.lines(), Contains(HasSubstr("30 % of the packets lost")));
  EXPECT_THAT(findings.lines(), testing::Not(Contains(HasSubstr("(0 % of the packets lost"))));
}

TEST(Rehearsal, CountingOnWhoHasLeftFailsWhenSomebodyLeaves) {
  NOT_WITH_SANITIZERS;
  EXPECT_THAT(rehearsal_of("keeps_the_absent").lines(),
              Contains(AllOf(HasSubstr("has no task, and nobody does"), HasSubstr("is penalised (robot"))));
}

TEST(Rehearsal, WaitingForEachOtherFailsThoughRobotsMayIdle) {
  NOT_WITH_SANITIZERS;
  const Findings findings =
      check_rehearsal(Loaded(REGISTA_PLUGIN_FILE, "never_begins"), {.base = [](Values&) {}, .may_idle = true});
  EXPECT_THAT(findings.lines(),
              Contains(HasSubstr("nobody has a task (0 % of the packets lost, 3 robots; they begin")));
}

TEST(Rehearsal, SayingNothingFailsWhoeverClaimsToNegotiate) {
  NOT_WITH_SANITIZERS;
  EXPECT_THAT(rehearsal_of("judges_alone").lines(), Contains(HasSubstr("no agreement within 20.0 s")));
}

TEST(Rehearsal, NegotiatingWithoutAMailboxIsRehearsedAndNamed) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "negotiates_without_mailbox");
  const std::vector<Check> checks = contract(REGISTA_KIND_ASSIGNER);
  const auto rehearsal = std::ranges::find(checks, "rehearsal", &Check::name);
  ASSERT_NE(rehearsal, checks.end());
  EXPECT_TRUE(rehearsal->applies(plugin, {}));
  EXPECT_THAT(check_descriptor(plugin).lines(),
              testing::ElementsAre("assigner: says that it negotiates, but receives nothing: it has no mailbox"));
  NOT_WITH_SANITIZERS;
  EXPECT_THAT(rehearsal->run(plugin, {}).lines(),
              Contains(AllOf(HasSubstr("no agreement within 20.0 s: robots"), HasSubstr("both do"))));
}

TEST(Rehearsal, TheSameSeedGivesTheSameRehearsalAndAnotherAnother) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "consensus_auction");
  const auto times = [&](std::uint64_t seed) {
    std::vector<double> out;
    const Rehearsal rehearsal = rehearse(plugin, Values(plugin), {.robots = 7, .radio = {.loss = 0.3}, .seed = seed});
    for (const Act& act : rehearsal.acts) out.push_back(act.settled_after.value_or(-1.0));
    out.push_back(static_cast<double>(rehearsal.bytes));
    return out;
  };
  EXPECT_EQ(times(1), times(1));
  EXPECT_NE(times(1), times(2));
}

TEST(Rehearsal, TakesTeamsOfThreeToEleven) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "consensus_auction");
  for (const int robots : {3, 5, 11}) {
    for (const Act& act : rehearse(plugin, Values(plugin), {.robots = robots}).acts) {
      EXPECT_TRUE(act.settled_after) << robots << " robots, " << act.name << ": " << act.disagreement;
    }
  }
  for (const int robots : {2, 12}) EXPECT_THROW(rehearse(plugin, Values(plugin), {.robots = robots}), std::logic_error);
}

}  // namespace
