// SPDX-License-Identifier: MIT
#include "plugin/parameters.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <span>
#include <string_view>

#include "plugin/kinds.hpp"
#include "plugin/shared_object.hpp"
#include "scene.hpp"

namespace regista::plugin::test {
namespace {

using config::Node;

// Of the plugin "sound": reach, decay, rounds, eager, order, title, formation.
enum { reach, decay, rounds, eager, order, title, formation };

Parameters resolve_sound(const Node& params) {
  const Found sound = open("sound");
  return resolve(*sound.descriptor, use("sound", params));
}

std::string refusal(const std::string& name, const Node& value) {
  return message_of([&] { resolve_sound(map({{name, value}})); });
}

// The message of a wrong value.
std::string said(const std::string& name, const std::string& reason) {
  return "team.yaml:3:20: parameter \"" + name + "\" of plugin sound: " + reason;
}

std::string_view text(const Parameters& parameters, std::size_t index) {
  return {parameters.values()[index].text, static_cast<std::size_t>(parameters.values()[index].text_size)};
}

TEST(Parameters, AreDefaultsUnlessGiven) {
  for (const Node& nothing : {Node(), Node::null({"team.yaml", 2, 30}), map({})}) {
    const Parameters parameters = resolve_sound(nothing);
    const auto values = parameters.values();
    ASSERT_EQ(values.size(), 7u);
    EXPECT_EQ(values[reach].number, 12.0);
    EXPECT_EQ(values[decay].number, 0.01);
    EXPECT_EQ(values[rounds].number, 3.0);
    EXPECT_EQ(values[eager].number, 1.0);
    EXPECT_EQ(values[order].number, 1.0);
    EXPECT_EQ(text(parameters, title), "plain");
    EXPECT_EQ(values[formation].text, nullptr);
    EXPECT_EQ(values[reach].text, nullptr);
    EXPECT_TRUE(parameters.files().empty());
  }
}

TEST(Parameters, AreWhatTheYamlSays) {
  const Parameters parameters = resolve_sound(map({{"reach", scalar("0.5")},
                                                   {"rounds", scalar("10")},
                                                   {"eager", scalar("false")},
                                                   {"order", scalar("first")},
                                                   {"title", quoted("")},
                                                   {"decay", scalar("1e-6")}}));
  EXPECT_EQ(parameters.values()[reach].number, 0.5);
  EXPECT_EQ(parameters.values()[decay].number, 1e-6);
  EXPECT_EQ(parameters.values()[rounds].number, 10.0);
  EXPECT_EQ(parameters.values()[eager].number, 0.0);
  EXPECT_EQ(parameters.values()[order].number, 0.0);
  ASSERT_NE(parameters.values()[title].text, nullptr);
  EXPECT_EQ(text(parameters, title), "");
}

TEST(Parameters, NullMeansTheDefault) {
  EXPECT_EQ(resolve_sound(map({{"reach", Node::null({"team.yaml", 3, 20})}})).values()[reach].number, 12.0);
}

TEST(Parameters, ArriveInThePlugin) {
  Scene scene(8);
  Utility utility(instance_of(open("sound"), 0,
                              map({{"reach", scalar("7.5")},
                                   {"rounds", scalar("4")},
                                   {"eager", scalar("false")},
                                   {"order", scalar("first")},
                                   {"title", scalar("four")}})));
  const std::span<const double> out = utility.score(scene.frame, 1, 8);
  const double expected[] = {7.5, 0.01, 4.0, 0.0, 0.0, 4.0, 0.0};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(out[i], expected[i]) << i;
}

TEST(Parameters, TextsOutliveCopies) {
  auto first = std::make_unique<Parameters>(resolve_sound(map({{"title", scalar("short")}})));
  const Parameters second = *first;
  first.reset();
  EXPECT_EQ(text(second, title), "short");
}

TEST(Parameters, RefuseUnknownNames) {
  EXPECT_EQ(
      message_of([] {
        resolve_sound(map({{"eager", scalar("true")}, {"reech", scalar("1")}}));
      }),
      "team.yaml:4:10: unknown parameter \"reech\" in plugin sound; nearest: \"reach\"; known: reach, decay, rounds, "
      "eager, order, title, formation");
  const Found negotiator = open("sound", 1);
  EXPECT_EQ(message_of([&] {
              resolve(*negotiator.descriptor, use("negotiator", map({{"reach", scalar("1")}})));
            }),
            "team.yaml:3:10: unknown parameter \"reach\" in plugin negotiator; it has none");
  EXPECT_EQ(message_of([] { resolve_sound(scalar("12")); }),
            "team.yaml:3:20: params of plugin sound: \"12\"; expected a map");
}

TEST(Parameters, RefuseOtherTypes) {
  EXPECT_EQ(refusal("reach", scalar("far")), said("reach", "\"far\" is not a number"));
  EXPECT_EQ(refusal("reach", quoted("12")), said("reach", "\"12\" is text, being quoted; expected a number"));
  EXPECT_EQ(refusal("reach", Node::sequence({}, {"team.yaml", 3, 20})), said("reach", "a list; expected a number"));
  EXPECT_EQ(refusal("rounds", scalar("2.5")), said("rounds", "\"2.5\" is not an integer"));
  EXPECT_EQ(refusal("eager", scalar("yes")), said("eager", "\"yes\" is neither true nor false; write true"));
  EXPECT_EQ(refusal("title", map({})), "team.yaml:2:30: parameter \"title\" of plugin sound: a map; expected text");
  EXPECT_EQ(refusal("formation", Node::sequence({}, {"team.yaml", 3, 20})), said("formation", "a list; expected text"));
}

TEST(Parameters, RefuseNumbersOutOfRange) {
  EXPECT_EQ(refusal("reach", scalar("25")), said("reach", "25 is outside 0.5 to 20 m"));
  EXPECT_EQ(refusal("reach", scalar("20.000001")), said("reach", "20.000001 is outside 0.5 to 20 m"));
  EXPECT_EQ(refusal("reach", scalar("20")), "");
  EXPECT_EQ(refusal("rounds", scalar("0")), said("rounds", "0 is outside 1 to 10"));
  EXPECT_EQ(refusal("reach", scalar(".nan")), said("reach", "\".nan\" is not finite"));
  EXPECT_EQ(refusal("reach", scalar("-.inf")), said("reach", "\"-.inf\" is not finite"));
  EXPECT_EQ(refusal("reach", scalar("1e999")), said("reach", "\"1e999\" is beyond what a number can hold"));
}

TEST(Parameters, RefuseUnknownChoices) {
  EXPECT_EQ(refusal("order", scalar("furst")),
            said("order", "unknown choice \"furst\"; nearest: \"first\"; known: first, best"));
  EXPECT_EQ(refusal("order", scalar("1")), said("order", "unknown choice \"1\"; known: first, best"));
}

class FileParameter : public ::testing::Test {
 protected:
  // `params: {formation: name}` as it would stand in team.yaml of the folder.
  Parameters resolve_file(const std::string& name) {
    return resolve_sound(map({{"formation", scalar(name, 3, folder / "team.yaml")}}));
  }
  std::string refusal(const std::string& name) {
    return message_of([&] { resolve_file(name); });
  }
  std::string said(const std::string& reason) {
    return (folder / "team.yaml").string() + ":3:20: parameter \"formation\" of plugin sound: " + reason;
  }
  void write(const std::string& name, const std::string& content) {
    std::ofstream(folder / name, std::ios::binary) << content;
  }

  Folder folder;
};

TEST_F(FileParameter, IsReadFromBesideTheYamlFile) {
  const std::string content(
      "line\n\0\xff"
      "end",
      10);
  write("a.conf", content);
  const Parameters parameters = resolve_file("a.conf");
  EXPECT_EQ(text(parameters, formation), content);
  EXPECT_EQ(parameters.values()[formation].text[content.size()], '\0');
  ASSERT_EQ(parameters.files().size(), 1u);
  EXPECT_EQ(parameters.files()[0].parameter, "formation");
  EXPECT_EQ(parameters.files()[0].path, folder / "a.conf");
  EXPECT_EQ(parameters.files()[0].hash, content_hash(content));
  EXPECT_EQ(text(resolve_file(folder / "a.conf"), formation), content);
}

TEST_F(FileParameter, MayBeEmpty) {
  write("a.conf", "");
  const Parameters parameters = resolve_file("a.conf");
  EXPECT_NE(parameters.values()[formation].text, nullptr);
  EXPECT_EQ(text(parameters, formation), "");
}

TEST_F(FileParameter, MustExist) {
  write("a.conf", "x");
  EXPECT_EQ(refusal("b.txt"), said((folder / "b.txt").string() + ": no such file"));
  fs::create_directory(folder / "sub");
  EXPECT_EQ(refusal("sub"), said((folder / "sub").string() + ": is not a regular file"));
}

TEST_F(FileParameter, MustNotBeLarge) {
  write("a.conf", "");
  fs::resize_file(folder / "a.conf", 16'000'000);
  EXPECT_EQ(refusal("a.conf"), "");
  fs::resize_file(folder / "a.conf", 16'000'001);
  EXPECT_EQ(refusal("a.conf"), said((folder / "a.conf").string() + ": has 16000001 bytes; at most 16000000 are read"));
}

}  // namespace
}  // namespace regista::plugin::test
