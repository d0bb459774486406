// SPDX-License-Identifier: MIT
#include "report/svg.hpp"

#include <gmock/gmock.h>

#include "report/gnuplot.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Figure figure() {
  Figure out;
  out.name = "fig";
  out.title = "A \"title\" <b>";
  out.description = "What it shows";
  out.width = 100;
  out.height = 50;
  return out;
}

std::string svg(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<svg\n viewBox=\"0 0 100 50\"\n xmlns=\"http://www.w3.org/2000/svg\">\n" + content +
         "</svg>\n";
}

TEST(SvgForPage, ColoursAreThoseOfThePage) {
  const std::string page = svg_for_page(
      svg("<rect x=\"0\" y=\"0\" width=\"100\" height=\"50\" fill=\"#ffffff\"/>"
          "<g fill=\"none\" color=\"black\" stroke=\"currentColor\"><path stroke='rgb(  0, 114, 178)' d='M1,2 L3,4'/>"
          "<path stroke='rgb(204, 204, 204)' d='M0,0'/><path stroke='black' d='M0,0'/></g>"),
      figure());
  EXPECT_THAT(page, AllOf(HasSubstr("stroke=\"var(--series-1)\" d=\"M1,2 L3,4\""), HasSubstr("stroke=\"var(--grid)\""),
                          HasSubstr("stroke=\"currentColor\" d=\"M0,0\"")));
  EXPECT_THAT(page, AllOf(Not(HasSubstr("<rect")), Not(HasSubstr("black")), Not(HasSubstr("rgb("))));
  EXPECT_THAT(page, HasSubstr("aria-label=\"A &quot;title&quot; &lt;b&gt;: What it shows\""));
}

TEST(SvgForFile, ColoursAndSheetStay) {
  const std::string file = svg_for_file(svg("<rect x=\"0\" y=\"0\" width=\"100\" height=\"50\" fill=\"#ffffff\"/>"
                                            "<path stroke='rgb(  0, 114, 178)' d='M1,2'/>"),
                                        figure());
  EXPECT_THAT(file, AllOf(HasSubstr("<rect x=\"0\""), HasSubstr("stroke=\"#0072b2\""),
                          HasSubstr("xmlns=\"http://www.w3.org/2000/svg\"")));
}

TEST(Svg, IdsBelongToTheFigureAndUnusedDefinitionsGo) {
  const std::string content =
      "<defs><circle id='a' r='1'/><use xlink:href='#a' id='b'/><circle id='c' r='2'/></defs>"
      "<use xlink:href='#b' transform='translate(1,2)'/>";
  EXPECT_THAT(svg_for_page(svg(content), figure()),
              AllOf(HasSubstr("<circle id=\"fig-a\""), HasSubstr("<use href=\"#fig-a\" id=\"fig-b\""),
                    HasSubstr("<use href=\"#fig-b\""), Not(HasSubstr("fig-c"))));
}

TEST(Svg, NothingThatIsNotDrawnIsLetThrough) {
  const std::string page =
      svg_for_page(svg("<title>Gnuplot</title><desc>Produced by GNUPLOT 5.4</desc><g class='x' onclick='alert(1)' "
                       "style='color:red'><title>t</title><text onload=\"x\">a &lt;b</text></g><g></g>"
                       "<filter id='f'><feFlood flood-color='white'/></filter>"),
                   figure());
  EXPECT_THAT(page, HasSubstr("<text>a &lt;b</text>"));
  for (const char* each :
       {"GNUPLOT", "Gnuplot", "onclick", "onload", "class", "style", "filter", "feFlood", "<g></g>"}) {
    EXPECT_THAT(page, Not(HasSubstr(each)));
  }
}

TEST(Svg, StrangePicturesAreRefused) {
  for (const char* content :
       {"<script>alert(1)</script>", "<foreignObject/>", "<image/>", "<a>x</a>", "<style>x</style>",
        "<use xlink:href='http://x/y'/>", "<use xlink:href='javascript:x'/>", "<path fill='url(#x)'/>",
        "<text><script>x</script></text>", "<g><g>", "<g", "<path d=1/>", "<path d='a", "</g>", "<path d='\"/>"}) {
    EXPECT_THROW(svg_for_page(svg(content), figure()), StrangePicture) << content;
  }
  EXPECT_THROW(svg_for_page("", figure()), StrangePicture);
  EXPECT_THROW(svg_for_page("<svg></svg>", figure()), StrangePicture);
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  EXPECT_THROW(svg_for_page(svg(deep), figure()), StrangePicture);
}

TEST(GnuplotText, IsAStringOfGnuplotAndNothingElse) {
  EXPECT_EQ(gnuplot_text("'a'b'"), "'\u2019a\u2019b\u2019'");
  EXPECT_EQ(gnuplot_text("`date` @x $y \\"), "'`date` @x $y \\'");
  EXPECT_EQ(gnuplot_text("a\nb"), "'a\\nb'");
  EXPECT_EQ(gnuplot_text("&#65;"), "'& #65;'");
  EXPECT_EQ(gnuplot_text(std::string(40, 'x')), '\'' + std::string(32, 'x') + "...'");
}

// What gnuplot makes of a name that tries everything: the name, and nothing else.
TEST(Gnuplot, DrawsHostileNamesAsTheyAre) {
  const std::vector<std::pair<std::string, std::string>> names{
      {"'; system('touch x') # `id` <b>&amp;", "\u2019; system(\u2019touch x\u2019) # `id` &lt;b>&amp;..."},
      {"\\", "\\"},
      {"a\\", "a\\"},
      {"\\'", "\\\u2019"},
      {"''", "\u2019\u2019"},
      {"\"; exit #", "\"; exit #"},
      {"%s %d {/Symbol a} ^2_3 @x $0", "%s %d {/Symbol a} ^2_3 @x $0"},
      {"`touch x`", "`touch x`"},
      {"a\nb", "a\\nb"},
      {"&lt;&#60;", "&amp;lt;&amp; #60;"},
      {"שלום", "שלום"},
  };
  for (const auto& [hostile, seen] : names) {
    Figure drawn = figure();
    drawn.csv = "x,y\n1,2\n2,3\n";
    drawn.commands = "set xtics (" + gnuplot_mark(hostile) + " 1)\nplot 'fig.csv' using 1:2 with lines title " +
                     gnuplot_text(hostile) + "\n";
    const Drawing drawing = draw(drawn, Png::wanted);
    if (drawing.no_gnuplot) GTEST_SKIP() << "gnuplot is not installed";
    EXPECT_EQ(drawing.why_not, "") << hostile;
    EXPECT_TRUE(drawing.png.starts_with("\x89PNG"));
    const std::string page = svg_for_page(drawing.svg, drawn);
    const std::size_t first = page.find('>' + seen + "</text>");
    EXPECT_NE(first, std::string::npos) << page;
    EXPECT_NE(page.find('>' + seen + "</text>", first + 1), std::string::npos) << page;
    EXPECT_EQ(draw(drawn, Png::left_out).svg, drawing.svg);
  }
}

TEST(Gnuplot, SaysWhatItCannotDraw) {
  Figure wrong = figure();
  wrong.csv = "x,y\n";
  wrong.commands = "plat 'fig.csv'\n";
  const Drawing drawing = draw(wrong, Png::left_out);
  if (drawing.no_gnuplot) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_EQ(drawing.svg, "");
  EXPECT_THAT(drawing.why_not, testing::StartsWith("gnuplot: "));
}

}  // namespace
}  // namespace regista::report
