// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "config/documents.hpp"
#include "config/node.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

Node text(std::string_view yaml) { return parse_text(yaml, "t.yaml"); }

TEST(Show, SaysUnitMeaningAndOrigin) {
  EXPECT_EQ(show(override_with(text("disturbance: d\nradio:\n  delay: 1.50\n"), {"camera.ball_blindness=0.25"})),
            "disturbance: d                                # name of this disturbance; t.yaml:1:14\n"
            "radio:                                        # of all robots, all the time\n"
            "  loss: 0                                     # probability per packet and receiver; default\n"
            "  delay: 1.5                                  # s, of every packet; t.yaml:3:10\n"
            "  jitter: 0                                   # s, width of a uniform law on top of the delay; default\n"
            "  burst:                                      # loss in bursts, of each receiver by itself\n"
            "    mean_good: 10                             # s, mean time between two bursts; default\n"
            "    mean_bad: 1                               # s, mean length of a burst; default\n"
            "    loss: 0                                   # probability per packet and receiver within a burst; 0 is "
            "off; default\n"
            "  silence: false                              # no packet reaches anybody; default\n"
            "camera:                                       # of all robots, all the time\n"
            "  ball_blindness: 0.25                        # probability that a sighting of the ball is lost; --set "
            "camera.ball_blindness=0.25\n"
            "  ghost_balls: 0                              # 1/s, false balls of each robot, anywhere in its view; "
            "default\n"
            "incidents: []                                 # what strikes some robots at some time; default\n");
}

TEST(Show, ACommentStaysInItsLine) {
  const std::string page = show(override_with(text("disturbance: d\n"), {"radio.delay=\n  1"}));
  EXPECT_NE(page.find("; --set radio.delay=\\n  1\n"), std::string::npos) << page;
  EXPECT_EQ(parse_text(page, "shown.yaml")["radio"]["delay"].text(), "1");
}

TEST(Show, ATeamReadsBackTheSame) {
  const Node document = parse(project / "tests/fixtures/config/team.yaml");
  const Node shown = parse_text(show(document), "shown.yaml");
  EXPECT_TRUE(same(shown, parse_text(show(shown), "again.yaml")));
  const Team a = read_document<Team>(document), b = read_document<Team>(shown);
  ASSERT_EQ(a.contexts.size(), b.contexts.size());
  for (std::size_t i = 0; i < a.contexts.size(); ++i) {
    EXPECT_EQ(a.contexts[i].name, b.contexts[i].name);
    EXPECT_EQ(a.contexts[i].role_list, b.contexts[i].role_list);
    EXPECT_TRUE(same(a.contexts[i].sender.params, b.contexts[i].sender.params));
    ASSERT_EQ(a.contexts[i].terms.size(), b.contexts[i].terms.size());
    for (std::size_t t = 0; t < a.contexts[i].terms.size(); ++t) {
      EXPECT_EQ(a.contexts[i].terms[t].weight, b.contexts[i].terms[t].weight);
    }
  }
}

// Any number of degrees that a person or the tuner writes comes back as it was read.
TEST(Show, DegreesComeBackExactly) {
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    const double degrees = std::uniform_real_distribution(1.0, 3600.0)(random);
    const Node document = text(fmt::format("robot: r\nwalk: {{turn_deg: {:.{}g}}}\n", degrees, 1 + i % 17));
    const Node shown = parse_text(show(document), "shown.yaml");
    EXPECT_EQ(read_document<Robot>(document).walk.turn, read_document<Robot>(shown).walk.turn)
        << shown["walk"]["turn_deg"].text();
  }
}

TEST(Show, ParametersOfDeclaredPlugins) {
  using Type = PluginParameter::Type;
  const PluginDeclaration plugins[] = {
      {"event_based", "predictor", "another kind of the same name", {{"wrong", Type::real, 0, 1, "", "", 0}}},
      {"event_based",
       "sender",
       "",
       {{"period", Type::real, 0, 600, "s", "at the latest", 10},
        {"reserve", Type::integer, 0, 100, "packets", "kept back", 20},
        {.name = "whistle", .type = Type::boolean, .doc = "heard", .initial = 1},
        {.name = "mode", .type = Type::choice, .doc = "how", .initial = 1, .choices = {"slow", "fast"}},
        {.name = "label", .type = Type::text, .doc = "any", .initial_text = "a: b"},
        {.name = "weights", .type = Type::file, .doc = "none by default"}}},
  };
  const std::string page =
      show(load(project / "tests/fixtures/config/team.yaml", {"sender.params.strange=[1]"}), plugins);
  const Node params = parse_text(page, "shown.yaml")["sender"]["params"];
  EXPECT_EQ(flow(params), "{period: 10, reserve: 30, whistle: true, mode: fast, label: \"a: b\", strange: [1]}");
  const std::string other =
      show(load(project / "tests/fixtures/config/team.yaml", {"sender.params.weights=w.txt"}), plugins);
  EXPECT_EQ(parse_text(other, "shown.yaml")["sender"]["params"]["weights"].text(),
            (std::filesystem::current_path() / "w.txt").string());
  EXPECT_NE(page.find("    period: 10                                # s, at the latest; default\n"), std::string::npos)
      << page;
}

TEST(Show, FlowReadsBackTheSame) {
  for (const char* yaml : {"a: [1, -2.5, 1e-3, x, '', ' a', \"b: c\", '#', '- x', '-', '?', '[', 'null', '~', 'a,b', "
                           "\"\\n\\t\\\\\\\"\\x01\", é, \"it's\"]",
                           "a: {b: {}, c: [], d: [[], {}], sender.params.x: 4, 'x y': 1, \"<<\": 2, '': 3, 'null': 4}",
                           "a: [~, {b: ~}]"}) {
    const Node node = text(yaml)["a"];
    EXPECT_TRUE(same(text("a: " + flow(node))["a"], node)) << flow(node);
  }
}

}  // namespace
}  // namespace regista::config
