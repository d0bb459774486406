// SPDX-License-Identifier: MIT
// What plugins drew and logged: found again in a recording, and shown without harm whatever stands there.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/errors.hpp"
#include "fuzz/recorded_match/recorded.hpp"
#include "recording/moment_svg.hpp"

namespace regista::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Told {
  const char* topic;
  double time;
  std::string text;
};

std::string of(double time, const std::string& rest, const char* whose = R"("side":"home","robot":1)") {
  return fmt::format(R"({{"time":{},{},)", time, whose) + rest + '}';
}
// A message of /draw of home 1.
Told drawn(double time, const std::string& layer, const std::string& shapes, const std::string& plugin = "voronoi") {
  return {"/draw", time,
          of(time, R"("plugin":")" + plugin + R"(","layer":")" + layer + R"(","shapes":[)" + shapes + ']')};
}
Told logged(double time, const std::string& text, const std::string& level = "info") {
  return {"/log", time, of(time, R"("plugin":"voronoi","level":")" + level + R"(","text":")" + text + '"')};
}

const std::string dots = R"({"shape":"points","at":[[1,2],[-3,0.5]]})";
const std::string triangle = R"({"shape":"polygon","at":[[0,0],[2,0],[0,2]],"colour":"#cc79A780","filled":true})";

std::size_t count(std::string_view text, std::string_view what) {
  std::size_t out = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1)) ++out;
  return out;
}

class DrawingsTest : public testing::Test {
 protected:
  DrawingsTest()
      : file_((access("/dev/shm", W_OK) == 0 ? "/dev/shm/drawings_" : testing::TempDir() + "drawings_") +
              std::to_string(getpid()) + ".mcap") {}
  ~DrawingsTest() override { std::filesystem::remove(file_); }

  // A match of 100 s with these messages in it; a state of the game each second, what a robot decides at the first.
  void write(const std::vector<Told>& told) const {
    const RecordedTexts texts;
    mcap::Writer writer(file_, {.replace = true});
    writer.write(mcap::Metadata{"match",
                                {{"format", "1"},
                                 {"program", "regista"},
                                 {"field", texts.field},
                                 {"ball_radius", "0.05"},
                                 {"home", texts.team},
                                 {"away", texts.team}}});
    std::map<std::string, mcap::ChannelId> channels;
    const auto put = [&](const std::string& topic, double time, const std::string& text) {
      const auto when = static_cast<std::uint64_t>(std::llround(time * 1e9));
      const auto [channel, added] = channels.try_emplace(topic);
      if (added) channel->second = writer.add_channel(topic, "json");
      writer.write({channel->second, 0, when, when, text});
    };
    put("/decision/home/1", 1.0, texts.decision);
    put("/belief/home/1", 1.0, texts.belief);
    for (int second = 1; second <= 100; ++second) {
      std::string game = texts.game;
      game.replace(game.find("\"time\":1"), 8, "\"time\":" + std::to_string(second));
      put("/game", second, game);
      for (const Told& each : told) {
        if (each.time >= second && each.time < second + 1) put(each.topic, each.time, each.text);
      }
      writer.finish_chunk();
    }
    writer.close();
  }
  RecordedMoment at(double time, const std::optional<RobotName>& robot = RobotName{0, 1}) const {
    return RecordedMatch(file_).at(time, robot);
  }
  std::string picture(double time) const {
    const RecordedMatch match(file_);
    const RobotName robot{0, 1};
    return moment_svg(match, match.at(time, robot), robot);
  }
  std::string refusal(double time = 100.0) const {
    try {
      at(time);
    } catch (const mcap::Error& error) {
      return error.what();
    }
    return "";
  }
  std::filesystem::path file_;
};

std::vector<std::string> names(const std::vector<RecordedDrawing>& drawings) {
  std::vector<std::string> out;
  for (const RecordedDrawing& each : drawings) {
    out.push_back(each.name() + " " + std::to_string(each.shapes.size()));
  }
  return out;
}

TEST_F(DrawingsTest, ReadsShapes) {
  write({drawn(2.0, "cells",
               dots + ',' + triangle + R"(,{"shape":"line","at":[[0,1],[1,1]],"width":0.05})" +
                   R"(,{"shape":"text","at":[[1,1]],"text":"a \"b\"","colour":"#00000000"})")});
  const std::vector<RecordedDrawing> found = at(2.0).drawings;
  ASSERT_THAT(names(found), ElementsAre("voronoi: cells 4"));
  const std::vector<RecordedShape>& shapes = found[0].shapes;
  using Kind = RecordedShape::Kind;
  EXPECT_EQ(shapes[0].kind, Kind::points);
  EXPECT_THAT(shapes[0].at, ElementsAre(std::array{1.0, 2.0}, std::array{-3.0, 0.5}));
  EXPECT_FALSE(shapes[0].colour || shapes[0].width || shapes[0].filled);
  EXPECT_EQ(shapes[1].kind, Kind::polygon);
  EXPECT_TRUE(shapes[1].filled);
  EXPECT_EQ(shapes[1].colour, (RecordedColour{0xcc, 0x79, 0xa7, 0x80}));
  EXPECT_EQ(shapes[2].kind, Kind::line);
  EXPECT_EQ(shapes[2].width, 0.05);
  EXPECT_EQ(shapes[3].kind, Kind::text);
  EXPECT_EQ(shapes[3].text, "a \"b\"");
  EXPECT_EQ(shapes[3].colour, (RecordedColour{0, 0, 0, 0}));
}

TEST_F(DrawingsTest, WhatWasDrawnLastStands) {
  write({drawn(2.0, "cells", dots), drawn(3.0, "axes", triangle), drawn(4.0, "cells", dots + ',' + dots),
         drawn(5.0, "cells", dots, "gap"), drawn(50.0, "cells", ""), drawn(60.0, "late", dots)});
  EXPECT_THAT(names(at(1.0).drawings), IsEmpty());
  EXPECT_THAT(names(at(2.0).drawings), ElementsAre("voronoi: cells 1"));
  EXPECT_THAT(names(at(3.9).drawings), ElementsAre("voronoi: cells 1", "voronoi: axes 1"));
  EXPECT_THAT(names(at(49.0).drawings), ElementsAre("voronoi: cells 2", "voronoi: axes 1", "gap: cells 1"));
  EXPECT_THAT(names(at(55.0).drawings), ElementsAre("voronoi: cells 0", "voronoi: axes 1", "gap: cells 1"));
}

TEST_F(DrawingsTest, AreOfOneRobot) {
  std::vector<Told> told{drawn(2.0, "cells", dots), logged(2.0, "mine")};
  for (const char* whose : {R"("side":"away","robot":1)", R"("side":"home","robot":2)"}) {
    told.push_back({"/draw", 2.0, of(2.0, R"("plugin":"other","layer":"l","shapes":[])", whose)});
    told.push_back({"/log", 2.0, of(2.0, R"("plugin":"other","level":"info","text":"theirs")", whose)});
  }
  // What is of others is not read further than to that.
  told.push_back({"/draw", 2.0, R"({"side":"home","robot":2,"plugin":"p","layer":"l","shapes":[[[)"});
  // In another order the same.
  told.push_back(
      {"/draw", 3.0,
       R"({"shapes":[{"at":[],"shape":"line","side":7}],"layer":"m","robot":1,"plugin":"p","side":"home"})"});
  write(told);
  EXPECT_THAT(names(at(9.0).drawings), ElementsAre("voronoi: cells 1", "p: m 1"));
  EXPECT_EQ(at(2.5).log.size(), 1u);
  EXPECT_THAT(names(at(9.0, RobotName{1, 1}).drawings), ElementsAre("other: l 0"));
  EXPECT_THAT(at(9.0, std::nullopt).drawings, IsEmpty());
}

TEST_F(DrawingsTest, LogHoldsTheLastLinesOfTwoSeconds) {
  std::vector<Told> told;
  for (const double time : {9.9, 10.1, 10.2, 10.3, 10.4, 10.5, 10.6})
    told.push_back(logged(time, fmt::format("at {}", time)));
  told.push_back(logged(30.0, "late", "warning"));
  write(told);
  const auto texts = [&](double time) {
    std::vector<std::string> out;
    for (const RecordedLogLine& line : at(time).log) out.push_back(line.level + ' ' + line.text);
    return out;
  };
  EXPECT_THAT(texts(9.0), IsEmpty());
  EXPECT_THAT(texts(10.2), ElementsAre("info at 9.9", "info at 10.1", "info at 10.2"));
  EXPECT_THAT(texts(10.6), ElementsAre("info at 10.2", "info at 10.3", "info at 10.4", "info at 10.5", "info at 10.6"));
  EXPECT_THAT(texts(12.45), ElementsAre("info at 10.5", "info at 10.6"));
  EXPECT_THAT(texts(13.0), IsEmpty());
  EXPECT_THAT(texts(30.0), ElementsAre("warning late"));
}

TEST_F(DrawingsTest, WhatCannotBeReadIsRefused) {
  for (const char* shape : {"7",
                            "{}",
                            R"({"shape":"circle","at":[]})",
                            R"({"shape":"line"})",
                            R"({"shape":"line","at":[[1]]})",
                            R"({"shape":"line","at":[[1,2,3]]})",
                            R"({"shape":"line","at":[[1,null]]})",
                            R"({"shape":"line","at":[["1",2]]})",
                            R"({"shape":"line","at":[[1,1e999]]})",
                            R"({"shape":"line","at":{}})",
                            R"({"shape":"line","at":[],"colour":"red"})",
                            R"({"shape":"line","at":[],"colour":"#12345"})",
                            R"({"shape":"line","at":[],"colour":"#-2345678"})",
                            R"({"shape":"line","at":[],"colour":"\" onload=\""})",
                            R"({"shape":"line","at":[],"width":-1})",
                            R"({"shape":"line","at":[],"width":"1"})",
                            R"({"shape":"polygon","at":[],"filled":1})",
                            R"({"shape":"text","at":[],"text":"a"})",
                            R"({"shape":"text","at":[[1,2],[3,4]],"text":"a"})",
                            R"({"shape":"text","at":[[1,2]]})",
                            R"({"shape":"text","at":[[1,2]],"text":1})"}) {
    write({drawn(2.0, "cells", shape)});
    EXPECT_EQ(refusal(), file_.string() + ": is damaged: a message of /draw cannot be read") << shape;
    EXPECT_EQ(refusal(1.0), "");
  }
  for (const char* message : {"", "7", "[]", "{}", R"({"side":"home","robot":1,"plugin":"p"})",
                              R"({"side":"north","robot":1,"plugin":"p","layer":"l"})",
                              R"({"side":"home","robot":-1,"plugin":"p","layer":"l"})",
                              R"({"side":"home","robot":99999999999,"plugin":"p","layer":"l"})",
                              R"({"side":"home","robot":"1","plugin":"p","layer":"l","shapes":[]})",
                              R"({"side":"home","robot":1,"plugin":"p","layer":"l"})",
                              R"({"side":"home","robot":1,"plugin":"p","layer":"l","shapes":{}})",
                              R"({"side":"home","robot":1,"plugin":"p","layer":"l","shapes":[})"}) {
    write({{"/draw", 2.0, message}});
    EXPECT_EQ(refusal(), file_.string() + ": is damaged: a message of /draw cannot be read") << message;
  }
  for (const char* message : {"", "{}", R"({"side":"home","robot":1})",
                              R"({"time":"2","side":"home","robot":1,"plugin":"p","level":"info","text":"a"})",
                              R"({"time":2,"side":"home","robot":1,"plugin":"p","level":"info","text":null})"}) {
    write({{"/log", 2.0, message}});
    EXPECT_EQ(refusal(2.0), file_.string() + ": is damaged: a message of /log cannot be read") << message;
    EXPECT_EQ(refusal(9.0), "") << "nobody asks for it";
  }
}

TEST_F(DrawingsTest, PictureShowsLayersBelowTheRobotsAndInTheLegend) {
  write({drawn(2.0, "cells", dots + ',' + triangle),
         drawn(2.0, "axes", R"({"shape":"line","at":[[0,0],[1,0]]})", "gap")});
  const std::string shown = picture(2.0);
  EXPECT_THAT(shown, HasSubstr(">voronoi: cells</text>"));
  EXPECT_THAT(shown, HasSubstr(">gap: axes</text>"));
  EXPECT_EQ(count(shown, R"(<g class="layer")"), 2u);
  EXPECT_GT(shown.find(R"(<g class="layer")"), shown.find(R"(class="grass")"));
  EXPECT_LT(shown.rfind(R"(<g class="layer")"), shown.find(R"(<g class="robot)"));
  EXPECT_THAT(shown, HasSubstr(R"(fill="#cc79a7" fill-opacity="0.50")"));
  // Taken away: no drawing, no entry, and the other keeps its colour.
  const auto colour_of_axes = [](const std::string& svg) {
    const std::size_t place = svg.find(R"( stroke="#)", svg.rfind(R"(<g class="layer")"));
    return svg.substr(place, 17);
  };
  write({drawn(2.0, "cells", dots), drawn(2.0, "axes", R"({"shape":"line","at":[[0,0],[1,0]]})", "gap"),
         drawn(3.0, "cells", "")});
  const std::string later = picture(3.0);
  EXPECT_THAT(later, Not(HasSubstr("voronoi: cells")));
  EXPECT_EQ(count(later, R"(<g class="layer")"), 1u);
  EXPECT_EQ(colour_of_axes(later), colour_of_axes(shown));
  EXPECT_EQ(count(later, R"(class="swatch")"), 1u);
}

TEST_F(DrawingsTest, ManyLayersHaveALegendThatEnds) {
  std::vector<Told> told;
  for (int i = 0; i < 40; ++i)
    told.push_back(drawn(2.0, "layer " + std::to_string(i), R"({"shape":"line","at":[[0,0],[1,0]]})"));
  write(told);
  const std::string shown = picture(2.0);
  EXPECT_EQ(count(shown, ">voronoi: layer "), 24u);
  EXPECT_THAT(shown, HasSubstr("and 16 more layers"));
  EXPECT_EQ(count(shown, R"(<g class="layer")"), 40u);
  EXPECT_GT(count(shown, "stroke-dasharray=\"7 4\""), 0u);
}

// All numbers of attributes, but for the SVG's own sizes, lie near the picture.
void expect_numbers_within(const std::string& svg, double most) {
  const std::size_t begin = svg.find("</style>");
  for (std::size_t i = begin; i < svg.size(); ++i) {
    const bool starts =
        (std::isdigit(static_cast<unsigned char>(svg[i])) != 0) &&
        (std::isalnum(static_cast<unsigned char>(svg[i - 1])) == 0 || svg[i - 1] == 'M' || svg[i - 1] == 'L') &&
        svg[i - 1] != '.' && svg[i - 1] != '#';
    if (!starts) continue;
    ASSERT_LT(std::stod(svg.substr(i, 400)), most) << svg.substr(i, 100);
  }
}

TEST_F(DrawingsTest, FarPointsDoNotSpoilThePicture) {
  for (const std::string far : {"1e6", "1e300", "1.7e308"}) {
    const std::string around =
        "[[-" + far + ",-" + far + "],[" + far + ",-" + far + "],[" + far + "," + far + "],[-" + far + "," + far + "]]";
    std::string shapes;
    for (const char* kind : {"points", "line", "polygon"}) {
      shapes += R"({"shape":")" + std::string(kind) + R"(","at":)" + around + R"(,"filled":true},)";
      shapes += R"({"shape":")" + std::string(kind) + R"(","at":)" + around + R"(,"width":)" + far + "},";
    }
    shapes += R"({"shape":"line","at":[[0,0],[)" + far + ",-" + far + R"(]]},)";
    shapes += R"({"shape":"text","at":[[)" + far + R"(,0]],"text":"far away"})";
    write({drawn(2.0, "cells", shapes)});
    const std::string shown = picture(2.0);
    EXPECT_EQ(shown.find("nan"), std::string::npos);
    EXPECT_EQ(shown.find("inf"), std::string::npos);
    EXPECT_THAT(shown, Not(HasSubstr("far away")));
    EXPECT_LT(shown.size(), 20'000u);
    expect_numbers_within(shown, 3000.0);
  }
}

TEST_F(DrawingsTest, HostileTextsDoNoHarm) {
  const std::string hostile = R"(</text><script>alert(1)</script>\u202e\n\"&)" + std::string(300, 'W');
  write({drawn(2.0, hostile, R"({"shape":"text","at":[[0,0]],"text":")" + hostile + R"("})", hostile),
         {"/log", 2.0,
          of(2.0, R"("plugin":")" + hostile + R"(","level":")" + hostile + R"(","text":")" + hostile + '"')}});
  const std::string shown = picture(2.0);
  EXPECT_THAT(shown, Not(HasSubstr("<script")));
  EXPECT_THAT(shown, Not(HasSubstr("\xe2\x80\xae")));
  EXPECT_THAT(shown, HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(shown, Not(HasSubstr(std::string(61, 'W'))));
}

TEST_F(DrawingsTest, LogStandsAtTheFootOfThePanel) {
  const std::string word = "\xe4\xb8\x96";  // as wide as two letters
  std::string wide;
  for (int i = 0; i < 60; ++i) wide += word;
  write({logged(2.0, "two cells are empty", "warning"), logged(2.0, std::string(200, 'x')), logged(2.0, wide, "error"),
         logged(2.0, "short", "debug")});
  const std::string shown = picture(2.0);
  EXPECT_THAT(shown, HasSubstr(">0:02.0 warning voronoi: two cells are empty</text>"));
  EXPECT_THAT(shown, HasSubstr(">0:02.0 debug voronoi: short</text>"));
  // 62 columns each.
  EXPECT_THAT(shown, HasSubstr(">0:02.0 voronoi: " + std::string(43, 'x') + "...</text>"));
  std::string cut = ">0:02.0 error voronoi: ";
  for (int i = 0; i < 18; ++i) cut += word;
  EXPECT_THAT(shown, HasSubstr(cut + "...</text>"));
  EXPECT_THAT(picture(9.0), Not(HasSubstr("Log of its plugins")));
}

std::string refused(std::vector<RecordedDrawing> drawings, const std::vector<std::string>& typed) {
  try {
    keep_layers(drawings, typed);
  } catch (const config::BadInput& error) {
    return error.what();
  }
  std::string out;
  for (const std::string& name : names(drawings)) out += name + '\n';
  return out;
}

TEST(KeepLayers, LeavesThoseThatAreNamed) {
  const std::vector<RecordedDrawing> all{
      {"voronoi", "cells", {{}}}, {"voronoi", "axes", {{}, {}}}, {"gap", "cells", {}}, {"gap", "a: b", {{}}}};
  EXPECT_EQ(refused(all, {}), "voronoi: cells 1\nvoronoi: axes 2\ngap: cells 0\ngap: a: b 1\n");
  EXPECT_EQ(refused(all, {"cells"}), "voronoi: cells 1\nvoronoi: axes 0\ngap: cells 0\ngap: a: b 0\n");
  EXPECT_EQ(refused(all, {"voronoi: axes", "a: b"}), "voronoi: cells 0\nvoronoi: axes 2\ngap: cells 0\ngap: a: b 1\n");
  EXPECT_EQ(
      refused(all, {"cells", "cels"}),
      "--layer: unknown layer \"cels\" in the drawings of this robot; nearest: \"cells\"; known: cells, axes, a: b");
  EXPECT_EQ(refused(all, {"voronoi: axe"}),
            "--layer: unknown layer \"voronoi: axe\" in the drawings of this robot; nearest: \"voronoi: axes\"; "
            "known: voronoi: cells, voronoi: axes, gap: cells, gap: a: b");
  EXPECT_EQ(refused({}, {"cells"}), "--layer \"cells\": no plugin of this robot has drawn anything by then");
  EXPECT_EQ(refused({}, {}), "");
  EXPECT_EQ(refused({{"p", std::string(500, 'a') + "\n", {}}}, {"b"}),
            "--layer: unknown layer \"b\" in the drawings of this robot; known: " + std::string(60, 'a') + "...");
}

// Pieces of a message are taken out, doubled, or replaced by what JSON knows else.
TEST_F(DrawingsTest, WhateverStandsInAMessageItIsShownOrRefused) {
  const std::vector<std::string> others{"null", "-1",   "1e300", "1e999", "\"x\"", "[]",
                                        "{}",   "true", "0",     "[[]]",  "-3.5",  ""};
  std::mt19937 random(12);
  const auto below = [&](std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
  };
  const Told sound =
      drawn(2.0, "cells", dots + ',' + triangle + R"(,{"shape":"text","at":[[1,1]],"text":"a","width":0.1})");
  int refusals = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Told told = trial % 4 == 0 ? logged(2.0, "a") : sound;
    for (std::size_t changes = 1 + below(2); changes > 0; --changes) {
      const std::size_t begin = told.text.find_first_of(",:[{", below(told.text.size()));
      if (begin == std::string::npos) continue;
      const std::size_t end = std::min(told.text.find_first_of(",]}", begin + 1), told.text.size());
      told.text.replace(begin + 1, end - begin - 1, others[below(others.size())]);
    }
    write({told});
    const std::string line = refusal(2.0);
    refusals += line.empty() ? 0 : 1;
    ASSERT_EQ(line.find('\n'), std::string::npos);
    if (!line.empty()) continue;
    ASSERT_EQ(picture(2.0).find("nan"), std::string::npos) << told.text;
  }
  EXPECT_GT(refusals, 100);
  EXPECT_LT(refusals, 950);
}

}  // namespace
}  // namespace regista::recording
