// SPDX-License-Identifier: MIT
#include "campaign/job.hpp"
#include "campaign/match_encoding.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace regista::campaign {
namespace {

Job some_job() {
  Job job;
  job.teams = {"a \"team\".yaml", "b\n.yaml"};
  job.rules = "rules.yaml";
  job.overrides = {"home.utility.terms.near.weight=0.5", "rules.durations.ready=3"};
  job.plugins = {"old", "new"};
  job.opening = "corner kick.yaml";
  job.limit = "12.5";
  job.seed = UINT64_MAX;
  job.home_inputs = {{"team a", "1"}};
  job.away_inputs = {{"team b", "2"}, {"plugin greedy (x.so)", "greedy 3"}};
  job.common_inputs = {{"program", "4"}};
  return job;
}

TEST(Job, SurvivesTheWayToAWorker) {
  const std::string line = to_json(some_job());
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(job_from_json(line), some_job());
  using enum plugin::Inspection;
  for (const plugin::Inspection each : {seldom, answers, often, always}) {
    Job job = some_job();
    job.look = each;
    EXPECT_EQ(job_from_json(to_json(job)).look, each);
  }
}

TEST(Job, IsACommandLineOfMatch) {
  const std::vector<std::string> expected{"match",
                                          "a \"team\".yaml",
                                          "b\n.yaml",
                                          "--seed",
                                          "18446744073709551615",
                                          "--opening",
                                          "corner kick.yaml",
                                          "--limit",
                                          "12.5",
                                          "--rules",
                                          "rules.yaml",
                                          "--set",
                                          "home.utility.terms.near.weight=0.5",
                                          "--set",
                                          "rules.durations.ready=3",
                                          "--plugins",
                                          "old",
                                          "--plugins",
                                          "new"};
  EXPECT_EQ(match_arguments(some_job()), expected);
}

TEST(Job, WithoutOptionsIsAShortCommandLine) {
  Job job;
  job.teams = {"a.yaml", "b.yaml"};
  EXPECT_EQ(match_arguments(job), (std::vector<std::string>{"match", "a.yaml", "b.yaml", "--seed", "1"}));
}

TEST(Failure, SurvivesTheWayToAFile) {
  const Failure failure{1, "greedy", "assign", 3, UINT64_MAX, "column 2\ngiven to \"rows\" 0 and 4"};
  EXPECT_EQ(failure_from_json(to_json(failure)), failure);
  EXPECT_THROW(failure_from_json(""), std::invalid_argument);
  EXPECT_THROW(failure_from_json("{}"), std::invalid_argument);
  std::string third = to_json(failure);
  third.replace(third.find("\"side\":1"), 8, "\"side\":2");
  EXPECT_THROW(failure_from_json(third), std::invalid_argument);
}

TEST(Inputs, SurviveTheWayToAFile) {
  const std::vector<Input> inputs{{"team a", "1"}, {"plugin \"b\" (x.so)", ""}};
  EXPECT_EQ(inputs_from_json(to_json(inputs)), inputs);
  EXPECT_EQ(inputs_from_json("[]"), std::vector<Input>{});
  for (const char* damaged : {"", "[[\"name\"]]", "[[1,2]]", "[{}]"}) {
    EXPECT_THROW(inputs_from_json(damaged), std::invalid_argument) << damaged;
  }
}

TEST(Forfeit, IsLostByTheSideThatFailed) {
  const MatchResult home = forfeit({0, "greedy", "assign", 3, 4, "fell"}, 1.5);
  const MatchResult away = forfeit({1, "greedy", "assign", 3, 4, "fell"}, 1.5);
  EXPECT_EQ(home.score, (std::array{0, 10}));
  EXPECT_EQ(away.score, (std::array{10, 0}));
  EXPECT_EQ(home.ended, "forfeit");
  EXPECT_TRUE(home.metrics.empty());
  EXPECT_EQ(home.hash, "");
  EXPECT_EQ(home.seconds, 1.5);
}

TEST(Answer, SurvivesTheWayBack) {
  Answer played;
  played.kind = Answer::Kind::played;
  played.decided = {{3, 1},       "full_time",
                    "9f2c",       metrics_from_json(R"({"packets":[3,null],"roles":[{"a":{"x":1}},{}]})"),
                    std::nullopt, 1.25};
  const Answer back = answer_from_json(to_json(played));
  EXPECT_EQ(back.kind, Answer::Kind::played);
  EXPECT_EQ(back.decided, played.decided);

  Answer failed;
  failed.kind = Answer::Kind::failed;
  failed.decided.failure = Failure{1, "greedy", "assign", 3, UINT64_MAX, "column 2 given to rows 0 and 4"};
  EXPECT_EQ(answer_from_json(to_json(failed)).decided.failure, failed.decided.failure);
}

TEST(Answer, TextThatIsNoUtf8IsStillAnAnswer) {
  Answer stopped;
  stopped.message = "\xff\xfe";
  EXPECT_EQ(answer_from_json(to_json(stopped)).message, "\xef\xbf\xbd\xef\xbf\xbd");
}

TEST(Answer, RefusesWhatItDidNotWrite) {
  EXPECT_THROW(answer_from_json(""), std::invalid_argument);
  EXPECT_THROW(answer_from_json("{}"), std::invalid_argument);
  std::string cut = to_json(Answer{});
  cut.pop_back();
  EXPECT_THROW(answer_from_json(cut), std::invalid_argument);
  std::string other = to_json(Answer{});
  other.replace(other.find("stopped"), 7, "dreamed");
  EXPECT_THROW(answer_from_json(other), std::invalid_argument);
  other = to_json(Answer{});
  other.replace(other.find("stopped"), 7, "failed");
  EXPECT_THROW(answer_from_json(other), std::invalid_argument);
  EXPECT_THROW(job_from_json("[]"), std::invalid_argument);
}

}  // namespace
}  // namespace regista::campaign
