// SPDX-License-Identifier: MIT
// One formation in JSON and in each of the older text forms: the same places for the ball anywhere. Broken and foreign
// texts: each refused in one line that says where, what was found and what is wanted.
#include <gtest/gtest.h>

#include <functional>
#include <iomanip>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "formation.hpp"
#include "formation_file.hpp"

namespace {

using namespace formations;

constexpr int players = 11;

// As in a file: y to the right, centimetres, in metres.
struct Point {
  double x, y;
};
struct Picture {
  Point ball;
  std::vector<Point> at;
};

std::vector<Picture> made_up(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto centimetres = [&](int most) {
    return (static_cast<int>(random() % (200u * static_cast<unsigned>(most))) - 100 * most) / 100.0;
  };
  std::vector<Picture> out;
  for (int i = 0; i < count; ++i) {
    // The balls lie on lines that cross, so that many are on one circle, where the order of samples decides.
    Picture& each = out.emplace_back(Picture{{10.0 * (i % 5) - 20.0, 8.0 * (i / 5) - 16.0}, {}});
    for (int k = 0; k < players; ++k) each.at.push_back({centimetres(52), centimetres(34)});
  }
  return out;
}

std::string json(const std::string& method, const std::vector<Picture>& pictures) {
  std::ostringstream out;
  out << std::setprecision(17) << R"({"method": ")" << method << R"(", "data": [)";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Picture& each = pictures[i];
    out << (i > 0 ? ", " : "") << R"({"ball": {"x": )" << each.ball.x << R"(, "y": )" << each.ball.y << "}";
    for (std::size_t k = 0; k < each.at.size(); ++k)
      out << ", \"" << k + 1 << R"(": {"x": )" << each.at[k].x << R"(, "y": )" << each.at[k].y << "}";
    out << "}";
  }
  out << "]}";
  return out.str();
}

std::string samples(const std::vector<Picture>& pictures) {
  std::ostringstream out;
  out << std::setprecision(17) << "Begin Samples 2 " << pictures.size() << "\n";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    out << "----- " << i << " -----\nBall " << pictures[i].ball.x << ' ' << pictures[i].ball.y << '\n';
    for (std::size_t k = 0; k < players; ++k)
      out << k + 1 << ' ' << pictures[i].at[k].x << ' ' << pictures[i].at[k].y << '\n';
  }
  out << "End Samples\n";
  return out.str();
}

const char* const roles_2 =
    "Begin Roles\n1 Goalie 0\n2 CenterBack -1\n3 CenterBack 2\n4 SideBack -1\n5 SideBack 4\n6 DefensiveHalf 0\n"
    "7 OffensiveHalf -1\n8 OffensiveHalf 7\n9 SideForward -1\n10 SideForward 9\n11 CenterForward 0\nEnd Roles\n";
const char* const roles_3 =
    "Begin Roles\n# unum type name partner\n1 G  Goalie 0 x x\n2 DF Sweeper 0 x x\n3 DF CenterBack 0 marker x\n"
    "4 DF SideBack -1 marker setplay_marker\n5 DF SideBack 4 x x\n6 MF A 0 x x\n7 MF B -1 x x\n8 MF C 7 x x\n"
    "9 FW D -1 x x\n10 FW E 9 x x\n11 FW F 0 x setplay_marker\nEnd Roles\n";

std::string version_2(const std::vector<Picture>& pictures) {
  return "Formation DelaunayTriangulation 2\n" + std::string(roles_2) + samples(pictures) + "End\n";
}

std::string version_1(const std::vector<Picture>& pictures) {
  std::ostringstream out;
  out << std::setprecision(17) << "Formation DelaunayTriangulation\n";
  for (int k = 0; k < players; ++k) out << "Role" << k << ' ' << (k % 3 == 2 ? k : k % 3 - 1) << ' ';
  for (const Picture& each : pictures) {
    out << '\n' << each.ball.x << ' ' << each.ball.y << ' ';
    for (const Point& at : each.at) out << at.x << ' ' << at.y << ' ';
  }
  out << "\nEnd\n";
  return out.str();
}

std::string fixed(const Picture& picture, const std::string& header = "Formation Static") {
  std::ostringstream out;
  out << std::setprecision(17) << header << "\n# ------\n# before the kick-off\n";
  for (std::size_t k = 0; k < players; ++k)
    out << ' ' << k + 1 << " Role   " << picture.at[k].x << "  " << picture.at[k].y << '\n';
  return out.str();
}

std::string refusal(std::string_view bytes) {
  try {
    read_formation(bytes);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "read";
}

// Bit by bit the same places, for the ball on and around the field.
void expect_same(const std::string& text, const std::string& original) {
  const std::vector<Sample> a = read_formation(text), b = read_formation(original);
  for (const Beyond beyond : {Beyond::nearest_point, Beyond::nearest_sample}) {
    const Formation one(a, 9.0 / 105.0, 6.0 / 68.0, beyond), other(b, 9.0 / 105.0, 6.0 / 68.0, beyond);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-6.0, 6.0), y(-4.0, 4.0);
    for (int i = 0; i < 2000; ++i) {
      Position ball{x(random), 0.0};
      ball.y = y(random);
      const Shares first = one.shares(ball), second = other.shares(ball);
      for (std::size_t k = 0; k < players; ++k) ASSERT_EQ(one.position(first, k), other.position(second, k)) << k;
    }
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error(from);
  return text.replace(at, from.size(), to);
}

TEST(FormationText, AllFormsHoldTheSame) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const std::vector<Picture> pictures = made_up(25, seed);
    const std::string original = json("DelaunayTriangulation", pictures), text = version_2(pictures);
    expect_same(text, original);
    expect_same(version_1(pictures), original);
    expect_same(replaced(version_1(pictures), "Triangulation\n", "Triangulation 1\n"), original);
    expect_same("Formation DelaunayTriangulation 3\n" + std::string(roles_3) + samples(pictures), original);
    expect_same(replaced(text, "Triangulation 2", "Triangulation"), original);
    // Comments, blanks, other ends of lines, no numbers of samples, constraints of another method.
    std::string varied = "# 20180612\n\n// by hand\n" + replaced(text, "Begin Samples", "# samples\nBegin Samples");
    varied = replaced(varied, "End\n", "End\n");
    for (std::size_t i = 0; i < pictures.size(); ++i)
      varied = replaced(varied, "----- " + std::to_string(i) + " -----\n", i % 2 == 0 ? "" : "\n// next\n");
    varied =
        replaced(varied, "\nEnd Samples\n", " # the last\nEnd Samples\nBegin Constraints 1\n0 1\nEnd Constraints\n");
    expect_same(varied, original);
    std::string windows;
    for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
    expect_same("\xef\xbb\xbf" + windows, original);
  }
}

TEST(FormationText, StaticFormsHoldTheSame) {
  Picture picture = made_up(1, 3).front();
  const std::string original = json("Static", {picture});
  expect_same(fixed(picture), original);
  expect_same(fixed(picture, "Formation Static 0") + "Begin Samples 2 0\nEnd Samples\n", original);
  expect_same("Formation Static 2\n" + std::string(roles_2) + samples({picture}), original);
}

TEST(FormationText, TheLeftIsLeft) {
  std::vector<Picture> pictures = made_up(1, 1);
  pictures[0].ball = {54.5, -36.0};
  pictures[0].at[1] = {-0.72, -12.0};
  const std::vector<Sample> read = read_formation(version_2(pictures));
  EXPECT_EQ(read[0].ball, (GridPoint{545'000, 360'000}));
  EXPECT_EQ(read[0].positions[1], (Position{-0.72, 12.0}));
}

TEST(FormationText, WhatIsReadOfOtherMethods) {
  const auto other = [](const std::string& method, const std::string& behind = "") {
    return refusal("Formation " + method + behind + "\nRole Goalie\nType C\n");
  };
  for (const std::string method : {"BPN", "UvA", "KNN", "CDT", "RBF", "SBSP", "NGNet", "static"}) {
    const std::string found = "its method is \"" + method + "\"; read are DelaunayTriangulation and Static";
    EXPECT_EQ(other(method), "formation: line 1, column 11: " + found);
    EXPECT_EQ(refusal("{\n  \"version\": \"1\",\n  \"method\" : \"" + method + "\", \"data\": []}"),
              "formation: line 3, column 14: " + found);
  }
  EXPECT_EQ(other("UvA", "    // 433_Offensive"),
            "formation: line 1, column 11: its method is \"UvA\"; read are DelaunayTriangulation and Static");
  EXPECT_EQ(refusal("# by hand\n\n  Formation BPN 2"),
            "formation: line 3, column 13: its method is \"BPN\"; read are DelaunayTriangulation and Static");
  EXPECT_EQ(refusal("{\"method\": 3}"),
            "formation: line 1, column 2: its method is \"3\"; read are DelaunayTriangulation and Static");
  EXPECT_EQ(refusal("Formation DelaunayTriangulation 4\n"),
            "formation: line 1, column 33: its version is 4; read are 1 to 3");
  EXPECT_EQ(refusal("# 20210624\nMethod,Static\nRoleNumber,1,2\n"),
            "formation: has the form \"Method,Static\" of librcsc; read are JSON and text that begins with "
            "\"Formation\"");
}

TEST(FormationText, AKeyStandsOnceInAnObject) {
  const std::string sound = json("Static", made_up(1, 1));
  EXPECT_EQ(refusal(sound), "read");
  EXPECT_EQ(refusal(replaced(sound, ", \"data\"", ",\n \"method\": \"Static\", \"data\"")),
            "formation: line 2, column 2: \"method\" is given twice");
  EXPECT_EQ(refusal(replaced(sound, ", \"data\"", ", \"more\": [{\"method\": 1}, {\"method\": 2}], \"data\"")), "read");
  EXPECT_EQ(refusal(replaced(sound, ", \"data\"", ",\n \"more\": {\"a\": {\"b\": {}}, \"a\": 2}, \"data\"")),
            "formation: line 2, column 27: \"a\" is given twice");
  EXPECT_EQ(refusal(replaced(sound, ", \"data\"", ",\n \"\\\"\\\\\": 1, \"\\\"\\\\\": 2, \"data\"")),
            "formation: line 2, column 13: \"\"\\\" is given twice");
  const std::string ball = sound.substr(sound.find("\"ball\""), sound.find('}') + 1 - sound.find("\"ball\""));
  EXPECT_EQ(refusal(replaced(sound, ball, ball + ",\n  " + ball)),
            "formation: line 2, column 3: \"ball\" is given twice");
}

TEST(FormationText, ALinkThatGitWroteAsTextIsNamed) {
  for (const std::string path : {"normal-formation.conf", "../formations-dt/normal-formation.conf"}) {
    for (const char* end : {"", "\n", "\r\n"}) {
      EXPECT_EQ(refusal(path + end),
                "formation: is a symbolic link of git that was checked out as text; name the file "
                "that it leads to, \"" +
                    path + "\"");
    }
  }
  EXPECT_EQ(refusal("nothing"),
            "formation: line 1, column 2: not JSON; expected a formation file of librcsc, in JSON "
            "or as text that begins with \"Formation\"");
}

TEST(FormationText, RefusedWithTheirPlace) {
  const std::vector<Picture> pictures = made_up(3, 2);
  const std::string text = version_2(pictures), old = version_1(pictures), places = fixed(pictures[0]);
  const auto changed = [&](const std::string& from, const std::string& to) {
    return refusal(replaced(text, from, to));
  };
  EXPECT_EQ(refusal("Formation"),
            "formation: line 1, column 10: the line ends; expected "
            "DelaunayTriangulation or Static");
  EXPECT_EQ(changed("Triangulation 2", "Triangulation two"),
            "formation: line 1, column 33: \"two\"; expected the version of its form, 1 to 3");
  EXPECT_EQ(changed("Begin Roles", "Roles"), "formation: line 2, column 1: \"Roles\"; expected \"Begin Roles\"");
  EXPECT_EQ(changed("3 CenterBack 2", "4 CenterBack 2"),
            "formation: line 5, column 1: \"4\"; expected \"3 ROLE PARTNER\"");
  EXPECT_EQ(changed("5 SideBack 4", "5 SideBack"),
            "formation: line 7, column 11: the line ends; expected "
            "the number of the position on the other side, or 0 or -1");
  EXPECT_EQ(changed("11 CenterForward 0\n", ""), "formation: line 13, column 1: \"End\"; expected \"11 ROLE PARTNER\"");
  EXPECT_EQ(changed("End Roles\n", ""), "formation: line 14, column 1: \"Begin\"; expected \"End Roles\"");
  EXPECT_EQ(changed("Samples 2 3", "Samples 1 3"),
            "formation: line 15, column 15: \"1\"; expected 2, the version of samples that is read");
  EXPECT_EQ(changed("Samples 2 3", "Samples 2 0"), "formation: line 15, column 17: holds no samples");
  EXPECT_EQ(changed("Samples 2 3", "Samples 2 5000"),
            "formation: line 15, column 17: has 5000 samples; at most 1000 are read");
  EXPECT_EQ(changed("Samples 2 3", "Samples 2 2"),
            "formation: line 42, column 1: \"-----\"; expected \"End Samples\" after 2 samples");
  EXPECT_EQ(changed("Samples 2 3", "Samples 2 4"),
            "formation: line 55, column 1: \"End\"; expected \"Ball X Y\" of sample 3 of 4");
  EXPECT_EQ(changed("----- 1 -----", "----- 2 -----"),
            "formation: line 29, column 7: \"2\"; expected 1, the number of the sample");
  EXPECT_EQ(changed("Ball -10 -16", "Ball -10"),
            "formation: line 30, column 9: the line ends; expected a number, y of the ball");
  EXPECT_EQ(changed("Ball -10 -16", "Ball -10 -16 3"),
            "formation: line 30, column 14: \"3\"; expected the end of the line after \"Ball X Y\"");
  EXPECT_EQ(changed("Ball -10 -16", "Ball -10 nan"),
            "formation: line 30, column 6: y is farther than 1000 m from the centre");
  EXPECT_EQ(changed("Ball -10 -16", "Ball -10 1e999"),
            "formation: line 30, column 10: \"1e999\"; expected a number, y of the ball");
  EXPECT_EQ(changed("Ball -10 -16", "Ball -20 -16"),
            "formation: the sample at line 17, column 1 and the sample at "
            "line 30, column 1 have the ball at the same place");
  EXPECT_EQ(changed("End Samples", "End"),
            "formation: line 55, column 1: \"End\"; expected \"End "
            "Samples\" after 3 samples");
  EXPECT_EQ(changed("End\n", "more\n"), "formation: line 56, column 1: \"more\"; expected \"End\"");
  EXPECT_EQ(refusal("Formation DelaunayTriangulation 3\n" + std::string(roles_2) + samples(pictures)),
            "formation: line 3, column 11: the line ends; expected the number of the position on the other "
            "side, or 0 or -1");
  EXPECT_EQ(refusal("Formation Static 2\n" + std::string(roles_2) + samples(pictures)),
            "formation: is static but has 3 samples");
  EXPECT_EQ(refusal(replaced(old, "\nEnd\n", "\n")), "formation: line 5: the file ends; expected a sample, or \"End\"");
  EXPECT_EQ(refusal(replaced(old, "Role10 0 ", "")),
            "formation: line 2, column 84: the line ends; expected \"Begin Roles\", or a name and a partner "
            "of eleven roles");
  EXPECT_EQ(refusal(replaced(places, "11 Role", "10 Role")),
            "formation: line 14, column 2: \"10\"; expected \"11 ROLE X Y\"");
  EXPECT_EQ(refusal(places + "12 Role 0 0\n"),
            "formation: line 15, column 1: \"12\"; expected the end of the file after eleven positions");
}

// One cut after the other: a refusal in one line, or all of it.
TEST(FormationText, Truncated) {
  const std::vector<Picture> pictures = made_up(2, 4);
  for (const std::string& text : {version_2(pictures), version_1(pictures)}) {
    const std::size_t whole = text.rfind("\nEnd\n");
    for (std::size_t length = 0; length < text.size(); ++length) {
      const std::string answer = refusal(text.substr(0, length));
      if (length < whole && text.substr(0, length).find("End Samples") == std::string::npos) {
        EXPECT_EQ(answer.rfind("formation: ", 0), 0u) << text.substr(0, length);
      }
      EXPECT_EQ(answer.find('\n'), std::string::npos);
    }
  }
  const std::string places = fixed(pictures[0]);
  for (std::size_t length = 0; length < places.rfind('.'); ++length) {
    EXPECT_EQ(refusal(places.substr(0, length)).rfind("formation: ", 0), 0u) << length;
  }
}

// Pieces are exchanged, doubled and taken out.
TEST(FormationText, WhateverStandsInItItIsReadOrRefused) {
  const std::vector<Picture> pictures = made_up(3, 5);
  const std::vector<std::string> texts{
      version_2(pictures), version_1(pictures), fixed(pictures[0]),
      "Formation DelaunayTriangulation 3\n" + std::string(roles_3) + samples(pictures)};
  const std::vector<std::string> pieces{"",    "\n",  "-1",   "End", "End Samples\n", "Ball",         "1e300", "-----",
                                        "nan", "+-3", "\xff", "#",   "99999999999",   "Begin Roles\n"};
  std::mt19937 random(6);
  int refused = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::string text = texts[random() % texts.size()];
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t begin = random() % text.size(), end = text.find_first_of(" \n", begin);
      text.replace(begin, end == std::string::npos ? 0 : end - begin, pieces[random() % pieces.size()]);
    }
    try {
      for (const Sample& sample : read_formation(text)) {
        ASSERT_EQ(sample.positions.size(), 11u);
        for (const Position& at : sample.positions) ASSERT_TRUE(std::abs(at.x) <= 1000.0 && std::abs(at.y) <= 1000.0);
      }
    } catch (const std::invalid_argument& error) {
      ++refused;
      const std::string why = error.what();
      ASSERT_EQ(why.rfind("formation: ", 0), 0u);
      ASSERT_EQ(why.find_first_of("\n\xff"), std::string::npos) << why;
    }
  }
  EXPECT_GT(refused, 2000);
  EXPECT_LT(refused, 4000);
}

}  // namespace
