// SPDX-License-Identifier: MIT
// Which numbers of a team may be tuned, how they are chosen, and the mapping to the unit cube.
#include "study/tuning/parameter.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "config/parse.hpp"
#include "config/scalar.hpp"
#include "config/team.hpp"

namespace regista::study {
namespace {

using config::Node;
using config::PluginDeclaration;
using config::PluginParameter;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Type = PluginParameter::Type;

PluginParameter number(const char* name, double least, double most, double initial, bool log = false) {
  PluginParameter out{name, Type::real, least, most, "m", "what it is", initial};
  out.tunable = true;
  out.log_scale = log;
  return out;
}

PluginParameter whole(const char* name, double least, double most, double initial) {
  PluginParameter out = number(name, least, most, initial);
  out.type = Type::integer;
  return out;
}

std::vector<PluginDeclaration> plugins() {
  PluginParameter fixed = number("fixed", 0, 1, 0.5),
                  choice{.name = "mode", .type = Type::choice, .choices = {"a", "b"}};
  fixed.tunable = false;
  choice.tunable = true;
  return {{"near", "utility", "", {number("reach", 0.5, 4, 2)}},
          {"far", "utility", "", {number("scale", 1e-3, 10, 0.1, true), fixed}},
          {"near", "assigner", "", {whole("depth", 1, 9, 3), choice}},
          {"timed", "sender", "", {number("period", 0, 60, 10), whole("reserve", 0, 1200, 30)}},
          {"events", "sender", "", {whole("reserve", 0, 100, 20)}},
          {"track", "predictor", "", {number("noise", 0, 5, 1, true)}},
          {"lost", "context", "", {number("after", 0, 60, 5)}},
          {"always", "context", "", {}},
          {"grid", "positioner", "", {number("step", 0.1, 1, 0.5)}},
          {"hunt", "behaviour", "", {number("haste", 0, 2, 1)}},
          {"support", "behaviour", "", {number("reach", 0, 3, 1.5)}},
          {"play_ball", "behaviour", "", {number("bonus", 0, 20, 4)}},
          {"idle", "behaviour", "", {number("patience", 0, 9, 1)}}};
}

constexpr auto team = R"(team: t
predictors: {self: {plugin: still}, ball: {plugin: track, params: {noise: 0.25}}}
contexts:
  - {name: playing, plugin: always}
  - name: dotted
    plugin: lost
    params: {after: 7.5}
    use: {roles: r, sender.params.period: 4, utility.terms.far.weight: 0.125, positioner: ~}
  - name: nested
    plugin: lost
    use: {sender: {plugin: events, params: {reserve: 40}}, utility: {terms: {near: ~, third: {plugin: near, weight: 2, tune: [1, 3]}}}}
positioner: {plugin: grid}
utility:
  terms:
    near: {plugin: near, weight: 0.75, tune: [0, 1]}
    far: {plugin: far, params: {scale: 0.5}}
assigner: {plugin: near, params: {depth: 5}}
sender: {plugin: timed}
roles: {r: []}
)";

std::vector<Tunable> of(const std::string& text = team) {
  return tunables(config::parse_text(text, "team.yaml"), plugins());
}

const Tunable* find(const std::vector<Tunable>& all, const std::string& path) {
  const auto found = std::ranges::find(all, path, &Tunable::path);
  return found == all.end() ? nullptr : &*found;
}

config::TunedPath asked(std::string pattern, std::optional<std::array<double, 2>> range = {}) {
  return {std::move(pattern), range, {"t.yaml", 5, 3}, {"t.yaml", 5, 20}};
}

std::vector<Parameter> choose(const std::vector<config::TunedPath>& paths, const std::string& text = team) {
  return chosen_parameters(paths, of(text));
}

std::vector<std::string> names(const std::vector<Parameter>& all) {
  std::vector<std::string> out;
  for (const Parameter& each : all) out.push_back(each.path);
  return out;
}

std::string error_of(const std::vector<config::TunedPath>& paths, const std::string& text = team) {
  try {
    choose(paths, text);
  } catch (const config::Error& error) {
    return error.what();
  }
  return "";
}

// --- tunables -----------------------------------------------------------------------------------------------------

TEST(Tunables, TheTeamsOwnInTheOrderOfTheDocument) {
  std::vector<std::string> own;
  const auto all = of();
  for (const Tunable& each : all) {
    if (!each.path.starts_with("contexts.")) own.push_back(each.path);
  }
  EXPECT_THAT(
      own, ElementsAre("predictors.ball.params.noise", "positioner.params.step", "utility.terms.near.weight",
                       "utility.terms.near.params.reach", "utility.terms.far.weight", "utility.terms.far.params.scale",
                       "utility.terms.far.params.fixed", "assigner.params.depth", "assigner.params.mode",
                       "sender.params.period", "sender.params.reserve"));
}

TEST(Tunables, OfBehavioursThatThePageListsOrItsRolesMayActBy) {
  const auto all = of(std::string(team) +
                      "behaviours: {press: {plugin: hunt, params: {haste: 1.5}}, play_ball: {params: {bonus: 6}}}\n");
  EXPECT_EQ(find(all, "behaviours.press.params.haste")->start, 1.5);
  EXPECT_TRUE(find(all, "behaviours.press.params.haste")->said);
  EXPECT_EQ(find(all, "behaviours.play_ball.params.bonus")->start, 6.0) << "the plugin of its name";
  EXPECT_EQ(find(all, "behaviours.support.params.reach"), nullptr) << "no role acts by it";
  const std::string roles =
      "roles: {r: [{name: a, target: {at: ball}}, {name: b, behaviour: hunt, target: {at: ball}}]}\n";
  const auto by_roles = of(std::string(team).substr(0, std::string_view(team).find("roles: {r: []}")) + roles);
  EXPECT_EQ(find(by_roles, "behaviours.play_ball.params.bonus")->start, 4.0);
  EXPECT_FALSE(find(by_roles, "behaviours.play_ball.params.bonus")->said) << "no pattern finds it";
  EXPECT_NE(find(by_roles, "behaviours.support.params.reach"), nullptr);
  EXPECT_NE(find(by_roles, "behaviours.hunt.params.haste"), nullptr);
  EXPECT_EQ(find(by_roles, "behaviours.idle.params.patience"), nullptr);
}

TEST(Tunables, ValuesInForceAndWhatIsDeclared) {
  const auto all = of();
  EXPECT_EQ(find(all, "predictors.ball.params.noise")->start, 0.25);
  EXPECT_TRUE(find(all, "predictors.ball.params.noise")->log_scale);
  EXPECT_EQ(find(all, "positioner.params.step")->start, 0.5);  // by default
  const Tunable& weight = *find(all, "utility.terms.near.weight");
  EXPECT_EQ(weight.start, 0.75);
  EXPECT_EQ(weight.least, 0.0);
  EXPECT_EQ(weight.most, 1.0);
  EXPECT_EQ(weight.refusal, "");
  EXPECT_EQ(find(all, "utility.terms.far.weight")->start, config::UtilityTerm{}.weight);
  EXPECT_THAT(find(all, "utility.terms.far.weight")->refusal, HasSubstr("tune"));
  const Tunable& depth = *find(all, "assigner.params.depth");
  EXPECT_EQ(depth.start, 5.0);
  EXPECT_TRUE(depth.integer);
  EXPECT_EQ(depth.least, 1.0);
  EXPECT_EQ(depth.most, 9.0);
  EXPECT_EQ(depth.unit, "m");
  EXPECT_EQ(depth.doc, "what it is");
  EXPECT_THAT(find(all, "assigner.params.mode")->refusal, HasSubstr("number"));
  EXPECT_THAT(find(all, "utility.terms.far.params.fixed")->refusal, HasSubstr("tunable"));
}

TEST(Tunables, OfContextsWhatHoldsThere) {
  const auto all = of();
  EXPECT_EQ(find(all, "contexts.dotted.params.after")->start, 7.5);
  EXPECT_EQ(find(all, "contexts.nested.params.after")->start, 5.0);
  // What a context says itself, by a key with dots or in maps.
  EXPECT_EQ(find(all, "contexts.dotted.use.sender.params.period")->start, 4.0);
  EXPECT_EQ(find(all, "contexts.dotted.use.utility.terms.far.weight")->start, 0.125);
  EXPECT_EQ(find(all, "contexts.nested.use.sender.params.reserve")->start, 40.0);
  EXPECT_EQ(find(all, "contexts.nested.use.sender.params.reserve")->most, 100.0);  // of another plugin
  EXPECT_EQ(find(all, "contexts.nested.use.utility.terms.third.weight")->start, 2.0);
  EXPECT_EQ(find(all, "contexts.nested.use.utility.terms.third.weight")->most, 3.0);
  // What it takes over.
  EXPECT_EQ(find(all, "contexts.playing.use.utility.terms.near.weight")->start, 0.75);
  EXPECT_EQ(find(all, "contexts.dotted.use.utility.terms.far.params.scale")->start, 0.5);
  EXPECT_EQ(find(all, "contexts.playing.use.assigner.params.depth")->start, 5.0);
  EXPECT_EQ(find(all, "contexts.dotted.use.sender.params.reserve")->start, 30.0);
  // What it has not.
  EXPECT_EQ(find(all, "contexts.dotted.use.positioner.params.step"), nullptr);
  EXPECT_EQ(find(all, "contexts.nested.use.utility.terms.near.weight"), nullptr);
  EXPECT_EQ(find(all, "contexts.nested.use.sender.params.period"), nullptr);
}

// A context's page says some values; those it takes over are its team's.
TEST(Tunables, AContextSaysWhatStandsThere) {
  const auto all = of();
  std::vector<std::string> said;
  for (const Tunable& each : all) {
    if (each.said && each.path.starts_with("contexts.")) said.push_back(each.path);
  }
  EXPECT_THAT(said, ElementsAre("contexts.dotted.params.after", "contexts.dotted.use.utility.terms.far.weight",
                                "contexts.dotted.use.sender.params.period", "contexts.nested.params.after",
                                "contexts.nested.use.utility.terms.third.weight",
                                "contexts.nested.use.utility.terms.third.params.reach",
                                "contexts.nested.use.sender.params.reserve"));
  for (const Tunable& each : all) EXPECT_TRUE(each.said || each.path.starts_with("contexts.")) << each.path;
}

TEST(Tunables, AContextThatNamesItsPluginByAPathSaysItsParameters) {
  const auto all =
      of("team: t\ncontexts: [{name: c, plugin: always, use: {sender.plugin: events}},"
         " {name: d, plugin: always, use: {sender.params: {period: 3}}}]\nsender: {plugin: timed}\n");
  ASSERT_NE(find(all, "contexts.c.use.sender.params.reserve"), nullptr);
  EXPECT_TRUE(find(all, "contexts.c.use.sender.params.reserve")->said);
  EXPECT_EQ(find(all, "contexts.c.use.sender.params.reserve")->start, 20.0);
  EXPECT_TRUE(find(all, "contexts.d.use.sender.params.period")->said);
  EXPECT_FALSE(find(all, "contexts.d.use.sender.params.reserve")->said);
}

TEST(Tunables, PluginsThatAreNotDeclaredHaveNone) {
  EXPECT_THAT(of("team: t\nsender: {plugin: unknown, params: {period: 3}}\nassigner: {plugin: timed}\n"), IsEmpty());
}

// --- Choosing -----------------------------------------------------------------------------------------------------

TEST(ChosenParameters, ByPathAsTheyAre) {
  const auto chosen = choose({asked("sender.params.period"), asked("assigner.params.depth")});
  ASSERT_THAT(names(chosen), ElementsAre("assigner.params.depth", "sender.params.period"));  // as in the document
  EXPECT_EQ(chosen[0], (Parameter{"assigner.params.depth", 5.0, 1.0, 9.0, true, false, "m", "what it is"}));
  EXPECT_EQ(chosen[1], (Parameter{"sender.params.period", 10.0, 0.0, 60.0, false, false, "m", "what it is"}));
}

TEST(ChosenParameters, APatternMeansWhatTheDocumentSaysAndCanBeTuned) {
  EXPECT_THAT(names(choose({asked("utility.terms.*.weight")})), ElementsAre("utility.terms.near.weight"));
  EXPECT_THAT(names(choose({asked("*.weight")})),
              ElementsAre("utility.terms.near.weight", "contexts.nested.use.utility.terms.third.weight"));
  EXPECT_THAT(names(choose({asked("contexts.*.use.sender.params.*")})),
              ElementsAre("contexts.dotted.use.sender.params.period", "contexts.nested.use.sender.params.reserve"));
  EXPECT_THAT(names(choose({asked("sender.params.[pr]e*")})),
              ElementsAre("sender.params.period", "sender.params.reserve"));
  EXPECT_THAT(names(choose({asked("sender.params.perio?")})), ElementsAre("sender.params.period"));
}

TEST(ChosenParameters, APathMayGiveAContextAValueOfItsOwn) {
  const auto chosen = choose({asked("contexts.playing.use.utility.terms.near.weight", {{0.5, 1}})});
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(chosen[0].start, 0.75);
  EXPECT_EQ(chosen[0].least, 0.5);
}

TEST(ChosenParameters, EachOnceAndTheLastRangeHolds) {
  const auto chosen = choose({asked("sender.params.*", {{5, 50}}), asked("sender.params.period", {{8, 20}}),
                              asked("sender.params.reserve"), asked("sender.params.period")});
  ASSERT_THAT(names(chosen), ElementsAre("sender.params.period", "sender.params.reserve"));
  EXPECT_EQ(chosen[0].least, 8.0);
  EXPECT_EQ(chosen[0].most, 20.0);
  EXPECT_EQ(chosen[1].least, 5.0);
  EXPECT_EQ(chosen[1].most, 50.0);
}

TEST(ChosenParameters, RangesOfWholeNumbersBeginAndEndAtOne) {
  const auto chosen = choose({asked("assigner.params.depth", {{2.5, 6.5}})});
  EXPECT_EQ(chosen[0].least, 3.0);
  EXPECT_EQ(chosen[0].most, 6.0);
  EXPECT_THAT(error_of({asked("assigner.params.depth", {{5.2, 5.8}})}),
              AllOf(HasSubstr("t.yaml:5:20: "), HasSubstr("no whole number")));
}

TEST(ChosenParameters, AFixedRange) {
  const auto chosen =
      choose({asked("sender.params.period", {{10, 10}}), asked("predictors.ball.params.noise", {{0.25, 0.25}})});
  for (const Parameter& each : chosen) {
    EXPECT_TRUE(each.fixed());
    EXPECT_EQ(share_of(each, each.start), 0.0);
    EXPECT_EQ(value_at_share(each, 0.7), each.start);
  }
}

TEST(ChosenParameters, WhatIsRefusedAndWhere) {
  struct Wrong {
    config::TunedPath path;
    std::vector<std::string> says;
  };
  const Wrong all[] = {
      {asked("utility.terms.far.weight"), {"t.yaml:5:3: ", "utility.terms.far.weight", "tune: [least, largest]"}},
      {asked("assigner.params.mode"), {"t.yaml:5:3: ", "plugin near", "number"}},
      {asked("utility.terms.far.params.fixed"), {"t.yaml:5:3: ", "plugin far", "tunable"}},
      {asked("sender.params.perod"), {"t.yaml:5:3: ", "\"sender.params.perod\"", "nearest: sender.params.period, "}},
      {asked("utility.terms.naer.weight"), {"t.yaml:5:3: ", "nearest: utility.terms.near.weight, "}},
      {asked("nothing.*"), {"t.yaml:5:3: ", "\"nothing.*\"", "matches nothing"}},
      {asked("utility.terms.far.w*"), {"t.yaml:5:3: ", "matches nothing"}},
      {asked("contexts.playing.use.*"), {"t.yaml:5:3: ", "matches nothing"}},
      {asked("sender.params"), {"t.yaml:5:3: ", "nearest"}},
      {asked("sender.params.period", {{-1, 20}}),
       {"t.yaml:5:20: ", "sender.params.period", "-1 to 20", "wider", "0 to 60"}},
      {asked("sender.params.period", {{5, 61}}), {"t.yaml:5:20: ", "wider"}},
      {asked("utility.terms.near.weight", {{0, 1.5}}), {"t.yaml:5:20: ", "wider"}},
      {asked("utility.terms.*.weight", {{0, 0.7}}), {"t.yaml:5:20: ", "the team's own 0.75", "0 to 0.7"}},
      {asked("utility.terms.near.weight", {{0.8, 1}}), {"t.yaml:5:20: ", "the team's own 0.75"}},
      {asked("predictors.ball.params.noise"), {"t.yaml:5:3: ", "logarithmic", "narrow"}},
      {asked("predictors.ball.params.noise", {{0, 1}}), {"t.yaml:5:20: ", "logarithmic"}},
  };
  for (const Wrong& each : all) {
    const std::string found = error_of({each.path});
    for (const std::string& part : each.says) EXPECT_THAT(found, HasSubstr(part)) << each.path.pattern;
    EXPECT_TRUE(found.starts_with(each.says.front())) << found;
    EXPECT_EQ(found.find('\n'), std::string::npos);
  }
  EXPECT_EQ(error_of({asked("predictors.ball.params.noise", {{1e-6, 1}})}), "");
}

TEST(ChosenParameters, ATeamWithNothingToTuneSaysSo) {
  EXPECT_THAT(error_of({asked("a.b")}, "team: t\nutility: {terms: {near: {plugin: far2, weight: 1}}}\n"),
              HasSubstr("nothing of it can be"));
}

// The range of a weight may leave out its own value: `tune` only says what may be searched.
TEST(ChosenParameters, ATuneThatLeavesOutTheWeightIsRefused) {
  EXPECT_THAT(error_of({asked("utility.terms.near.weight")},
                       "team: t\nutility: {terms: {near: {plugin: near, weight: 2, tune: [0, 1]}}}\n"),
              AllOf(HasSubstr("t.yaml:5:3: "), HasSubstr("the team's own 2 is outside 0 to 1")));
}

// --- Mapping ------------------------------------------------------------------------------------------------------

// Ranges of many sizes, real and whole, straight and logarithmic.
std::vector<Parameter> random_parameters() {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> exponent(-6, 6), share(0, 1);
  std::vector<Parameter> out;
  for (int i = 0; i < 400; ++i) {
    Parameter each;
    each.path = "p";
    each.integer = i % 3 == 0;
    each.log_scale = i % 2 == 0;
    const double a = std::pow(10.0, exponent(random)), b = std::pow(10.0, exponent(random));
    each.least = each.log_scale ? std::min(a, b) : (i % 4 == 1 ? -a : 0.0);
    each.most = std::max({a, b, each.least * 1.01});
    if (each.integer) {
      each.least = std::ceil(each.least) + (each.log_scale ? 1.0 : 0.0);
      each.most = std::ceil(each.most) + 1.0 + each.least;
    }
    out.push_back(each);
  }
  return out;
}

TEST(Mapping, EndsAreExactAndItIsMonotone) {
  for (const Parameter& each : random_parameters()) {
    EXPECT_EQ(value_at_share(each, 0.0), each.least);
    EXPECT_EQ(value_at_share(each, 1.0), each.most);
    EXPECT_EQ(share_of(each, each.least), 0.0);
    EXPECT_EQ(share_of(each, each.most), 1.0);
    double before = each.least;
    for (int i = 0; i <= 1000; ++i) {
      const double value = value_at_share(each, i / 1000.0);
      EXPECT_GE(value, before);
      EXPECT_LE(value, each.most);
      if (each.integer) {
        EXPECT_EQ(value, std::round(value));
      }
      before = value;
    }
  }
}

TEST(Mapping, ThereAndBackIsTheSameUpToRounding) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  for (const Parameter& each : random_parameters()) {
    for (int i = 0; i < 50; ++i) {
      const double value = value_at_share(each, any(random));
      EXPECT_EQ(rounded(each, value), value);  // nothing is rounded twice
      EXPECT_EQ(value_at_share(each, share_of(each, value)), value) << each.least << ' ' << each.most;
      const double share = share_of(each, value);
      EXPECT_GE(share, 0.0);
      EXPECT_LE(share, 1.0);
    }
  }
}

// Independent formulas: equal steps of the share are equal steps, or equal factors.
TEST(Mapping, Scales) {
  const Parameter straight{"p", 1, -2, 6, false, false, "", ""}, log{"p", 1, 0.01, 100, false, true, "", ""};
  EXPECT_DOUBLE_EQ(value_at_share(straight, 0.25), 0.0);
  EXPECT_DOUBLE_EQ(share_of(straight, 4.0), 0.75);
  EXPECT_DOUBLE_EQ(value_at_share(log, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(value_at_share(log, 0.75), 10.0);
  EXPECT_NEAR(share_of(log, 0.1), 0.25, 1e-12);
  const Parameter whole_number{"p", 1, 0, 10, true, false, "", ""};
  EXPECT_EQ(value_at_share(whole_number, 0.449), 4.0);
  EXPECT_EQ(value_at_share(whole_number, 0.451), 5.0);
}

TEST(Mapping, RoundedToSixDigits) {
  const Parameter each{"p", 1, 0, 1000, false, false, "", ""};
  EXPECT_EQ(rounded(each, 0.123456789), 0.123457);
  EXPECT_EQ(rounded(each, 123.456789), 123.457);
  EXPECT_EQ(rounded(each, -3.0), 0.0);
  EXPECT_EQ(rounded(each, 2000.0), 1000.0);
  const Parameter far{"p", 1, 1e6, 1e6 + 0.5, false, false, "", ""};
  EXPECT_EQ(rounded(far, 2e6), 1e6 + 0.5);
}

// A narrow range far from zero keeps values in between.
TEST(Mapping, ANarrowRangeHasMoreThanItsEnds) {
  for (const double offset : {1000.0, 1e6, 1e8}) {
    const Parameter each{"p", offset, offset, offset + 1.0, false, false, "", ""};
    for (int i = 0; i <= 20; ++i) EXPECT_NEAR(share_of(each, value_at_share(each, i / 20.0)), i / 20.0, 1e-4) << offset;
  }
}

TEST(Mapping, TextsReadBackExactly) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(0, 1);
  for (Parameter each : random_parameters()) {
    for (int i = 0; i < 20; ++i) {
      const double value = i == 0 ? each.least : i == 1 ? each.most : value_at_share(each, any(random));
      const std::string text = text_of(each, value);
      EXPECT_EQ(config::to_real(config::parse_value(text, {}), "p"), value) << text;
      if (each.integer) {
        EXPECT_EQ(static_cast<double>(config::to_integer(config::parse_value(text, {}), "p")), value);
      }
      EXPECT_EQ(text.find_first_not_of("0123456789.+-e"), std::string::npos) << text;
    }
    // What a person wrote is not rounded.
    each.integer = false;
    const double odd = each.least + (each.most - each.least) * any(random);
    EXPECT_EQ(config::to_real(config::parse_value(text_of(each, odd), {}), "p"), odd);
  }
}

}  // namespace
}  // namespace regista::study
