// SPDX-License-Identifier: MIT
#include "config/renamed_keys.hpp"

#include <gtest/gtest.h>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/team.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

const Declares present_build = [](std::string_view, std::string_view parameter) {
  return parameter == "leave_lost_ball" || parameter == "narrow_angle" || parameter == "for_robots" ||
         parameter == "ramp_seconds" || parameter == "stop_negotiating_at";
};

TEST(RenamedKeys, HaveTheirPresentNamesInParametersAndTargets) {
  const Node former = parse_text(
      "behaviours: {keep_goal: {params: {late: 1, comes_out: 0.8, apart: 1}}}\n"
      "utility: {terms: {stay: {plugin: persistence, params: {rows: own}}}}\n"
      "roles: {playing: [{name: rows, target: {at: ball, across: 2}}]}\n"
      "across: 1\n",
      "team.yaml");
  const Node present = with_present_names(former, present_build);
  EXPECT_TRUE(
      same(present, parse_text("behaviours: {keep_goal: {params: {leave_lost_ball: 1, narrow_angle: 0.8, apart: 1}}}\n"
                               "utility: {terms: {stay: {plugin: persistence, params: {for_robots: own}}}}\n"
                               "roles: {playing: [{name: rows, target: {at: ball, lateral: 2}}]}\n"
                               "across: 1\n",
                               "other.yaml")));
  EXPECT_TRUE(same(with_present_names(present, present_build), present));
  EXPECT_EQ(to_string(present["roles"]["playing"].elements()[0]["target"]["lateral"].where()), "team.yaml:3:59");
}

TEST(RenamedKeys, InWhatAContextLaysOverHaveThemToo) {
  const Node former = parse_text(
      "assigner: {plugin: token_passing}\n"
      "utility: {terms: {stay: {plugin: persistence, params: {rows: own}}}}\n"
      "contexts:\n"
      "  - plugin: mine\n"
      "    params: {rows: 1}\n"
      "    use:\n"
      "      utility.terms.stay.params.rows: all\n"
      "      assigner.params.static_at: 5\n"
      "      targets: {wing: {at: ball, across: 1}}\n"
      "      targets.libero.across: 2\n"
      "      utility: {terms: {stay: {params: {full_after: 0}}}}\n",
      "team.yaml");
  EXPECT_TRUE(same(with_present_names(former, present_build),
                   parse_text("assigner: {plugin: token_passing}\n"
                              "utility: {terms: {stay: {plugin: persistence, params: {for_robots: own}}}}\n"
                              "contexts:\n"
                              "  - plugin: mine\n"
                              "    params: {rows: 1}\n"
                              "    use:\n"
                              "      utility.terms.stay.params.for_robots: all\n"
                              "      assigner.params.stop_negotiating_at: 5\n"
                              "      targets: {wing: {at: ball, lateral: 1}}\n"
                              "      targets.libero.lateral: 2\n"
                              "      utility: {terms: {stay: {params: {ramp_seconds: 0}}}}\n",
                              "other.yaml")));
}

TEST(RenamedKeys, OfAnotherPluginAreItsOwn) {
  const Node mine = parse_text("utility: {terms: {x: {plugin: mine, params: {rows: 3}}}}\n", "team.yaml");
  EXPECT_TRUE(same(with_present_names(mine, present_build), mine));
}

TEST(RenamedKeys, OfAPluginOfAnEarlierVersionStay) {
  const Node former =
      parse_text("utility: {terms: {x: {plugin: persistence, params: {rows: own, full_after: 3}}}}\n", "t.yaml");
  const Declares rows = [](std::string_view plugin, std::string_view parameter) {
    return (plugin == "persistence" && parameter == "rows") || present_build(plugin, parameter);
  };
  EXPECT_TRUE(same(
      with_present_names(former, rows),
      parse_text("utility: {terms: {x: {plugin: persistence, params: {rows: own, ramp_seconds: 3}}}}\n", "t.yaml")));
}

TEST(RenamedKeys, ThatStandBesideTheirPresentNameAreLeftToTheReader) {
  const Node both = parse_text("roles: {r: [{target: {across: 1, lateral: 2}}]}\n", "team.yaml");
  EXPECT_TRUE(same(with_present_names(both, present_build), both));
}

TEST(RenamedKeys, InAPageAreAMistakeThatSaysThePresentName) {
  const std::string page = content_of(project / "tests/fixtures/config/team.yaml");
  const std::size_t at = page.find("lateral:");
  ASSERT_NE(at, std::string::npos);
  const std::string former = std::string(page).replace(at, 7, "across");
  const std::string message = error_of([&] { read_document<Team>(parse_text(former, "team.yaml")); });
  EXPECT_TRUE(message.starts_with("team.yaml:") && message.ends_with("target.across is now lateral")) << message;
}

}  // namespace
}  // namespace regista::config
