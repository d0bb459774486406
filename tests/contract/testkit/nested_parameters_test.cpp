// SPDX-License-Identifier: MIT
// Parameters that are bound to members of structs inside of the plugin class: where defaults come from, where values
// go, and which declarations do not compile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/kind_checks.hpp>
#include <regista/utility.hpp>

namespace {

using namespace regista::testkit;
using testing::ElementsAre;

enum class Shape { round, square };

struct Limits {
  double least = 0.25, most = 4.0;
};
struct Named {
  std::string name = "plain";
};
struct Settings : Named {
  Limits limits{.most = 2.0};
  int rounds = 3;
  bool eager = true;
  Shape shape = Shape::square;
  std::array<Limits, 2> sides{{{1.0, 1.5}, {0.5, 3.5}}};
};

constexpr std::array shapes{"round", "square"};

// What several plugins may share.
constexpr auto limits(const char* least, const char* most) {
  return std::tuple{regista::real(least, &Limits::least, {0.0, 1.0}, "m", "Not nearer").tunable(),
                    regista::real(most, &Limits::most, {1.0, 5.0}, "m", "Not farther")};
}

struct Side {
  std::size_t index;
  constexpr auto& operator()(auto& settings) const { return settings.sides[index]; }
};

struct Nested {
  static constexpr auto id = "nested", version = "1.0.0", summary = "Keeps the settings of its algorithm";
  Settings settings;
  double own = 7.0;
  Limits second{.least = 0.75};
  static constexpr std::tuple parameters{
      regista::within(&Nested::settings, regista::within(&Settings::limits, limits("least", "most")),
                      regista::integer("rounds", &Settings::rounds, {1, 10}, "1", "Rounds of bidding")),
      regista::real("own", &Nested::own, {0.0, 10.0}, "1", "Of the plugin itself"),
      regista::within(&Nested::settings, regista::boolean("eager", &Settings::eager, "Begin at once"),
                      regista::choice("shape", &Settings::shape, shapes, "What it looks like"),
                      regista::text("name", &Settings::name, "Of a base"),
                      regista::within(Side{1}, limits("right_least", "right_most"))),
      std::tuple{regista::within(&Nested::second, limits("second_least", "second_most"))}};

  void score(const regista::Frame&, regista::Utilities out) {
    const std::array<double, 12> members{settings.limits.least,
                                         settings.limits.most,
                                         static_cast<double>(settings.rounds),
                                         own,
                                         settings.eager ? 1.0 : 0.0,
                                         static_cast<double>(settings.shape),
                                         static_cast<double>(settings.name.size()),
                                         settings.sides[1].least,
                                         settings.sides[1].most,
                                         second.least,
                                         second.most,
                                         settings.sides[0].most};
    for (std::size_t i = 0; i < members.size(); ++i) out(0, i) = members[i];
  }
};

const Loaded nested{*regista::Plugin<Nested, regista::utility>::descriptor()};

std::vector<double> members(const Values& values) {
  FrameBuilder frame;
  frame.own(1).robot(1);
  for (int i = 0; i < 12; ++i) frame.task(i);
  const Matrix seen = Instance(nested, EnvironmentBuilder{}.own(1), values).score(frame.build());
  std::vector<double> out;
  for (std::size_t i = 0; i < 12; ++i) out.push_back(seen(0, i));
  return out;
}

TEST(NestedParameters, AreListedInTheOrderOfTheirDeclaration) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < nested.parameter_count(); ++i) names.push_back(nested.parameter(i).name);
  EXPECT_THAT(names, ElementsAre("least", "most", "rounds", "own", "eager", "shape", "name", "right_least",
                                 "right_most", "second_least", "second_most"));
  EXPECT_THAT(check_descriptor(nested).lines(), ElementsAre());
  EXPECT_EQ(nested.parameter(0).flags, std::uint32_t{REGISTA_PARAMETER_TUNABLE});
  EXPECT_EQ(nested.parameter(1).flags, 0u);
}

// Where a struct is initialised in another way, that is the default of its plugin.
TEST(NestedParameters, HaveTheDefaultsOfTheStructTheyAreIn) {
  std::vector<double> defaults;
  for (std::size_t i = 0; i < nested.parameter_count(); ++i) defaults.push_back(nested.parameter(i).initial);
  EXPECT_THAT(defaults, ElementsAre(0.25, 2.0, 3.0, 7.0, 1.0, 1.0, 0.0, 0.5, 3.5, 0.75, 4.0));
  EXPECT_STREQ(nested.parameter(6).initial_text, "plain");
  EXPECT_THAT(members(Values(nested)), ElementsAre(0.25, 2.0, 3.0, 7.0, 1.0, 1.0, 5.0, 0.5, 3.5, 0.75, 4.0, 1.5));
}

TEST(NestedParameters, ReachTheirMembersAndNoOthers) {
  EXPECT_THAT(members(Values(nested)
                          .set("most", 5.0)
                          .set("rounds", 4)
                          .set("eager", 0.0)
                          .set("shape", "round")
                          .set("name", "four")
                          .set("right_most", 1.25)
                          .set("second_least", 0.125)),
              ElementsAre(0.25, 5.0, 4.0, 7.0, 0.0, 0.0, 4.0, 0.5, 1.25, 0.125, 4.0, 1.5));
}

// --- What does not compile ---------------------------------------------------------------------------------------

struct Other {
  double reach = 1.0;
};

constexpr auto of_limits = regista::real("least", &Limits::least, {0.0, 1.0}, "m", "Not nearer");
constexpr auto of_other = regista::real("reach", &Other::reach, {0.0, 1.0}, "m", "Elsewhere");

template <class Member, class... Declared>
concept CanHold = requires(Member member, Declared... declared) {
  regista::within(member, declared...);
};

// Members of the struct, one by one or in a tuple, and of no other; a number has no members.
static_assert(CanHold<Limits Settings::*, decltype(of_limits)>);
static_assert(!CanHold<Limits Settings::*, decltype(of_other)>);
static_assert(!CanHold<Limits Settings::*, decltype(of_limits), decltype(of_other)>);
static_assert(CanHold<Limits Settings::*, decltype(limits("a", "b"))>);
static_assert(!CanHold<Limits Settings::*, decltype(std::tuple{of_limits, of_other})>);
static_assert(!CanHold<int Settings::*, decltype(of_limits)>);
// A way through another struct.
static_assert(CanHold<Settings Nested::*, decltype(regista::within(&Settings::limits, of_limits))>);
static_assert(!CanHold<Limits Nested::*, decltype(regista::within(&Settings::limits, of_limits))>);
static_assert(CanHold<Settings Nested::*, decltype(regista::within(Side{0}, of_limits))>);
static_assert(!CanHold<Settings Nested::*, decltype(regista::within(Side{0}, of_other))>);

// The list of a plugin: of its own class, or of a base of it.
struct Derived : Nested {};
template <class Plugin, class... Declared>
constexpr bool fit = regista::detail::MemberOf<std::tuple<Declared...>, Plugin>;
static_assert(fit<Nested, decltype(regista::real("own", &Nested::own, {0.0, 1.0}, "1", "")),
                  decltype(regista::within(&Nested::second, of_limits))>);
static_assert(fit<Derived, decltype(regista::within(&Nested::second, of_limits))>);
static_assert(!fit<Other, decltype(regista::within(&Nested::second, of_limits))>);
static_assert(!fit<Nested, decltype(of_limits)>);
static_assert(!fit<Nested, double>);

}  // namespace
