// SPDX-License-Identifier: MIT
// The pictures of charts, read back by a reader of their own and measured: what is drawn lies where the axes say.
#include "report/figure.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "course.hpp"
#include "picture.hpp"
#include "report/tournament_history.hpp"
#include "report/tournament_report.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// --- Charts ----------------------------------------------------------------------------------------------------------

Figure figure_of(const Chart& chart) {
  return {.name = "fig", .title = "A \"title\" <b>", .description = "What it shows", .chart = chart};
}
Chart chart_of(const Series& series) { return {.panels = {{{}, {series}}}}; }
std::vector<Element> drawn(const Chart& chart) { return read(svg(figure_of(chart), Medium::file).str()); }

Series dots(std::vector<Point> points) { return {.points = std::move(points), .shape = Shape::circle}; }

TEST(Figure, PointsLieWhereTheAxesSay) {
  for (const double scale : {1e-6, 0.01, 1.0, 37.0, 2.5e7}) {
    const std::vector<Point> points{{0.0, -3.0 * scale}, {1.5, 2.0 * scale}, {4.0, 7.1 * scale}};
    const std::vector<Element> picture = drawn(chart_of(dots(points)));
    const std::vector<Place> x = ticks_of(picture, true), y = ticks_of(picture, false);
    ASSERT_GT(x.size(), 2u);
    ASSERT_GT(y.size(), 2u);
    EXPECT_GT(y.front().at, y.back().at);  // upwards
    const std::vector<Element> circles = all(picture, "circle");
    ASSERT_EQ(circles.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(circles[i].number("cx"), expected(x, points[i].x), 0.3) << scale;
      EXPECT_NEAR(circles[i].number("cy"), expected(y, points[i].y), 0.3) << scale;
    }
  }
}

TEST(Figure, LogarithmicAxesHavePowersOfTen) {
  Chart chart = chart_of(dots({{0.02, 1.0}, {1.0, 2.0}, {700.0, 3.0}}));
  chart.panels[0].x.logarithmic = true;
  const std::vector<Element> picture = drawn(chart);
  const std::vector<Place> x = ticks_of(picture, true);
  for (const double power : {0.1, 1.0, 10.0, 100.0}) {
    EXPECT_TRUE(std::ranges::any_of(x, [&](const Place& each) { return each.value == power; })) << power;
  }
  for (const Place& each : x) EXPECT_NEAR(each.at, expected(x, each.value, true), 0.2) << each.value;
  EXPECT_NEAR(all(picture, "circle")[1].number("cx"), expected(x, 1.0, true), 0.2);
}

TEST(Figure, WhatIsNoNumberIsLeftOut) {
  const double none = unknown, endless = HUGE_VAL;
  Series series = dots({{0.0, 1.0},
                        {1.0, 2.0},
                        {2.0, none},
                        {3.0, endless},
                        {none, 1.0},
                        {4.0, 1.0},
                        {5.0, 2.0},
                        {6.0, endless},
                        {7.0, 2.0},
                        {8.0, 1.0},
                        {9.0, -endless}});
  series.join = Join::line;
  const std::vector<Element> picture = drawn(chart_of(series));
  EXPECT_EQ(all(picture, "circle").size(), 6u);
  EXPECT_EQ(segments(picture, "#0072b2").size(), 3u);  // interrupted
  for (const Join join : {Join::line, Join::steps}) {
    series.join = join;
    const std::vector<Element> joined = drawn(chart_of(series));
    const std::vector<Place> y = ticks_of(joined, false);
    for (const Segment& each : segments(joined, "#0072b2")) {  // none goes on to the edge
      EXPECT_GE(std::min(each.y0, each.y1), expected(y, 2.0) - 0.3);
      EXPECT_LE(std::max(each.y0, each.y1), expected(y, 1.0) + 0.3);
    }
  }
  series.join = Join::line;
  Chart logarithmic = chart_of(series);
  logarithmic.panels[0].x.logarithmic = true;
  EXPECT_EQ(all(drawn(logarithmic), "circle").size(), 5u);  // 0 has no logarithm
  for (const Chart& chart : {chart_of(series), logarithmic}) {
    EXPECT_THAT(svg(figure_of(chart), Medium::page).str(), AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
  }
}

TEST(Figure, IntervalsReachToTheirEnds) {
  Series bars = dots(
      {{1.0, 5.0, 4.0, 7.0}, {2.0, 5.0, -HUGE_VAL, 6.0}, {3.0, 5.0, -HUGE_VAL, HUGE_VAL}, {4.0, 5.0, unknown, 6.0}});
  bars.interval = Interval::whiskers;
  Chart chart = chart_of(bars);
  chart.y.range = Range{0.0, 10.0};
  std::vector<Element> picture = drawn(chart);
  const std::vector<Place> y = ticks_of(picture, false);
  std::vector<Segment> upright;
  std::ranges::copy_if(segments(picture, "#0072b2"), std::back_inserter(upright),
                       [](const Segment& each) { return each.x0 == each.x1; });
  ASSERT_EQ(upright.size(), 2u);  // the third has no end, one of the fourth is not known
  EXPECT_NEAR(upright[0].y0, expected(y, 4.0), 0.2);
  EXPECT_NEAR(upright[0].y1, expected(y, 7.0), 0.2);
  EXPECT_NEAR(upright[1].y0, expected(y, 0.0), 0.2);  // to the edge
  EXPECT_NEAR(upright[1].y1, expected(y, 6.0), 0.2);

  chart.panels[0].series[0].interval = Interval::band;
  picture = drawn(chart);
  const auto band =
      std::ranges::find_if(picture, [](const Element& each) { return each.attributes.contains("fill-opacity"); });
  ASSERT_NE(band, picture.end());
  EXPECT_THAT(band->attributes.at("d"), HasSubstr(fmt::format(" {:.1f}", expected(y, 0.0))));
}

TEST(Figure, BarsBeginAtZero) {
  Series bars{.points = {{1.0, 30.0}, {2.0, 12.0}, {3.0, 0.0}, {4.0, 9.0, 3.0}}, .bar = 0.8};
  const std::vector<Element> upright = drawn(chart_of(bars));
  const std::vector<Place> y = ticks_of(upright, false);
  EXPECT_EQ(y.front().value, 0.0);
  std::vector<Element> rects = all(upright, "rect");
  rects.erase(rects.begin());   // the sheet
  ASSERT_EQ(rects.size(), 3u);  // no bar of nothing
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_NEAR(rects[i].number("y"), expected(y, bars.points[i].y), 0.2);
    EXPECT_NEAR(rects[i].number("y") + rects[i].number("height"), y.front().at, 0.2);
  }
  EXPECT_NEAR(rects[2].number("y") + rects[2].number("height"), expected(y, 3.0), 0.2);  // on top of another one

  for (Point& each : bars.points) std::swap(each.x, each.y);
  Chart rows{.rows = {"a", "b", "c", "d", "e"}, .panels = {{{}, {bars}}, {{}, {bars}}}};
  const std::vector<Element> flat = drawn(rows);
  rects = all(flat, "rect");
  ASSERT_EQ(rects.size(), 7u);
  EXPECT_NEAR(rects[1].number("width") / rects[2].number("width"), 30.0 / 12.0, 0.02);
  EXPECT_NEAR(rects[1].number("height"), 0.8 * rows.height / 5.0, 0.2);
  EXPECT_LT(rects[1].number("x") + rects[1].number("width"), rects[4].number("x"));  // panels lie beside each other
}

TEST(Figure, WhatLiesOutsideIsCutOff) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    std::normal_distribution<double> value(0.0, 3.0);
    Series series{
        .join = round % 2 == 0 ? Join::line : Join::steps, .shape = Shape::circle, .interval = Interval::band};
    for (int i = 0; i < 12; ++i) {
      const double y = value(random), wide = std::abs(value(random));
      series.points.push_back({static_cast<double>(i), y, y - wide, i % 5 == 0 ? HUGE_VAL : y + wide});
    }
    Chart chart = chart_of(series);
    chart.y.range = Range{-1.0, 1.0};
    const std::vector<Element> picture = drawn(chart);
    const std::vector<Place> y = ticks_of(picture, false);
    const double top = expected(y, 1.0) - 0.2, bottom = expected(y, -1.0) + 0.2;
    std::size_t inside = 0;
    for (const Segment& each : segments(picture, "#0072b2")) {
      EXPECT_TRUE(each.y0 >= top && each.y0 <= bottom && each.y1 >= top && each.y1 <= bottom);
    }
    for (const Point& each : series.points) inside += each.y >= -1.0 && each.y <= 1.0;
    EXPECT_EQ(all(picture, "circle").size(), inside);
  }
}

// An interval may reach below what can be; the axis of bars does not.
TEST(Figure, WhiskersOfBarsEndAtZero) {
  const Series bars{.points = {{5.0, 0.0}}, .bar = 0.5};
  const Series whiskers{.colour = 1, .points = {{5.0, 0.0, -20.0, 9.0}}, .interval = Interval::whiskers};
  const std::vector<Element> picture = drawn({.rows = {"a"}, .panels = {{{}, {bars, whiskers}}}});
  const std::vector<Place> x = ticks_of(picture, true);
  EXPECT_EQ(x.front().value, 0.0);
  EXPECT_NEAR(all(picture, "rect").at(1).number("x"), x.front().at, 0.2);
  const Segment whisker = segments(picture, "#d55e00").at(0);
  EXPECT_NEAR(whisker.x0, x.front().at, 0.2);
  EXPECT_NEAR(whisker.x1, expected(x, 9.0), 0.2);
}

// Up to the edge, not only to the last point before it.
TEST(Figure, LinesAreCutAtTheEdge) {
  Chart chart = chart_of({.points = {{0.0, 0.0}, {2.0, 4.0}, {4.0, -4.0}, {5.0, 0.0}}, .join = Join::line});
  chart.y.range = Range{-1.0, 1.0};
  chart.panels[0].x.range = Range{0.0, 5.0};
  const std::vector<Element> picture = drawn(chart);
  const std::vector<Place> x = ticks_of(picture, true), y = ticks_of(picture, false);
  // Where 0 -> 4 -> -4 -> 0 meets 1 and -1.
  const std::vector<Segment> expected_parts{{0.0, 0.0, 0.5, 1.0}, {2.75, 1.0, 3.25, -1.0}, {4.75, -1.0, 5.0, 0.0}};
  const std::vector<Segment> parts = segments(picture, "#0072b2");
  ASSERT_EQ(parts.size(), expected_parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_NEAR(parts[i].x0, expected(x, expected_parts[i].x0), 0.3);
    EXPECT_NEAR(parts[i].y0, expected(y, expected_parts[i].y0), 0.3);
    EXPECT_NEAR(parts[i].x1, expected(x, expected_parts[i].x1), 0.3);
    EXPECT_NEAR(parts[i].y1, expected(y, expected_parts[i].y1), 0.3);
  }
}

// --- Ticks and texts -------------------------------------------------------------------------------------------------

TEST(Figure, TicksAreEvenAndApart) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-8.0, 9.0), offset(-3.0, 3.0), length(60.0, 1100.0);
  for (int round = 0; round < 5000; ++round) {
    const double wide = std::pow(10.0, exponent(random)), low = offset(random) * wide * (round % 3 == 0 ? 100.0 : 1.0);
    const bool upright = round % 2 == 0;
    const Scale scale{{low, low + wide}, false, 50.0, 50.0 + length(random)};
    const std::vector<Tick> found = ticks(scale, false, upright);
    ASSERT_GE(found.size(), scale.end - scale.begin > 400.0 ? 2u : 1u) << low << ' ' << wide;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_GE(found[i].at, low - 1e-6 * wide);
      EXPECT_LE(found[i].at, low + wide * (1.0 + 1e-6));
      if (i == 0) continue;
      const double step = found[i].at - found[i - 1].at;
      const double digit = step / std::pow(10.0, std::floor(std::log10(step * (1.0 + 1e-6))));
      EXPECT_LT(std::min({std::abs(digit - 1.0), std::abs(digit - 2.0), std::abs(digit - 5.0)}), 1e-5) << step;
      EXPECT_NEAR(std::stod(found[i].text), found[i].at, 1e-4 * step) << found[i].text;
      const double apart = scale.at(found[i].at) - scale.at(found[i - 1].at);
      // Letters are 14 units high and less than 8 wide.
      const auto letters = static_cast<double>(found[i].text.size() + found[i - 1].text.size());
      EXPECT_GT(apart, upright ? 15.0 : 4.0 * letters + 4.0) << found[i].text;
    }
  }
  for (const auto& [high, most] : std::vector<std::pair<double, double>>{{3.0, 3.0}, {0.4, 0.0}, {1234.0, 1200.0}}) {
    const std::vector<Tick> whole = ticks({{0.0, high}, false, 0.0, 600.0}, true, false);
    for (const Tick& each : whole) EXPECT_EQ(each.at, std::round(each.at));
    EXPECT_EQ(whole.back().at, most);
  }
}

TEST(Figure, LogarithmicTicksAreApart) {
  for (double low = 1e-9; low < 1e6; low *= 7.3) {
    for (double times = 1.1; times < 1e12; times *= 2.9) {
      const Scale scale{{low, low * times}, true, 0.0, 500.0};
      const std::vector<Tick> found = ticks(scale, false, false);
      ASSERT_GE(found.size(), 1u);
      EXPECT_LE(found.size(), 30u);
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(std::stod(found[i].text) / found[i].at, 1.0, 1e-3) << found[i].text;
        if (i == 0) continue;
        EXPECT_GT(scale.at(found[i].at) - scale.at(found[i - 1].at), 20.0);
      }
    }
  }
}

struct Box {
  double left, top, right, bottom;
};

// As wide as a sans-serif font draws it, which is less than the painter allows for.
Box box_of(const Element& text) {
  double x = 0.0, y = 0.0;
  const bool turned = text.attributes.contains("transform");
  if (turned) {
    const std::string& how = text.attributes.at("transform");
    std::size_t end = 0;
    x = std::stod(how.substr(10), &end);
    y = std::stod(how.substr(10 + end));
  } else {
    x = text.number("x");
    y = text.number("y");
  }
  const std::string& anchor = text.attributes.at("text-anchor");
  const double width = 7.4 * static_cast<double>(text.text.size());
  const double before = anchor == "start" ? 0.0 : anchor == "middle" ? 0.5 * width : width;
  return turned ? Box{x - 11.0, y - width + before, x + 3.0, y + before}
                : Box{x - before, y - 11.0, x - before + width, y + 3.0};
}

TEST(Figure, TextsNeverMeetAndAreNotCut) {
  const auto name = [](std::size_t letters, std::size_t i) { return std::string(letters, 'm') + std::to_string(i); };
  for (const std::size_t letters : {1u, 9u, 30u, 60u}) {
    for (const std::size_t count : {1u, 3u, 9u}) {
      for (const bool rows : {false, true}) {
        for (const double times : {1.0, 1e-7, 123456.789}) {
          Chart chart{.y = {.title = rows ? "" : in_title(name(letters, 0)) + ", per match"},
                      .width = rows ? page_width : 620.0};
          chart.panels.resize(rows ? 3 : 1);
          for (std::size_t i = 0; i < count; ++i) {
            if (rows) chart.rows.push_back(name(letters, i));
            for (Panel& panel : chart.panels) {
              panel.x.title = "goals of " + in_title(name(letters, 0)) + " less goals of " + in_title(name(letters, 1));
              panel.series.push_back({.name = name(letters, i), .colour = i, .shape = shape_of(i)});
              panel.series.back().points = {{1.0 * times, static_cast<double>(i)}, {9.0 * times, 0.5}};
            }
          }
          const std::vector<Element> picture = drawn(chart);
          const Element& sheet = picture.front();
          std::vector<Box> boxes;
          for (const Element& each : all(picture, "text")) {
            const Box box = box_of(each);
            EXPECT_TRUE(box.left >= 0.0 && box.top >= 0.0 && box.right <= sheet.number("width") &&
                        box.bottom <= sheet.number("height"))
                << each.text;
            for (const Box& other : boxes) {
              EXPECT_FALSE(box.left < other.right && other.left < box.right && box.top < other.bottom &&
                           other.top < box.bottom)
                  << each.text << ' ' << letters << ' ' << count << ' ' << rows << ' ' << times;
            }
            boxes.push_back(box);
          }
        }
      }
    }
  }
}

TEST(Figure, TheLastNumberOfAnAxisIsNotCut) {
  for (const double high : {1e-5, 10.0, 100000.0, 5e8}) {
    Chart chart = chart_of(dots({{0.0, 0.0}, {high, 1.0}}));
    chart.panels[0].x.range = Range{0.0, high};
    const std::vector<Element> picture = drawn(chart);
    for (const Element& each : all(picture, "text")) EXPECT_LE(box_of(each).right, 620.0) << each.text;
    const std::vector<Place> x = ticks_of(picture, true);
    EXPECT_NEAR(all(picture, "circle")[1].number("cx"), expected(x, high), 0.3);
  }
}

TEST(Figure, LinesBreakWhereTheyCan) {
  EXPECT_THAT(in_lines("uncovered_seconds, min per 60 min", 230.0),
              ElementsAre("uncovered_seconds,", "min per 60 min"));
  EXPECT_THAT(in_lines("short", 100.0), ElementsAre("short"));
  EXPECT_TRUE(in_lines("", 100.0).empty());
  EXPECT_THAT(in_lines("weights.bearing", 90.0), ElementsAre("weights.", "bearing"));
  for (const char* word : {"mmmmmmmmmmmmmmmmmmmmmmm", "שלוםשלוםשלוםשלום", "日本語日本語日本語"}) {
    std::string whole;
    for (const std::string& each : in_lines(word, 50.0)) {
      EXPECT_LE(text_width(each), 50.0);
      whole += each;
    }
    EXPECT_EQ(whole, word);
  }
  EXPECT_EQ(in_lines("mm", 1.0).size(), 2u);  // a letter at least
}

TEST(Figure, NoTextGetsOutOfItsPlace) {
  const std::string hostile = "<script>&\"'\n\u202e</text>";
  const std::string seen = "<script>&\"'\\n\\u202e</text>";
  Chart chart{.y = {.title = in_title(hostile)}, .panels = {{{.title = in_title(hostile)}, {dots({{1.0, 2.0}})}}}};
  chart.panels[0].series[0].name = hostile;
  Chart rows{.rows = {hostile}, .panels = {{{}, {dots({{1.0, 0.0}})}}}};
  for (const Chart& each : {chart, rows}) {
    Figure figure = figure_of(each);
    figure.title = figure.description = hostile;
    for (const Medium look : {Medium::page, Medium::file}) {
      const std::vector<Element> picture = read(svg(figure, look).str());
      EXPECT_TRUE(all(picture, "script").empty());
      EXPECT_TRUE(std::ranges::any_of(picture, [&](const Element& text) { return text.text == seen; }));
    }
  }
  rows.rows = {std::string(40, 'x')};
  EXPECT_TRUE(
      std::ranges::any_of(drawn(rows), [](const Element& text) { return text.text == std::string(32, 'x') + "..."; }));
}

// The longest that is not cut, one more, and much more.
TEST(Figure, TheKeyOfGoalDifferencesSaysWhoWins) {
  for (const auto& [letters, kept] : std::vector<std::pair<std::size_t, std::string>>{
           {27, std::string(27, 'm')}, {28, std::string(24, 'm') + "..."}, {44, std::string(24, 'm') + "..."}}) {
    Course course({std::string(letters, 'm'), "b"});
    TournamentHistory record(course.plan, *course.tournament);
    const campaign::MatchResult decided = match(2, 1);
    course.take(decided);
    record.take(&decided);
    const std::vector<Figure> figures = tournament_figures(course.view(), record);
    const auto figure = std::ranges::find(figures, "goal_differences", &Figure::name);
    ASSERT_NE(figure, figures.end());
    std::vector<std::string> key;
    for (const Element& each : all(read(svg(*figure, Medium::file).str()), "text")) {
      if (each.attributes.at("text-anchor") == "start") key.push_back(each.text);
    }
    EXPECT_THAT(key, ElementsAre(kept + " wins", "draws", "b wins"));
  }
  EXPECT_EQ(name_with("\u202e\u202e", " wins"), "\\u202e\\u202e wins");
  EXPECT_THAT(name_with(std::string(28, '\n'), " wins"), testing::EndsWith("\\n... wins"));
}

// --- The picture -----------------------------------------------------------------------------------------------------

TEST(Figure, OfAPageIsInThePagesColours) {
  const std::string page = svg(figure_of(chart_of(dots({{1.0, -2.0}, {2.0, 3.0}}))), Medium::page).str();
  EXPECT_THAT(page, AllOf(HasSubstr("role=\"img\""), HasSubstr("viewBox=\"0 0 620 "), HasSubstr("var(--series-1)"),
                          HasSubstr("var(--grid)"), HasSubstr("currentColor"),
                          HasSubstr("aria-label=\"A &quot;title&quot; &lt;b&gt;: What it shows\"")));
  for (const char* each : {"#", " id=", "width=\"620\"", "font-family", "http", "style", "class"}) {
    EXPECT_THAT(page, Not(HasSubstr(each)));
  }
}

TEST(Figure, OfAFileNeedsNothingElse) {
  const std::string file = svg(figure_of(chart_of(dots({{1.0, -2.0}, {2.0, 3.0}}))), Medium::file).str();
  EXPECT_THAT(file,
              AllOf(HasSubstr("xmlns=\"http://www.w3.org/2000/svg\""), HasSubstr("#0072b2"), HasSubstr("fill=\"#fff\""),
                    HasSubstr("<title>A &quot;title&quot; &lt;b&gt;</title><desc>What it shows</desc>"),
                    HasSubstr("sans-serif"), Not(HasSubstr("var(")), Not(HasSubstr("currentColor"))));
  EXPECT_EQ(file, svg(figure_of(chart_of(dots({{1.0, -2.0}, {2.0, 3.0}}))), Medium::file).str());
}

TEST(Figure, OfNearlyNothing) {
  const Series nothing{.name = "nothing", .join = Join::line, .shape = Shape::cross, .interval = Interval::band};
  for (Chart chart :
       {Chart{}, chart_of({}), chart_of(nothing), chart_of(dots({{3.0, 0.0}})), chart_of(dots({{1e6, 1e-9}})),
        chart_of({.points = {{0.0, 0.0}}, .bar = 1.0}), Chart{.rows = {"a"}}}) {
    for (const bool logarithmic : {false, true}) {
      for (Panel& panel : chart.panels) panel.x.logarithmic = logarithmic;
      const std::string picture = svg(figure_of(chart), Medium::file).str();
      EXPECT_GT(read(picture).size(), 3u);
      EXPECT_THAT(picture, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
    }
  }
  const std::vector<Element> one = drawn(chart_of(dots({{3.0, 4.0}})));
  EXPECT_NEAR(all(one, "circle").at(0).number("cx"), expected(ticks_of(one, true), 3.0), 0.3);
  EXPECT_NEAR(all(one, "circle").at(0).number("cy"), expected(ticks_of(one, false), 4.0), 0.3);
}

TEST(Figure, TheKeyNamesWhatIsDrawn) {
  Chart chart = chart_of(dots({{1.0, 2.0}}));
  EXPECT_TRUE(std::ranges::none_of(all(drawn(chart), "text"),
                                   [](const Element& each) { return each.attributes.at("text-anchor") == "start"; }));
  const double height = drawn(chart).front().number("height");
  chart.panels[0].series[0].name = "mine";
  std::vector<Element> picture = drawn(chart);
  EXPECT_TRUE(std::ranges::any_of(picture, [](const Element& each) { return each.text == "mine"; }));
  EXPECT_EQ(all(picture, "circle").size(), 2u);
  EXPECT_GT(picture.front().number("height"), height);
  chart.panels[0].series[0].join = Join::dashes;
  EXPECT_THAT(svg(figure_of(chart), Medium::file).str(), HasSubstr("stroke-dasharray"));
}

}  // namespace
}  // namespace regista::report
